//! Makes the starter of an exercise from its solution.

/// The files to which a line of a solution belongs.
#[derive(Clone, Copy)]
enum Part {
    Both,
    Solution,
    Starter,
}

/// The starter: the solution without the lines between `// exercise` and
/// `// instead`, and with the comments from there to `// end` as code.
pub fn starter(solution: &str) -> Result<String, String> {
    let mut part = Part::Both;
    let mut starter = String::new();
    for (number, line) in (1..).zip(solution.lines()) {
        let code = line.trim_start();
        let indent = &line[..line.len() - code.len()];
        part = match (part, code) {
            (Part::Both, "// exercise") => Part::Solution,
            (Part::Solution, "// instead") => Part::Starter,
            (Part::Starter, "// end") => Part::Both,
            (_, "// exercise" | "// instead" | "// end") => {
                return Err(format!(
                    "line {number} is \"{code}\", but the order is // exercise, // instead, // end"
                ));
            }
            (Part::Both, _) => {
                starter.extend([line, "\n"]);
                part
            }
            (Part::Solution, _) => part,
            (Part::Starter, _) => {
                let comment = code.strip_prefix("//").ok_or_else(|| {
                    format!("line {number} is no comment, but stands after // instead")
                })?;
                let comment = comment.strip_prefix(' ').unwrap_or(comment);
                let indent = if comment.is_empty() { "" } else { indent };
                starter.extend([indent, comment, "\n"]);
                part
            }
        };
    }
    match part {
        Part::Both => Ok(starter),
        _ => Err("the last // exercise has no // end".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::starter;

    #[test]
    fn marked_lines_are_replaced() {
        let solution = "
fn square(x: f64) -> f64 {
    // exercise
    let square = x * x;
    square
    // instead
    // let x =
    //     missing(\"x\", 0.0);
    //
    // // A comment.
    // x
    // end
}
";
        let expected = "
fn square(x: f64) -> f64 {
    let x =
        missing(\"x\", 0.0);

    // A comment.
    x
}
";
        assert_eq!(starter(solution).unwrap(), expected);
        assert_eq!(starter(expected).unwrap(), expected, "nothing is marked");
    }

    #[test]
    fn marks_in_wrong_order_are_refused_with_their_line() {
        for (solution, place) in [
            ("// exercise\n// end\n", "line 2"),
            ("\n// instead\n", "line 2"),
            ("// end\n", "line 1"),
            ("// exercise\n// instead\n// x\n// exercise\n", "line 4"),
            ("// exercise\n// instead\nx\n// end\n", "line 3"),
            ("// exercise\n1\n", "no // end"),
        ] {
            let error = starter(solution).unwrap_err();
            assert!(error.contains(place), "{error}");
        }
    }
}

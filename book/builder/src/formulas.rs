//! Formulas: Markdown would take their signs for its own, so it gets them marked. `formulas.js` draws them.

/// What a page with formulas says to a browser that does not draw them.
const NOTICE: &str = "<noscript>\n\n*JavaScript draws the formulas of this page. Without it they stand as they are \
    typed, in the language of TeX.*\n\n</noscript>\n\n";

/// Puts each formula of a page, between `$` and `$` or between `$$` and `$$`, into an element whose text
/// is the formula. An error is a formula or code that does not end.
pub fn mark(page: &str) -> Result<String, String> {
    let mut marked = String::new();
    let mut has_formulas = false;
    let mut rest = page;
    while let Some(start) = rest.find(['$', '`']) {
        let (before, from) = rest.split_at(start);
        let sign = if from.starts_with('$') { '$' } else { '`' };
        // Code ends with as many signs as it begins with.
        let opened = from.trim_start_matches(sign);
        let delimiter = &from[..from.len() - opened.len()];
        let Some((inside, after)) = opened.split_once(delimiter) else {
            let line = from.lines().next().unwrap_or_default();
            return Err(format!("{line}: a second {delimiter} is missing"));
        };
        marked += before;
        has_formulas |= sign == '$';
        marked += &match delimiter {
            "$" => element("formula", inside),
            "$$" => element("formula display", inside),
            _ => [delimiter, inside, delimiter].concat(),
        };
        rest = after;
    }
    let notice = if has_formulas { NOTICE } else { "" };
    Ok([notice, &marked, rest].concat())
}

fn element(class: &str, formula: &str) -> String {
    let mut text = String::new();
    for letter in formula.chars() {
        // Behind a backslash Markdown takes punctuation as it is.
        if letter.is_ascii_punctuation() {
            text.push('\\');
        }
        text.push(if letter == '\n' { ' ' } else { letter });
    }
    format!(r#"<span class="{class}">{text}</span>"#)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_marked_and_code_is_not() {
        let page = "`$a$` and ```` ```$ ```` cost $c_i$:\n\n$$\nx'\n$$\n";
        let expected = "`$a$` and ```` ```$ ```` cost <span class=\"formula\">c\\_i</span>:\n\n\
            <span class=\"formula display\"> x\\' </span>\n";
        assert_eq!(mark(page).unwrap(), [NOTICE, expected].concat());
        assert_eq!(mark("`$a$` costs nothing").unwrap(), "`$a$` costs nothing");
        assert_eq!(
            mark("cost $c\nor $d$").unwrap_err(),
            "$: a second $ is missing"
        );
    }
}

//! Writes cases as the file has them.

use std::fmt::Write;

use corpus::{Answer, Asks, Bound, Case, Outlook, Row, Shape, Step};

/// The text of a file of cases, below its first lines.
pub fn file(head: &str, cases: &[Case]) -> String {
    let mut text = head.to_owned();
    for case in cases {
        text.push('\n');
        text.push_str(&entry(case));
    }
    text
}

/// The text of a file of rows, below its first lines.
pub fn rows(head: &str, rows: &[Row]) -> String {
    let mut text = head.to_owned();
    for row in rows {
        text.push('\n');
        text.push_str(&entry(&row.case));
        for line in of_row(row) {
            text.push_str(&line);
            text.push('\n');
        }
    }
    text
}

/// The lines that only rows of the laboratories have.
fn of_row(row: &Row) -> Vec<String> {
    let mut lines = Vec::new();
    if let Some(distance) = &row.distance {
        lines.push(format!("distance = {}", quoted(&distance.digits)));
    }
    let expected = &row.expected;
    let asks = match expected.asks {
        Asks::Distance => None,
        Asks::AsGiven => Some("as-given"),
        Asks::T => Some("t"),
        Asks::Normal => Some("normal"),
        Asks::IsLit => Some("is-lit"),
    };
    lines.extend(asks.map(|asks| format!("asks = \"{asks}\"")));
    match expected.bound {
        Bound::Equal => {}
        Bound::Ulps(ulps) => lines.push(format!("bound = {{ ulps = {} }}", number(ulps))),
        Bound::Conditions(times) => {
            lines.push(format!("bound = {{ conditions = {} }}", number(times)));
        }
        Bound::Roundings { length, cosine } => lines.push(format!(
            "bound = {{ length = {}, cosine = {} }}",
            number(length),
            number(cosine)
        )),
    }
    match expected.protocol {
        Some(Outlook::Holds) => lines.push("protocol = \"holds\"".to_owned()),
        Some(Outlook::Fails) => lines.push("protocol = \"fails\"".to_owned()),
        None => {}
    }
    if expected.is_refused {
        lines.push("lesson = \"refuses\"".to_owned());
    }
    lines
}

fn entry(case: &Case) -> String {
    let question = &case.question;
    let mut lines = vec![
        "[[case]]".to_owned(),
        format!("id = {}", quoted(&question.id)),
        format!("family = {}", quoted(&question.family)),
        format!("says = {}", quoted(&question.says)),
        format!("source = {}", quoted(&question.source)),
        shape(&question.shape),
    ];
    if !question.under.is_empty() {
        let steps: Vec<_> = question.under.iter().map(step).collect();
        lines.push(format!("under = [{}]", steps.join(", ")));
    }
    lines.push(format!(
        "ray = {{ origin = {}, direction = {} }}",
        three(question.origin),
        three(question.direction),
    ));
    let [min, max] = question.within.map(number);
    lines.push(format!("within = [{min}, {max}]"));
    match &case.answer {
        Answer::Miss => lines.push("answer = \"miss\"".to_owned()),
        Answer::Coplanar => lines.push("answer = \"coplanar\"".to_owned()),
        Answer::NoShape => lines.push("answer = \"none\"".to_owned()),
        Answer::Hit(hit) => {
            lines.push("answer = \"hit\"".to_owned());
            lines.push(format!("t = {}", quoted(&hit.digits)));
            if let Some(normal) = &hit.normal {
                let normal = normal.clone().map(|digits| quoted(&digits));
                lines.push(format!("normal = [{}]", normal.join(", ")));
            }
        }
    }
    lines.push(format!("condition = {}", number(case.condition)));
    lines.push(format!("margin = {}", number(case.margin)));
    let mut text = lines.join("\n");
    text.push('\n');
    text
}

fn shape(shape: &Shape) -> String {
    match shape {
        Shape::Plane { point, normal } => format!(
            "plane = {{ point = {}, normal = {} }}",
            three(*point),
            three(*normal)
        ),
        Shape::Sphere { center, radius } => format!(
            "sphere = {{ center = {}, radius = {} }}",
            three(*center),
            number(*radius)
        ),
        Shape::Box { low, high } => {
            format!("box = {{ low = {}, high = {} }}", three(*low), three(*high))
        }
        Shape::Disc {
            center,
            normal,
            radius,
        } => format!(
            "disc = {{ center = {}, normal = {}, radius = {} }}",
            three(*center),
            three(*normal),
            number(*radius)
        ),
        Shape::Tube { from, to, radius } => format!(
            "tube = {{ from = {}, to = {}, radius = {} }}",
            three(*from),
            three(*to),
            number(*radius)
        ),
        Shape::Triangles(triangles) => {
            let mut text = "triangles = [\n".to_owned();
            for corners in triangles {
                let [a, b, c] = corners.map(three);
                // A `String` takes all.
                let _ = writeln!(text, "    [{a}, {b}, {c}],");
            }
            text.push(']');
            text
        }
    }
}

fn step(step: &Step) -> String {
    match step {
        Step::Translate(by) => format!("{{ translate = {} }}", three(*by)),
        Step::Scale(by) => format!("{{ scale = {} }}", three(*by)),
    }
}

fn three(numbers: [f64; 3]) -> String {
    let [x, y, z] = numbers.map(number);
    format!("[{x}, {y}, {z}]")
}

/// The shortest decimal that is read as this double again.
fn number(number: f64) -> String {
    if number.is_infinite() {
        return if number > 0.0 { "inf" } else { "-inf" }.to_owned();
    }
    if number.is_nan() {
        return "nan".to_owned();
    }
    format!("{number:?}")
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

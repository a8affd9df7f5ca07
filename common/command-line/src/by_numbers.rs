//! `explain --by-numbers`: how a pixel changes with each number of its scene file.

use common::pixel_trace::digits;
use common::sensitivity::{
    Edge, Influence, NumberPlace, Response, Unit, influences, sort_by_strength,
};
use common::{Error, Scene, Settings, text};

use crate::options::Options;
use crate::print::print;
use crate::render::warn_unused;
use crate::terminal_progress::TerminalProgress;

/// Prints how the linear colour of a pixel changes with each number of the scene file.
pub fn list_numbers(
    scene: &Scene,
    pixel: [u32; 2],
    settings: &Settings,
    options: &Options,
    as_json: bool,
) -> Result<(), Error> {
    let rays = scene.rays()?;
    let progress = TerminalProgress::new(scene.name, settings.size);
    let threads = options.thread_pool()?;
    let numbers = rays.numbers(settings).ok_or_else(|| no_file(scene))?;
    let mut influences =
        threads.install(|| influences(rays, settings, pixel, &numbers, &progress))?;
    sort_by_strength(&mut influences);
    drop(progress);
    warn_unused(scene, options, settings);
    if as_json {
        return print(&json(&influences));
    }
    let (name, size, [x, y]) = (scene.name, settings.size, pixel);
    print(&format!(
        "{name} {size}, pixel {x},{y}: the change of its linear colour per unit of each number"
    ))?;
    print(&table(&influences))?;
    print(&without_effect(&influences))
}

fn no_file(Scene { name, .. }: &Scene) -> Error {
    Error::Usage(format!(
        "{name} is a scene of the program, whose numbers stand in its code; name a scene file, such as \
         one that `export {name} --to toml -o scene.toml` writes"
    ))
}

/// The numbers that change the pixel, one on a line.
fn table(influences: &[Influence]) -> String {
    let head = ["line", "number", "value", "red", "green", "blue", ""];
    let mut rows = vec![head.map(str::to_owned)];
    let changing = influences.iter().filter(|it| it.response.is_change());
    for Influence { number, response } in changing {
        let value = value(number);
        let name = format!("{} {}", number.table, number.key);
        let [red, green, blue] = match response {
            Response::Smooth { slope, .. } => slope.map(|channel| digits(&[channel])),
            other => [in_words(other), String::new(), String::new()],
        };
        let per = match response {
            Response::Smooth { .. } if unit(number).is_empty() => String::new(),
            Response::Smooth { .. } => format!("per {}", unit(number)),
            _ => String::new(),
        };
        let line = number.line.to_string();
        rows.push([line, name, value, red, green, blue, per]);
    }
    if rows.len() == 1 {
        return "no number of the file changes this pixel".to_owned();
    }
    // Words reach over the columns of the channels.
    let is_number = |row: &[String; 7]| !row[4].is_empty();
    let width = |column: usize| {
        let cells = rows.iter().filter(|row| column < 3 || is_number(row));
        cells
            .map(|row| row[column].chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: [usize; 7] = std::array::from_fn(width);
    let lines = rows.iter().map(|row| {
        let [line, name, value, red, green, blue, per] = row;
        let begin = format!(
            "{line:>0$}  {name:1$}  {value:>2$}",
            widths[0], widths[1], widths[2]
        );
        if !is_number(row) {
            return format!("{begin}  {red}");
        }
        let channels = format!(
            "{red:>0$}  {green:>1$}  {blue:>2$}",
            widths[3], widths[4], widths[5]
        );
        format!("{begin}  {channels}  {per}").trim_end().to_owned()
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The value of a number as the file has it; that of a colour in a text in few digits.
fn value(number: &NumberPlace) -> String {
    let all = text::number(number.value);
    if number.unit == Unit::Channel && all.len() > digits(&[number.value]).len() {
        return digits(&[number.value]);
    }
    all
}

/// The unit of a number, behind "per".
const fn unit(number: &NumberPlace) -> &'static str {
    match number.unit {
        Unit::Length => "unit of length",
        Unit::Degree => "degree",
        Unit::Direction(_) | Unit::Factor | Unit::Scale | Unit::Channel | Unit::Whole => "",
    }
}

/// A response that is no derivative, in words.
fn in_words(response: &Response) -> String {
    match response {
        Response::None => "no effect".to_owned(),
        Response::Smooth { slope, .. } => digits(slope),
        Response::Edge(Edge { distance, jump }) => {
            let jump = digits(jump);
            let size = digits(&[distance.abs()]);
            let place = if *distance == 0.0 {
                "here".to_owned()
            } else if *distance > 0.0 {
                format!("at a value larger by {size}")
            } else {
                format!("at a value smaller by {size}")
            };
            format!("an edge: the pixel jumps by {jump} {place}")
        }
        Response::Kink { below, above } => {
            let [below, above] = [below, above].map(|slope| digits(slope));
            format!("an edge: the slope jumps here from {below} to {above}")
        }
        Response::Turning { half_pixel, .. } => {
            format!(
                "a turning point: half a pixel changes it by {}",
                digits(half_pixel)
            )
        }
        Response::Unknown(half_pixel) => {
            format!(
                "unknown slope: half a pixel changes it by {}",
                digits(half_pixel)
            )
        }
        Response::Whole => "a whole number, without a derivative".to_owned(),
        Response::Fixed(reason) => format!("cannot be moved: {reason}"),
    }
}

/// How many numbers do not change the pixel, and which cannot be moved.
fn without_effect(influences: &[Influence]) -> String {
    let count = |is_one: fn(&Response) -> bool| {
        let responses = influences.iter().map(|influence| &influence.response);
        responses.filter(|response| is_one(response)).count()
    };
    let none = count(|response| *response == Response::None);
    let whole = count(|response| *response == Response::Whole);
    let fixed = count(|response| matches!(response, Response::Fixed(_)));
    let all = influences.len();
    let mut parts = vec![format!(
        "numbers without effect on this pixel: {none} of {all}"
    )];
    if whole > 0 {
        parts.push(format!(
            "whole numbers, by which there is no derivative: {whole}"
        ));
    }
    if fixed > 0 {
        parts.push(format!("numbers that cannot be moved alone: {fixed}"));
    }
    parts.join("; ")
}

/// The influences for programs, one on a line.
fn json(influences: &[Influence]) -> String {
    let rows: Vec<_> = influences.iter().map(json_row).collect();
    format!("[\n{}\n]", rows.join(",\n"))
}

fn json_row(Influence { number, response }: &Influence) -> String {
    let NumberPlace {
        line,
        columns,
        table,
        key,
        value,
        ..
    } = number;
    let columns = [columns.start, columns.end];
    let response = match response {
        Response::Smooth { slope, error } => {
            format!(r#""slope": {slope:?}, "error": {error:?}"#)
        }
        Response::Edge(Edge { distance, jump }) => {
            format!(r#""jump": {jump:?}, "distance": {distance:?}"#)
        }
        Response::Kink { below, above } => format!(r#""below": {below:?}, "above": {above:?}"#),
        Response::None => r#""slope": [0.0, 0.0, 0.0], "error": 0.0"#.to_owned(),
        Response::Turning {
            slope,
            error,
            half_pixel,
        } => format!(r#""slope": {slope:?}, "error": {error:?}, "half_pixel": {half_pixel:?}"#),
        Response::Unknown(half_pixel) => {
            format!(r#""unknown": true, "half_pixel": {half_pixel:?}"#)
        }
        Response::Whole => r#""whole": true"#.to_owned(),
        Response::Fixed(_) => r#""fixed": true"#.to_owned(),
    };
    // Names from the file have no characters that Rust and JSON escape differently: they are visible.
    let unit = unit(number);
    format!(
        r#"{{"line": {line}, "columns": {columns:?}, "table": {table:?}, "key": {key:?}, "value": {value:?}, "per": {unit:?}, {response}}}"#
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn influence(key: &str, unit: Unit, response: Response) -> Influence {
        Influence {
            number: NumberPlace {
                line: 7,
                columns: 3..4,
                bytes: 50..51,
                at: 50,
                index: 0,
                table: "[[sphere]] #2".to_owned(),
                key: key.to_owned(),
                value: 0.1,
                unit,
                allowed: [f64::NEG_INFINITY, f64::INFINITY],
            },
            response,
        }
    }

    #[test]
    fn derivatives_stand_in_columns_and_edges_in_words() {
        let slope = [0.25, 0.0, -1.0 / 3.0];
        let edge = Edge {
            distance: -0.001,
            jump: [1.0, 0.5, 0.0],
        };
        let influences = [
            influence("radius", Unit::Length, Response::Edge(edge)),
            influence(
                "center x",
                Unit::Length,
                Response::Smooth {
                    slope,
                    error: 1e-12,
                },
            ),
            influence("center y", Unit::Length, Response::None),
            influence("count", Unit::Whole, Response::Whole),
        ];
        let lines = [
            "line  number                  value   red  green     blue",
            "   7  [[sphere]] #2 radius      0.1  an edge: the pixel jumps by (1, 0.5, 0) at a value smaller by 0.001",
            "   7  [[sphere]] #2 center x    0.1  0.25      0  -0.3333  per unit of length",
        ];
        assert_eq!(table(&influences), lines.join("\n"));
        assert_eq!(
            without_effect(&influences),
            "numbers without effect on this pixel: 1 of 4; whole numbers, by which there is no \
             derivative: 1"
        );
        let json = json(&influences);
        let row = r#"{"line": 7, "columns": [3, 4], "table": "[[sphere]] #2", "key": "center x", "value": 0.1, "per": "unit of length", "slope": [0.25, 0.0, -0.3333333333333333], "error": 1e-12}"#;
        assert_eq!(json.lines().nth(2), Some(&*format!("{row},")));
    }
}

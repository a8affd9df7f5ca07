//! `MarkedCopy`: a copy of a picture in which the place of a fact is marked.

use std::path::PathBuf;

use common::{Color, Error, Image, Transfer, picture_file};

use crate::pictures::fact::Fact;
use crate::pictures::judgement::{Judgement, MeasuredValue};
use crate::pictures::line::Line;
use crate::pictures::quantity::Quantity;
use crate::pictures::values::Region;

/// The extension of marked copies.
pub const MARKED_EXTENSION: &str = "marked.png";

/// The colours of marks.
const COLORS: [(&str, Color); 4] = [
    ("magenta", Color::MAGENTA),
    ("yellow", Color::YELLOW),
    ("green", Color::GREEN),
    ("cyan", Color::new(0.0, 1.0, 1.0)),
];

/// The width of a frame, and how far one around a line is from it, in pixels.
const THICK: i64 = 2;
const FROM_LINE: f64 = 3.0;

/// The length of marks of places on a line, outside of its frame.
const TICK: f64 = 9.0;

/// A marked copy.
pub struct MarkedCopy {
    pub file: PathBuf,
    /// What its colours mean.
    pub words: String,
}

/// Writes a copy of the picture of a fact, `*.marked.png` beside it. None if the fact has neither picture nor place.
pub fn mark(
    judgement: &Judgement,
    fact: &Fact,
    measured: Option<&MeasuredValue>,
) -> Result<Option<MarkedCopy>, Error> {
    let Ok(opened) = judgement.opened(&fact.run) else {
        return Ok(None);
    };
    let mut image = opened.image.clone();
    let words = match (&fact.quantity, measured) {
        (Quantity::Edge(line) | Quantity::Width(line), _) => {
            let [first, second] = contrasts(&image, bounds(*line));
            frame_line(&mut image, *line, first.1);
            if let Quantity::Edge(_) = fact.quantity {
                tick(&mut image, *line, fact.value, second.1);
                if let Some(measured) = measured {
                    tick(&mut image, *line, measured.value, first.1);
                }
                let (first, second) = (first.0, second.0);
                format!("the line and the edge in {first}, its right place in {second}")
            } else {
                format!("the line in {}", first.0)
            }
        }
        (measure, _) => {
            let different = measured.and_then(|measured| measured.different);
            let Some(region) = measure.region().or(different) else {
                return Ok(None);
            };
            let [(name, color), _] = contrasts(&image, region);
            frame(&mut image, region, color);
            format!("the region in {name}")
        }
    };
    let file = opened.drawn.file.with_extension(MARKED_EXTENSION);
    let bytes = image.to_rgb8(Transfer::Linear);
    picture_file::save_png(&file, image.size(), &bytes)?;
    Ok(Some(MarkedCopy { file, words }))
}

/// The two colours that differ most from the mean around the place.
fn contrasts(image: &Image, region: Region) -> [(&'static str, Color); 2] {
    let mut sum = Color::BLACK;
    let mut count = 0.0;
    for (y, row) in (0..).zip(image.rows()) {
        for (x, color) in (0..).zip(row) {
            let is_near = |at: u32, from: u32, count: u32| (from..from + count).contains(&at);
            if is_near(x, region.x, region.width) && is_near(y, region.y, region.height) {
                sum += *color;
                count += 1.0;
            }
        }
    }
    let mean = sum * (1.0 / count);
    let distance = |color: Color| {
        let parts = [color.r - mean.r, color.g - mean.g, color.b - mean.b];
        parts.map(|part| part * part).iter().sum::<f64>()
    };
    let mut colors = COLORS;
    colors.sort_by(|a, b| distance(b.1).total_cmp(&distance(a.1)));
    [colors[0], colors[1]]
}

/// The pixels that a line passes.
fn bounds(line: Line) -> Region {
    let [x, y] = [0, 1].map(|i| line.from[i].min(line.to[i]) as u32);
    let [width, height] = [0, 1].map(|i| (line.from[i] - line.to[i]).abs() as u32 + 1);
    Region {
        x,
        y,
        width,
        height,
    }
}

/// A frame just outside of a region.
fn frame(image: &mut Image, region: Region, color: Color) {
    let (left, top) = (i64::from(region.x), i64::from(region.y));
    let (right, bottom) = (
        left + i64::from(region.width),
        top + i64::from(region.height),
    );
    for y in top - THICK..bottom + THICK {
        for x in left - THICK..right + THICK {
            if !(left..right).contains(&x) || !(top..bottom).contains(&y) {
                set(image, x as f64, y as f64, color);
            }
        }
    }
}

/// A frame around a line, whose pixels stay as they are.
fn frame_line(image: &mut Image, line: Line, color: Color) {
    let beside = line.beside() + FROM_LINE;
    let ends = [-FROM_LINE, line.length() + FROM_LINE];
    for side in [-beside, beside] {
        stroke(image, line, ends, [side, side], color);
    }
    for end in ends {
        stroke(image, line, [end, end], [-beside, beside], color);
    }
}

/// Marks on both sides of a place on a line.
fn tick(image: &mut Image, line: Line, at: f64, color: Color) {
    let beside = line.beside() + FROM_LINE;
    for side in [-1.0, 1.0] {
        let across = [side * beside, side * (beside + TICK)];
        stroke(image, line, [at, at], across, color);
    }
}

/// Paints the pixels from one point to another, each given along the line and beside it.
fn stroke(image: &mut Image, line: Line, along: [f64; 2], beside: [f64; 2], color: Color) {
    let steps = (2.0 * libm::hypot(along[1] - along[0], beside[1] - beside[0])) as u32 + 1;
    for step in 0..=steps {
        let part = f64::from(step) / f64::from(steps);
        let [along, beside] = [along, beside].map(|[from, to]| from + part * (to - from));
        let [x, y] = line.point(along, beside);
        set(image, x.round(), y.round(), color);
    }
}

fn set(image: &mut Image, x: f64, y: f64, color: Color) {
    if x >= 0.0 && y >= 0.0 {
        image.set(x as u32, y as u32, color);
    }
}

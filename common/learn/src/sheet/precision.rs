//! `Report`: the error of a program's pictures against its run time, in words and as diagrams.

mod diagrams;
mod words;

use common::Median;
use judge::pictures::{Axis, Precision, Sheet};
use measure::experiment::Errors;

/// The pixels of a block along each side. Where there are fewer rows, they stand beside each other.
const SIDE: usize = 4;

/// The errors of a program's pictures and the times of its runs.
pub struct Report<'a> {
    sheet: &'a Sheet,
    precision: Precision<'a>,
    pub points: Vec<Point>,
}

/// What is measured with a number of samples.
pub struct Point {
    pub samples: u32,
    /// The errors of the pixels.
    pub errors: Errors,
    /// The errors of the means of blocks of pixels, if there is noise.
    blocks: Option<Errors>,
    /// The error of theory.
    theory: f64,
    pub seconds: Median,
}

impl<'a> Report<'a> {
    /// The report of pictures and the times that they took. The error is a sentence about the program.
    pub fn new(
        sheet: &'a Sheet,
        precision: Precision<'a>,
        seconds: impl IntoIterator<Item = Median>,
    ) -> Result<Self, String> {
        let theory = precision.theory;
        let mut points = Vec::<Point>::new();
        for (of_picture, seconds) in precision.points.iter().zip(seconds) {
            let scale = theory.tests.unwrap_or(1.0);
            let all: Vec<_> = of_picture.errors.iter().map(|e| e * scale).collect();
            let has_noise = theory.tests.is_none() && precision.axis == Axis::Logarithm;
            let blocks = has_noise.then(|| Errors::of(means_of_blocks(&all, precision.width)));
            points.push(Point {
                samples: of_picture.samples,
                errors: Errors::of(all),
                blocks,
                theory: theory.errors[points.len()],
                seconds,
            });
        }
        let is_used = "does the program use --samples?";
        for (two, pictures) in points.windows(2).zip(precision.points.windows(2)) {
            if pictures[0].errors == pictures[1].errors {
                let [few, many] = [two[0].samples, two[1].samples];
                return Err(format!(
                    "{}: {few} and {many} samples draw the same pixels: {is_used}",
                    sheet.name
                ));
            }
        }
        for Point {
            samples, errors, ..
        } in &points
        {
            if errors.rms == 0.0 {
                return Err(format!(
                    "{}: with {samples} samples the picture is exact already: {is_used}",
                    sheet.name
                ));
            }
        }
        if theory.tests.is_some() {
            let scale = points[0].errors.rms / points[0].theory;
            for point in &mut points {
                point.theory *= scale;
            }
        }
        Ok(Self {
            sheet,
            precision,
            points,
        })
    }

    fn counts_tests(&self) -> bool {
        self.precision.theory.tests.is_some()
    }
}

/// The means of the errors of neighbouring pixels.
fn means_of_blocks(errors: &[f64], width: usize) -> Vec<f64> {
    let height = errors.len() / width;
    let [columns, rows] = if height < SIDE {
        [SIDE * SIDE, 1]
    } else {
        [SIDE, SIDE]
    };
    let mut means = Vec::new();
    for top in 0..height / rows {
        for left in 0..width / columns {
            let mut sum = 0.0;
            for y in top * rows..(top + 1) * rows {
                let from = y * width + left * columns;
                sum += errors[from..from + columns].iter().sum::<f64>();
            }
            means.push(sum / (columns * rows) as f64);
        }
    }
    means
}

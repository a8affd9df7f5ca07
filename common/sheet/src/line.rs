//! `Line`: a line across a picture, and the places where its values cross a level.

use common::Size;

use crate::measure::Values;

/// The least difference between the ends of an edge: 2 of 255 bytes are noise of rounding.
const LEAST_STEP: f64 = 2.5 / 255.0;

/// A line from pixel to pixel, whose centres have whole coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    pub from: [f64; 2],
    pub to: [f64; 2],
}

impl Line {
    pub fn is_inside(self, size: Size) -> bool {
        let is_inside = |[x, y]: [f64; 2]| {
            let (right, bottom) = (size.width() - 1, size.height() - 1);
            (0.0..=right.into()).contains(&x) && (0.0..=bottom.into()).contains(&y)
        };
        is_inside(self.from) && is_inside(self.to) && self.length() >= 1.0
    }

    pub fn length(self) -> f64 {
        let [from, to] = [self.from, self.to];
        libm::hypot(to[0] - from[0], to[1] - from[1])
    }

    /// The point at this distance from the beginning.
    pub fn at(self, distance: f64) -> [f64; 2] {
        let part = distance / self.length();
        [0, 1].map(|i| self.from[i] + part * (self.to[i] - self.from[i]))
    }

    /// Where the value first crosses the middle between its ends.
    pub fn edge(self, values: &Values) -> Result<f64, String> {
        let [middle] = self.crossings(values, [0.5])?;
        Ok(middle)
    }

    /// The distance between the places where the value first crosses 10 % and 90 % of the step.
    pub fn width(self, values: &Values) -> Result<f64, String> {
        let [low, high] = self.crossings(values, [0.1, 0.9])?;
        Ok(high - low)
    }

    /// The distances from the beginning at which the value first crosses parts of the step between the two ends.
    fn crossings<const N: usize>(
        self,
        values: &Values,
        parts: [f64; N],
    ) -> Result<[f64; N], String> {
        // A point for each pixel, and the end.
        let count = self.length().ceil().max(1.0) as u32;
        let step = self.length() / f64::from(count);
        let at = |i: u32| values.between(self.at(step * f64::from(i)));
        let course: Vec<_> = (0..=count).map(at).collect();
        let (first, last) = (course[0], course[course.len() - 1]);
        if (last - first).abs() < LEAST_STEP {
            return Err(format!(
                "there is no edge: the value is {first:.3} at the beginning of the line and {last:.3} at its end"
            ));
        }
        Ok(parts.map(|part| {
            let level = first + part * (last - first);
            let is_past = |value: f64| (value - level) * (last - first) >= 0.0;
            let after = course.iter().position(|value| is_past(*value));
            // The end is past each level, and the beginning before it.
            let after = after.unwrap_or(course.len() - 1).max(1);
            let (before, past) = (course[after - 1], course[after]);
            let beyond = (level - before) / (past - before);
            step * ((after - 1) as f64 + beyond)
        }))
    }
}

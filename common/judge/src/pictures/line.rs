//! `Line`: a line across a picture, and the places where its values cross a level.

use common::Size;

use crate::pictures::values::Values;

/// The least difference between the ends of an edge: 2 of 255 bytes are noise of rounding.
const MIN_STEP: f64 = 2.5 / 255.0;

/// A line from pixel to pixel, whose centres have whole coordinates. Its value at a place is the mean across
/// several parallel lines, each a pixel beside the last; this one is in their middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    pub from: [f64; 2],
    pub to: [f64; 2],
    pub lines: u32,
}

impl Line {
    pub fn is_inside(self, size: Size) -> bool {
        let is_inside = |[x, y]: [f64; 2]| {
            let (right, bottom) = (size.width() - 1, size.height() - 1);
            (0.0..=right.into()).contains(&x) && (0.0..=bottom.into()).contains(&y)
        };
        let length = self.length();
        let beside = self.beside();
        let corners = [0.0, length].map(|along| [-beside, beside].map(|b| self.point(along, b)));
        length >= 1.0 && self.lines % 2 == 1 && corners.as_flattened().iter().all(|p| is_inside(*p))
    }

    pub fn length(self) -> f64 {
        let [from, to] = [self.from, self.to];
        libm::hypot(to[0] - from[0], to[1] - from[1])
    }

    /// The distance from the middle to the outermost of the parallel lines.
    pub fn beside(self) -> f64 {
        f64::from(self.lines / 2)
    }

    /// The point at this distance from the beginning, and at this one beside the line.
    pub fn point(self, along: f64, beside: f64) -> [f64; 2] {
        let [from, to] = [self.from, self.to];
        let [dx, dy] = [0, 1].map(|i| (to[i] - from[i]) / self.length());
        [
            from[0] + along * dx - beside * dy,
            from[1] + along * dy + beside * dx,
        ]
    }

    /// The mean of the values at this distance from the beginning.
    fn value(self, values: &Values, along: f64) -> f64 {
        let beside = |i: u32| f64::from(i) - self.beside();
        let value = |i: u32| values.between(self.point(along, beside(i)));
        (0..self.lines).map(value).sum::<f64>() / f64::from(self.lines)
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
        let at = |i: u32| self.value(values, step * f64::from(i));
        let course: Vec<_> = (0..=count).map(at).collect();
        let (first, last) = (course[0], course[course.len() - 1]);
        if (last - first).abs() < MIN_STEP {
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

//! `Numbers`: the random numbers of a scene, most of them halves, so that rays and lights run along faces, and through
//! edges and corners.

/// Draws a whole number, at least 0 and less than this one.
pub type Below<'a> = &'a mut dyn FnMut(u32) -> u32;

/// Which numbers a scene has, beside halves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Ordinary ones. No 0 is negative.
    Plain,
    /// Zeros of both signs, subnormal and huge numbers, in a scene of any size anywhere.
    Extreme,
    /// Those that are at the ends of ranges or beyond, and any bits.
    Any,
}

/// Zeros, and numbers that are 0 beside any other: subnormal ones, those that are subnormal or 0 in
/// single precision, and those whose reciprocal is infinite there.
const ALMOST_ZERO: [f64; 8] = [0.0, 0.0, 5e-324, 1e-310, 1e-200, 1e-46, 1e-40, 1e-31];

/// Units of length.
const UNITS: [f64; 10] = [1.0, 1.0, 1.0, 1.0, 1e-95, 1e-30, 1e-6, 1e6, 1e40, 1e85];

/// Ends of the ranges that constructors and number formats have, and numbers beyond.
#[rustfmt::skip]
const ENDS: [f64; 24] = [
    0.0, -0.0, 1.0, -1.0, 1.0 - f64::EPSILON / 2.0, 1.0 + f64::EPSILON,
    1e-100, 1e100, -1e100, 1e-7, 1e-12, 1e50, 1e-50, 1e150, 1e-150, 1e160, 1e-160,
    std::f64::consts::PI, std::f64::consts::FRAC_PI_2,
    f64::MIN_POSITIVE, f64::MAX, 5e-324, f64::INFINITY, f64::NAN,
];

/// Random numbers, and the place of a scene.
pub struct Numbers<'a> {
    below: Below<'a>,
    pub(super) style: Style,
    /// The unit of length.
    pub unit: f64,
    pub(super) middle: [f64; 3],
    /// The reach of points along each axis, in units.
    pub(super) reach: [f64; 3],
}

impl<'a> Numbers<'a> {
    /// The numbers of a scene of this style, drawn by `below`.
    pub fn new(below: Below<'a>, style: Style) -> Self {
        let mut numbers = Self {
            below,
            style,
            unit: 1.0,
            middle: [0.0; 3],
            reach: [1.0; 3],
        };
        if style == Style::Extreme {
            numbers.unit = numbers.one_of(&UNITS);
            if numbers.below(5) == 0 {
                numbers.middle = numbers
                    .point()
                    .map(|x| x * numbers.one_of(&[1e3, 1e6, 1e13]));
            }
        }
        numbers
    }

    /// A whole number, at least 0 and less than `end`, which is at least 1.
    pub fn below(&mut self, end: usize) -> usize {
        (self.below)(end as u32) as usize
    }

    /// One of some values.
    pub fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// A number with a sign of its own.
    pub fn signed(&mut self, magnitude: f64) -> f64 {
        [magnitude, -magnitude][self.below(2)]
    }

    /// 0 of either sign, or almost 0.
    pub fn almost_zero(&mut self) -> f64 {
        let magnitude = self.one_of(&ALMOST_ZERO);
        self.signed(magnitude)
    }

    /// A number from -2 to 2, in most cases a half.
    pub fn number(&mut self) -> f64 {
        match (self.below(8), self.style) {
            (0, _) => self.below(1 << 20) as f64 / f64::from(1 << 18) - 2.0,
            (1, Style::Extreme) => self.almost_zero(),
            (2, Style::Extreme) if self.below(8) == 0 => {
                let magnitude = self.one_of(&[1e12, 1e31, 1e39]);
                self.signed(magnitude)
            }
            _ => {
                let halves = self.below(5) as f64 / 2.0;
                let signed = self.signed(halves);
                // Adding 0 makes a 0 positive.
                if self.style == Style::Extreme {
                    signed
                } else {
                    signed + 0.0
                }
            }
        }
    }

    /// Any number.
    pub fn any(&mut self) -> f64 {
        let bits = [(); 4].map(|()| self.below(1 << 16) as u64);
        match self.below(8) {
            0 => f64::from_bits(bits.iter().fold(0, |all, bits| all << 16 | bits)),
            1 => self.one_of(&ENDS),
            // A power of two from 2^-384 to 2^381, whose sum with anything rounds.
            2 => f64::from_bits((1023 - 384 + 3 * (bits[0] % 256)) << 52),
            3 => (bits[0] as f64 - 32_768.0) / 4096.0,
            // So few that they repeat: edges that touch, shapes within each other.
            _ => (bits[0] % 256) as f64 / 8.0 - 16.0,
        }
    }

    /// A point of the scene. A 0 keeps its sign where the middle is 0.
    pub fn point(&mut self) -> [f64; 3] {
        let at = [0, 1, 2].map(|axis| self.number() * self.reach[axis]);
        self.at(at)
    }

    /// The point at these coordinates in units.
    pub(super) fn at(&self, coordinates: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|axis| {
            let from_middle = coordinates[axis] * self.unit;
            if self.middle[axis] == 0.0 {
                from_middle
            } else {
                self.middle[axis] + from_middle
            }
        })
    }

    /// A direction of any length, in half of all cases along an axis, or almost.
    pub fn direction(&mut self) -> [f64; 3] {
        let axis = self.below(6);
        [0, 1, 2].map(|i| match axis {
            0..3 if i == axis => self.signed(1.0),
            0..3 if self.style == Style::Extreme => self.almost_zero(),
            0..3 => 0.0,
            _ => self.number(),
        })
    }
}

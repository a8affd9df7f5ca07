//! `LogAxis`: a logarithmic axis, with labels that are right over any range.

/// A logarithmic axis.
pub struct LogAxis {
    /// The logarithms of its ends, to base 10.
    from: f64,
    to: f64,
    /// The positions of its ends in the picture.
    start: f64,
    end: f64,
}

/// A number that an axis is labelled with.
pub struct AxisLabel {
    /// The number.
    pub number: f64,
    /// The number in words.
    pub text: String,
}

/// The shortest axis in decades: it holds two of the numbers 1 to 9 times a power of ten.
const SHORTEST: f64 = 0.61;

/// From this many decades on, every axis holds two of 1, 2, 5, 10...
const ONE_TWO_FIVE: f64 = 0.7;

/// Distance of the outermost numbers from the ends, as a fraction of the axis.
const PADDING: f64 = 0.03;

/// The most labels of powers of ten.
const MAX_POWERS: f64 = 8.0;

impl LogAxis {
    /// The axis of some positive numbers between two positions in the picture.
    pub fn new(numbers: &[f64], start: f64, end: f64) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for number in numbers {
            low = low.min(libm::log10(*number));
            high = high.max(libm::log10(*number));
        }
        if numbers.is_empty() {
            (low, high) = (0.0, 1.0);
        }
        let padding = (PADDING * (high - low)).max((SHORTEST - (high - low)) / 2.0);
        Self {
            from: low - padding,
            to: high + padding,
            start,
            end,
        }
    }

    /// The position of a number in the picture.
    pub fn at(&self, number: f64) -> f64 {
        let fraction = (libm::log10(number) - self.from) / (self.to - self.from);
        self.start + fraction * (self.end - self.start)
    }

    /// Whether a number lies between the ends.
    pub fn holds(&self, number: f64) -> bool {
        (self.from..=self.to).contains(&libm::log10(number))
    }

    /// The numbers with a label, from small to large: factors times powers of ten.
    pub fn labels(&self) -> Vec<AxisLabel> {
        let decades = self.to - self.from;
        let (factors, step): (&[i32], i32) = match decades {
            // Without 7 and 9, whose labels are too near to the next.
            ..ONE_TWO_FIVE => (&[1, 2, 3, 4, 5, 6, 8], 1),
            ..2.0 => (&[1, 2, 5], 1),
            _ => (&[1], (decades / MAX_POWERS).ceil() as i32),
        };
        let mut held = Vec::new();
        for power in self.from.floor() as i32..=self.to.ceil() as i32 {
            for factor in factors {
                let tick = Tick {
                    factor: *factor,
                    power,
                };
                if power.rem_euclid(step) == 0 && self.holds(tick.number()) {
                    held.push(tick);
                }
            }
        }
        let are_plain = held.iter().all(|tick| (-3..=4).contains(&tick.power));
        let mut labels = Vec::new();
        for tick in held {
            labels.push(AxisLabel {
                number: tick.number(),
                text: if are_plain {
                    tick.plain()
                } else {
                    tick.as_power()
                },
            });
        }
        labels
    }
}

/// A factor times a power of ten.
struct Tick {
    factor: i32,
    power: i32,
}

impl Tick {
    fn number(&self) -> f64 {
        f64::from(self.factor) * libm::pow(10.0, self.power.into())
    }

    /// The number with as many decimal places as it needs.
    fn plain(&self) -> String {
        let places = (-self.power).max(0) as usize;
        format!("{:.places$}", self.number())
    }

    /// The number with an exponent, such as 2·10⁷.
    fn as_power(&self) -> String {
        const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        let mut exponent = String::new();
        for sign_or_digit in self.power.to_string().chars() {
            exponent.push(match sign_or_digit.to_digit(10) {
                Some(digit) => DIGITS[digit as usize],
                None => '⁻',
            });
        }
        match self.factor {
            1 => format!("10{exponent}"),
            factor => format!("{factor}·10{exponent}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(numbers: &[f64]) -> Vec<String> {
        let labels = LogAxis::new(numbers, 0.0, 1.0).labels();
        labels.into_iter().map(|label| label.text).collect()
    }

    #[test]
    fn labels_suit_the_range() {
        assert_eq!(labels(&[1e-6, 1e3]), ["10⁻⁶", "10⁻⁴", "10⁻²", "10⁰", "10²"]);
        assert_eq!(labels(&[1.0, 1e3]), ["1", "10", "100", "1000"]);
        assert_eq!(labels(&[3e-3, 0.06]), ["0.005", "0.01", "0.02", "0.05"]);
        assert_eq!(labels(&[4e6, 3e7]), ["5·10⁶", "10⁷", "2·10⁷"]);
        assert_eq!(labels(&[1.0, 3.0]), ["1", "2", "3"]);
        assert_eq!(labels(&[]), ["1", "2", "5", "10"]);
    }

    /// Wherever an axis lies, and however short it is, its labels are two or more
    /// different ones, and each of them is the number that it stands at.
    #[test]
    fn every_axis_has_different_labels() {
        for n in 0..4000 {
            let low = libm::pow(10.0, f64::from(n % 60) / 6.1 - 4.0);
            let high = low * libm::pow(10.0, f64::from(n) / 400.0);
            let axis = LogAxis::new(&[low, high], 0.0, 1.0);
            let labels = axis.labels();
            assert!(labels.len() > 1 && labels.len() < 11, "{low} {high}");
            assert!(labels.windows(2).all(|pair| pair[0].text != pair[1].text));
            for AxisLabel { number, text } in labels {
                assert!((0.0..=1.0).contains(&axis.at(number)));
                let plain: Option<f64> = text.parse().ok();
                assert!(plain.is_none_or(|plain| (plain / number - 1.0).abs() < 1e-12));
            }
        }
    }
}

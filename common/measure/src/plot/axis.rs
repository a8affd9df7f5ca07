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

/// The shortest axis in decades: it holds two of the numbers 1 to 9 times a power of ten.
const SHORTEST: f64 = 0.61;

/// From this many decades on, every axis holds two of 1, 2, 5, 10...
const ONE_TWO_FIVE: f64 = 0.7;

/// Distance of the outermost numbers from the ends, as a fraction of the axis.
const PADDING: f64 = 0.03;

/// The most labels of powers of ten.
const MOST_POWERS: f64 = 8.0;

impl LogAxis {
    /// The axis of some positive numbers between two positions in the picture.
    pub fn new(numbers: impl Iterator<Item = f64>, (start, end): (f64, f64)) -> Self {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let logs = numbers.map(libm::log10);
        let (low, high) = logs.fold(ends, |(a, b), log| (a.min(log), b.max(log)));
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
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

    /// The numbers with a label, and their labels.
    pub fn labels(&self) -> Vec<(f64, String)> {
        let decades = self.to - self.from;
        let (factors, step): (&[i32], _) = match decades {
            // Without 7 and 9, whose labels are too near to the next.
            ..ONE_TWO_FIVE => (&[1, 2, 3, 4, 5, 6, 8], 1),
            ..2.0 => (&[1, 2, 5], 1),
            _ => (&[1], (decades / MOST_POWERS).ceil() as i32),
        };
        let powers = self.from.floor() as i32..=self.to.ceil() as i32;
        let powers = powers.filter(|power| power.rem_euclid(step) == 0);
        let all = powers.flat_map(|power| factors.iter().map(move |factor| (*factor, power)));
        let is_held = |(factor, power): &(i32, i32)| self.holds(number(*factor, *power));
        let held: Vec<_> = all.filter(is_held).collect();
        let is_plain = held.iter().all(|(_, power)| (-3..=4).contains(power));
        let label = |(factor, power)| (number(factor, power), label(factor, power, is_plain));
        held.into_iter().map(label).collect()
    }
}

fn number(factor: i32, power: i32) -> f64 {
    f64::from(factor) * libm::pow(10.0, power.into())
}

/// A factor times a power of ten, plain or as a power.
fn label(factor: i32, power: i32, is_plain: bool) -> String {
    if is_plain {
        let places = (-power).max(0) as usize;
        return format!("{:.places$}", number(factor, power));
    }
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| digits[digit as usize]);
    let exponent: String = power.to_string().chars().map(raised).collect();
    match factor {
        1 => format!("10{exponent}"),
        _ => format!("{factor}·10{exponent}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(numbers: &[f64]) -> Vec<String> {
        let axis = LogAxis::new(numbers.iter().copied(), (0.0, 1.0));
        axis.labels().into_iter().map(|(_, label)| label).collect()
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
            let axis = LogAxis::new([low, high].into_iter(), (0.0, 1.0));
            let labels = axis.labels();
            assert!(labels.len() > 1 && labels.len() < 11, "{low} {high}");
            assert!(labels.windows(2).all(|pair| pair[0].1 != pair[1].1));
            for (number, label) in labels {
                assert!((0.0..=1.0).contains(&axis.at(number)));
                let plain: Option<f64> = label.parse().ok();
                assert!(plain.is_none_or(|plain| (plain / number - 1.0).abs() < 1e-12));
            }
        }
    }
}

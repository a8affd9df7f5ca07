//! Figures in words: so coarse that the next measurement says the same.

use common::Median;

use crate::front::EQUAL_TIMES;

/// The relation of two times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    Longer,
    Shorter,
    Same,
}

impl Relation {
    pub fn of(quotient: &Median) -> Self {
        if quotient.low > EQUAL_TIMES {
            Self::Longer
        } else if EQUAL_TIMES * quotient.high < 1.0 {
            Self::Shorter
        } else {
            Self::Same
        }
    }

    pub fn named(name: &str) -> Option<Self> {
        match name {
            "longer" => Some(Self::Longer),
            "shorter" => Some(Self::Shorter),
            "same" => Some(Self::Same),
            _ => None,
        }
    }

    pub const fn name(self) -> &'static str {
        match self {
            Self::Longer => "longer",
            Self::Shorter => "shorter",
            Self::Same => "same",
        }
    }
}

/// Steps of about a fifth to a quarter, in each decade.
const STEPS: [f64; 11] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];

/// The nearest step.
pub fn coarse(number: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10(number)));
    let mut nearest = power;
    for step in STEPS {
        let step = step * power;
        // Nearer in their ratio.
        if libm::log(step / number).abs() < libm::log(nearest / number).abs() {
            nearest = step;
        }
    }
    // Without the rounding error of a product.
    libm::round(nearest * 1e3) / 1e3
}

/// A quotient of times as the words between "takes" and "as the other".
pub fn as_long(quotient: &Median) -> String {
    let factor = quotient.value;
    match Relation::of(quotient) {
        Relation::Same => "as long".to_owned(),
        Relation::Longer => format!("about {} as long", multiple(factor)),
        Relation::Shorter => format!("about {} as long", part(1.0 / factor)),
    }
}

/// A factor above 1.
pub fn multiple(factor: f64) -> String {
    let factor = coarse(factor.max(1.2));
    if factor == 2.0 {
        "twice".to_owned()
    } else {
        format!("{factor} times")
    }
}

/// One over a number above 1.
fn part(divisor: f64) -> String {
    let name = match coarse(divisor.max(1.2)) {
        1.2 => "five sixths",
        1.5 => "two thirds",
        2.0 => "half",
        2.5 => "two fifths",
        3.0 => "a third",
        4.0 => "a quarter",
        5.0 => "a fifth",
        6.0 => "a sixth",
        8.0 => "an eighth",
        10.0 => "a tenth",
        other => return format!("1/{other}"),
    };
    name.to_owned()
}

/// A number with two digits, in the notation of the book's formulas.
pub fn in_a_formula(number: f64) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{number:.1e}");
    match text.split_once('e') {
        _ if (0.1..1000.0).contains(&number) => {
            let rounded: f64 = text.parse().unwrap_or(number);
            format!("{rounded}")
        }
        Some((mantissa, power)) => format!(r"${mantissa} \cdot 10^{{{power}}}$"),
        None => text,
    }
}

/// A fraction in per cent with two digits.
pub fn percent(fraction: f64) -> String {
    if fraction == 0.0 {
        return "0".to_owned();
    }
    let percent: f64 = format!("{:.1e}", 100.0 * fraction)
        .parse()
        .unwrap_or_default();
    if percent < 1e-3 {
        return format!("{} %", in_a_formula(percent));
    }
    format!("{percent} %")
}

/// A count with three digits, in groups of three.
pub fn count(number: f64) -> String {
    let rounded: f64 = format!("{number:.2e}").parse().unwrap_or(number);
    let digits = format!(
        "{:.0}",
        if number < 100.0 {
            libm::round(number)
        } else {
            rounded
        }
    );
    let mut grouped = String::new();
    for (n, digit) in digits.chars().enumerate() {
        if n > 0 && (digits.len() - n) % 3 == 0 && digits.len() > 4 {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped
}

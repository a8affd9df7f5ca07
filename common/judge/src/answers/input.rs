//! `Input`: the arguments of a question, which are read from a line, moved and shown.

use std::str::{FromStr, Split, SplitWhitespace};

use common::{Color, Sampling};

/// The zeros at the end of nine decimals by which a number seems to be a shorter one.
const ZEROS: usize = 3;

/// Some roundings: 254.17999999999998 is shown as 254.18.
const ROUNDING: f64 = 1e-15;

/// The arguments that a line still has, with `|` between them.
pub type Arguments<'t> = Split<'t, char>;

/// An argument of the code that is asked, or a tuple of all arguments.
pub trait Input: Clone {
    /// Calls a function with each number that may be moved.
    fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64));

    /// The argument in words; of a tuple, those of each.
    fn words(&self) -> Vec<String>;

    /// Takes it from an argument of a line, of which it may be a part, such as a number of a list.
    #[must_use]
    fn read_part(_: &mut SplitWhitespace) -> Option<Self> {
        None
    }

    /// Takes the next argument of a line, which is this and nothing else; of a tuple, one for each.
    #[must_use]
    fn read(arguments: &mut Arguments) -> Option<Self> {
        let mut parts = arguments.next()?.split_whitespace();
        let argument = Self::read_part(&mut parts)?;
        parts.next().is_none().then_some(argument)
    }

    /// The numbers that may be moved.
    fn numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.clone()
            .for_each_number(&mut |number| numbers.push(*number));
        numbers
    }

    /// This input with other numbers.
    #[must_use]
    fn with_numbers(mut self, numbers: &[f64]) -> Self {
        let mut numbers = numbers.iter();
        self.for_each_number(&mut |number| *number = numbers.next().copied().unwrap_or(*number));
        self
    }
}

impl Input for f64 {
    fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
        f(self);
    }

    fn words(&self) -> Vec<String> {
        vec![readable(*self)]
    }

    fn read_part(parts: &mut SplitWhitespace) -> Option<Self> {
        word(parts)
    }
}

impl Input for Color {
    fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
        for channel in [&mut self.r, &mut self.g, &mut self.b] {
            f(channel);
        }
    }

    fn words(&self) -> Vec<String> {
        self.channels().words()
    }

    fn read_part(parts: &mut SplitWhitespace) -> Option<Self> {
        let [r, g, b] = Input::read_part(parts)?;
        Some(Self::new(r, g, b))
    }
}

/// A number with as many digits as a reader needs to follow it, or with all if it lies just beside a shorter
/// one: of 1.000000000001, only they say that it is outside of a sphere of radius 1.
pub(crate) fn readable(number: f64) -> String {
    // Without the sign of -0.
    let number = number + 0.0;
    let exact = format!("{number:?}");
    if exact.len() < 12 {
        return exact.trim_end_matches(".0").to_owned();
    }
    let (digits, exponent) = if (1e-3..1e6).contains(&number.abs()) {
        (format!("{number:.9}"), String::new())
    } else {
        let text = format!("{number:.9e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        (digits.to_owned(), format!("e{exponent}"))
    };
    let significant = digits.trim_end_matches('0').trim_end_matches('.');
    let short = format!("{significant}{exponent}");
    let is_rounded = digits.len() - significant.len() >= ZEROS;
    let is_equal = |short: f64| (short - number).abs() <= ROUNDING * number.abs();
    if is_rounded && !short.parse().is_ok_and(is_equal) {
        exact
    } else {
        short
    }
}

macro_rules! lists {
    ($($list:ty, $($n:ident)?, $most:expr;)+) => { $(
        impl<T: Input $(, const $n: usize)?> Input for $list {
            fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
                for item in self.iter_mut() {
                    item.for_each_number(f);
                }
            }

            fn words(&self) -> Vec<String> {
                let items: Vec<_> = self.iter().flat_map(Input::words).collect();
                vec![format!("[{}]", items.join(", "))]
            }

            fn read_part(parts: &mut SplitWhitespace) -> Option<Self> {
                let mut items = Vec::new();
                while items.len() < $most && parts.clone().next().is_some() {
                    items.push(T::read_part(parts)?);
                }
                items.try_into().ok()
            }
        }
    )+ };
}

lists! { [T; N], N, N; Vec<T>, , usize::MAX; }

/// Makes a struct an [`Input`], by its fields in the order of the question: `input! { Lamp: color, place }`.
#[macro_export]
macro_rules! input {
    ($name:ident: $($field:ident),+) => {
        impl $crate::answers::Input for $name {
            fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
                $(self.$field.for_each_number(f);)+
            }

            fn words(&self) -> Vec<String> {
                [$(self.$field.words()),+].concat()
            }

            fn read(arguments: &mut $crate::answers::Arguments) -> Option<Self> {
                Some(Self { $($field: $crate::answers::Input::read(arguments)?),+ })
            }
        }
    };
}

/// Arguments that are not moved.
macro_rules! fixed {
    ($($read:ident: $($fixed:ty)+;)+) => { $($(
        impl Input for $fixed {
            fn for_each_number(&mut self, _: &mut dyn FnMut(&mut f64)) {}

            fn words(&self) -> Vec<String> {
                vec![format!("{self:?}")]
            }

            fn read_part(parts: &mut SplitWhitespace) -> Option<Self> {
                $read(parts)
            }
        }
    )+)+ };
}

fixed! { word: bool u8 u32 i32 u64 usize; sampling: Sampling; }

/// A text, in quotes if it begins or ends with a space, or has several lines.
impl Input for String {
    fn for_each_number(&mut self, _: &mut dyn FnMut(&mut f64)) {}

    fn words(&self) -> Vec<String> {
        vec![format!("{self:?}")]
    }

    fn read(arguments: &mut Arguments) -> Option<Self> {
        let mut text = arguments.next()?.trim();
        take_quoted(&mut text).or_else(|| Some(text.to_owned()))
    }
}

/// Takes words in quotes from the beginning of a text.
pub fn take_quoted(text: &mut &str) -> Option<String> {
    let mut words = String::new();
    let mut letters = text.strip_prefix('"')?.chars();
    loop {
        match letters.next()? {
            '"' => break,
            '\\' => words.push(match letters.next()? {
                'n' => '\n',
                'r' => '\r',
                't' => '\t',
                escaped => escaped,
            }),
            letter => words.push(letter),
        }
    }
    *text = letters.as_str();
    Some(words)
}

fn word<T: FromStr>(parts: &mut SplitWhitespace) -> Option<T> {
    // A comma may stand between the items of a list.
    parts.next()?.trim_end_matches(',').parse().ok()
}

fn sampling(parts: &mut SplitWhitespace) -> Option<Sampling> {
    let name: String = word(parts)?;
    let mut all = Sampling::ALL.into_iter();
    all.find(|sampling| format!("{sampling:?}") == name)
}

macro_rules! tuples {
    ($($($item:ident)+;)+) => { $(
        #[allow(non_snake_case, reason = "an item has the name of its type")]
        impl<$($item: Input),+> Input for ($($item,)+) {
            fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
                let ($($item,)+) = self;
                $($item.for_each_number(f);)+
            }

            fn words(&self) -> Vec<String> {
                let ($($item,)+) = self;
                [$($item.words()),+].concat()
            }

            fn read(arguments: &mut Arguments) -> Option<Self> {
                Some(($($item::read(arguments)?,)+))
            }
        }
    )+ };
}

tuples! { A B; A B C; A B C D; A B C D E; A B C D E F; A B C D E F G; }

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn a_number_is_told_from_a_shorter_one_beside_it() {
        assert_eq!(readable(2.0), "2");
        assert_eq!(readable(2.000_000_000_001), "2.000000000001");
        assert_eq!(readable(10.000_000_000_000_2), "10.0000000000002");
        assert_eq!(readable(1.000_000_000_01e-7), "1.00000000001e-7");
        assert_eq!(readable(254.179_999_999_999_98), "254.18");
        assert_eq!(readable(1.0 / 3.0), "0.333333333");
        assert_eq!(readable(-0.0), "0");
    }
}

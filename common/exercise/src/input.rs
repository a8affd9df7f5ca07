//! `Input`: the arguments of a question, whose numbers can be moved and shown.

use common::{Color, Sampling};

/// An argument of the code that is asked, or a tuple of all arguments.
pub trait Input: Clone {
    /// Calls a function with each number that may be moved.
    fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64));

    /// The argument in words; of a tuple, those of each.
    fn words(&self) -> Vec<String>;

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
        vec![shown(*self)]
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
}

/// A number with as many digits as a reader needs to follow it.
pub(crate) fn shown(number: f64) -> String {
    // Without the sign of -0.
    let exact = format!("{:?}", number + 0.0);
    match number.abs() {
        _ if exact.len() < 12 => exact.trim_end_matches(".0").to_owned(),
        1e-3..1e6 => format!("{number:.9}")
            .trim_end_matches(['0', '.'])
            .to_owned(),
        _ => {
            let text = format!("{number:.9e}");
            let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            format!("{}e{exponent}", digits.trim_end_matches(['0', '.']))
        }
    }
}

macro_rules! lists {
    ($($list:ty, $($n:ident)?;)+) => { $(
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
        }
    )+ };
}

lists! { [T; N], N; Vec<T>, ; }

/// Makes a struct an [`Input`], by its fields in the order of the question: `input! { Lamp: color, place }`.
#[macro_export]
macro_rules! input {
    ($name:ident: $($field:ident),+) => {
        impl $crate::Input for $name {
            fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
                $(self.$field.for_each_number(f);)+
            }

            fn words(&self) -> Vec<String> {
                [$(self.$field.words()),+].concat()
            }
        }
    };
}

/// Arguments that are not moved.
macro_rules! fixed {
    ($($fixed:ty)+) => { $(
        impl Input for $fixed {
            fn for_each_number(&mut self, _: &mut dyn FnMut(&mut f64)) {}

            fn words(&self) -> Vec<String> {
                vec![format!("{self:?}")]
            }
        }
    )+ };
}

fixed! { Sampling bool u8 u32 i32 u64 usize &'static str String }

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
        }
    )+ };
}

tuples! { A B; A B C; A B C D; A B C D E; A B C D E F; A B C D E F G; }

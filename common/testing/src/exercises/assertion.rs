//! The messages of `assert_eq!` in examples.

/// The message of a panic; that of `assert_eq!(yours, right)` in the words of the checks.
pub fn assertion_words(message: &str) -> String {
    let in_words = || {
        let rest = message.strip_prefix("assertion `left == right` failed")?;
        let (about, values) = rest.split_once("\n  left: ")?;
        let (yours, right) = values.split_once("\n right: ")?;
        let about = about.strip_prefix(": ").unwrap_or("an example fails");
        Some(format!("{about}:\n    must be {right}; yours is {yours}"))
    };
    in_words().unwrap_or_else(|| message.to_owned())
}

#[cfg(test)]
mod tests {
    use std::panic::catch_unwind;

    use super::*;

    #[test]
    fn values_of_an_assertion_are_yours_and_the_right_one() {
        // The messages of the standard library.
        let words = |assertion: fn()| {
            let payload = catch_unwind(assertion).unwrap_err();
            assertion_words(payload.downcast_ref::<String>().unwrap())
        };
        assert_eq!(
            words(|| assert_eq!(1 + 1, 3, "the sum of {} numbers", 2)),
            "the sum of 2 numbers:\n    must be 3; yours is 2"
        );
        assert_eq!(
            words(|| assert_eq!([1], [2])),
            "an example fails:\n    must be [2]; yours is [1]"
        );
    }
}

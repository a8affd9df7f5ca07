//! `is_rounding`: rounding is no mistake in an `assert_eq!` that students write, or kept from an earlier
//! starter.

/// The values in the message of `assert_eq!(yours, right)`; none of another panic.
fn values(message: &str) -> Option<[&str; 2]> {
    let rest = message.strip_prefix("assertion `left == right` failed")?;
    let (_, values) = rest.split_once("\n  left: ")?;
    Some(values.split_once("\n right: ")?.into())
}

/// Whether the numbers that an assertion finds different are equal but for rounding, which is no
/// mistake.
pub fn is_rounding(message: &str) -> bool {
    let Some([yours, right]) = values(message) else {
        return false;
    };
    let ((words, yours), (other_words, right)) = (parts(yours), parts(right));
    let largest = right.iter().fold(1e-3, |a: f64, b| a.max(b.abs()));
    let mut pairs = yours.iter().zip(&right);
    words == other_words
        && yours.len() == right.len()
        && pairs.all(|(a, b)| (a - b).abs() <= 1e-9 * largest)
}

/// The words of a value, and its numbers.
fn parts(value: &str) -> (String, Vec<f64>) {
    let (mut words, mut numbers) = (String::new(), Vec::new());
    for part in value.split(|c: char| " ,:()[]{}".contains(c)) {
        match part.parse() {
            Ok(number) => numbers.push(number),
            Err(_) => words += part,
        }
    }
    (words, numbers)
}

#[cfg(test)]
mod tests {
    use std::panic::catch_unwind;

    use super::*;

    /// The message of the standard library for these values.
    fn message_of(assertion: fn()) -> String {
        let payload = catch_unwind(assertion).unwrap_err();
        match payload.downcast::<String>() {
            Ok(message) => *message,
            Err(payload) => (*payload.downcast_ref::<&str>().unwrap()).to_owned(),
        }
    }

    #[test]
    fn rounding_is_no_mistake() {
        let is_rounding = |assertion| is_rounding(&message_of(assertion));
        assert!(is_rounding(|| assert_eq!([1e-33, 0.5], [0.0, 0.5])));
        assert!(is_rounding(|| assert_eq!(Some(0.1 + 0.2), Some(0.3))));
        assert!(!is_rounding(|| assert_eq!(Some(0.1), Some(0.3))));
        assert!(!is_rounding(|| assert_eq!(Some(0.1), None)));
        assert!(!is_rounding(|| panic!("1")));
    }
}

//! `numbers`: reads a number, a list of numbers, or a list of such lists.

use toml::de::DeValue;

use crate::Form;

/// Finite numbers in this form, from 1 if they are whole; none if the value has another form.
pub fn numbers(value: &DeValue, form: &Form) -> Option<Vec<f64>> {
    let mut numbers = Vec::new();
    add_numbers(value, form.lengths()?, &mut numbers)?;
    let is_whole = |n: &f64| n.fract() == 0.0 && (1.0..=f64::from(u32::MAX)).contains(n);
    let is_right = !form.is_whole() || numbers.iter().all(is_whole);
    is_right.then_some(numbers)
}

/// Adds the numbers of a value, whose lists have these lengths, the outermost first.
fn add_numbers(value: &DeValue, lengths: &[usize], numbers: &mut Vec<f64>) -> Option<()> {
    let number: f64 = match (value, lengths) {
        (DeValue::Array(rows), [length, lengths @ ..]) if rows.len() == *length => {
            let mut rows = rows.iter();
            return rows.try_for_each(|row| add_numbers(row.get_ref(), lengths, numbers));
        }
        (DeValue::Float(number), []) => number.as_str().parse().ok()?,
        (DeValue::Integer(number), []) => {
            i128::from_str_radix(number.as_str(), number.radix()).ok()? as f64
        }
        _ => return None,
    };
    number.is_finite().then(|| numbers.push(number))
}

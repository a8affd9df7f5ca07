//! `numbers`: reads a number, a list of numbers, or a list of such lists.

use toml::de::DeValue;

/// Finite numbers in a form such as `3 x 4 numbers`, or from 1 in one such as `2 whole numbers`;
/// none if the value has another form.
pub fn numbers(value: &DeValue, form: &str) -> Option<Vec<f64>> {
    let words = form.split_at(form.find("number")?).0.split_whitespace();
    let lengths: Vec<_> = words.filter_map(|word| word.parse().ok()).collect();
    let mut numbers = Vec::new();
    add_numbers(value, &lengths, &mut numbers)?;
    let is_whole = |n: &f64| n.fract() == 0.0 && (1.0..=f64::from(u32::MAX)).contains(n);
    let is_right = !form.contains("whole") || numbers.iter().all(is_whole);
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

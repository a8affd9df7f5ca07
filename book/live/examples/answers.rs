//! Answers requests of figures natively, for the test in a browser: each line of the
//! input is a figure and its numbers, each line of the output the answer's lists.

use std::io::{self, BufRead};

fn main() -> io::Result<()> {
    for line in io::stdin().lock().lines() {
        let line = line?;
        let mut words = line.split_whitespace();
        let figure = words.next().unwrap_or_default();
        let numbers: Vec<f64> = words.filter_map(|word| word.parse().ok()).collect();
        match live::call(figure, &numbers) {
            Ok(answer) => {
                let lists = answer.numbers.iter().map(|(name, numbers)| {
                    let numbers: Vec<_> = numbers.iter().map(f64::to_string).collect();
                    format!("{name}={}", numbers.join(","))
                });
                println!("{}", lists.collect::<Vec<_>>().join(" "));
            }
            Err(error) => println!("error: {error}"),
        }
    }
    Ok(())
}

//! Answers requests of figures natively, for the test in a browser: each line of the
//! input is a request, such as a figure, and its numbers, each line of the output the answer's lists.

use std::io::{self, BufRead};

fn main() -> io::Result<()> {
    for line in io::stdin().lock().lines() {
        let line = line?;
        let words: Vec<_> = line.split_whitespace().collect();
        let is_number = |word: &&str| word.parse::<f64>().is_ok();
        let request = words.iter().position(is_number).unwrap_or(words.len());
        let (request, numbers) = words.split_at(request);
        let numbers: Vec<f64> = numbers
            .iter()
            .filter_map(|word| word.parse().ok())
            .collect();
        match live::call(&request.join(" "), &numbers) {
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

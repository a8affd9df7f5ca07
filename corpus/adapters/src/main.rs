//! Asks formulas and libraries in Rust the cases of the corpus, and writes what they find.
//!
//! `cargo run --release --manifest-path corpus/adapters/Cargo.toml` writes `corpus/results/NAME.txt` for each.

mod bvh;
mod engine;
mod lesson;
mod moeller_trumbore;
mod parry;
mod protocol;
mod single;
mod woop_compensated;

use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

use corpus::{Found, Question, SINGLE_CASES};

/// Something that can be asked.
struct Adapter {
    /// The name of the file of its results.
    name: &'static str,
    /// Its version and options, for the table.
    title: &'static str,
    /// The cases that it is asked: those in doubles, or those in single precision.
    cases: &'static str,
    /// What it finds; none if it has no such shape, or its documentation excludes the question.
    ask: fn(&Question) -> Option<Found>,
}

fn main() -> io::Result<()> {
    let adapters = [
        lesson::ADAPTER,
        engine::ADAPTER,
        protocol::ADAPTER,
        single::ADAPTER,
        moeller_trumbore::ADAPTER,
        woop_compensated::ADAPTER,
        parry::ADAPTER,
        bvh::ADAPTER,
    ];
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results");
    fs::create_dir_all(&folder)?;
    for adapter in adapters {
        let is_single = adapter.cases == SINGLE_CASES;
        let precision = if is_single { "single" } else { "double" };
        let mut text = format!("# {}\n# {precision}\n", adapter.title);
        let cases = corpus::read(adapter.cases).map_err(io::Error::other)?;
        for case in cases {
            // A `String` takes all.
            let _ = match (adapter.ask)(&case.question) {
                None => Ok(()),
                Some(None) => writeln!(text, "{} miss", case.question.id),
                Some(Some(t)) => writeln!(text, "{} {t:?}", case.question.id),
            };
        }
        fs::write(folder.join(adapter.name).with_extension("txt"), text)?;
    }
    Ok(())
}

/// Each triangle's nearest answer.
fn nearest(found: impl IntoIterator<Item = Found>) -> Found {
    found
        .into_iter()
        .flatten()
        .reduce(|a, b| if b < a { b } else { a })
}

/// An answer within the interval of a question, for what has no interval itself.
fn within(question: &Question, found: Found) -> Found {
    let [min, max] = question.within;
    found.filter(|t| t.is_nan() || (min < *t && *t < max))
}

//! `cargo book`: builds the book into `target/book`.
//!
//! 1. mdBook is installed below `target/`, if it is missing (`mdbook`), and so is the target of a
//!    browser, by rustup.
//! 2. Lists of the files of each stage are written for the chapters (`changes`), and tables of the
//!    exercises (`exercises`).
//! 3. The stages become a WebAssembly module, by which the pictures of the pages are live
//!    (`live_module`, `yours`).
//! 4. mdBook builds the pages (`pages`); before, it calls this program to fill in recorded
//!    figures and to mark formulas (`preprocess`). A warning is an error.

mod changes;
mod command;
mod exercises;
mod file;
mod formulas;
mod live_module;
mod locks;
mod mdbook;
mod pages;
mod preprocess;
mod recorded;
mod yours;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use live_module::LiveModule;

/// Builds the book into `target/book`: static files, for any web server.
#[derive(Parser)]
#[command(name = "cargo book", bin_name = "cargo book", version)]
struct Arguments {
    /// Shows the book in a browser.
    #[arg(long)]
    open: bool,
    /// Shows pictures by this exercise of the reader's beside those of the lesson, such as
    /// `a04-intersections/sphere`.
    #[arg(long, value_name = "STAGE/EXERCISE", value_parser = yours::parse, num_args = 1..)]
    yours: Vec<yours::Exercise>,
    #[command(subcommand)]
    command: Option<Task>,
}

#[derive(Subcommand)]
enum Task {
    /// Measures the experiments of all stages, for the figures and plots of the book.
    Record {
        /// Measures nothing: says which quotients of times have another sign in this recording, of
        /// another machine or day.
        #[arg(long, value_name = "OTHER.csv")]
        compare: Option<PathBuf>,
    },
    /// Changes the pages for mdBook.
    // clap would propose its name for a misspelt `record`.
    #[command(hide = true, name = "mdbook")]
    Preprocess {
        /// The words by which mdBook asks whether its kind of output is served.
        words: Vec<String>,
    },
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    // The paths of this program begin in the root of the repository.
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    std::env::set_current_dir(root).map_err(file::with_path(root.as_ref()))?;
    match &arguments.command {
        Some(Task::Record { compare: None }) => return recorded::record(),
        Some(Task::Record {
            compare: Some(other),
        }) => return recorded::compare(other),
        // All kinds of output are served.
        Some(Task::Preprocess { words }) if !words.is_empty() => return Ok(()),
        Some(Task::Preprocess { .. }) => return preprocess::run(),
        _ => {}
    }
    build(&arguments.yours)?;
    println!("open {}/index.html", pages::FOLDER);
    if arguments.open {
        pages::open()?;
    }
    Ok(())
}

fn build(yours: &[yours::Exercise]) -> Result<(), String> {
    changes::write()?;
    exercises::write()?;
    // mdBook takes a minute of one core, and the module another.
    let module = std::thread::scope(|scope| {
        let installed = scope.spawn(mdbook::install);
        let module = LiveModule::build(yours);
        let outcome = installed
            .join()
            .map_err(|_| "the installation panicked".to_owned());
        outcome??;
        module
    })?;
    pages::build(module.as_ref())
}

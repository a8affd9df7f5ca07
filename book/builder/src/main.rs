//! `cargo book`: builds the book into `target/book`, and checks it.
//!
//! 1. The programs that it needs are installed below `target/`, if they are missing (`tools`), and so
//!    is the target of a browser, by rustup.
//! 2. Lists of the files of each stage are written for the chapters (`changes`), and tables of the
//!    exercises (`exercises`).
//! 3. The stages become a WebAssembly module, by which the pictures of the pages are live
//!    (`live_module`, `yours`).
//! 4. mdBook builds the pages (`pages`); before, it calls this program to fill in recorded
//!    figures (`recorded`).
//! 5. A warning or a file from the network is an error (`pages`, `network`).

mod changes;
mod command;
mod exercises;
mod file;
mod live_module;
mod locks;
mod network;
mod pages;
mod pdf;
mod publish;
mod recorded;
mod tools;
mod yours;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use live_module::LiveModule;

/// Builds the book into `target/book`, and checks it.
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
    /// Builds the book and leaves it in a folder as static files, for any web server.
    Publish {
        /// The folder. A book that lies there already is replaced.
        folder: PathBuf,
    },
    /// Builds the book and prints it into a PDF file, by Chromium or Chrome.
    Pdf {
        /// The file.
        file: PathBuf,
    },
    /// Measures the experiments of all stages, for the figures and plots of the book.
    Record,
    /// Fills in recorded figures for mdBook.
    #[command(hide = true)]
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
    // Paths of the command line begin where the reader is.
    let mut destination = None;
    let mut document = None;
    match &arguments.command {
        Some(Task::Publish { folder }) => destination = Some(publish::Destination::new(folder)?),
        Some(Task::Pdf { file }) => document = Some(file::absolute(file)?),
        _ => {}
    }
    std::env::set_current_dir(root).map_err(file::with_path(root.as_ref()))?;
    match &arguments.command {
        Some(Task::Record) => return recorded::record(),
        // All kinds of output are served.
        Some(Task::Preprocess { words }) if !words.is_empty() => return Ok(()),
        Some(Task::Preprocess { .. }) => return recorded::preprocess(),
        _ => {}
    }
    build(&arguments.yours)?;

    if let Some(destination) = destination {
        destination.publish()
    } else if let Some(document) = document {
        pdf::write(&document)
    } else {
        println!("open {}/index.html", pages::FOLDER);
        if arguments.open {
            pages::open()?;
        }
        Ok(())
    }
}

fn build(yours: &[yours::Exercise]) -> Result<(), String> {
    changes::write()?;
    exercises::write()?;
    // The programs take a minute of one core, and the module another.
    let module = std::thread::scope(|scope| {
        let tools = scope.spawn(tools::install);
        let module = LiveModule::build(yours);
        let outcome = tools
            .join()
            .map_err(|_| "the installation panicked".to_owned());
        outcome??;
        module
    })?;
    pages::build(module.as_ref())?;
    network::check()
}

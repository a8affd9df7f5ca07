//! The pages, by mdBook.

use std::path::Path;
use std::process::Command;

use crate::command::{not_started, run};
use crate::live_module::LiveModule;
use crate::{file, mdbook};

/// Where the pages are.
pub const FOLDER: &str = "target/book";

/// Builds the pages. A warning of mdBook is an error.
pub fn build(module: Option<&LiveModule>) -> Result<(), String> {
    let mut mdbook = command(module)?;
    let output = mdbook
        .output()
        .map_err(|error| not_started(&mdbook, &error))?;
    let log = String::from_utf8_lossy(&output.stderr);
    eprint!("{log}");
    if !output.status.success() {
        return Err(format!("mdbook ended with {}", output.status));
    }
    if log.lines().any(is_warning) {
        return Err("the book has warnings".to_owned());
    }
    copy_scripts(module)
}

/// Shows the pages in a browser.
pub fn open() -> Result<(), String> {
    let page = format!("{FOLDER}/index.html");
    if cfg!(target_os = "windows") {
        let mut explorer = Command::new("explorer");
        explorer.arg(page.replace('/', "\\"));
        // Its status is 1 also if it has shown the page.
        let outcome = explorer.status();
        return outcome
            .map(|_| ())
            .map_err(|error| not_started(&explorer, &error));
    }
    let program = if cfg!(target_os = "macos") {
        "open"
    } else {
        "xdg-open"
    };
    run(Command::new(program).arg(page))
}

fn command(module: Option<&LiveModule>) -> Result<Command, String> {
    let mut mdbook = mdbook::command();
    mdbook.args(["build", "book"]);
    let this = std::env::current_exe().map_err(|error| error.to_string())?;
    let preprocessor = format!("'{}' mdbook", this.display());
    mdbook.env("MDBOOK_PREPROCESSOR__BUILDER__COMMAND", preprocessor);
    if module.is_some() {
        let scripts =
            r#"["katex/katex.min.js", "formulas.js", "generated/live.js", "fold.js", "access.js"]"#;
        mdbook.env("MDBOOK_OUTPUT__HTML__ADDITIONAL_JS", scripts);
    }
    Ok(mdbook)
}

/// Whether a line of mdBook's log is about a fault.
fn is_warning(line: &str) -> bool {
    let mut words = line.split(|letter: char| !letter.is_alphanumeric());
    words.any(|word| word == "WARN" || word == "ERROR")
}

fn copy_scripts(module: Option<&LiveModule>) -> Result<(), String> {
    let Some(module) = module else {
        return Ok(());
    };
    for script in &module.scripts {
        let name = script.file_name().unwrap_or_default();
        file::copy(script, &Path::new(FOLDER).join("generated").join(name))?;
    }
    Ok(())
}

//! `cargo book pdf FILE`: the book as a document, printed by a browser. mdBook makes one page of all
//! chapters for the purpose.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{command, file, pages};

/// Browsers that print without a window, by the names of their programs.
const BROWSERS: [&str; 7] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "chrome",
    "msedge",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
];

/// The call by which the page opens the dialog of the printer.
const DIALOG: &str = "window.setTimeout(window.print, 100);";

/// Writes the built book into a file.
pub fn write(document: &Path) -> Result<(), String> {
    let folder = Path::new(pages::FOLDER);
    let page = file::read(&folder.join("print.html"))?.replace(DIALOG, "");
    let path = folder.join("document.html");
    file::write(&path, &page)?;
    let outcome = print(&path, document);
    // It is no page of the book.
    let _ = fs::remove_file(&path);
    outcome
}

fn print(page: &Path, document: &Path) -> Result<(), String> {
    let page = file::absolute(page)?;
    // An old document would hide that no new one is written.
    if document.exists() {
        fs::remove_file(document).map_err(file::with_path(document))?;
    }
    let mut browser = Command::new(find_browser()?);
    // The page is our own, and as root, in a container, a browser has no sandbox.
    browser.args([
        "--headless",
        "--disable-gpu",
        "--no-sandbox",
        "--no-pdf-header-footer",
    ]);
    // The time of the page, in milliseconds, in which its pictures are loaded.
    browser.arg("--virtual-time-budget=30000");
    browser.arg(format!("--print-to-pdf={}", document.display()));
    browser.arg(format!("file://{}", page.display()));
    command::output(&mut browser)?;
    if !document.is_file() {
        return Err(format!("the browser has written no {}", document.display()));
    }
    println!("written: {}", document.display());
    Ok(())
}

fn find_browser() -> Result<PathBuf, String> {
    let works = |name: &&&str| command::output(Command::new(name).arg("--version")).is_ok();
    let browser = BROWSERS.iter().find(works).map(PathBuf::from);
    browser.ok_or_else(|| {
        "a PDF needs Chromium or Chrome. Another browser prints the page of `cargo book --open` \
         that the symbol of a printer shows"
            .to_owned()
    })
}

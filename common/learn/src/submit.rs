//! `submit`: packs the student's files into one zip file, with the versions of the tools.

use std::fs;
use std::io::{self, Cursor, Write};
use std::process::Command;

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::exercise::Exercise;
use crate::files::{self, failed};
use crate::progress;

/// Packs your files into NAME.zip, which you hand in
#[derive(clap::Args)]
pub struct Submit {
    /// Your name, in letters, digits, - and _
    #[arg(value_name = "NAME")]
    name: String,
}

impl Submit {
    /// Writes the zip file, and returns what is in it.
    pub fn run(self, course: &[Exercise]) -> Result<String, String> {
        let name = self.name;
        let is_plain = |c: char| c.is_alphanumeric() || ['-', '_'].contains(&c);
        if name.is_empty() || !name.chars().all(is_plain) {
            return Err(format!("\"{name}\" is no name of letters, digits, - and _"));
        }
        let begun: Vec<_> = course.iter().filter(|e| files::is_begun(e)).collect();
        if begun.is_empty() {
            return Err("no exercise is begun; `cargo learn` shows the first".to_owned());
        }
        let path = format!("{name}.zip");
        let written = packed(&begun).and_then(|bytes| fs::write(&path, bytes));
        written.map_err(failed(path.as_ref()))?;
        let done = begun.iter().filter(|e| progress::is_done(e)).count();
        let count = begun.len();
        Ok(format!("{path}: {count} files, {done} of them done"))
    }
}

/// The zip file: the student's files, and the results of the last checks.
fn packed(begun: &[&Exercise]) -> io::Result<Vec<u8>> {
    let rustc = Command::new("rustc").arg("--version").output();
    let rustc = rustc.map_or(Vec::new(), |said| said.stdout);
    let mut results = concat!("learn ", env!("CARGO_PKG_VERSION"), "\n").to_owned();
    results += &String::from_utf8_lossy(&rustc);
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let mut add = |name: &str, bytes: &[u8]| {
        zip.start_file(name, SimpleFileOptions::default())?;
        zip.write_all(bytes)
    };
    for e in begun {
        let yours = files::yours(e);
        if yours.is_symlink() {
            let problem = format!("{} is a link; hand in the file itself", yours.display());
            return Err(io::Error::other(problem));
        }
        let name = format!("{}/exercises/{}.rs", e.stage, e.name);
        let bytes = fs::read(&yours).map_err(|error| io::Error::other(failed(&yours)(error)))?;
        add(&name, &bytes)?;
        results += &[e.name, " ", progress::mark(e), "\n"].concat();
    }
    add("results.txt", results.as_bytes())?;
    Ok(zip.finish()?.into_inner())
}

//! `submit`: packs the student's files into one zip file.

use std::fs::{self, File};
use std::io::{self, Cursor, Write};
use std::path::Path;

use common::text;
use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

use crate::exercise::Exercise;
use crate::files::{self, with_path};
use crate::progress::Progress;

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
            let name = text::name(&name);
            return Err(format!("\"{name}\" is no name of letters, digits, - and _"));
        }
        let begun: Vec<_> = course.iter().filter(|e| files::is_begun(e)).collect();
        if begun.is_empty() {
            return Err("no exercise is begun; `cargo learn` shows the first".to_owned());
        }
        let path = format!("{name}.zip");
        if !is_replaced(path.as_ref()) {
            return Err(format!(
                "{path} has other files than exercises; move it, or submit by another name"
            ));
        }
        let bytes = pack(&begun)?;
        fs::write(&path, bytes).map_err(with_path(path.as_ref()))?;
        let progress = Progress::read();
        let done = begun.iter().filter(|e| progress.is_done(e)).count();
        let count = begun.len();
        Ok(format!("{path}: {count} files, {done} of them done"))
    }
}

/// Whether a file may be written anew: it is missing, or has nothing but exercises, as an earlier one has.
fn is_replaced(path: &Path) -> bool {
    let Ok(file) = File::open(path) else {
        return !path.exists();
    };
    ZipArchive::new(file).is_ok_and(|zip| {
        zip.file_names()
            .flatten()
            .all(|name| name.contains("/exercises/"))
    })
}

/// The bytes of the zip file.
fn pack(begun: &[&Exercise]) -> Result<Vec<u8>, String> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for e in begun {
        let yours = files::yours(e);
        if yours.is_symlink() {
            let path = text::path(&yours);
            return Err(format!("{path} is a link; hand in the file itself"));
        }
        let name = format!("{}/exercises/{}.rs", e.stage, e.name);
        let text = files::text_of(&yours)?;
        let with_name = |error: io::Error| format!("{name}: {error}");
        let started = zip.start_file(&*name, SimpleFileOptions::default());
        started.map_err(|error| with_name(error.into()))?;
        zip.write_all(text.as_bytes()).map_err(with_name)?;
    }
    let zip = zip.finish().map_err(|error| error.to_string())?;
    Ok(zip.into_inner())
}

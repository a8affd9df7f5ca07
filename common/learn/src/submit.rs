//! `submit`: packs the student's files into one zip file.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

use common::text;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use rawzip::time::UtcDateTime;
use rawzip::{CompressionMethod, ZipArchive, ZipArchiveWriter};

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
                "{path} is a broken link, or has other files than exercises; move it, or submit by another name"
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
    let Ok(bytes) = fs::read(path) else {
        return !path.exists() && !path.is_symlink();
    };
    let is_exercise = |name: &[u8]| String::from_utf8_lossy(name).contains("/exercises/");
    ZipArchive::from_slice(&bytes).is_ok_and(|zip| {
        zip.entries()
            .all(|entry| entry.is_ok_and(|entry| is_exercise(entry.file_path().as_ref())))
    })
}

/// The bytes of the zip file.
fn pack(begun: &[&Exercise]) -> Result<Vec<u8>, String> {
    let mut zip = ZipArchiveWriter::new(Vec::new());
    for e in begun {
        let yours = files::yours(e);
        if yours.is_symlink() {
            let path = text::path(&yours);
            return Err(format!("{path} is a link; hand in the file itself"));
        }
        let name = format!("{}/exercises/{}.rs", e.stage, e.name);
        let text = files::text_of(&yours)?;
        add(&mut zip, &name, text.as_bytes()).map_err(|error| format!("{name}: {error}"))?;
    }
    zip.finish().map_err(|error| error.to_string())
}

/// Adds a file.
fn add(zip: &mut ZipArchiveWriter<Vec<u8>>, name: &str, bytes: &[u8]) -> Result<(), rawzip::Error> {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    let now = UtcDateTime::from_unix(now.map_or(0, |now| now.as_secs() as i64));
    let file = zip.new_file(name).last_modified(now);
    let (mut entry, config) = file
        .compression_method(CompressionMethod::DEFLATE)
        .start()?;
    let mut file = config.wrap(DeflateEncoder::new(&mut entry, Compression::default()));
    file.write_all(bytes)?;
    let (encoder, descriptor) = file.finish()?;
    encoder.finish()?;
    entry.finish(descriptor)?;
    Ok(())
}

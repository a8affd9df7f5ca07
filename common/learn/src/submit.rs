//! `submit`: packs the student's files into one zip file.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use common::text;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use rawzip::time::UtcDateTime;
use rawzip::{CompressionMethod, ZipArchive, ZipArchiveWriter};

use crate::exercise::Exercise;
use crate::files::{self, with_path};
use crate::progress::Progress;
use crate::student_file;

/// What systems, tools and Cargo add to a folder, and no student.
const ADDED: [&str; 7] = [
    "__MACOSX",
    ".DS_Store",
    "Thumbs.db",
    "desktop.ini",
    ".git",
    ".learn",
    "target",
];

/// The file that names the open sheets of a program.
pub const SHEETS: &str = "sheet.txt";

const LINK: &str = "is a link; hand in the file itself";

/// Packs your files into NAME.zip, which you hand in
#[derive(clap::Args)]
pub struct Submit {
    /// Your name, in letters, digits, - and _
    #[arg(value_name = "NAME")]
    name: String,
    /// The folder of your own program, which is packed, too, for the sheets that its sheet.txt names
    program: Option<PathBuf>,
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
        let begun: Vec<_> = course
            .iter()
            .filter(|e| student_file::is_begun(e))
            .collect();
        if begun.is_empty() && self.program.is_none() {
            return Err("no exercise is begun; `cargo learn` shows the first".to_owned());
        }
        let path = format!("{name}.zip");
        if !is_replaced(path.as_ref()) {
            return Err(format!(
                "{path} is a broken link, or has other files than a hand-in; move it, or submit by another name"
            ));
        }
        let mut zip = ZipArchiveWriter::new(Vec::new());
        pack(&mut zip, &begun)?;
        let progress = Progress::read();
        let done = begun.iter().filter(|e| progress.is_done(e)).count();
        let mut words = format!("{path}: {} files, {done} of them done", begun.len());
        if let Some(folder) = &self.program {
            let count = pack_program(&mut zip, folder)?;
            let _ = write!(words, "; a program of {count} files");
        }
        let bytes = zip.finish().map_err(|error| error.to_string())?;
        fs::write(&path, bytes).map_err(with_path(path.as_ref()))?;
        Ok(words)
    }
}

/// Whether a file may be written anew: it is missing, or has nothing but exercises and programs, as an earlier one has.
fn is_replaced(path: &Path) -> bool {
    let Ok(bytes) = fs::read(path) else {
        return !path.exists() && !path.is_symlink();
    };
    let Ok(zip) = ZipArchive::from_slice(&bytes) else {
        return false;
    };
    let mut names = Vec::new();
    for entry in zip.entries() {
        let Ok(entry) = entry else {
            return false;
        };
        names.push(String::from_utf8_lossy(entry.file_path().as_ref()).into_owned());
    }
    let programs: Vec<_> = names
        .iter()
        .filter_map(|name| name.strip_suffix(SHEETS))
        .collect();
    let is_of_program = |name: &str| programs.iter().any(|folder| name.starts_with(folder));
    names
        .iter()
        .all(|name| name.contains("/exercises/") || is_of_program(name))
}

/// Whether a system or a tool has added this file or folder.
#[must_use]
pub fn is_added(name: &str) -> bool {
    ADDED.contains(&name) || name.starts_with("._")
}

/// Adds the files of exercises.
fn pack(zip: &mut ZipArchiveWriter<Vec<u8>>, begun: &[&Exercise]) -> Result<(), String> {
    for e in begun {
        let yours = student_file::path(e);
        if yours.is_symlink() {
            let path = text::path(&yours);
            return Err(format!("{path} {LINK}"));
        }
        let name = format!("{}/exercises/{}.rs", e.stage, e.name);
        let text = files::text_of(&yours)?;
        add(zip, &name, text.as_bytes()).map_err(|error| format!("{name}: {error}"))?;
    }
    Ok(())
}

/// Adds the files of a program, and returns how many there are.
fn pack_program(zip: &mut ZipArchiveWriter<Vec<u8>>, folder: &Path) -> Result<usize, String> {
    if !folder.is_dir() {
        return Err(format!("{} is no folder of a program", text::path(folder)));
    }
    let folder = fs::canonicalize(folder).map_err(with_path(folder))?;
    if !folder.join(SHEETS).is_file() {
        return Err(format!(
            "{} lacks a file {SHEETS}, which names the sheets, such as glass",
            text::path(&folder)
        ));
    }
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let mut open = vec![(folder.clone(), name.into_owned())];
    let mut count = 0;
    while let Some((place, inner)) = open.pop() {
        for entry in fs::read_dir(&place).map_err(with_path(&place))? {
            let entry = entry.map_err(with_path(&place))?;
            let (path, name) = (entry.path(), entry.file_name());
            let name = name.to_string_lossy();
            let inner = format!("{inner}/{name}");
            let kind = entry.file_type().map_err(with_path(&path))?;
            if is_added(&name) {
                continue;
            }
            if kind.is_symlink() {
                return Err(format!("{} {LINK}", text::path(&path)));
            }
            if kind.is_dir() {
                open.push((path, inner));
            } else {
                let bytes = fs::read(&path).map_err(with_path(&path))?;
                add(zip, &inner, &bytes).map_err(|error| format!("{inner}: {error}"))?;
                count += 1;
            }
        }
    }
    Ok(count)
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

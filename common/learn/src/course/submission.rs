//! `submission`: the files of exercises in a folder or a zip file. Nothing else is looked at.

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use zip::ZipArchive;

use crate::exercise::Exercise;

/// The most bytes of a student's file.
const MOST: u64 = 64 * 1024;

/// The text of a file, or what is wrong with it.
pub fn read(submission: &Path, e: &Exercise) -> Result<String, String> {
    let path = format!("{}/exercises/{}.rs", e.stage, e.name);
    let read = if submission.is_dir() {
        from_folder(submission, &path)
    } else {
        from_zip(submission, &path)
    };
    match read {
        Ok(text) if text.len() as u64 > MOST => Err("the file is larger than 64 KiB".to_owned()),
        Err(error) if error.kind() == ErrorKind::NotFound => Err("not handed in".to_owned()),
        read => read.map_err(|error| format!("the file cannot be read: {error}")),
    }
}

/// Reads a file, and follows no link out of the folder.
fn from_folder(folder: &Path, path: &str) -> io::Result<String> {
    let real = folder.join(path).canonicalize()?;
    let is_inside = real.strip_prefix(folder.canonicalize()?) == Ok(Path::new(path));
    if !is_inside || !fs::metadata(&real)?.is_file() {
        return Err(io::Error::other("it is a link, or no file"));
    }
    beginning(File::open(real)?)
}

/// Reads a file that is in a zip file, or in a folder there.
fn from_zip(archive: &Path, path: &str) -> io::Result<String> {
    let mut archive = ZipArchive::new(File::open(archive)?)?;
    let is_it = |name: &Cow<str>| Path::new(&**name).ends_with(path);
    let name = {
        let mut names = archive.file_names().filter_map(Result::ok);
        names.find(is_it).map(Cow::into_owned)
    };
    let name = name.ok_or(ErrorKind::NotFound)?;
    beginning(archive.by_name(&name)?)
}

fn beginning(file: impl Read) -> io::Result<String> {
    let mut text = String::new();
    file.take(MOST + 1).read_to_string(&mut text)?;
    Ok(text)
}

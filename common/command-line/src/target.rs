//! Where pictures and texts are written: `Target` for pictures, `write_text` for a text.

use std::fs;
use std::path::{Path, PathBuf};

use common::{Error, Image, Scene, Size, Stage, Transfer, atomic_file, picture_file, text};

use crate::options::Options;
use crate::print::warn;
use crate::save::save_beside_others;

/// The folder for pictures, below the current one.
const DEFAULT_FOLDER: &str = "out";

/// Where pictures are written.
pub enum Target {
    /// A folder, which is made if it is missing.
    Folder(PathBuf),
    /// A PNG file, for one picture.
    File(PathBuf),
}

impl Default for Target {
    fn default() -> Self {
        Self::Folder(DEFAULT_FOLDER.into())
    }
}

impl Target {
    /// Reads the argument of `-o`, for this many pictures: a name that ends in `.png`
    /// is a file, and any other name without an ending is a folder.
    pub fn new(output: Option<PathBuf>, pictures: usize) -> Result<Self, Error> {
        let Some(path) = output else {
            return Ok(Self::default());
        };
        match path.extension() {
            _ if path.as_os_str() == "-" => Err(Error::Usage(
                "-o - must be a folder or the name of a PNG file; pictures are not written to \
                 standard output"
                    .to_owned(),
            )),
            _ if path.is_dir() => Ok(Self::Folder(path)),
            None => Ok(Self::Folder(path)),
            Some(_) if !ends_in(&path, "png") => Err(Error::Usage(format!(
                "-o {} must be a folder or the name of a PNG file, ending in .png",
                text::path(&path)
            ))),
            Some(_) if pictures > 1 => Err(Error::Usage(format!(
                "-o {} has room for one picture, not {pictures}; give a folder",
                text::path(&path)
            ))),
            Some(_) => Ok(Self::File(path)),
        }
    }

    fn path(&self, stage: &Stage, scene: &Scene) -> PathBuf {
        match self {
            Self::Folder(folder) => folder.join(picture_name(stage, scene)),
            Self::File(path) => path.clone(),
        }
    }

    /// An error if the picture of `scene` cannot be written.
    pub fn check(&self, stage: &Stage, scene: &Scene, options: &Options) -> Result<(), Error> {
        check_no_input(&self.path(stage, scene), scene, options)?;
        match self {
            // A folder can be made wherever a file can.
            Self::Folder(folder) if !folder.exists() => {
                let checked = atomic_file::check_writable(folder);
                // Another program may have made the folder meanwhile.
                checked.or_else(|error| if folder.is_dir() { Ok(()) } else { Err(error) })
            }
            _ => atomic_file::check_writable(&self.path(stage, scene)),
        }
    }

    /// Writes the rows of an unfinished picture beside the place of the finished one, over no other picture; the rows
    /// that are missing are black.
    pub fn keep_rows(
        &self,
        stage: &Stage,
        scene: &Scene,
        size: Size,
        rgb: &[u8],
    ) -> Result<(), Error> {
        if rgb.is_empty() {
            return Ok(());
        }
        let path = self.path(stage, scene);
        let folder = path.parent().unwrap_or(&path);
        make_folder(folder)?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let path = save_beside_others(folder, &format!("{name}-unfinished"), size, rgb)?;
        let path = text::path(&path);
        warn(&format!("note: {path} has the rows that were drawn"));
        Ok(())
    }

    /// Writes the picture of `scene` and returns its path.
    pub fn write(
        &self,
        stage: &Stage,
        scene: &Scene,
        image: &Image,
        transfer: Transfer,
    ) -> Result<PathBuf, Error> {
        if let Self::Folder(folder) = self {
            make_folder(folder)?;
        }
        let path = self.path(stage, scene);
        picture_file::save_png(&path, image.size(), &image.to_rgb8(transfer))?;
        Ok(path)
    }
}

/// Whether a name has this ending, in small or capital letters.
pub fn ends_in(path: &Path, ending: &str) -> bool {
    path.extension()
        .is_some_and(|end| end.eq_ignore_ascii_case(ending))
}

/// An error if the name of a file is not that of a PNG file.
pub fn check_png(path: &Path) -> Result<(), Error> {
    if ends_in(path, "png") {
        return Ok(());
    }
    Err(Error::Usage(format!(
        "{} must be the name of a PNG file, ending in .png; nothing is saved",
        text::path(path)
    )))
}

/// Whether both names lead to one file that is there.
pub fn is_same_file(one: &Path, other: &Path) -> bool {
    let found = [one, other].map(fs::canonicalize);
    matches!(found, [Ok(one), Ok(other)] if one == other)
}

/// An error if the file that is about to be written is one of those that the scene is read from.
pub fn check_no_input(path: &Path, scene: &Scene, options: &Options) -> Result<(), Error> {
    let mut inputs = scene.files.iter().chain(&options.open);
    match inputs.find(|input| is_same_file(path, input)) {
        Some(input) => Err(Error::Usage(format!(
            "{} is read by this command; it needs another file to write",
            text::path(input)
        ))),
        None => Ok(()),
    }
}

/// What becomes of a file with another text than the one that is written.
#[derive(clap::Args)]
pub struct Replace {
    /// Replace a file that has another text
    #[arg(long)]
    replace: bool,
}

/// An error if a text cannot be written into the file that a person names: it must have this ending.
pub fn check_text(
    path: &Path,
    ending: &str,
    scene: &Scene,
    options: &Options,
) -> Result<(), Error> {
    if !ends_in(path, ending) {
        let path = text::path(path);
        return Err(Error::Usage(format!(
            "{path} must be the name of a file that ends in .{ending}; nothing is written"
        )));
    }
    check_no_input(path, scene, options)?;
    atomic_file::check_writable(path)
}

/// Writes a text into a file that is checked, and says so. A file with another text is kept, which may be a person's
/// work, unless the person wants it replaced. A drawing is renewed, as pictures are.
pub fn write_text(path: &Path, text: &str, other: &Replace) -> Result<(), Error> {
    let shown = text::path(path);
    let is_lost = |old: Vec<u8>| old != text.as_bytes() && !old.starts_with(b"<svg");
    if !other.replace && fs::read(path).is_ok_and(is_lost) {
        return Err(Error::Usage(format!(
            "{shown} is there and has another text; it is kept, unless --replace is given"
        )));
    }
    atomic_file::write(path, text.as_bytes())?;
    warn(&format!("note: {shown} is written"));
    Ok(())
}

/// Makes `out/` if it is missing.
pub fn make_default_folder() -> Result<&'static Path, Error> {
    let folder = Path::new(DEFAULT_FOLDER);
    make_folder(folder)?;
    Ok(folder)
}

/// Makes a folder if it is missing, and its parents.
pub fn make_folder(folder: &Path) -> Result<(), Error> {
    match fs::create_dir_all(folder) {
        Err(_) if folder.is_symlink() && !folder.exists() => Err(Error::Write {
            path: folder.to_owned(),
            reason: "it is a link to a folder that is not there".to_owned(),
        }),
        Err(_) if folder.exists() && !folder.is_dir() => Err(Error::Write {
            path: folder.to_owned(),
            reason: "it is a file, not a folder".to_owned(),
        }),
        // Another program may have made the folder meanwhile.
        Err(error) if !folder.exists() => Err(atomic_file::cannot_write(folder, &error)),
        _ => Ok(()),
    }
}

/// The file name of a scene's picture, `STAGE-SCENE.png`.
#[must_use]
pub fn picture_name(stage: &Stage, scene: &Scene) -> String {
    format!("{}-{}.png", stage.name, scene.name)
}

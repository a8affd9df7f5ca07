//! `Sheet`: an open task, the pictures that it asks for, and the facts that judge them.

use common::Size;
use common::row::{self, Row};

use crate::pictures::fact::Fact;
use crate::pictures::run::Run;

/// The longest time of a run, unless the sheet says another.
const SECONDS: u32 = 60;

/// An open task.
#[derive(Debug)]
pub struct Sheet {
    /// The name of its file, without `.toml`.
    pub name: String,
    /// The heading of its page.
    pub title: String,
    /// Its page of the book.
    pub page: String,
    /// The stage that opens it: its program needs nothing above.
    pub stage: String,
    /// How long it takes.
    pub hours: u32,
    /// Exercises whose functions move into the student's program, once they are done.
    pub steps: Vec<String>,
    /// A scene whose samples are threads, and whose speed-up is measured.
    pub timed: Option<String>,
    /// The pictures that the student's program draws.
    pub pictures: Vec<RequestedPicture>,
    /// The facts, in the order in which they are asked.
    pub facts: Vec<Fact>,
}

/// A scene that the student's program draws, once for each number of samples.
#[derive(Debug)]
pub struct RequestedPicture {
    /// The name of the scene.
    pub scene: String,
    /// The numbers of samples.
    pub samples: Vec<u32>,
    /// The size of the picture.
    pub size: Size,
    /// The longest time of a run, in seconds.
    pub seconds: u32,
}

impl Sheet {
    /// Reads the text of a sheet's file, `NAME.toml`.
    pub fn read(name: &str, text: &str) -> Result<Self, String> {
        row::read(&format!("{name}.toml"), text, |row| {
            Self::read_row(name, row)
        })
    }

    fn read_row(name: &str, row: &Row) -> Result<Self, String> {
        let mut sheet = Self {
            name: name.to_owned(),
            title: row.get("title")?,
            page: row.get("page")?,
            stage: row.get("stage")?,
            hours: row.get("hours")?,
            steps: row.find("steps")?.unwrap_or_default(),
            timed: row.find("timed")?,
            pictures: Vec::new(),
            facts: Vec::new(),
        };
        for row in row.rows("picture")? {
            let picture = RequestedPicture::read(&row)?;
            if sheet.picture(&picture.scene).is_some() {
                return Err(row.error("scene", "is that of an earlier picture"));
            }
            sheet.pictures.push(picture);
        }
        let unknown = |scene: &String| sheet.picture(scene).is_none();
        if sheet.timed.as_ref().is_some_and(unknown) {
            return Err(row.error("timed", "names no scene of a picture"));
        }
        for row in row.rows("fact")? {
            let fact = Fact::read(&row, &sheet)?;
            if sheet.facts.iter().any(|other| other.name == fact.name) {
                return Err(row.error("name", "is that of an earlier fact"));
            }
            sheet.facts.push(fact);
        }
        row.end()?;
        Ok(sheet)
    }

    /// The picture of a scene.
    pub(crate) fn picture(&self, scene: &str) -> Option<&RequestedPicture> {
        self.pictures.iter().find(|picture| picture.scene == scene)
    }
}

impl RequestedPicture {
    fn read(row: &Row) -> Result<Self, String> {
        let scene: String = row.get("scene")?;
        let is_plain = |letter: char| letter.is_ascii_alphanumeric() || letter == '-';
        if !scene.chars().all(is_plain) {
            return Err(row.error("scene", "must be letters, digits and `-`"));
        }
        let [width, height] = row.get("size")?;
        let picture = Self {
            scene,
            samples: row.get("samples")?,
            size: Size::new(width, height)
                .map_err(|error| row.error("size", &error.to_string()))?,
            seconds: row.find("seconds")?.unwrap_or(SECONDS),
        };
        row.end()?;
        Ok(picture)
    }

    /// The run with the most samples of the row, which is its last.
    pub(crate) fn last(&self) -> Run {
        self.run(self.samples.last().copied().unwrap_or_default())
    }

    /// The run with this number of samples.
    pub(crate) fn run(&self, samples: u32) -> Run {
        Run {
            scene: self.scene.clone(),
            samples,
        }
    }
}

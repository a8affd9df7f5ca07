//! Reads the row of a fact: all pictures that it names are there, and all places are inside of them.

use common::Size;
use common::row::{DeValue, Row, Value};

use super::Fact;
use crate::pictures::fitted_slope::Axis;
use crate::pictures::line::Line;
use crate::pictures::quantity::{Exact, Quantity};
use crate::pictures::run::Run;
use crate::pictures::sheet::{RequestedPicture, Sheet};
use crate::pictures::theory::Theory;
use crate::pictures::values::{Channel, Region};

/// What a fact measures, without the places where.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Mean,
    Greatest,
    Least,
    Alike,
    Autocorrelation,
    Load,
    Edge,
    Width,
    Spread,
    Same,
    Growth,
    Slope,
}

/// The words for it in a sheet.
const KINDS: [(&str, Kind); 12] = [
    ("mean", Kind::Mean),
    ("greatest", Kind::Greatest),
    ("least", Kind::Least),
    ("alike", Kind::Alike),
    ("autocorrelation", Kind::Autocorrelation),
    ("load", Kind::Load),
    ("edge", Kind::Edge),
    ("width", Kind::Width),
    ("spread", Kind::Spread),
    ("same", Kind::Same),
    ("growth", Kind::Growth),
    ("slope", Kind::Slope),
];

impl Fact {
    pub(crate) fn read(row: &Row, sheet: &Sheet) -> Result<Self, String> {
        let name: String = row.get("name")?;
        if name.contains(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_') {
            return Err(row.error("name", "must be one word"));
        }
        let kind = kind(row)?;
        let run = run(row, kind, sheet)?;
        let size = picture(row, "scene", sheet, &run.scene)?.size;
        let fact = Self {
            quantity: quantity(row, kind, sheet, size)?,
            name,
            run,
            says: row.get("says")?,
            channel: row.find("channel")?,
            value: row.get("value")?,
            formula: row.get("formula")?,
            within: row.get("within")?,
            or_less: row.find("or_less")?.unwrap_or_default(),
            because: row.get("because")?,
            hint: row.get("hint")?,
        };
        for (key, number) in [("value", fact.value), ("within", fact.within)] {
            if !number.is_finite() {
                return Err(row.error(key, "must be a finite number"));
            }
        }
        row.end()?;
        Ok(fact)
    }
}

fn kind(row: &Row) -> Result<Kind, String> {
    let word: String = row.get("measure")?;
    let known = KINDS.iter().find(|(known, _)| *known == word);
    known.map(|(_, kind)| *kind).ok_or_else(|| {
        let known = KINDS.map(|(known, _)| known).join(", ");
        row.error("measure", &format!("is {word}; it must be one of {known}"))
    })
}

/// The picture of a scene that a key names.
fn picture<'a>(
    row: &Row,
    key: &str,
    sheet: &'a Sheet,
    scene: &str,
) -> Result<&'a RequestedPicture, String> {
    let unknown = || row.error(key, &format!("names no scene of a picture: {scene}"));
    sheet.picture(scene).ok_or_else(unknown)
}

/// The run of a number of samples.
fn run_of(row: &Row, picture: &RequestedPicture, samples: u32) -> Result<Run, String> {
    if picture.samples.contains(&samples) {
        Ok(picture.run(samples))
    } else {
        let scene = &picture.scene;
        Err(row.error("samples", &format!("has {samples}, which {scene} has not")))
    }
}

/// The run of the picture that the fact is about.
fn run(row: &Row, kind: Kind, sheet: &Sheet) -> Result<Run, String> {
    if let Kind::Growth | Kind::Slope = kind {
        let mut runs = runs(row, sheet)?;
        return runs.pop().ok_or_else(|| row.error("samples", "is empty"));
    }
    let scene: String = row.get("scene")?;
    let picture = picture(row, "scene", sheet, &scene)?;
    match row.find("samples")? {
        Some(samples) => run_of(row, picture, samples),
        None => Ok(picture.last()),
    }
}

/// The runs of several scenes, or those of one with more and more samples.
fn runs(row: &Row, sheet: &Sheet) -> Result<Vec<Run>, String> {
    let scenes: Option<Vec<String>> = row.find("scenes")?;
    let mut runs = Vec::new();
    if let Some(scenes) = &scenes {
        for scene in scenes {
            runs.push(picture(row, "scenes", sheet, scene)?.last());
        }
    } else {
        let scene: String = row.get("scene")?;
        let picture = picture(row, "scene", sheet, &scene)?;
        for samples in row.get::<Vec<u32>>("samples")? {
            runs.push(run_of(row, picture, samples)?);
        }
    }
    if runs.len() < 3 || !runs.is_sorted_by(|a, b| a.scene != b.scene || a.samples < b.samples) {
        let key = if scenes.is_some() {
            "scenes"
        } else {
            "samples"
        };
        return Err(row.error(key, "must be three or more, and samples must ascend"));
    }
    Ok(runs)
}

/// What is measured in a picture of this size.
fn quantity(row: &Row, kind: Kind, sheet: &Sheet, size: Size) -> Result<Quantity, String> {
    Ok(match kind {
        Kind::Mean => Quantity::Mean(region(row, size)?),
        Kind::Greatest => Quantity::Greatest(region(row, size)?),
        Kind::Least => Quantity::Least(region(row, size)?),
        Kind::Alike => {
            let region = region(row, size)?;
            if region.height < 2 {
                return Err(row.error("region", "must have two rows or more"));
            }
            Quantity::Alike(region)
        }
        Kind::Autocorrelation => Quantity::Autocorrelation(region(row, size)?),
        Kind::Load => Quantity::Load(region(row, size)?),
        Kind::Edge => Quantity::Edge(line(row, size)?),
        Kind::Width => Quantity::Width(line(row, size)?),
        Kind::Spread => {
            let region = region(row, size)?;
            Quantity::Spread {
                region,
                exact: exact(row, sheet, size, region)?,
            }
        }
        Kind::Same => Quantity::Same(same_size(
            row,
            "as",
            sheet,
            &row.get::<String>("as")?,
            size,
        )?),
        Kind::Growth => {
            let runs = runs(row, sheet)?;
            for run in &runs {
                same_size(row, "scenes", sheet, &run.scene, size)?;
            }
            Quantity::Growth {
                region: region(row, size)?,
                runs,
            }
        }
        Kind::Slope => {
            let region = region(row, size)?;
            let runs = runs(row, sheet)?;
            Quantity::Slope {
                region,
                exact: exact(row, sheet, size, region)?,
                axis: row.find("axis")?.unwrap_or_default(),
                theory: theory(row, runs.len())?,
                runs,
            }
        }
    })
}

/// The last run of another scene, whose picture is compared pixel by pixel.
fn same_size(
    row: &Row,
    key: &'static str,
    sheet: &Sheet,
    scene: &str,
    size: Size,
) -> Result<Run, String> {
    let other = picture(row, key, sheet, scene)?;
    if other.size == size {
        Ok(other.last())
    } else {
        let problem = format!("names {scene}, a picture of another size");
        Err(row.error(key, &problem))
    }
}

fn exact(row: &Row, sheet: &Sheet, size: Size, region: Region) -> Result<Exact, String> {
    let scene: Option<String> = row.find("exact_scene")?;
    if let Some(scene) = scene {
        return Ok(Exact::Run(same_size(
            row,
            "exact_scene",
            sheet,
            &scene,
            size,
        )?));
    }
    let exact = row.get("exact")?;
    match &exact {
        Exact::Columns(columns) if columns.len() != region.width as usize => {
            Err(row.error("exact", "must have a number for each column of the region"))
        }
        _ => Ok(exact),
    }
}

/// What theory says about the errors of these many runs, if the row says it.
fn theory(row: &Row, runs: usize) -> Result<Option<Theory>, String> {
    let Some(row) = row.table("theory")? else {
        return Ok(None);
    };
    let theory = Theory {
        name: row.get("name")?,
        errors: row.get("errors")?,
        formula: row.get("formula")?,
        unseen: row.get("unseen")?,
        tests: row.find("tests")?,
    };
    row.end()?;
    let are_positive = theory.errors.iter().all(|error| *error > 0.0);
    if theory.errors.len() != runs || !are_positive {
        return Err(row.error("errors", "must be positive, one for each number of samples"));
    }
    Ok(Some(theory))
}

fn region(row: &Row, size: Size) -> Result<Region, String> {
    let [x, y, width, height] = row.get("region")?;
    let region = Region {
        x,
        y,
        width,
        height,
    };
    if region.is_inside(size) {
        Ok(region)
    } else {
        let problem = format!("must be x, y, width and height within {size}");
        Err(row.error("region", &problem))
    }
}

fn line(row: &Row, size: Size) -> Result<Line, String> {
    let line = Line {
        from: row.get("from")?,
        to: row.get("to")?,
        lines: row.find("lines")?.unwrap_or(1),
    };
    if line.is_inside(size) {
        Ok(line)
    } else {
        let problem = format!(
            "must be another point than `from`, and all parallel `lines`, an odd number, within {size}"
        );
        Err(row.error("to", &problem))
    }
}

impl Value for Channel {
    fn form() -> String {
        "\"red\", \"green\" or \"blue\"".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        match value.as_str()? {
            "red" => Some(Self::Red),
            "green" => Some(Self::Green),
            "blue" => Some(Self::Blue),
            _ => None,
        }
    }
}

impl Value for Exact {
    fn form() -> String {
        "a number, or a list of one for each column of the region".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        let number = f64::read(value).map(Self::Number);
        number.or_else(|| Vec::read(value).map(Self::Columns))
    }
}

impl Value for Axis {
    fn form() -> String {
        "\"linear\", or missing for the logarithm of the samples".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        (value.as_str()? == "linear").then_some(Self::Linear)
    }
}

//! The recordings of the book: measurements of all experiments, from which its pages take their figures.
//!
//! A page names a figure by an anchor instead of typing it:
//!
//! | anchor | becomes |
//! |---|---|
//! | `{{recorded time a04.sphere-far.compensated/stable longer}}` | about 2.5 times as long |
//! | `{{recorded times a04.sphere-far.compensated/stable}}` | the same as a number, for a table |
//! | `{{recorded error a04.sphere-far.stable@512}}` | the root mean square error, or the fraction of wrong answers |
//! | `{{recorded factor a04.triangle-needle.cramer/woop-ours}}` | the quotient of two errors |
//! | `{{recorded slope a04.sphere-far.stable}}` | the slope of the curve, or `no power law` |
//! | `{{recorded work a03.samples-level-edge.regular}}` | the work that half a grey level takes |
//! | `{{recorded saved a06.left-out-aab.reflected}}` | the milliseconds that a kind of work takes, which is left out |
//! | `{{recorded front a04.sphere-far}}` | the methods that no other beats |
//! | `{{recorded errors a07.condition}}` | a table: a row for each value of the parameter |
//! | `{{recorded fronts}}` | a table of the fronts of all experiments |
//! | `{{recorded where}}` | machine, build and date |
//!
//! Methods are named in lower case with dashes, by as many letters as tell them apart. `@` names the value of
//! the parameter, by default the last one that both methods have; `@most` is that of the greatest
//! quotient. The last word of a time is what the sentence says about it: `longer`, `shorter` or
//! `same`. If the measurement of any build says otherwise, the anchor is an error.

mod anchor;
mod words;

use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::plot;
use crate::report::{Measured, opposite_of};

pub use anchor::Anchor;

/// The build whose figures the book shows: what a user runs who wants speed.
pub const MAIN_BUILD: &str = "fastest";

/// The texts of all recordings.
#[derive(Default)]
pub struct Texts(Vec<Text>);

/// The text of a recording.
struct Text {
    build: String,
    /// The name of the stage, such as `a04-intersections`.
    stage: String,
    csv: String,
}

impl Texts {
    /// Reads the files `BUILD/STAGE/EXPERIMENT.csv` in a folder.
    pub fn read(folder: &Path) -> Result<Self, String> {
        let mut texts = Vec::new();
        for build in names(folder)? {
            let of_build = folder.join(&build);
            for stage in names(&of_build)? {
                let of_stage = of_build.join(&stage);
                for file in names(&of_stage)? {
                    let path = of_stage.join(&file);
                    let text = fs::read_to_string(&path);
                    texts.push(Text {
                        build: build.clone(),
                        stage: stage.clone(),
                        csv: text.map_err(|error| format!("{}: {error}", path.display()))?,
                    });
                }
            }
        }
        Ok(Self(texts))
    }

    /// The measurements.
    pub fn recordings(&self) -> Result<Recordings<'_>, String> {
        let mut builds: Vec<Build> = Vec::new();
        for Text { build, stage, csv } in &self.0 {
            let measured = Measured::parse(csv);
            let measured = measured.map_err(|error| format!("a recording of {stage}: {error}"))?;
            if builds.last().is_none_or(|last| last.name != build) {
                let (name, stages) = (build.as_str(), Vec::new());
                builds.push(Build { name, stages });
            }
            let stages = builds.last_mut().map(|build| &mut build.stages);
            let Some(stages) = stages else { continue };
            if stages
                .last()
                .is_none_or(|last: &StageRecordings| last.name != stage)
            {
                let (name, experiments) = (stage.as_str(), Vec::new());
                stages.push(StageRecordings { name, experiments });
            }
            if let Some(last) = stages.last_mut() {
                last.experiments.push(measured);
            }
        }
        // The build that the book shows comes first.
        builds.sort_by_key(|build| build.name != MAIN_BUILD);
        match builds.first() {
            Some(first) if first.name == MAIN_BUILD => Ok(Recordings { builds }),
            _ => Err(format!("there are no recordings of the build {MAIN_BUILD}")),
        }
    }
}

/// The names in a folder, in alphabetical order.
fn names(folder: &Path) -> Result<Vec<String>, String> {
    let failed = |error| format!("{}: {error}", folder.display());
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let name = entry.map_err(failed)?.file_name();
        let name = name.to_string_lossy();
        if !name.starts_with('.') && name != "README.md" {
            names.push(name.into_owned());
        }
    }
    names.sort();
    Ok(names)
}

/// The measurements of all builds, the one of the book first.
pub struct Recordings<'a> {
    builds: Vec<Build<'a>>,
}

struct Build<'a> {
    name: &'a str,
    stages: Vec<StageRecordings<'a>>,
}

/// The measurements of a stage.
pub struct StageRecordings<'a> {
    /// The name, such as `a04-intersections`.
    pub name: &'a str,
    /// All of its experiments.
    pub experiments: Vec<Measured<'a>>,
}

impl StageRecordings<'_> {
    /// The first part of the name, such as `a04`.
    fn short(&self) -> &str {
        self.name.split('-').next().unwrap_or_default()
    }
}

impl<'a> Recordings<'a> {
    /// The stages of the build that the book shows.
    pub fn stages(&self) -> &[StageRecordings<'a>] {
        self.builds.first().map_or(&[], |build| &build.stages)
    }

    /// A page with figures instead of anchors. A figure that is not recorded, or that
    /// contradicts its sentence, is an error with the place of its anchor.
    pub fn fill(&self, page: &str) -> Result<String, NotFilled> {
        let mut filled = String::new();
        let mut rest = page;
        while let Some(anchor) = Anchor::first(rest) {
            filled += &rest[..anchor.start];
            let at = page.len() - rest.len() + anchor.start;
            filled += &self
                .figure(anchor.words)
                .map_err(|why| NotFilled { at, why })?;
            rest = &rest[anchor.end..];
        }
        Ok(filled + rest)
    }

    /// The plots of all experiments.
    pub fn plots(&self) -> Vec<Plot> {
        let mut plots = Vec::new();
        for stage in self.stages() {
            for measured in &stage.experiments {
                let name = format!("{}-{}", stage.name, measured.experiment.name);
                let opposite = opposite_of(measured, &stage.experiments);
                for plot in plot::plots(measured, opposite) {
                    plots.push(Plot {
                        name: format!("{name}{}", plot.ending),
                        svg: plot.svg,
                    });
                }
            }
        }
        plots
    }

    /// The rows of the fronts of all experiments.
    fn fronts(&self) -> String {
        let mut table = "| | experiment | question | Pareto front |\n|---|---|---|---|".to_owned();
        for stage in self.stages() {
            for measured in &stage.experiments {
                // Two programs that give the same picture have no errors to compare.
                if measured.experiment.name.starts_with("render-") {
                    continue;
                }
                // Of two opposite ones, the row of the first is that of both.
                let opposite = opposite_of(measured, &stage.experiments);
                let name = measured.experiment.name;
                let is_second = opposite.is_some_and(|other| other.experiment.name < name);
                if let Some(row) = measured.row(opposite).filter(|_| !is_second) {
                    let number = stage.short().trim_start_matches(['a', '0']);
                    let _ = write!(table, "\n| {number} {row}");
                }
            }
        }
        table
    }
}

/// A plot of a recording as a file.
pub struct Plot {
    /// The name of the file.
    pub name: String,
    /// Its text.
    pub svg: String,
}

/// Why an anchor has no figure.
#[derive(Debug, PartialEq, Eq)]
pub struct NotFilled {
    /// The first byte of the anchor in the page.
    pub at: usize,
    /// What is wrong.
    pub why: String,
}

#[cfg(test)]
mod tests;

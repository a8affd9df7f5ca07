//! `Judgement`: what the pictures of a program say when they are asked the facts of a sheet, one after the other.

use std::collections::BTreeMap;
use std::path::PathBuf;

use common::{Image, picture_file, text};

use crate::pictures::fact::Fact;
use crate::pictures::fitted_slope::{Point, fitted_slope};
use crate::pictures::quantity::{Exact, Quantity};
use crate::pictures::run::Run;
use crate::pictures::sheet::{RequestedPicture, Sheet};
use crate::pictures::theory::{PixelErrors, Precision};
use crate::pictures::values::{Region, Values, different, growth, root_mean_square};

/// A picture that the program has written.
#[derive(Debug)]
pub struct Drawn {
    /// Its file.
    pub file: PathBuf,
    /// The time of the run.
    pub seconds: f64,
}

/// Which facts are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facts {
    /// All, for a mark.
    All,
    /// Those up to the first that fails, so that the answer comes soon.
    UntilOneFails,
    /// The one of which theory knows the error at each number of samples.
    WithTheory,
}

/// What a picture says about a fact.
#[derive(Debug)]
pub enum State {
    /// The right value.
    Right(MeasuredValue),
    /// Another value.
    Wrong(MeasuredValue),
    /// Nothing could be measured; the sentence says why.
    NotMeasured(String),
    /// An earlier fact has failed.
    NotAsked,
}

/// The value of a fact in the pictures, and what is said about it.
#[derive(Debug, Default)]
pub struct MeasuredValue {
    pub(crate) value: f64,
    /// Where pixels differ.
    pub(crate) different: Option<Region>,
}

/// A picture that is opened.
#[derive(Debug)]
pub(crate) struct Opened {
    pub drawn: Drawn,
    pub image: Image,
}

/// The pictures by their runs, or why there is none.
type Pictures = BTreeMap<Run, Result<Opened, String>>;

/// The facts of a sheet, and what the pictures say about them.
#[derive(Debug)]
pub struct Judgement<'a> {
    /// The sheet.
    pub sheet: &'a Sheet,
    /// A state for each fact.
    pub states: Vec<State>,
    pub(crate) pictures: Pictures,
}

/// Asks the facts. `draw` runs the program and says where its picture is; its error is a sentence about the
/// program.
pub fn ask_facts<'a>(
    sheet: &'a Sheet,
    facts: Facts,
    draw: &mut dyn FnMut(&RequestedPicture, &Run) -> Result<Drawn, String>,
) -> Judgement<'a> {
    let mut judgement = Judgement {
        sheet,
        states: Vec::new(),
        pictures: Pictures::new(),
    };
    for fact in &sheet.facts {
        let is_asked = match facts {
            Facts::All => true,
            Facts::UntilOneFails => judgement.first_failure().is_none(),
            Facts::WithTheory => fact.theory().is_some(),
        };
        let state = if is_asked {
            judgement.draw(fact, draw);
            judgement.ask(fact)
        } else {
            State::NotAsked
        };
        judgement.states.push(state);
    }
    judgement
}

impl Judgement<'_> {
    /// The number of facts that hold and count: pictures of one colour must not fulfil them all.
    #[must_use]
    pub fn passed(&self) -> usize {
        let right = self.right();
        if right.iter().any(|fact| fact.quantity.needs_two_colors()) {
            right.len()
        } else {
            0
        }
    }

    /// How many facts hold, in words.
    #[must_use]
    pub fn summary(&self) -> String {
        let [right, all] = [self.right().len(), self.states.len()];
        let count = if self.none_counts() {
            ", and none counts yet"
        } else {
            ""
        };
        format!("{right} of {all} facts hold{count}")
    }

    /// Whether facts hold, and pictures of one colour would fulfil all of these.
    pub(crate) fn none_counts(&self) -> bool {
        self.passed() == 0 && !self.right().is_empty()
    }

    /// The facts that hold.
    fn right(&self) -> Vec<&Fact> {
        let mut right = Vec::new();
        for (fact, state) in self.sheet.facts.iter().zip(&self.states) {
            if let State::Right(_) = state {
                right.push(fact);
            }
        }
        right
    }

    /// The first fact that does not hold.
    #[must_use]
    pub fn first_failure(&self) -> Option<&Fact> {
        let failed = |state: &State| matches!(state, State::Wrong(_) | State::NotMeasured(_));
        let place = self.states.iter().position(failed)?;
        self.sheet.facts.get(place)
    }

    /// How far that fact's value is from the right one, in tolerances; infinitely far where nothing could be measured.
    #[must_use]
    pub fn tolerances_off(&self) -> f64 {
        let Some(fact) = self.first_failure() else {
            return 0.0;
        };
        match self.state(fact) {
            State::Wrong(measured) => (measured.value - fact.value).abs() / fact.within,
            _ => f64::INFINITY,
        }
    }

    /// The files of all pictures, in the order of their names.
    #[must_use]
    pub fn files(&self) -> Vec<&PathBuf> {
        let opened = self.pictures.values().flatten();
        opened.map(|opened| &opened.drawn.file).collect()
    }

    /// Draws the pictures of a fact that are not there yet. A scene of which one run has failed is not run again.
    fn draw(
        &mut self,
        fact: &Fact,
        draw: &mut dyn FnMut(&RequestedPicture, &Run) -> Result<Drawn, String>,
    ) {
        for run in fact.runs() {
            let is_same = |other: &&Run| other.scene == run.scene;
            let failed = |other: &Run| self.pictures[other].is_err();
            let has_failed = self.pictures.keys().filter(is_same).any(failed);
            if self.pictures.contains_key(run) || has_failed {
                continue;
            }
            let Some(picture) = self.sheet.picture(&run.scene) else {
                continue;
            };
            let opened = draw(picture, run).and_then(|drawn| open(picture, drawn));
            let is_lost = opened.is_err();
            self.pictures.insert(run.clone(), opened);
            if is_lost {
                return;
            }
        }
    }

    /// The picture of a run. An error is the sentence about the run of its scene that has failed.
    pub(crate) fn opened(&self, run: &Run) -> Result<&Opened, String> {
        if let Some(Ok(opened)) = self.pictures.get(run) {
            return Ok(opened);
        }
        for (other, opened) in &self.pictures {
            if let Err(problem) = opened
                && other.scene == run.scene
            {
                return Err(format!("{}: {problem}", other.words()));
            }
        }
        Err(format!("{}: it is not drawn", run.words()))
    }

    /// Asks a fact whose pictures are drawn.
    fn ask(&self, fact: &Fact) -> State {
        match self.measure(fact) {
            Ok(measured) if fact.is_right(measured.value) => State::Right(measured),
            Ok(measured) => State::Wrong(measured),
            Err(problem) => State::NotMeasured(problem),
        }
    }

    /// The values of a run's picture that a fact is about.
    fn values(&self, fact: &Fact, run: &Run) -> Result<Values<'_>, String> {
        Ok(Values {
            image: &self.opened(run)?.image,
            channel: fact.channel,
        })
    }

    /// The differences of a run's picture from what is exact.
    fn errors(
        &self,
        fact: &Fact,
        run: &Run,
        region: Region,
        exact: &Exact,
    ) -> Result<Vec<f64>, String> {
        let values = self.values(fact, run)?;
        Ok(match exact {
            Exact::Number(number) => values.errors(region, |_| *number),
            Exact::Columns(columns) => {
                values.errors(region, |(x, _)| columns[(x - region.x) as usize])
            }
            Exact::Run(other) => {
                let other = self.values(fact, other)?;
                values.errors(region, |pixel| other.at(pixel))
            }
        })
    }

    /// The errors of the sheet's pictures at each number of samples, or why there are none.
    pub fn precision(&self) -> Result<Precision<'_>, String> {
        let none = || {
            let Sheet { name, timed, .. } = self.sheet;
            let time = match timed {
                Some(_) => ", and its time once they all hold",
                None => "",
            };
            format!(
                "{name} has no error that falls with samples; without --report, its facts are asked{time}"
            )
        };
        let fact = self.sheet.fact_with_theory().ok_or_else(none)?;
        let Quantity::Slope {
            region,
            exact,
            axis,
            runs,
            theory: Some(theory),
        } = &fact.quantity
        else {
            return Err(none());
        };
        let mut points = Vec::new();
        for run in runs {
            points.push(PixelErrors {
                samples: run.samples,
                seconds: self.opened(run)?.drawn.seconds,
                errors: self.errors(fact, run, *region, exact)?,
            });
        }
        let picture = self.sheet.picture(&fact.run.scene).ok_or_else(none)?;
        Ok(Precision {
            fact,
            theory,
            axis: *axis,
            picture,
            runs,
            width: region.width as usize,
            points,
        })
    }

    fn measure(&self, fact: &Fact) -> Result<MeasuredValue, String> {
        // The first picture that is missing is the reason, whichever picture is measured first.
        for run in fact.runs() {
            self.opened(run)?;
        }
        let values = |run: &Run| self.values(fact, run);
        let spread = |run: &Run, region: Region, exact: &Exact| {
            let errors = self.errors(fact, run, region, exact)?;
            Ok::<_, String>(root_mean_square(&errors))
        };
        let mut measured = MeasuredValue::default();
        let of_fact = values(&fact.run)?;
        measured.value = match &fact.quantity {
            Quantity::Mean(region) => of_fact.mean(*region),
            Quantity::Greatest(region) => of_fact.greatest(*region),
            Quantity::Least(region) => of_fact.least(*region),
            Quantity::Alike(region) => of_fact.alike(*region),
            Quantity::Autocorrelation(region) => {
                let found = of_fact.autocorrelation(*region);
                found.ok_or("there is no noise: all pixels have the same value")?
            }
            Quantity::Load(region) => of_fact.load(*region),
            Quantity::Edge(line) => line.edge(&of_fact)?,
            Quantity::Width(line) => line.width(&of_fact)?,
            Quantity::Spread { region, exact } => spread(&fact.run, *region, exact)?,
            Quantity::Same(other) => {
                let (count, around) = different(of_fact.image, &self.opened(other)?.image);
                measured.different = around;
                count as f64
            }
            Quantity::Growth { region, runs } => {
                let mean = |run| Ok(values(run)?.mean(*region));
                growth(&runs.iter().map(mean).collect::<Result<Vec<_>, String>>()?)
            }
            Quantity::Slope {
                region,
                exact,
                axis,
                runs,
                ..
            } => {
                let mut points = Vec::new();
                for run in runs {
                    points.push(Point {
                        samples: run.samples,
                        error: spread(run, *region, exact)?,
                    });
                }
                fitted_slope(&points, *axis)?
            }
        };
        Ok(measured)
    }
}

/// Opens a picture, which must have the size that the sheet says.
fn open(picture: &RequestedPicture, drawn: Drawn) -> Result<Opened, String> {
    let image = picture_file::open(&drawn.file).map_err(|error| error.to_string())?;
    if image.size() != picture.size {
        let file = text::path(&drawn.file);
        let (size, right) = (image.size(), picture.size);
        return Err(format!(
            "the picture has {size} pixels, and the sheet says {right}: {file}"
        ));
    }
    Ok(Opened { drawn, image })
}

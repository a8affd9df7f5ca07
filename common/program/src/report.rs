//! `report`: error against run time, for experiments or for scenes.

use std::path::PathBuf;

use common::Error;
use measure::experiment::Experiment;
use measure::report::{self, Measured};
use measure::{Effort, Stage, scene_report};

use crate::print::print;
use crate::target::{make_default_folder, make_folder};
use crate::terminal_progress::terminal_bar;

/// Reports the named experiments, or the scenes that are named after the word
/// `scene`.
pub fn report(
    stage: &Stage,
    names: &[String],
    quick: bool,
    output: Option<PathBuf>,
) -> Result<(), Error> {
    let effort = if quick { Effort::Quick } else { Effort::Full };
    match names.split_first() {
        Some((first, [])) if first == "scene" => {
            let all: Vec<_> = stage.scenes.iter().map(|scene| scene.name).collect();
            let all = all.join(", ");
            Err(Error::Usage(format!("report scene takes a scene: {all}")))
        }
        Some((first, scenes)) if first == "scene" => {
            let scenes = scenes.iter().map(|name| stage.scene(name));
            let experiments = scenes.map(|scene| scene_report::experiment(scene?));
            let experiments = experiments.collect::<Result<Vec<_>, _>>()?;
            measure(stage, &experiments, effort, output)
        }
        _ => {
            let experiments = chosen((stage.experiments)(), names)?;
            measure(stage, &experiments, effort, output)
        }
    }
}

fn measure(
    stage: &Stage,
    experiments: &[Experiment],
    effort: Effort,
    output: Option<PathBuf>,
) -> Result<(), Error> {
    let folder = match output {
        Some(folder) => folder,
        None => make_default_folder()?.join("report"),
    };
    make_folder(&folder)?;
    for experiment in experiments {
        report::check_writable(experiment, &folder, stage.name)?;
    }
    for experiment in experiments {
        let mut bar = None;
        let measured = Measured::new(experiment, effort, |done, all| {
            let bar = bar.get_or_insert_with(|| terminal_bar(experiment.name, all as u64));
            bar.set_position(done as u64);
        });
        if let Some(bar) = bar {
            bar.finish_and_clear();
        }
        print(&measured.table());
        for path in measured.write(&folder, stage.name)? {
            print(&format!("  {}", path.display()));
        }
    }
    Ok(())
}

/// The experiments with these names; without a name, all experiments.
fn chosen(
    experiments: Vec<Experiment<'static>>,
    names: &[String],
) -> Result<Vec<Experiment<'static>>, Error> {
    let known: Vec<_> = experiments.iter().map(|e| e.name).collect();
    for name in names {
        if !known.contains(&name.as_str()) {
            let known = known.join(", ");
            return Err(Error::Usage(format!(
                "there is no experiment \"{name}\"; there are {known}, and scene NAME"
            )));
        }
    }
    let is_wanted = |e: &Experiment| names.is_empty() || names.iter().any(|name| name == e.name);
    Ok(experiments.into_iter().filter(is_wanted).collect())
}

#[cfg(test)]
mod tests {
    use common::{Image, Scene};
    use measure::experiment::{Axis, Curve, Point, Unit};

    use super::*;

    fn experiments() -> Vec<Experiment<'static>> {
        let experiment = |name| Experiment {
            name,
            about: "",
            knob: "n",
            work: "steps",
            error: "",
            unit: Unit::Light,
            exact: "",
            seeds: &[],
            against: Axis::Work,
            curves: Box::new(|_| {
                let point = Point::new(1.0, 1.0, [1.0], || 0.0);
                vec![Curve::new("", [point])]
            }),
        };
        vec![experiment("one"), experiment("two")]
    }

    fn stage() -> Stage {
        let disc = Scene::painted("disc", "", |settings, _| Image::black(settings.size));
        Stage {
            experiments,
            ..crate::stage_of(vec![disc])
        }
    }

    fn names(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn the_named_experiments_are_chosen_or_all() {
        let chosen = |asked: &[&str]| {
            let chosen = chosen(experiments(), &names(asked))?;
            Ok::<_, Error>(chosen.iter().map(|e| e.name).collect::<Vec<_>>())
        };
        assert_eq!(chosen(&[]).unwrap(), ["one", "two"]);
        assert_eq!(chosen(&["two"]).unwrap(), ["two"]);
        let error = chosen(&["two", "three"]).unwrap_err().to_string();
        let expected = "there is no experiment \"three\"; there are one, two, and scene NAME";
        assert_eq!(error, expected);
    }

    #[test]
    fn reports_are_written_into_a_new_folder() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("new/reports");
        report(&stage(), &names(&["two"]), true, Some(output.clone())).unwrap();
        let files = output.read_dir().unwrap();
        let mut files: Vec<_> = files.map(|file| file.unwrap().file_name()).collect();
        files.sort();
        assert_eq!(files, ["a00-two.csv", "a00-two.svg"]);
    }

    #[test]
    fn scene_names_follow_the_word_scene() {
        let refused = |asked: &[&str]| {
            let nowhere = Some("/dev/null".into());
            let refused = report(&stage(), &names(asked), true, nowhere);
            refused.unwrap_err().to_string()
        };
        assert_eq!(refused(&["scene"]), "report scene takes a scene: disc");
        assert!(refused(&["scene", "disc"]).starts_with("disc is not sampled"));
        assert!(refused(&["scene", "one"]).contains("no scene \"one\""));
    }
}

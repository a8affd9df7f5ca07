//! `report`: error against run time, for experiments or for scenes.

use std::path::PathBuf;

use command_line::{make_default_folder, make_folder, print, terminal_bar};
use common::{Error, Stage, text};

use crate::experiment::Experiment;
use crate::report::{self, Measured};
use crate::{Laboratory, scene_report};

/// Reports the named experiments, or the scenes that are named after the word
/// `scene`.
pub fn report(
    laboratory: &Laboratory,
    names: &[String],
    output: Option<PathBuf>,
) -> Result<(), Error> {
    let stage = &laboratory.stage;
    match names.split_first() {
        Some((first, [])) if first == "scene" => {
            let names: Vec<_> = stage.scenes.iter().map(|scene| scene.name).collect();
            let names = names.join(", ");
            Err(Error::Usage(format!("report scene takes a scene: {names}")))
        }
        Some((first, names)) if first == "scene" => {
            let mut scenes = Vec::new();
            for name in names {
                scenes.push(stage.scene(name)?);
            }
            let mut experiments = Vec::new();
            for scene in &scenes {
                experiments.push(scene_report::experiment(scene)?);
            }
            measure(stage, experiments, output)
        }
        _ => {
            let experiments = chosen((laboratory.experiments)(), names)?;
            measure(stage, experiments, output)
        }
    }
}

/// The rounds in which the methods of an experiment take turns.
const ROUNDS: usize = 9;

fn measure(
    stage: &Stage,
    experiments: Vec<Experiment>,
    output: Option<PathBuf>,
) -> Result<(), Error> {
    let folder = match output {
        Some(folder) => folder,
        None => make_default_folder()?.join("report"),
    };
    make_folder(&folder)?;
    let mut all: Vec<Measured> = Vec::new();
    for experiment in experiments {
        let (mut bar, name) = (None, experiment.name);
        let measured = Measured::new(experiment, ROUNDS, |done, all| {
            let bar = bar.get_or_insert_with(|| terminal_bar(name, all as u64));
            bar.set_position(done as u64);
        });
        if let Some(bar) = bar {
            bar.finish_and_clear();
        }
        let opposite = report::opposite_of(&measured, &all);
        print(&measured.table(opposite))?;
        for path in measured.write(&folder, stage.name, opposite)? {
            print(&format!("  {}", text::path(&path)))?;
        }
        all.push(measured);
    }
    Ok(())
}

/// The experiments with these names; without a name, all experiments.
fn chosen(
    experiments: Vec<Experiment<'static>>,
    names: &[String],
) -> Result<Vec<Experiment<'static>>, Error> {
    let known: Vec<_> = experiments.iter().map(|e| e.name).collect();
    if let Some(name) = names.iter().find(|name| !known.contains(&name.as_str())) {
        let known = known.join(", ");
        return Err(Error::Usage(format!(
            "there is no experiment \"{name}\"; there are {known}, and scene NAME"
        )));
    }
    let mut chosen = experiments;
    if !names.is_empty() {
        chosen.retain(|experiment| names.iter().any(|name| name == experiment.name));
    }
    Ok(chosen)
}

#[cfg(test)]
mod tests {
    use common::{Image, Scene};

    use super::*;
    use crate::example::{curve, experiment};

    fn experiments() -> Vec<Experiment<'static>> {
        ["one", "two"]
            .map(|name| Experiment {
                name,
                curves: Box::new(|| vec![curve(&[(1.0, 1.0)])]),
                ..experiment()
            })
            .into()
    }

    #[test]
    fn the_named_experiments_or_scenes_are_reported_in_a_new_folder() {
        let disc = Scene::painted("disc", "", |settings, _| Image::black(settings.size));
        let laboratory = Laboratory {
            experiments,
            ..crate::example::laboratory(vec![disc])
        };
        let folder = tempfile::tempdir().unwrap();
        let report = |names: &[&str]| {
            let names: Vec<_> = names.iter().map(|name| (*name).to_owned()).collect();
            let output = folder.path().join("new/reports");
            report(&laboratory, &names, Some(output.clone()))?;
            let files = output.read_dir().unwrap();
            let mut files: Vec<_> = files.map(|file| file.unwrap().file_name()).collect();
            files.sort();
            Ok::<_, Error>(files)
        };
        assert_eq!(
            report(&["two"]).unwrap(),
            ["a00-two-time.svg", "a00-two.csv", "a00-two.svg"]
        );
        assert_eq!(report(&[]).unwrap().len(), 6);
        for (names, expected) in [
            (
                &["two", "three"][..],
                "there is no experiment \"three\"; there are one, two, and scene NAME",
            ),
            (&["scene"], "report scene takes a scene: disc"),
            (&["scene", "disc"], "disc is not sampled"),
            (&["scene", "one"], "no scene \"one\""),
        ] {
            let error = report(names).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
    }
}

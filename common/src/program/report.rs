//! `report`: error against run time, of experiments or of scenes.

use std::path::PathBuf;

use super::say;
use super::target::{make_default_folder, make_folder};
use crate::experiment::Experiment;
use crate::report::{self, Measured};
use crate::{Effort, Error, Stage, scene_report};

/// Reports the named experiments, or after the word `scene` the named scenes.
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
        let measured = Measured::new(experiment, effort);
        say(&measured.table());
        for path in measured.write(&folder, stage.name)? {
            say(&format!("  {}", path.display()));
        }
    }
    Ok(())
}

/// The experiments of these names; all without a name.
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

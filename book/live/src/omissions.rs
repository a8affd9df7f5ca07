//! The work that renderers leave out in a picture: how much of it there is, and pictures that do it to be timed.

use std::rc::Rc;

use common::comparison::{Comparison, WORK, small};
use common::omitted_work::{Words, count, is_omitted};
use common::steps::Counts;
use common::{Error, Omission, Omissions, Renderer, Scene, Settings};
use measure::experiment::{Curve, Errors, Experiment, Point, Times};
use measure::report::Measured;
use page::pixels;

use crate::{Answer, Answered, catalogue};

/// The scene of a picture, and settings for a small picture by the lesson or, if the first number is 1, the engine.
fn small_scene(picture: &str, numbers: &[f64]) -> Result<(Scene, Settings), Error> {
    let scene = catalogue::scene(picture)?;
    let settings = Settings {
        size: small(scene.defaults.size)?,
        renderer: match numbers {
            [engine, ..] if *engine == 1.0 => Renderer::Engine,
            _ => Renderer::Lesson,
        },
        ..scene.defaults.clone()
    };
    Ok((scene, settings))
}

/// The set without the kinds whose bits are set in a number of the page.
fn omissions(done: f64) -> Omissions {
    let done = done as u32;
    let mut omissions = Omissions::ALL;
    for (bit, omission) in Omission::ALL.into_iter().enumerate() {
        if done & (1 << bit) != 0 {
            omissions = omissions.without(omission);
        }
    }
    omissions
}

fn numbers_of(counts: &Counts) -> impl Iterator<Item = f64> {
    WORK.map(|work| counts[work.kind] as f64).into_iter()
}

/// What a picture leaves out. The text has the names of the kinds of work, and a line for each omission; the lists say
/// how much work the renderer does, how much each omission alone would add, and the bits of the omissions.
pub fn work(picture: &str, numbers: &[f64]) -> Answered {
    let (scene, settings) = small_scene(picture, numbers)?;
    let Comparison { done, all, .. } = Comparison::new(&scene, &settings)?;
    let image = scene.render(&settings, &())?;
    let mut lines = vec![WORK.map(|work| work.name).join("\t")];
    let (mut bits, mut alone) = (Vec::new(), Vec::new());
    for (bit, omission) in Omission::ALL.into_iter().enumerate() {
        if is_omitted(omission, &settings) {
            let Words { work, because } = Words::of(omission);
            lines.push(format!("{work}\t{because}"));
            let (_, counts) = count(&scene, &settings, Omissions::ALL.without(omission))?;
            alone.extend(numbers_of(&counts.without(&done)));
            bits.push(bit as f64);
        }
    }
    Ok(Answer {
        text: lines.join("\n"),
        ..pixels(&image)
    }
    .with("done", numbers_of(&done))
    .with("all", numbers_of(&all))
    .with("alone", alone)
    .with("bits", bits))
}

/// The work with the omissions put back whose bits are set in the second number, and the pixels.
pub fn done(picture: &str, numbers: &[f64]) -> Answered {
    let (scene, settings) = small_scene(picture, numbers)?;
    let put_back = numbers.get(1).copied().unwrap_or_default();
    let (image, counts) = count(&scene, &settings, omissions(put_back))?;
    Ok(pixels(&image).with("counts", numbers_of(&counts)))
}

/// The picture to be timed in turns: by the lesson with all omissions, with those put back whose bits are set in the
/// second number, and with all work. Beside the engine stands the lesson as it is.
pub fn measured(picture: &str, numbers: &[f64]) -> Result<Measured<'static>, Error> {
    let (scene, yours) = small_scene(picture, numbers)?;
    let scene = Rc::new(scene);
    let lesson = Settings {
        renderer: Renderer::Lesson,
        ..yours.clone()
    };
    let put_back = numbers.get(1).copied().unwrap_or_default();
    let all_on = (yours.renderer == Renderer::Lesson).then_some(Omissions::ALL);
    let curves = [
        ("all on", &lesson, all_on),
        ("yours", &yours, Some(omissions(put_back))),
        ("all work", &lesson, Some(omissions(u16::MAX.into()))),
    ]
    .map(|(method, settings, omissions)| {
        let scene = Rc::clone(&scene);
        let settings = Settings {
            omissions,
            ..settings.clone()
        };
        let point = Point {
            parameter: 1.0,
            work: 1.0,
            errors: Errors::of([0.0]),
            times: Times::of(move || scene.render(&settings, &())),
        };
        Curve::new(method, [point])
    });
    Ok(Measured {
        experiment: Experiment::new("left-out"),
        curves: curves.into(),
    })
}

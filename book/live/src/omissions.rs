//! The work that renderers leave out in a picture: how much of it there is, and pictures that do it to be timed.

use std::rc::Rc;

use common::comparison::{WORK, small};
use common::omitted_work::{OmittedWork, Words, count, is_omitted};
use common::steps::Counts;
use common::{Error, Omission, Omissions, Renderer, Scene, Settings};
use measure::experiment::{Curve, Errors, Experiment, Point, Times};
use measure::report::Measured;
use page::pixels;

use crate::{Answered, Reply, catalogue};

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

/// Every omission put back.
fn none_left_out() -> Omissions {
    omissions(u16::MAX.into())
}

/// What a picture leaves out. The text has the names of the kinds of work, and a line for each omission, whose reason the page has; the lists say
/// how much work the renderer does, how much if it leaves out nothing, how much each omission saves, counted as
/// `render --explain` does, and the bits of the omissions.
pub fn work(picture: &str, numbers: &[f64]) -> Answered {
    let (scene, settings) = small_scene(picture, numbers)?;
    let (image, done) = count(&scene, &settings, Omissions::ALL)?;
    let (_, all) = count(&scene, &settings, none_left_out())?;
    let rows = OmittedWork::all(&scene, &settings)?;
    let mut lines = vec![WORK.map(|work| work.name).join("\t")];
    let (mut bits, mut saved) = (Vec::new(), Vec::new());
    for (bit, omission) in Omission::ALL.into_iter().enumerate() {
        if is_omitted(omission, &settings) {
            lines.push(Words::of(omission).work.to_owned());
            let row = rows.iter().find(|row| row.omission == omission);
            match row {
                Some(row) => saved.extend(numbers_of(&row.steps)),
                None => saved.extend([0.0; WORK.len()]),
            }
            bits.push(bit as f64);
        }
    }
    Ok(Reply {
        text: lines.join("\n"),
        ..pixels(&image)
    }
    .with("done", numbers_of(&done))
    .with("all", numbers_of(&all))
    .with("saved", saved)
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
        ("all work", &lesson, Some(none_left_out())),
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

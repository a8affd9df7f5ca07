//! The work that renderers leave out in a picture: how much of it there is, and pictures that do it to be timed.

use common::comparison::{Comparison, WORK, small};
use common::omitted_work::{Words, count, is_omitted};
use common::steps::Counts;
use common::{Error, Median, Omission, Omissions, Renderer, Scene, Settings};
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

/// The same picture without counting, several times, to be timed. The third number says how often; a second one below
/// 0 takes the renderer as it is.
pub fn timed(picture: &str, numbers: &[f64]) -> Answered {
    let (scene, settings) = small_scene(picture, numbers)?;
    let put_back = numbers.get(1).copied().unwrap_or_default();
    let settings = Settings {
        omissions: (put_back >= 0.0).then(|| omissions(put_back)),
        ..settings
    };
    for _ in 1..numbers.get(2).map_or(1, |rounds| *rounds as u32) {
        scene.render(&settings, &())?;
    }
    Ok(pixels(&scene.render(&settings, &())?))
}

/// The median of quotients of times that were measured in turns, with its interval: first all dividends, then all
/// divisors. The text is for the reader.
pub fn quotient(times: &[f64]) -> Answer {
    let (dividends, divisors) = times.split_at(times.len() / 2);
    let median = Median::of_quotients(dividends, divisors);
    Answer::text(median.to_string()).with("quotient", [median.low, median.value, median.high])
}

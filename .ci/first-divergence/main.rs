//! Prints the first step at which the lesson and its broken copy part: in the worst pixel of the
//! first scene of the named stages whose picture differs.

use common::difference::worst_pixel;
use common::divergence::ROUNDING;
use common::{Error, Settings, Size, Transfer};

fn main() -> Result<(), Error> {
    let stages: Vec<_> = std::env::args().skip(1).collect();
    let pairs = [
        (lesson_a03::stage(), broken_a03::stage()),
        (lesson_a04::stage(), broken_a04::stage()),
        (lesson_a05::stage(), broken_a05::stage()),
        (lesson_a06::stage(), broken_a06::stage()),
        (lesson_a07::stage(), broken_a07::stage()),
    ];
    let named = |stage: &str| stages.iter().any(|name| stage.starts_with(name));
    let pairs = pairs.iter().filter(|(lesson, _)| named(lesson.name));
    for (lesson, broken) in pairs.flat_map(|(a, b)| a.scenes.iter().zip(&b.scenes)) {
        let settings = Settings {
            size: Size::new(320, 240)?,
            ..lesson.defaults.clone()
        };
        let [right, wrong] = [lesson, broken].map(|scene| scene.render(&settings, &()));
        let (right, wrong) = (right?, wrong?);
        if right.to_rgb8(Transfer::Linear) == wrong.to_rgb8(Transfer::Linear) {
            continue;
        }
        let Some(pixel) = worst_pixel(&right, &wrong) else {
            continue;
        };
        let [right, wrong] = [lesson, broken].map(|scene| scene.rays()?.trace(&settings, pixel));
        let parts = right?.first_divergence(&wrong?, "the edit's", ROUNDING);
        match parts {
            Some(parts) => println!("{}, {parts}", lesson.name),
            None => println!("{}: all steps are the same", lesson.name),
        }
        return Ok(());
    }
    println!("no picture differs");
    Ok(())
}

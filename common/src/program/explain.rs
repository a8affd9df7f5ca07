//! `render --explain`: what is left out of a picture's making, and what that
//! saves.

use std::time::Instant;

use super::say;
use crate::comparison::{Comparison, complete};
use crate::overrides::Overrides;
use crate::{Error, Image, Scene, Settings};

/// Times are the shortest of so many.
const ROUNDS: usize = 3;

/// Says what the scene's plan leaves out and what that saves, and returns the
/// picture.
pub fn explain(scene: &Scene, overrides: &Overrides) -> Result<Image, Error> {
    let settings = Settings {
        omit: true,
        ..overrides.settings(scene)?
    };
    say(&format!("{}  {}", scene.name, settings.size));
    say(&scene.plan(&settings)?.to_string());
    let threads = overrides.thread_pool()?;
    threads.install(|| {
        let comparison = Comparison::new(scene, &settings)?;
        if scene.heeds.sampling {
            say(&comparison.to_string());
            let [needed, all] = shortest(scene, [&settings, &complete(&settings)])?;
            let ratio = all / needed;
            say(&format!(
                "  time {needed:.3} s; everything takes {ratio:.2} times as long"
            ));
            let difference = comparison.difference;
            say(&format!(
                "  largest difference of a channel {difference:.1e}"
            ));
        }
        Ok(comparison.image)
    })
}

/// The shortest time of each, in seconds. They take turns, so that what else
/// the machine does hits them alike.
fn shortest(scene: &Scene, settings: [&Settings; 2]) -> Result<[f64; 2], Error> {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        for (settings, least) in settings.iter().zip(&mut least) {
            let start = Instant::now();
            scene.render(settings, &())?;
            *least = least.min(start.elapsed().as_secs_f64());
        }
    }
    Ok(least)
}

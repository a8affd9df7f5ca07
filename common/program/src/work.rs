//! `render --explain`: the work that the renderer skips for a picture, and how much
//! that saves.

use std::time::Instant;

use common::{Error, Image, Median, Scene, Settings};

use crate::comparison::{Comparison, complete};
use crate::options::Options;
use crate::print::print;

/// Prints the work that the renderer skips and how much that saves, and returns the picture.
pub fn render_and_report(
    scene: &Scene,
    settings: &Settings,
    options: &Options,
) -> Result<Image, Error> {
    print(&format!("{}  {}", scene.name, settings.size))?;
    let threads = options.thread_pool()?;
    threads.install(|| {
        let comparison = Comparison::new(scene, settings)?;
        if scene.uses.sampling {
            print(&comparison.to_string())?;
            let times = times(scene, [settings, &complete(settings)])?;
            print(&comparison_of(&times))?;
            let difference = comparison.difference;
            print(&format!(
                "  largest difference of a channel {difference:.1e}"
            ))?;
        } else {
            print("  nothing to leave out: the picture takes no rays")?;
        }
        Ok(comparison.image)
    })
}

/// The time of the chosen renderer, and how many times as long the one takes that skips
/// no work, if that is more than noise.
fn comparison_of([needed, all]: &[Vec<f64>; 2]) -> String {
    let time = Median::of(needed.clone()).value;
    let ratio = Median::of_quotients(all, needed);
    let Median { low, value, high } = ratio;
    match ratio.noise() {
        Some(noise) => {
            format!("  time {time:.3} s; everything: no difference beyond the noise of {noise}")
        }
        None => format!(
            "  time {time:.3} s; everything takes {value:.2} times as long ({low:.2} to {high:.2})"
        ),
    }
}

/// The times with each of the settings, in seconds. They take turns, so that other load
/// on the machine affects them equally.
fn times(scene: &Scene, settings: [&Settings; 2]) -> Result<[Vec<f64>; 2], Error> {
    let mut seconds = [const { Vec::new() }; 2];
    for _ in 0..Median::ROUNDS {
        for (settings, seconds) in settings.iter().zip(&mut seconds) {
            let start = Instant::now();
            scene.render(settings, &())?;
            seconds.push(start.elapsed().as_secs_f64());
        }
    }
    Ok(seconds)
}

#[cfg(test)]
mod tests {
    use std::thread::sleep;
    use std::time::Duration;

    use common::{Color, Renderer, Size};

    use super::*;

    /// The renderer that skips no work takes three milliseconds, and paints the picture
    /// white.
    fn scene() -> Scene {
        let wait = Duration::from_millis(3);
        let scene = Scene::sampled("slow", "", move |settings, _| {
            if settings.renderer != Renderer::AllWork {
                return Image::black(settings.size);
            }
            sleep(wait);
            Image::from_fn(settings.size, |_, _| Color::WHITE)
        });
        scene.with_defaults(Settings {
            size: Size::new(1, 1).unwrap(),
            ..Settings::default()
        })
    }

    #[test]
    fn each_renderer_has_its_own_times_and_the_chosen_one_paints_the_picture() {
        let scene = scene();
        let settings = &scene.defaults;
        let image = render_and_report(&scene, settings, &Options::default()).unwrap();
        assert_eq!(image.pixels(), [Color::BLACK]);
        let [needed, all] = times(&scene, [settings, &complete(settings)]).unwrap();
        assert_eq!((needed.len(), all.len()), (Median::ROUNDS, Median::ROUNDS));
        assert!(all.iter().all(|seconds| *seconds >= 0.003));
    }

    #[test]
    fn times_are_compared_unless_they_differ_by_noise() {
        let needed = vec![0.25; 6];
        let of = |all: [f64; 6]| comparison_of(&[needed.clone(), all.into()]);
        let slower = of([1.5, 1.0, 2.0, 1.5, 1.5, 1.5]);
        let numbers = ["time 0.250 s", "6.00 times", "(4.00 to 8.00)"];
        assert!(numbers.iter().all(|part| slower.contains(part)), "{slower}");
        let equal = of([0.125, 0.25, 0.25, 0.25, 0.25, 0.3125]);
        assert!(equal.contains("a factor of 2.0"), "{equal}");
    }
}

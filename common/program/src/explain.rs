//! `render --explain`: the work that the renderer skips for a picture, and how much
//! that saves.

use std::time::Instant;

use common::{Error, Image, Renderer, Scene, Settings};
use measure::comparison::{Comparison, complete};

use crate::options::Options;
use crate::print::print;

/// Number of renderings, of which the shortest time counts.
const ROUNDS: usize = 3;

/// Prints the work that the scene's plan skips and how much that saves, and returns
/// the picture.
pub fn explain(scene: &Scene, options: &Options) -> Result<Image, Error> {
    let settings = options.settings(scene)?;
    check(&settings)?;
    print(&format!("{}  {}", scene.name, settings.size));
    print(&scene.plan(&settings)?.to_string());
    let threads = options.thread_pool()?;
    threads.install(|| {
        let comparison = Comparison::new(scene, &settings)?;
        if scene.uses.sampling {
            print(&comparison.to_string());
            print(&times(shortest(scene, [&settings, &complete(&settings)])?));
            let difference = comparison.difference;
            print(&format!(
                "  largest difference of a channel {difference:.1e}"
            ));
        }
        Ok(comparison.image)
    })
}

/// Refuses the renderer that skips no work: there is nothing to compare it with.
pub fn check(settings: &Settings) -> Result<(), Error> {
    match settings.renderer {
        Renderer::Lesson | Renderer::Engine => Ok(()),
        Renderer::AllWork => Err(Error::Usage(
            "--explain compares a renderer with --no-omit, which leaves nothing out; \
             give --explain without --no-omit, or with --fast"
                .to_owned(),
        )),
    }
}

fn times([needed, all]: [f64; 2]) -> String {
    let ratio = all / needed;
    format!("  time {needed:.3} s; everything takes {ratio:.2} times as long")
}

/// The shortest time with each of the settings, in seconds. They take turns, so that
/// other load on the machine affects them equally.
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

#[cfg(test)]
mod tests {
    use std::thread::sleep;
    use std::time::Duration;

    use common::{Color, Size};

    use super::*;

    /// The renderer that skips no work takes three milliseconds, and paints the picture
    /// white.
    fn scene() -> Scene {
        let wait = Duration::from_millis(3);
        let scene = Scene::traced("slow", "", move |settings, _| {
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
    fn the_picture_comes_from_the_chosen_renderer() {
        let image = explain(&scene(), &Options::default()).unwrap();
        assert_eq!(image.pixels(), [Color::BLACK]);
    }

    #[test]
    fn the_renderer_that_skips_no_work_is_refused() {
        let scene = scene().with_defaults(Settings {
            renderer: Renderer::AllWork,
            ..Settings::default()
        });
        let error = explain(&scene, &Options::default()).unwrap_err();
        assert_eq!(error.exit_code(), 2);
        assert!(error.to_string().contains("without --no-omit"), "{error}");
    }

    #[test]
    fn each_renderer_has_its_own_time() {
        let scene = scene();
        let settings = &scene.defaults;
        let [needed, all] = shortest(&scene, [settings, &complete(settings)]).unwrap();
        assert!(
            needed >= 0.0 && needed < all && all >= 0.003,
            "{needed} {all}"
        );
    }

    #[test]
    fn times_are_printed_with_their_ratio() {
        let expected = "  time 0.250 s; everything takes 6.00 times as long";
        assert_eq!(times([0.25, 1.5]), expected);
    }
}

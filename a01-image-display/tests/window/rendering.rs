//! The window while a rendering goes on, and with a scene of rays.

use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};
use std::{env, fs, thread};

use a01_image_display::viewer;
use common::{
    Color, Error, Explained, Image, PixelTrace, Progress, Scene, SeenLine, Settings, fnv1a,
};
use measure::Stage;

use crate::display::{Display, wait_for};
use crate::{with_window, with_window_of};

/// A picture whose colour has the numbers that the window can change. At its full size, it is
/// rendered until it is stopped, unless it has one sample.
fn numbers(settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
    let light = settings.moves.lights.first().map_or(0.0, |way| way[0]);
    let [r, g] = settings.moves.turn;
    let color = Color::new(r, g, light + f64::from(settings.depth) / 8.0);
    let image = Image::from_fn(settings.size, |_, _| color)?;
    progress.row(
        0,
        &mut image
            .pixels()
            .iter()
            .copied()
            .take(settings.size.width() as usize),
    );
    while settings.samples > 1 && !progress.stopped() {
        thread::sleep(Duration::from_millis(5));
    }
    if progress.stopped() {
        Err(Error::Stopped)
    } else {
        Ok(image)
    }
}

struct OneLight;

impl Explained for OneLight {
    fn trace(&self, _: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error> {
        let (color, steps) = (Color::RED, vec![common::steps::Step::new("", "a step", "")]);
        Ok(PixelTrace {
            pixel,
            color,
            steps,
        })
    }

    fn drawing(&self, _: &Settings, _: &PixelTrace) -> Result<String, Error> {
        Ok(String::new())
    }

    fn seen_rays(&self, _: &Settings, _: &PixelTrace) -> Result<Vec<SeenLine>, Error> {
        Ok(Vec::new())
    }

    fn light_places(&self, _: &Settings) -> Result<Vec<[f64; 3]>, Error> {
        Ok(vec![[1.0, 2.0, 3.0]])
    }

    fn export(&self, _: &str, _: &Settings) -> Result<String, Error> {
        Ok(String::new())
    }
}

/// The program of the tests below, which start it in a process of its own.
#[test]
#[ignore = "is no test"]
fn program_with_rays() {
    let mut scene = Scene::traced("numbers", "", numbers).reflecting();
    scene.explained = Some(Arc::new(OneLight));
    let stage = Stage {
        name: "stage",
        about: "",
        scenes: vec![scene],
        experiments: Vec::new,
        extremes: |_| Vec::new(),
        search: None,
        open: None,
    };
    let line = ["stage", "--threads", "1"].map(Into::into);
    assert_eq!(program::run_with(&stage, viewer(), line), ExitCode::SUCCESS);
}

fn with_rendering(test: impl FnOnce(Display, &Path)) {
    let line = "rendering::program_with_rays --exact --ignored";
    with_window_of(&env::current_exe().expect("this test"), line, test);
}

#[test]
fn camera_and_lights_move_and_return() {
    with_rendering(|window, _| {
        let shown = |color: [u8; 3]| format!("picture: Some({})", fnv1a(&color.repeat(640 * 480)));
        // Depth 6 of 8.
        let start = shown([0, 0, 191]);
        window.play(&[
            ("mousemove --window WINDOW 300 100", &start),
            ("mousedown 3", "right: true"),
            // 50 pixels to the left and 20 up, of 0.01 each.
            ("mousemove --window WINDOW 250 80", &shown([128, 51, 191])),
            ("mousemove --window WINDOW 300 100", &start),
            ("mouseup 3", "right: false"),
            ("key ctrl+Left", &shown([51, 0, 191])),
            ("item 0 Depth", &shown([51, 0, 32])),
            // The slider stays selected: the next one is that of the light.
            ("key Down Right Right", &shown([51, 0, 159])),
            ("key r", &start),
            (
                "key i",
                "pixel: Some([320, 240]) & explained: true & text: \"a step\"",
            ),
            ("key Right", "pixel: Some([321, 240]) & explained: true"),
        ]);
    });
}

#[test]
fn a_rendering_that_goes_on_answers_and_ends() {
    with_rendering(|window, folder| {
        window.play(&[
            ("item 0.99 Samples", " to go\" & picture: None"),
            ("key s", "the picture is not finished yet"),
            ("key Escape Escape", ""),
        ]);
        window.wait_for_end();
        assert_eq!(folder.read_dir().unwrap().count(), 0, "no file");
    });
}

#[test]
fn a_finished_window_has_one_thread_and_hardly_computes() {
    with_window("show painter", |window, _| {
        let process = Path::new("/proc").join(window.program.id().to_string());
        wait_for("the end of other threads", || {
            let threads = process.join("task").read_dir().unwrap().count();
            (threads == 1 && window.state().contains("finished: true")).then_some(())
        });
        // Nanoseconds that the thread had a processor.
        let time = || {
            let statistics = fs::read_to_string(process.join("schedstat")).unwrap();
            let nanoseconds = statistics.split(' ').next().unwrap().parse();
            Duration::from_nanos(nanoseconds.unwrap())
        };
        let (start, before) = (Instant::now(), time());
        thread::sleep(Duration::from_secs(3));
        let (time, elapsed) = (time().abs_diff(before), start.elapsed());
        assert!(time < elapsed / 10, "{time:?} in {elapsed:?}");
    });
}

//! Locks the pictures of a stage in its tests.
//!
//! A lock has two halves: a text snapshot with the picture's size, the hash of
//! its bytes and a thumbnail in characters, and the expected PNG, which lies
//! where the book shows it. [`lock_pictures!`](crate::lock_pictures) writes the
//! tests; `INSTA_UPDATE=always` accepts what they see, in both halves.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::program::picture_name;
use crate::{Color, Image, Scene, Settings, Size, Stage, Transfer, picture_file};

/// Width of the thumbnail in characters.
const COLUMNS: usize = 48;

/// Where the test crate and its files lie; [`lock_pictures!`](crate::lock_pictures)
/// fills it in.
pub struct Places {
    /// The folder of the stage's crate.
    pub stage: &'static str,
    /// A folder for what a failed test leaves behind.
    pub scratch: &'static str,
    /// The stage's program.
    pub program: &'static str,
}

impl Places {
    fn expected(&self, name: &str) -> PathBuf {
        Path::new(self.stage)
            .join("../book/src/pictures")
            .join(name)
    }
}

/// Writes the tests of a stage's pictures: a lock for each scene, under its
/// name, and what holds for all of them.
///
/// ```ignore
/// common::lock_pictures! { a04_intersections::stage(); scene_1 scene_2 }
/// ```
#[macro_export]
macro_rules! lock_pictures {
    ($stage:expr; $($scene:ident)+) => {
        const PLACES: $crate::picture_lock::Places = $crate::picture_lock::Places {
            stage: env!("CARGO_MANIFEST_DIR"),
            scratch: env!("CARGO_TARGET_TMPDIR"),
            program: env!(concat!("CARGO_BIN_EXE_", env!("CARGO_PKG_NAME"))),
        };

        $(
            #[test]
            fn $scene() {
                $crate::picture_lock::check(&$stage, stringify!($scene), &PLACES);
            }
        )+

        #[test]
        fn every_scene_is_locked() {
            $crate::picture_lock::check_complete(&$stage, &[$(stringify!($scene)),+]);
        }

        #[test]
        fn one_thread_and_two_give_the_same_bytes() {
            $crate::picture_lock::check_threads(&$stage);
        }

        #[test]
        fn what_is_left_out_changes_no_byte() {
            $crate::picture_lock::check_omissions(&$stage);
        }

        #[test]
        fn pictures_of_one_pixel_and_of_one_row_are_no_trouble() {
            $crate::picture_lock::check_narrow_sizes(&$stage);
        }

        #[test]
        fn without_a_display_the_program_leaves_its_first_picture() {
            $crate::picture_lock::check_program(&$stage, &PLACES);
        }
    };
}

fn render(scene: &Scene, settings: &Settings) -> Image {
    let image = scene.render(settings, &()).expect("the scene renders");
    assert_eq!(image.count_non_finite(), 0, "no pixel is NaN or infinite");
    image
}

/// Renders a scene and compares it with both halves of its lock.
///
/// # Panics
///
/// If the picture differs; the message says how, and where to look at it.
pub fn check(stage: &Stage, test: &str, places: &Places) {
    let scene = stage.scene(&test.replace('_', "-")).expect("a scene");
    let image = render(scene, &scene.defaults);
    let (size, rgb) = (image.size(), image.to_rgb8(Transfer::Linear));

    let name = picture_name(stage, scene);
    let expected = places.expected(&name);
    let comparison = picture_file::open(&expected)
        .map_err(|error| error.to_string())
        .and_then(|stored| compare(&stored, &image));
    let accept = std::env::var("INSTA_UPDATE").as_deref() == Ok("always");
    let report = match comparison {
        Ok(()) => None,
        Err(_) if accept => {
            picture_file::save_png(&expected, size, &rgb).expect("the expected picture is written");
            None
        }
        Err(difference) => Some(leave_pictures(places, &name, &image, &difference)),
    };
    if let Some(report) = &report {
        eprintln!("{report}");
    }

    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(Path::new(places.stage).join("tests/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_description(format!("{}: {}", scene.name, scene.about));
    settings.bind(|| insta::assert_snapshot!(scene.name, describe(size, &rgb)));
    assert!(report.is_none(), "{}", report.unwrap_or_default());
}

/// Says how a picture differs from the expected one, if it does.
fn compare(expected: &Image, actual: &Image) -> Result<(), String> {
    let (size, other) = (expected.size(), actual.size());
    if size != other {
        return Err(format!("expected {size} pixels, got {other}"));
    }
    let bytes = |image: &Image| image.to_rgb8(Transfer::Linear);
    let (expected, actual) = (bytes(expected), bytes(actual));
    let pairs = expected.chunks_exact(3).zip(actual.chunks_exact(3));
    let differing: Vec<_> = pairs.enumerate().filter(|(_, (e, a))| e != a).collect();
    let Some((first, (wanted, got))) = differing.first() else {
        return Ok(());
    };
    let channels = expected.iter().zip(&actual);
    let largest = channels.map(|(e, a)| e.abs_diff(*a)).max().unwrap_or(0);
    let width = size.width() as usize;
    Err(format!(
        "{} of {} pixels differ, a channel by at most {largest} of 255; \
         the first is column {}, row {}: expected {wanted:?}, got {got:?}",
        differing.len(),
        size.pixels(),
        first % width,
        first / width,
    ))
}

/// Writes the actual, the expected and the difference picture, and says where.
fn leave_pictures(places: &Places, name: &str, actual: &Image, difference: &str) -> String {
    let scratch = Path::new(places.scratch);
    let write = |suffix: &str, image: &Image| {
        let path = scratch.join(name.replace(".png", suffix));
        let written = picture_file::save_png(&path, image.size(), &image.to_rgb8(Transfer::Linear));
        written.map_or_else(|error| error.to_string(), |()| path.display().to_string())
    };
    let mut report = vec![
        format!("{name}: {difference}"),
        format!("  actual:     {}", write(".actual.png", actual)),
    ];
    if let Ok(expected) = picture_file::open(&places.expected(name)) {
        report.push(format!(
            "  expected:   {}",
            write(".expected.png", &expected)
        ));
        let apart = Image::from_fn(actual.size(), |x, y| {
            let pixel = |image: &Image| image.get(x, y).unwrap_or(Color::WHITE);
            (pixel(actual) - pixel(&expected)).map(f64::abs)
        });
        if let Ok(apart) = apart {
            report.push(format!(
                "  difference: {}",
                write(".difference.png", &apart)
            ));
        }
    }
    report.push("  INSTA_UPDATE=always accepts what the test sees; look at it first".into());
    report.join("\n")
}

/// The text half of a lock.
fn describe(size: Size, rgb: &[u8]) -> String {
    let mut lines = vec![
        format!("size {size}"),
        format!("hash {:016x}", fnv1a(rgb)),
        "brightness and hue (capital: bright)".to_owned(),
    ];
    let (width, height) = (size.width() as usize, size.height() as usize);
    // A character is about twice as high as it is wide.
    let rows = (COLUMNS * height / width / 2).max(1);
    for row in 0..rows {
        let y = row * height / rows..((row + 1) * height).div_ceil(rows);
        let cell = |column: usize| {
            let x = column * width / COLUMNS..((column + 1) * width).div_ceil(COLUMNS);
            mean(rgb, width, x, y.clone())
        };
        let cells: Vec<_> = (0..COLUMNS).map(cell).collect();
        let characters = |f: fn(&[f64; 3]) -> char| cells.iter().map(f).collect::<String>();
        lines.push(format!(
            "|{}|  |{}|",
            characters(brightness),
            characters(hue)
        ));
    }
    lines.join("\n")
}

/// The mean of each channel over columns `x` and rows `y`, from 0 to 255.
fn mean(
    rgb: &[u8],
    width: usize,
    x: std::ops::Range<usize>,
    y: std::ops::Range<usize>,
) -> [f64; 3] {
    let count = (x.len() * y.len()) as f64;
    let cells = y.flat_map(|y| x.clone().map(move |x| 3 * (y * width + x)));
    let sums = cells.fold([0_u64; 3], |sums, at| {
        [0, 1, 2].map(|channel| sums[channel] + u64::from(rgb[at + channel]))
    });
    sums.map(|sum| sum as f64 / count)
}

fn brightness(&[r, g, b]: &[f64; 3]) -> char {
    const RAMP: &[u8; 10] = b" .:-=+*#%@";
    // Weights of ITU-R BT.709.
    let luminance = (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255.0;
    char::from(RAMP[(luminance * 9.0 + 0.5) as usize])
}

fn hue(channels: &[f64; 3]) -> char {
    // The letters of red, green, blue and their sums, by which channels are on.
    const NAMES: &[u8; 8] = b" rgybmcw";
    let strongest = channels.iter().copied().fold(0.0, f64::max);
    let on = |channel: usize| usize::from(channels[channel] > strongest / 2.0) << channel;
    let name = char::from(NAMES[on(0) | on(1) | on(2)]);
    match strongest {
        ..8.0 => '.',
        ..128.0 => name,
        _ => name.to_ascii_uppercase(),
    }
}

/// FNV-1a, 64 bits (Fowler, Noll, Vo): tells pictures apart, guards no secret.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Checks that the tests name all scenes of the stage.
///
/// # Panics
///
/// If a scene has no lock.
pub fn check_complete(stage: &Stage, tests: &[&str]) {
    let locked: Vec<_> = tests.iter().map(|test| test.replace('_', "-")).collect();
    let scenes: Vec<_> = stage.scenes.iter().map(|scene| scene.name).collect();
    assert_eq!(locked, scenes, "the tests name every scene, in order");
}

/// Few pixels, so that a scene can be rendered several times.
fn small(scene: &Scene) -> Settings {
    Settings {
        size: Size::new(96, 72).expect("a size"),
        ..scene.defaults.clone()
    }
}

/// Checks that the number of threads changes nothing.
///
/// # Panics
///
/// If it does.
pub fn check_threads(stage: &Stage) {
    for scene in &stage.scenes {
        let [one, two] = [1, 2].map(|threads| {
            let threads = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            threads
                .expect("threads")
                .install(|| render(scene, &small(scene)))
        });
        assert_eq!(one, two, "{}", scene.name);
    }
}

/// Checks that rays which are left out change nothing.
///
/// # Panics
///
/// If they do.
pub fn check_omissions(stage: &Stage) {
    for scene in &stage.scenes {
        let all = Settings {
            omit: false,
            ..small(scene)
        };
        let [with, without] = [small(scene), all].map(|settings| render(scene, &settings));
        assert_eq!(with, without, "{}", scene.name);
    }
}

/// Renders every scene at the sizes that divide by zero if anything does.
///
/// # Panics
///
/// If a picture has another size than asked for, or pixels that are no numbers.
pub fn check_narrow_sizes(stage: &Stage) {
    for scene in stage.scenes.iter().filter(|scene| scene.heeds.size) {
        for (width, height) in [(1, 1), (1, 50), (50, 1)] {
            let size = Size::new(width, height).expect("a size");
            let settings = Settings {
                size,
                ..scene.defaults.clone()
            };
            assert_eq!(render(scene, &settings).size(), size, "{}", scene.name);
        }
    }
}

/// Runs the program with no display and compares the PNG it leaves.
///
/// # Panics
///
/// If the program fails, or does not leave its first picture and say where.
pub fn check_program(stage: &Stage, places: &Places) {
    let folder = tempfile::tempdir().expect("a folder");
    // On these the display cannot be taken from the program, but only declined.
    let always_a_display = cfg!(any(windows, target_os = "macos"));
    let output = Command::new(places.program)
        .args(always_a_display.then_some("--no-window"))
        .current_dir(&folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .expect("the program runs");
    let name = picture_name(stage, &stage.scenes[0]);
    let said = String::from_utf8_lossy(&output.stdout);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    let explained = always_a_display || complaint.starts_with("no window: ");
    assert!(explained, "{complaint}");
    assert!(said.contains(&name), "{said}");
    let open = |path: &Path| picture_file::open(path).expect("a picture");
    let left = open(&folder.path().join("out").join(&name));
    assert_eq!(left, open(&places.expected(&name)));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(color: impl FnMut(u32, u32) -> Color) -> Image {
        Image::from_fn(Size::new(96, 64).unwrap(), color).unwrap()
    }

    #[test]
    fn a_difference_is_told_in_full() {
        let black = picture(|_, _| Color::BLACK);
        assert_eq!(compare(&black, &black), Ok(()));
        let mut other = black.clone();
        other.set(5, 2, Color::from_bytes([0, 7, 0]));
        other.set(9, 60, Color::from_bytes([3, 0, 0]));
        assert_eq!(
            compare(&black, &other).unwrap_err(),
            "2 of 6144 pixels differ, a channel by at most 7 of 255; \
             the first is column 5, row 2: expected [0, 0, 0], got [0, 7, 0]"
        );
        let wide = Image::black(Size::new(97, 64).unwrap()).unwrap();
        assert_eq!(
            compare(&black, &wide).unwrap_err(),
            "expected 96x64 pixels, got 97x64"
        );
    }

    #[test]
    fn a_mismatch_leaves_three_pictures() {
        let folder = tempfile::tempdir().unwrap();
        let scratch = folder.path().to_str().unwrap().to_owned().leak();
        // The expected picture lies at ../book/src/pictures from the stage.
        let stage = folder
            .path()
            .join("stage")
            .to_str()
            .unwrap()
            .to_owned()
            .leak();
        let places = Places {
            stage,
            scratch,
            program: "",
        };
        std::fs::create_dir_all(places.stage).unwrap();
        std::fs::create_dir_all(folder.path().join("book/src/pictures")).unwrap();
        let [black, red] = [Color::BLACK, Color::RED].map(|color| picture(|_, _| color));
        let rgb = black.to_rgb8(Transfer::Linear);
        picture_file::save_png(&places.expected("a.png"), black.size(), &rgb).unwrap();

        let report = leave_pictures(&places, "a.png", &red, "they differ");
        let left = |name: &str| picture_file::open(&folder.path().join(name)).unwrap();
        assert!(report.contains("a.png: they differ"), "{report}");
        assert_eq!(left("a.actual.png"), red);
        assert_eq!(left("a.expected.png"), black);
        assert_eq!(left("a.difference.png"), red);
    }

    #[test]
    fn the_thumbnail_shows_brightness_and_hue() {
        let halves = picture(|x, _| {
            if x < 48 {
                Color::WHITE
            } else {
                Color::RED * 0.4
            }
        });
        let text = describe(halves.size(), &halves.to_rgb8(Transfer::Linear));
        let line = text.lines().nth(3).unwrap();
        let expected = format!(
            "|{}{}|  |{}{}|",
            "@".repeat(24),
            ".".repeat(24),
            "W".repeat(24),
            "r".repeat(24)
        );
        assert_eq!(line, expected);
        assert_eq!(text.lines().count(), 3 + 16);
    }

    #[test]
    fn the_hash_is_the_published_one() {
        // Test vectors of the FNV draft (Eastlake et al.).
        assert_eq!(fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }
}

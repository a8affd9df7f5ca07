//! Random command lines: the programs of a stage and of its laboratory never panic, end with an
//! exit code that they document, and leave no file that is no whole picture.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::{env, fs};

use command_line::{Gallery, NotShown, run_with};
use common::{Color, Error, Image, Progress, Scene, Settings, Size, Stage, picture_file};
use measure::Laboratory;
use measure::extremes::{Case, Number};
use testing::{Random, for_seeds};

/// Set in the process that runs the programs: their messages are not output of a test,
/// and they write into the current folder.
const INSIDE: &str = "COMMAND_LINE_INSIDE";

#[test]
fn no_command_line_does_harm() {
    if env::var_os(INSIDE).is_some() {
        return run_many();
    }
    let mut test = Command::new(env::current_exe().expect("this test"));
    let output = test.env(INSIDE, "").arg("--nocapture").output();
    let output = output.expect("the test runs");
    let text = String::from_utf8_lossy(&output.stderr);
    let failure = text.find("panicked at").unwrap_or(0);
    assert!(output.status.success(), "{}", &text[failure..]);
}

fn run_many() {
    let folder = tempfile::tempdir().expect("a folder");
    // A path may begin with `..`.
    let place = folder.path().join("place");
    fs::create_dir(&place).expect("a folder");
    env::set_current_dir(&place).expect("a folder");
    for_seeds(1000, |random| {
        let line = ["a00".to_owned()].into_iter().chain(arguments(random));
        let line: Vec<_> = line.map(with_bytes).collect();
        let documented = [0, 1, 2].map(ExitCode::from);
        for code in [
            run_with(&stage(), Some(look), line.clone()),
            measure::run_with(&laboratory(), line.clone()),
        ] {
            assert!(documented.contains(&code), "{code:?} for {line:?}");
        }
        clear(folder.path(), &place);
    });
}

const COMMANDS: &str = "| list | show traced | show opened --no-window | show cube | render painted
    | render traced painted | render --all | render traced --explain | render -- --all
    | explain traced --pixel 1,1 | explain painted --pixel 9
    | export traced --to toml
    | report | report scene traced | extremes A B01 | render --help | rendr traced | -";

const FLAGS: &str = "--size --samples --sampling --max-error --seed --depth --threads
    --transfer --open -o --output --fast --no-omit --no-window
    --drawing --rays --replace";

const VALUES: &str = "0 1 4 -1 3x2 32768x32768 32769x1 1/510 1e-300 0/0 nan/0 inf center regular
    random stratified srgb a.png .. here \u{1F}a 1000001 4294967296 18446744073709551615";

/// One of these words, or in one of ten cases any text without a separator that could lead out of the
/// folder.
fn word(words: &str, random: &mut Random) -> String {
    if random.below(10) == 0 {
        let letters = (0..random.below(6)).filter_map(|_| match random.below(3) {
            0 => Some('-'),
            _ => char::from_u32(random.below(0x300)),
        });
        return letters.filter(|letter| !"/\\:".contains(*letter)).collect();
    }
    let words: Vec<_> = words.split_whitespace().collect();
    words[random.below(words.len() as u32) as usize].to_owned()
}

/// A command with up to four flags, most of them known and with a value.
fn arguments(random: &mut Random) -> Vec<String> {
    let commands: Vec<_> = COMMANDS.split('|').collect();
    let command = commands[random.below(commands.len() as u32) as usize];
    let mut arguments: Vec<_> = command.split_whitespace().map(str::to_owned).collect();
    for _ in 0..random.below(5) {
        let (flag, value) = (word(FLAGS, random), word(VALUES, random));
        match random.below(3) {
            0 => arguments.push(flag),
            1 => arguments.push(format!("{flag}={value}")),
            _ => arguments.extend([flag, value]),
        }
    }
    arguments
}

/// The argument; the control character 0x1F becomes a byte that is no text.
fn with_bytes(argument: String) -> OsString {
    #[cfg(unix)]
    return {
        let bytes = argument.into_bytes().into_iter();
        let bytes = bytes.map(|byte| if byte == 0x1F { 0xFF } else { byte });
        std::os::unix::ffi::OsStringExt::from_vec(bytes.collect())
    };
    #[cfg(not(unix))]
    return argument.into();
}

/// Deletes all files below, which must be whole pictures, and all folders but `place`.
fn clear(folder: &Path, place: &Path) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            clear(&path, place);
            if path != place {
                fs::remove_dir(&path).expect("an empty folder");
            }
        } else {
            picture_file::open(&path).expect("a whole picture");
            fs::remove_file(&path).expect("a file");
        }
    }
}

/// Paints the picture, unless that takes long.
fn paint(settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
    let samples = settings.size.pixels() as u64 * u64::from(settings.samples);
    if samples > 4096 {
        return Err(Error::Memory {
            size: settings.size,
        });
    }
    let color = |x, y| Color::from_bytes([x as u8, y as u8, 0]);
    let image = Image::from_fn(settings.size, color)?;
    for (y, row) in (0..).zip(image.rows()) {
        progress.row(y, &mut row.iter().copied());
    }
    Ok(image)
}

fn open(settings: &Settings, _: &dyn Progress) -> Result<Image, Error> {
    match &settings.file {
        Some(file) => picture_file::open(file),
        None => Image::black(settings.size),
    }
}

fn stage() -> Stage {
    let defaults = Settings {
        size: Size::new(3, 2).expect("a size"),
        ..Settings::default()
    };
    let scenes = [
        Scene::sampled("traced", "rays", paint).reflecting(),
        Scene::painted("painted", "no rays", paint),
        Scene::opened("opened", "a file", open),
    ];
    Stage {
        name: "a00",
        about: "A stage for random command lines",
        scenes: scenes
            .map(|scene| scene.with_defaults(defaults.clone()))
            .into(),
        open: None,
    }
}

fn laboratory() -> Laboratory {
    Laboratory {
        stage: stage(),
        experiments: Vec::new,
        extremes: |_| {
            vec![Case {
                id: "A01".into(),
                what: "a number".into(),
                exact: Number(1.0),
                ours: Number(1.0),
                ..Case::default()
            }]
        },
    }
}

/// A person who looks at each scene, saves it and closes the window.
fn look(gallery: &mut Gallery) -> Result<(), NotShown> {
    gallery.read_picture_file()?;
    gallery.begin()?;
    for _ in 0..3 {
        gallery.wait();
        gallery.explain([0, 0]);
        gallery.save(None);
        gallery.go_on(1);
    }
    Ok(())
}

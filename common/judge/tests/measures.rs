//! Each measure, in pictures whose values are known.

use std::fmt::Write;
use std::path::Path;

use common::{Color, Error, Image, Size, Transfer, picture_file};
use judge::pictures::{Drawn, Facts, RequestedPicture, Run, Sheet, ask_facts};

const HEAD: &str = "title = \"T\"\npage = \"p.md\"\nstage = \"a01\"\nhours = 1\n";

/// Byte 4 x in column x: 0 to 236.
fn ramp(x: u32, _: u32) -> Color {
    Color::gray(f64::from(4 * x) / 255.0)
}

/// Black up to column 19, 0.2 in column 20, then white.
fn soft(x: u32, _: u32) -> Color {
    Color::gray(match x {
        0..20 => 0.0,
        20 => 0.2,
        _ => 1.0,
    })
}

/// The white half, below the diagonal from the upper left.
fn diagonal(x: u32, y: u32) -> Color {
    if y > x { Color::WHITE } else { Color::BLACK }
}

/// Byte 100, and 110 or 90 of red.
fn noise(x: u32, y: u32) -> Color {
    let red = if (x + y).is_multiple_of(2) { 110 } else { 90 };
    Color::from_bytes([red, 100, 100])
}

fn grey(x: u32, y: u32) -> Color {
    let is_other = [(3, 4), (7, 2), (7, 9)].contains(&(x, y));
    Color::from_bytes([100, 100, if is_other { 101 } else { 100 }])
}

/// Bytes 10, 20, 30 and 60 in all pixels.
fn steps(n: usize) -> impl Fn(u32, u32) -> Color {
    move |_, _| Color::gray([10.0, 20.0, 30.0, 60.0][n] / 255.0)
}

fn image(scene: &str, size: Size) -> Result<Image, Error> {
    match scene {
        "ramp" => Image::from_fn(size, ramp),
        "soft" => Image::from_fn(size, soft),
        "diagonal" => Image::from_fn(size, diagonal),
        "noise" => Image::from_fn(size, noise),
        "flat" => Image::from_fn(size, |_, _| Color::from_bytes([100; 3])),
        "grey" => Image::from_fn(size, grey),
        step => Image::from_fn(size, steps(step[4..].parse().unwrap())),
    }
}

const SCENES: [&str; 10] = [
    "ramp", "soft", "diagonal", "noise", "flat", "grey", "step0", "step1", "step2", "step3",
];

/// Keys of a fact, and its value.
const FACTS: [(&str, f64); 24] = [
    // Rows are equal, but for a diagonal: in 5 x 5 pixels at it, 4 of 20 pairs.
    (
        "scene = \"ramp\"\nmeasure = \"alike\"\nregion = [10, 0, 11, 20]",
        1.0,
    ),
    (
        "scene = \"diagonal\"\nmeasure = \"alike\"\nregion = [10, 10, 5, 5]",
        16.0 / 20.0,
    ),
    // White, white, black, black: two of three neighbours are alike.
    (
        "scene = \"diagonal\"\nmeasure = \"autocorrelation\"\nregion = [8, 10, 4, 1]",
        1.0 / 3.0,
    ),
    // Of 40, 44 and 48 only the pixels below are alike.
    (
        "scene = \"ramp\"\nmeasure = \"autocorrelation\"\nregion = [10, 0, 3, 5]",
        1.0,
    ),
    // The deviations are -1, -1 and 3, -1: only from the upper right to the lower left they are opposite.
    (
        "scene = \"diagonal\"\nmeasure = \"autocorrelation\"\nregion = [10, 10, 2, 2]",
        1.0,
    ),
    // Black are both upper pixels, which count twice, and one below.
    (
        "scene = \"diagonal\"\nmeasure = \"load\"\nregion = [10, 10, 2, 2]",
        5.0 / 6.0,
    ),
    (
        "scene = \"ramp\"\nmeasure = \"mean\"\nregion = [10, 0, 11, 20]",
        60.0 / 255.0,
    ),
    (
        "scene = \"ramp\"\nmeasure = \"greatest\"\nregion = [10, 3, 11, 4]",
        80.0 / 255.0,
    ),
    (
        "scene = \"ramp\"\nmeasure = \"least\"\nregion = [10, 3, 11, 4]",
        40.0 / 255.0,
    ),
    (
        "scene = \"noise\"\nmeasure = \"mean\"\nregion = [0, 0, 1, 1]",
        310.0 / 765.0,
    ),
    (
        "scene = \"noise\"\nmeasure = \"mean\"\nchannel = \"red\"\nregion = [0, 0, 1, 1]",
        110.0 / 255.0,
    ),
    (
        "scene = \"noise\"\nmeasure = \"mean\"\nchannel = \"blue\"\nregion = [0, 0, 1, 1]",
        100.0 / 255.0,
    ),
    // The middle of a straight course, and of one whose bytes are 0, 51 and 255.
    (
        "scene = \"ramp\"\nmeasure = \"edge\"\nfrom = [10, 5]\nto = [31, 5]",
        10.5,
    ),
    (
        "scene = \"soft\"\nmeasure = \"edge\"\nfrom = [10, 5]\nto = [30, 5]",
        10.375,
    ),
    (
        "scene = \"soft\"\nmeasure = \"edge\"\nfrom = [30, 5]\nto = [10, 5]",
        9.625,
    ),
    (
        "scene = \"soft\"\nmeasure = \"width\"\nfrom = [30, 5]\nto = [10, 5]",
        1.375,
    ),
    (
        "scene = \"ramp\"\nmeasure = \"width\"\nfrom = [0, 5]\nto = [50, 5]",
        40.0,
    ),
    // The edge is a row lower in each next column, so the mean of three lines rises in three steps.
    (
        "scene = \"diagonal\"\nmeasure = \"width\"\nfrom = [8, 2]\nto = [8, 17]\nlines = 3",
        2.4,
    ),
    (
        "scene = \"noise\"\nmeasure = \"spread\"\nchannel = \"red\"\nexact = [0.3313725490196079, 0.4529411764705883]\nregion = [0, 0, 2, 1]",
        0.1,
    ),
    // Down a column: the edge is between rows 8 and 9.
    (
        "scene = \"diagonal\"\nmeasure = \"edge\"\nfrom = [8, 2]\nto = [8, 17]",
        6.5,
    ),
    (
        "scene = \"noise\"\nmeasure = \"spread\"\nchannel = \"red\"\nexact_scene = \"flat\"\nregion = [0, 0, 60, 20]",
        10.0 / 255.0,
    ),
    (
        "scene = \"flat\"\nmeasure = \"spread\"\nexact = 0\nregion = [0, 0, 60, 20]",
        100.0 / 255.0,
    ),
    ("scene = \"grey\"\nmeasure = \"same\"\nas = \"flat\"", 3.0),
    (
        "measure = \"growth\"\nscenes = [\"step0\", \"step1\", \"step2\", \"step3\"]\nregion = [0, 0, 2, 2]",
        20.0 / 255.0,
    ),
];

fn draw(folder: &Path, picture: &RequestedPicture, run: &Run) -> Drawn {
    let image = image(&picture.scene, picture.size).unwrap();
    let file = folder.join(run.file());
    picture_file::save_png(&file, image.size(), &image.to_rgb8(Transfer::Linear)).unwrap();
    Drawn { file, seconds: 0.0 }
}

/// A sheet with facts whose values are changed.
fn sheet(change: f64) -> Sheet {
    let mut text = HEAD.to_owned();
    for scene in SCENES {
        let _ = write!(
            text,
            "[[picture]]\nscene = \"{scene}\"\nsamples = [1]\nsize = [60, 20]\n"
        );
    }
    for (number, (keys, value)) in FACTS.iter().enumerate() {
        let value = value + change;
        let _ = write!(
            text,
            "[[fact]]\nname = \"fact{number}\"\n{keys}\nvalue = {value:?}\nwithin = 1e-9\nsays = \"s\"\n\
             formula = \"f\"\nbecause = \"b\"\nhint = \"h\"\n"
        );
    }
    Sheet::read("measures", &text).unwrap()
}

#[test]
fn each_measure_has_its_closed_form() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let right = sheet(0.0);
    let judgement = ask_facts(&right, Facts::All, &mut |picture, run| {
        Ok(draw(folder, picture, run))
    });
    assert_eq!(judgement.passed(), FACTS.len(), "{}", judgement.report());
    assert_eq!(
        judgement.report().lines().next(),
        Some("ok         fact0   s")
    );

    for change in [-1e-6, 1e-6] {
        let wrong = sheet(change);
        let judgement = ask_facts(&wrong, Facts::All, &mut |picture, run| {
            Ok(draw(folder, picture, run))
        });
        assert_eq!(judgement.passed(), 0, "{}", judgement.report());
    }
}

/// A sheet's mistakes are named with the file, the row and the key.
#[test]
fn a_sheet_that_lacks_something_is_named() {
    let picture = "[[picture]]\nscene = \"a\"\nsamples = [1, 2, 4]\nsize = [9, 9]\n";
    let fact = "[[fact]]\nname = \"f\"\nsays = \"s\"\nscene = \"a\"\nmeasure = \"mean\"\nregion = [0, 0, 9, 9]\n\
                value = 1\nformula = \"f\"\nwithin = 0\nbecause = \"b\"\nhint = \"h\"\n";
    let read = |text: &str| Sheet::read("glass", text);
    assert!(read(&[HEAD, picture, fact].concat()).is_ok());
    for (old, new, error) in [
        (
            HEAD,
            "hours = 1\npage = \"p\"\n",
            "glass.toml: `title` is missing; it must be a text",
        ),
        (
            "hours = 1",
            "hours = 1\ntimed = \"b\"",
            "glass.toml: `timed` names no scene of a picture",
        ),
        (
            "hours = 1",
            "hours = \"1\"",
            "glass.toml: `hours` must be a whole number from 0",
        ),
        (
            picture,
            "",
            "glass.toml: `picture` is missing; the file has rows [[picture]]",
        ),
        (
            "size = [9, 9]",
            "size = [9]",
            "glass.toml, picture 1 (a): `size` must be a list of 2",
        ),
        (
            "size = [9, 9]",
            "size = [0, 9]",
            "`size` size is 0x9, but must be from 1",
        ),
        (
            "hint = \"h\"",
            "hnt = \"h\"",
            "glass.toml, fact 1 (f): `hint` is missing",
        ),
        (
            "hint = \"h\"",
            "hint = \"h\"\nhnt = 1",
            "fact 1 (f): `hnt` is no key here; the nearest is `hint`",
        ),
        (
            "\"mean\"",
            "\"man\"",
            "`measure` is man; it must be one of mean, greatest",
        ),
        (
            "[0, 0, 9, 9]",
            "[0, 1, 9, 9]",
            "`region` must be x, y, width and height within 9x9",
        ),
        (
            "[0, 0, 9, 9]",
            "[0, 0, 9, -1]",
            "`region` must be a list of 4, each a whole number from 0",
        ),
        (
            "scene = \"a\"\nm",
            "scene = \"b\"\nm",
            "`scene` names no scene of a picture: b",
        ),
        (
            "scene = \"a\"\nm",
            "scene = \"a\"\nsamples = 3\nm",
            "`samples` has 3, which a has not",
        ),
        (
            "\"mean\"\nregion = [0, 0, 9, 9]",
            "\"edge\"\nfrom = [3, 3]\nto = [3, 3]",
            "`to` must be another point",
        ),
        (
            "\"mean\"\n",
            "\"slope\"\nexact = 1\nsamples = [1, 2]\n",
            "`samples` must be three or more",
        ),
        (
            "\"f\"\nsays",
            "\"two words\"\nsays",
            "`name` must be one word",
        ),
        (
            "value = 1",
            "value = nan",
            "`value` must be a finite number",
        ),
        ("page", "page = 1\npage", "glass.toml: "),
    ] {
        let text = [HEAD, picture, fact].concat().replacen(old, new, 1);
        let found = read(&text).unwrap_err();
        assert!(found.contains(error), "{old}: {found}");
    }
}

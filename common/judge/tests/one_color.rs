//! A program that traces no ray has no fact of any sheet: its pictures have one colour, or are copies of the book's.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use common::{Color, Image, Size, Transfer, picture_file};
use judge::pictures::{Drawn, Facts, Judgement, NAMES, Sheet, ask_facts};

const FOLDER: &str = env!("CARGO_MANIFEST_DIR");

fn read(name: &str) -> Sheet {
    let text = fs::read_to_string(format!("{FOLDER}/sheets/{name}.toml")).unwrap();
    Sheet::read(name, &text).unwrap()
}

/// What the judge says if all pictures are drawn by one function.
fn judged<'a>(sheet: &'a Sheet, folder: &Path, draw: &dyn Fn(Size) -> Image) -> Judgement<'a> {
    let mut files = BTreeMap::new();
    ask_facts(sheet, Facts::All, &mut |picture, _| {
        let name = format!("{}.png", picture.size);
        let file = files.entry(name.clone()).or_insert_with(|| {
            let file = folder.join(&name);
            let bytes = draw(picture.size).to_rgb8(Transfer::Linear);
            picture_file::save_png(&file, picture.size, &bytes).unwrap();
            file
        });
        Ok(Drawn {
            file: file.clone(),
            seconds: 0.0,
        })
    })
}

#[test]
fn a_picture_of_one_color_has_no_fact() {
    let folder = tempfile::tempdir().unwrap();
    for name in NAMES {
        let sheet = read(name);
        // The background of the tree and those of glass; the greys of single facts.
        let mut colors = vec![
            Color::BLACK,
            Color::WHITE,
            Color::gray(0.25),
            Color::new(0.0, 1.0, 0.4),
            Color::new(1.0, 0.0, 0.4),
        ];
        for fact in &sheet.facts {
            if !colors.contains(&Color::gray(fact.value)) {
                colors.push(Color::gray(fact.value));
            }
        }
        for color in colors {
            let draw = |size| Image::from_fn(size, |_, _| color).unwrap();
            let judgement = judged(&sheet, folder.path(), &draw);
            assert_eq!(judgement.passed(), 0, "{color:?}: {}", judgement.report());
            let summary = judgement.summary();
            assert!(
                summary.starts_with("0 of ") || summary.ends_with(" hold, and none counts yet"),
                "{summary}"
            );
        }
    }
}

#[test]
fn the_picture_of_a_page_has_no_fact() {
    let folder = tempfile::tempdir().unwrap();
    for name in NAMES {
        let sheet = read(name);
        for kind in ["", "-wrong"] {
            let file = format!("{FOLDER}/../../book/src/pictures/sheet-{name}{kind}.png");
            let picture = picture_file::open(Path::new(&file)).unwrap();
            // As large as the sheet asks for.
            let draw = |size: Size| {
                Image::from_fn(size, |x, y| {
                    let column = x * picture.size().width() / size.width();
                    let row = y * picture.size().height() / size.height();
                    picture.get(column, row).unwrap()
                })
                .unwrap()
            };
            let judgement = judged(&sheet, folder.path(), &draw);
            assert_eq!(judgement.passed(), 0, "{file}: {}", judgement.report());
        }
    }
}

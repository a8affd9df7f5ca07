use std::path::Path;
use std::time::Duration;
use std::{fs, thread};

use common::{Color, Image, Stage, atomic_file};

use super::*;
use crate::opened_file::OpenedFile;

/// A scene whose picture has the grey that the file names; a file without a number is broken.
fn open(path: &Path) -> Result<Scene, Error> {
    let text = fs::read_to_string(path).unwrap_or_default();
    let gray: f64 = text
        .trim()
        .parse()
        .map_err(|_| Error::Usage(format!("{text:?} is no number")))?;
    let mut scene = Scene::painted("own", "", move |_, _| {
        Ok(Image::black(Size::new(1, 1)?)?.map(|_| Color::gray(gray)))
    });
    scene.files = vec![path.to_owned()];
    Ok(scene)
}

fn stage() -> Stage {
    Stage {
        name: "a00",
        about: "",
        scenes: vec![Scene::painted("first", "", |settings, _| {
            Image::black(settings.size)
        })],
        open: Some(open),
    }
}

/// Shows a watched file of this text.
fn with_file(text: &str, test: impl FnOnce(&mut Gallery, &Path)) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("w.toml");
    fs::write(&path, text).unwrap();
    let stage = stage();
    let scenes = Scenes {
        stage: &stage,
        file: Some(OpenedFile::open(&stage, &path, true)),
        number: 0,
    };
    let mut gallery = Gallery::new(scenes, &Options::default()).unwrap();
    gallery.begin().unwrap();
    test(&mut gallery, &path);
}

fn save(path: &Path, text: &str) {
    atomic_file::write(path, text.as_bytes()).unwrap();
    thread::sleep(crate::watch::PERIOD + Duration::from_millis(1));
}

/// The red byte of the finished picture.
fn shown(gallery: &mut Gallery) -> u32 {
    gallery.update();
    gallery.wait();
    gallery.picture().pixel(0, 0) >> 16
}

#[test]
fn a_file_is_watched_while_another_scene_is_shown() {
    with_file("0.2", |gallery, path| {
        assert!(gallery.title().starts_with("a00: w.toml, "));
        assert_eq!(shown(gallery), 51);
        gallery.go_on(-1);
        assert_eq!(shown(gallery), 0);
        save(path, "0.4");
        assert_eq!(shown(gallery), 0);
        assert!(gallery.title().starts_with("a00: first, "));
        gallery.go_on(1);
        assert_eq!(shown(gallery), 102);
        save(path, "0.6");
        assert_eq!(shown(gallery), 153);
    });
}

#[test]
fn a_broken_file_is_waited_for_and_a_corrected_one_has_no_error() {
    with_file("broken", |gallery, path| {
        let line = |gallery: &Gallery| gallery.mistake().unwrap_or_default();
        assert!(line(gallery).contains("no number"));
        assert!(gallery.scene().is_none() && !gallery.is_rendering());
        // Its place in the list can be left and reached again.
        gallery.go_on(1);
        assert_eq!(line(gallery), "");
        gallery.go_on(1);
        save(path, "0.2");
        assert_eq!(shown(gallery), 51);
        assert_eq!(line(gallery), "");
        save(path, "0.2 again");
        assert_eq!(shown(gallery), 51, "the picture stays");
        assert!(line(gallery).contains("no number"));
    });
}

#[test]
fn before_the_file_is_right_there_is_nothing_to_move_print_or_save() {
    with_file("broken", |gallery, path| {
        gallery.rotate([30, 0]);
        gallery.approach(1);
        assert_eq!(gallery.camera.edits, Edits::default());
        gallery.print_camera();
        assert_eq!(gallery.lines(None), ["there is no scene yet"]);
        gallery.save(None);
        assert_eq!(gallery.lines(None), ["there is no picture to save"]);
        save(path, "0.2");
        assert_eq!(shown(gallery), 51);
        assert_eq!(gallery.lines(None), [""]);
    });
}

#[test]
fn an_answer_stands_above_the_numbers_of_a_pixel_and_ends() {
    with_file("0.2", |gallery, path| {
        gallery.save(None);
        assert_eq!(gallery.lines(None)[0], "the picture is not finished yet");
        shown(gallery);
        assert_eq!(gallery.lines(None), [""]);
        gallery.explain([0, 0]);
        let numbers = gallery.lines(None);
        let letter = path.with_file_name("letter.jpg");
        gallery.save(Some(letter.clone()));
        let lines = gallery.lines(None);
        assert!(lines[0].contains("ending in .png") && !letter.exists());
        assert_eq!(lines[1..], numbers);
        gallery.point();
        assert_eq!(gallery.lines(None), lines, "nobody has read it");
        gallery.answer.given -= Duration::from_secs(3);
        gallery.point();
        assert_eq!(gallery.lines(None), numbers);
    });
}

#[test]
fn a_broken_scene_file_is_read_again_when_its_mesh_is_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("w.toml");
    fs::write(&path, "# don't\nfile = \"knot.obj\"").unwrap();
    let stage = stage();
    let mut file = OpenedFile::open(&stage, &path, true);
    assert!(!file.reread(&stage));
    save(&folder.path().join("knot.obj"), "v 0 0 0");
    assert!(file.reread(&stage));
}

#[test]
fn a_pixel_has_its_bytes_and_its_colour_before_they_were_rounded() {
    with_file("0.7", |gallery, _| {
        shown(gallery);
        gallery.explain([0, 0]);
        let lines = ["pixel 0,0: bytes (179, 179, 179)", "colour (0.7, 0.7, 0.7)"];
        assert_eq!(gallery.lines(None), lines);
        gallery.forget();
        assert!(gallery.explained().is_none());
    });
}

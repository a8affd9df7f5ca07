use std::fs;
use std::thread;
use std::time::Duration;

use common::{Color, atomic_file};

use super::*;

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
    let black = |settings: &Settings, _: &dyn common::Progress| Image::black(settings.size);
    Stage {
        name: "a00",
        about: "",
        scenes: vec![
            Scene::painted("first", "", black),
            Scene::painted("second", "", black),
        ],
        open: Some(open),
    }
}

/// Shows a file of this text in a gallery.
fn with_file(text: &str, watch: bool, test: impl FnOnce(&mut Gallery, &Path)) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("w.toml");
    fs::write(&path, text).unwrap();
    let stage = stage();
    let showing = Showing {
        no_window: false,
        watch,
        appearance: Appearance::default(),
        options: Options::default(),
    };
    thread::scope(|scope| {
        let files = vec![OpenedFile::open(&stage, &path, watch)];
        let mut gallery = Gallery::new(&stage, files, 0, &showing, scope);
        gallery.start().unwrap();
        test(&mut gallery, &path);
    });
}

/// Saves a text as an editor does.
fn save(path: &Path, text: &str) {
    atomic_file::write(path, text.as_bytes()).unwrap();
    // Some file systems have coarse times.
    thread::sleep(Duration::from_millis(20));
}

/// The red of the finished picture.
fn shown(gallery: &mut Gallery) -> f64 {
    gallery.update();
    gallery.wait();
    let Some(Ok(image)) = &gallery.outcome else {
        panic!("no picture");
    };
    image.get(0, 0).unwrap().channels()[0]
}

#[test]
fn an_own_file_stays_in_the_list_and_is_watched_while_another_scene_is_shown() {
    with_file("0.25", true, |gallery, path| {
        assert_eq!(gallery.names(), ["w.toml", "first", "second"]);
        assert_eq!(
            (shown(gallery), gallery.title().as_str()),
            (0.25, "a00: w.toml")
        );
        gallery.go_to(1);
        assert_eq!((shown(gallery), gallery.name().as_str()), (0.0, "first"));
        save(path, "0.5");
        gallery.update();
        assert_eq!((shown(gallery), gallery.name().as_str()), (0.0, "first"));
        gallery.go_to(0);
        assert_eq!(shown(gallery), 0.5);
        save(path, "0.125");
        assert_eq!(shown(gallery), 0.125);
    });
}

#[test]
fn a_broken_file_is_waited_for_and_a_corrected_one_has_no_error() {
    with_file("broken", true, |gallery, path| {
        assert!(gallery.error().unwrap().to_string().contains("no number"));
        assert!(gallery.scene().is_none() && !gallery.is_busy());
        // Its place in the list can be left and reached again.
        gallery.go_to(2);
        assert!(gallery.error().is_none());
        gallery.go_to(0);
        assert!(gallery.error().is_some());
        save(path, "0.5");
        gallery.update();
        // Before its picture is finished, too.
        assert!(gallery.error().is_none());
        assert_eq!(shown(gallery), 0.5);
        save(path, "0.5 again");
        gallery.update();
        assert!(gallery.error().is_some());
        assert_eq!(shown(gallery), 0.5, "the picture stays");
        save(path, "0.75");
        gallery.update();
        assert!(gallery.error().is_none());
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
fn files_are_opened_beside_the_others() {
    with_file("0.25", false, |gallery, path| {
        let other = path.with_file_name("other.toml");
        fs::write(&other, "0.5").unwrap();
        gallery.open(&other).unwrap();
        assert_eq!(gallery.names(), ["w.toml", "other.toml", "first", "second"]);
        assert_eq!((shown(gallery), gallery.number()), (0.5, 1));
        // A broken file is no scene of the list, and what is shown stays.
        fs::write(&other, "broken").unwrap();
        gallery.open(&path.with_file_name("none.toml")).unwrap_err();
        gallery.open(&other).unwrap_err();
        let error = gallery.open(Path::new("a.png")).unwrap_err();
        assert!(error.to_string().contains("no scene file"), "{error}");
        assert_eq!((shown(gallery), gallery.names().len()), (0.5, 4));
        // The same file is opened again at its place.
        fs::write(&other, "0.75").unwrap();
        gallery.open(&other).unwrap();
        assert_eq!((shown(gallery), gallery.names().len()), (0.75, 4));
    });
}

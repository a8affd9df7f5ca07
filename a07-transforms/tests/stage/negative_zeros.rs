//! A negative zero in a scene file changes no pixel, by any renderer.

use std::fmt::Write;
use std::fs;

use a07_transforms::stage;
use common::{Color, Renderer, Settings, Size};

/// The scale of the camera: the picture shows almost all of the mirrors.
const SCALE: f64 = 3.9;

/// The number of pixels along each side.
const SIDE: u32 = 96;

/// The red and the green of the box behind the mirrors at this place.
fn red_and_green(x: i32, y: i32) -> (f64, f64) {
    (f64::from(x + 3) / 8.0, f64::from(y + 3) / 8.0)
}

/// Parallel rays along z meet four by four mirrors, each a box with a disc before it, which send
/// them back past the eye to as many boxes of different colours.
fn scene_file(gaze: &str) -> String {
    let mut file = format!(
        "[camera]\neye = [0, 0, 10]\ngaze = {gaze}\nup = [1, 0, 0]\nscale = {SCALE}\n\
         [world]\nambient = [1, 1, 1]\n[material.mirror]\nreflection = [1, 1, 1]\n"
    );
    for x in -2..2 {
        for y in -2..2 {
            let (right, up, (red, green)) = (x + 1, y + 1, red_and_green(x, y));
            let facing = if (x + y) % 2 == 0 { 1 } else { -1 };
            write!(
                file,
                "[[disc]]\ncenter = [{x}.5, {y}.5, 0]\nnormal = [0, 0, {facing}]\nradius = 0.5\n\
                 material = \"mirror\"\n\
                 [[box]]\nlbf = [{x}, {y}, -0.5]\nrun = [{right}, {up}, -0.1]\nmaterial = \"mirror\"\n\
                 [[box]]\nlbf = [{x}, {y}, 20]\nrun = [{right}, {up}, 21]\ncolor = [{red}, {green}, 1]\n"
            )
            .unwrap();
        }
    }
    file
}

/// The camera's x axis is upwards in the picture, and its y axis to the left. The mirrors change
/// neither coordinate.
#[test]
fn zeros_of_both_signs_in_the_gaze_give_the_same_picture() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mirrors.toml");
    for gaze in [
        "[0, 0, -1]",
        "[-0.0, -0.0, -1]",
        "[0, -0.0, -1]",
        "[-0.0, 0, -1]",
    ] {
        fs::write(&path, scene_file(gaze)).unwrap();
        let scene = (stage().open.unwrap())(&path).unwrap();
        for renderer in Renderer::ALL {
            let settings = Settings {
                size: Size::new(SIDE, SIDE).unwrap(),
                renderer,
                ..scene.defaults.clone()
            };
            let image = scene.render(&settings, &()).unwrap();
            for (row, pixels) in (0..SIDE).zip(image.rows()) {
                for (column, color) in (0..SIDE).zip(pixels) {
                    let from_middle =
                        |pixel: u32| SCALE * (0.5 - f64::from(pixel) / f64::from(SIDE - 1));
                    let [x, y] = [row, column].map(|pixel| from_middle(pixel).floor() as i32);
                    let (red, green) = red_and_green(x, y);
                    let expected = Color::new(red, green, 1.0);
                    assert_eq!(*color, expected, "{gaze}, {renderer:?}, {column}, {row}");
                }
            }
        }
    }
}

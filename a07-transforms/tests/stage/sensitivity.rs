//! How a pixel changes with the numbers of a scene file: against closed forms, and at edges.

use common::sensitivity::{self, Influence, Response, sort_by_strength};
use common::{Scene, Settings, Transfer};

use crate::scene_cases::open;

/// A picture of one pixel, whose ray goes straight down to the origin.
const DOWN: &str = "[picture]\nsize = [1, 1]\n\
    [camera]\neye = [0, 5, 0]\ngaze = [0, -1, 0]\nup = [0, 0, -1]\nangle = 1\n";

/// A grey floor that a lamp lights.
const LIT: &str = "[world]\nambient = [0.1, 0.1, 0.1]\n\
    [material.grey]\ndiffuse = [0.5, 0.25, 0.75]\n\
    [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"grey\"\n\
    [[point_light]]\ncolor = [0.8, 0.9, 1]\nposition = [1, 2, -3]\n";

/// The product of the channels of floor and lamp.
const GREY: [f64; 3] = [0.5 * 0.8, 0.25 * 0.9, 0.75];

const LAMP: &str = "[[point_light]] #1";

/// The influences of the numbers of a file on its only pixel.
fn influences(text: &str) -> Vec<Influence> {
    let scene = open(&format!("{DOWN}{text}")).unwrap();
    with_settings(&scene, &scene.defaults)
}

fn with_settings(scene: &Scene, settings: &Settings) -> Vec<Influence> {
    let rays = scene.rays().unwrap();
    let numbers = rays.numbers(settings).unwrap();
    let mut found = sensitivity::influences(rays, settings, [0, 0], &numbers, &()).unwrap();
    sort_by_strength(&mut found);
    found
}

/// The response to the number of a table and a key.
fn response<'a>(influences: &'a [Influence], table: &str, key: &str) -> &'a Response {
    let is_named = |it: &&Influence| it.number.table == table && it.number.key == key;
    let found = influences.iter().find(is_named);
    &found
        .unwrap_or_else(|| panic!("{table} {key}: {influences:#?}"))
        .response
}

#[track_caller]
fn assert_near(actual: [f64; 3], expected: [f64; 3]) {
    for (actual, expected) in actual.into_iter().zip(expected) {
        let error = (actual - expected).abs();
        assert!(error <= 1e-6 * expected.abs(), "{actual:e} {expected:e}");
    }
}

/// Asserts the slopes at these keys of a table.
#[track_caller]
fn assert_slopes(influences: &[Influence], table: &str, slopes: &[(&str, [f64; 3])]) {
    for (key, expected) in slopes {
        match response(influences, table, key) {
            Response::Smooth { slope, .. } => assert_near(*slope, *expected),
            Response::None => assert_near([0.0; 3], *expected),
            other => panic!("{table} {key}: {other:?}"),
        }
    }
}

/// The distance of the edge at a number, and the jump there.
#[track_caller]
fn edge(influences: &[Influence], table: &str, key: &str) -> (f64, [f64; 3]) {
    match response(influences, table, key) {
        Response::Edge(edge) => (edge.distance, edge.jump),
        other => panic!("{table} {key}: {other:?}"),
    }
}

/// c = cd ca + cd cl n · l with n · l = 2/√14, also where the colour is given in bytes of a transfer.
#[test]
fn a_color_changes_its_own_channel_by_its_factor() {
    let found = influences(LIT);
    let cosine = 2.0 / 14_f64.sqrt();
    let red = [0.1 + 0.8 * cosine, 0.0, 0.0];
    let blue = [0.0, 0.0, 0.1 + cosine];
    let slopes = [("diffuse red", red), ("diffuse blue", blue)];
    assert_slopes(&found, "[material.grey]", &slopes);
    let green = [0.0, 0.25 * cosine, 0.0];
    assert_slopes(&found, LAMP, &[("color green", green)]);
    assert_slopes(&found, "[world]", &[("ambient green", [0.0, 0.25, 0.0])]);

    let text = format!("{DOWN}{LIT}").replace("[0.5, 0.25, 0.75]", "\"#808080\"");
    let scene = open(&text).unwrap();
    let settings = Settings {
        transfer: Transfer::Srgb,
        ..scene.defaults.clone()
    };
    let before = scene.render(&settings, &()).unwrap();
    let found = with_settings(&scene, &settings);
    assert_slopes(&found, "[material.grey]", &[("diffuse red", red)]);
    let diffuse = found.iter().find(|it| it.number.key == "diffuse red");
    let value = diffuse.unwrap().number.value;
    assert!((value - Transfer::Srgb.decode(128.0 / 255.0)).abs() < 1e-15);
    // The file is as it was.
    assert_eq!(scene.render(&settings, &()).unwrap(), before);
}

/// n · l = y/|l| with l = (1, 2, -3) has the derivatives -xy/|l|³, (x² + z²)/|l|³ and -yz/|l|³; a
/// higher plane brings the light nearer.
#[test]
fn lamberts_cosine_changes_with_the_place_of_the_light_and_of_the_plane() {
    for (eye, scale) in [(5.0, 1.0), (5e6, 1e6), (5e-6, 1e-6)] {
        let lamp = [1.0, 2.0, -3.0].map(|x| x * scale);
        let text = format!("{DOWN}{LIT}")
            .replace("eye = [0, 5, 0]", &format!("eye = [0, {eye:?}, 0]"))
            .replace("[1, 2, -3]", &format!("{lamp:?}"));
        let scene = open(&text).unwrap();
        let found = with_settings(&scene, &scene.defaults);
        let cube = 14.0 * 14_f64.sqrt() * scale;
        let slope = |numerator: f64| GREY.map(|factor| factor * numerator / cube);
        let of_lamp = [
            ("position x", slope(-2.0)),
            ("position y", slope(10.0)),
            ("position z", slope(6.0)),
        ];
        assert_slopes(&found, LAMP, &of_lamp);
        let of_plane = [("point y", slope(-10.0)), ("point x", [0.0; 3])];
        assert_slopes(&found, "[[plane]] #1", &of_plane);
    }
}

/// The ray down the y axis touches the sphere, or passes at 1/100 of a pixel, which is
/// 10 tan(0.5°) = 0.087 wide. At the very edge the lesson decides whether the ray hits.
#[test]
fn the_pixel_jumps_at_the_edge_of_a_sphere() {
    for (radius, distance) in [("1", 0.0), ("0.999", 1e-3), ("1.001", -1e-3)] {
        let found = influences(&format!(
            "[world]\nbackground = [0, 0, 1]\n\
             [[sphere]]\ncenter = [1, 0, 0]\nradius = {radius}\ncolor = [1, 0.5, 0]\n"
        ));
        assert!(matches!(found[0].response, Response::Edge(_)), "{found:#?}");
        let (found, jump) = edge(&found, "[[sphere]] #1", "radius");
        assert!((found - distance).abs() < 1e-9, "{found}");
        // Outside of the sphere is the background.
        let inside = if distance < 0.0 { -1.0 } else { 1.0 };
        let expected = [1.0, 0.5, -1.0].map(|channel| channel * inside);
        assert_eq!(jump.map(f64::abs), expected.map(f64::abs));
        assert!(distance == 0.0 || jump == expected, "{jump:?}");
    }
}

/// The ball is between the lamp at (1, 2, -3) and the origin, which the middle of its shadow's edge
/// touches. A smaller ball lets the light through.
#[test]
fn the_pixel_jumps_at_the_edge_of_a_shadow() {
    let found = influences(&format!(
        "{LIT}[[sphere]]\ncenter = [0.5, 1, -1.4]\nradius = 0.085\nmaterial = \"grey\"\n"
    ));
    // The distance of the centre from the line through the origin along (1, 2, -3)/√14.
    let along = (0.5 + 2.0 + 4.2) / 14_f64.sqrt();
    let expected = (0.25 + 1.0 + 1.96 - along * along).sqrt() - 0.085;
    let (distance, jump) = edge(&found, "[[sphere]] #1", "radius");
    assert!((distance - expected).abs() < 1e-9, "{distance} {expected}");
    assert!(distance < 0.0 && jump.iter().all(|channel| *channel > 0.0));
}

/// The rim is at 1/100 of a pixel. The angle of the axis is atan 0.4, and that of the rim larger by the
/// half angle.
#[test]
fn the_rim_of_a_spot_is_found_beside_the_ray() {
    let found = influences(
        "[material.m]\ndiffuse = [1, 1, 1]\n\
         [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n\
         [[spot_light]]\ncolor = [1, 0.5, 0.25]\nposition = [1, 2, 0]\n\
         direction = [-0.4, -1, 0]\nhalf_angle = 4.743641690726176\n",
    );
    let half_angle = 4.743_641_690_726_176_f64.to_radians();
    let rim = 1.0 - 2.0 * libm::tan(libm::atan(0.4) + half_angle);
    let (of_eye, _) = edge(&found, "[camera]", "eye x");
    let (of_spot, _) = edge(&found, "[[spot_light]] #1", "position x");
    assert!((of_eye - rim).abs() < 1e-10, "{of_eye} {rim}");
    assert!((of_spot + rim).abs() < 1e-10, "{of_spot} {rim}");
}

/// A small jump before a large one; and two boxes of a thousandth of half a pixel, which is 0.0436 wide,
/// with nothing behind.
#[test]
fn the_nearest_edge_is_told_and_the_thinnest_box_is_found() {
    let boxes = |[a, b, c]: [f64; 3]| {
        influences(&format!(
            "[world]\nbackground = [0, 0, 1]\n\
             [[box]]\nlbf = [{a:?}, 0, -1]\nrun = [{b:?}, 0.01, 1]\ncolor = [0, 0.2, 1]\n\
             [[box]]\nlbf = [{b:?}, 0, -1]\nrun = [{c:?}, 0.01, 1]\ncolor = [1, 1, 0]\n"
        ))
    };
    let (near, _) = edge(&boxes([0.018, 0.036, 0.5]), "[camera]", "eye x");
    assert!((near - 0.018).abs() < 1e-9);
    for i in 0..20 {
        let near = 1e-4 + 0.001_987_6 * f64::from(i);
        let found = boxes([near, near + 2e-5, near + 4e-5]);
        let (of_eye, _) = edge(&found, "[camera]", "eye x");
        let (of_box, _) = edge(&found, "[[box]] #1", "lbf x");
        assert!((of_eye - near).abs() < 1e-9, "{near}");
        assert!((of_box + near).abs() < 1e-9, "{near}");
    }
}

/// Lambert's cosine is 0 for a light below the plane, and y/|l| above: shadows are off, so that
/// nothing jumps.
#[test]
fn the_slope_jumps_where_the_light_begins_to_arrive() {
    let lit_from =
        |place: &str| influences(&format!("{LIT}shadows = false\n").replace("[1, 2, -3]", place));
    let by_height = GREY.map(|factor| factor / 5.0);
    match response(&lit_from("[3, 0, 4]"), LAMP, "position y") {
        Response::Kink { below, above } => {
            assert_near(*below, [0.0; 3]);
            assert_near(*above, by_height);
        }
        other => panic!("{other:?}"),
    }
    // The light begins to arrive at 1e-5 below the lamp.
    let found = lit_from("[3, 1e-5, 4]");
    assert_slopes(&found, LAMP, &[("position y", by_height)]);
    // A lamp that nearly touches the floor: -xy/|l|³ with a length of √5 times 1e-5.
    let by_x = GREY.map(|factor| -2.0 * factor / (5.0 * 5.0_f64.sqrt() * 1e-5));
    let found = lit_from("[2e-5, 1e-5, 0]");
    assert_slopes(&found, LAMP, &[("position x", by_x)]);
}

/// cos^20000 of atan(0.0436/2) is e^-4.76, so that 0.991 of the highlight is gone.
#[test]
fn a_turning_point_is_told_with_the_change_by_half_a_pixel() {
    let found = influences(
        "[material.m]\ndiffuse = [0.1, 0.1, 0.1]\nspecular = [1, 0.5, 0.25]\nexponent = 20000\n\
         [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n\
         [[point_light]]\ncolor = [1, 1, 1]\nposition = [0, 2, 0]\n",
    );
    let lamp = response(&found, LAMP, "position x");
    let Response::Turning {
        half_pixel, slope, ..
    } = lamp
    else {
        panic!("{lamp:?}");
    };
    assert!((half_pixel[0] + 0.991).abs() < 2e-3, "{lamp:?}");
    assert!(slope[0].abs() < 1e-6, "{lamp:?}");
}

/// The third copy, at 2 times the step, is below the camera: the ray x = 0 hits it around x = c = -0.5
/// where n · l = √(1 - c²), whose derivative by c is -c/√(1 - c²).
#[test]
fn a_number_of_a_repeat_moves_all_of_its_copies() {
    let found = influences(
        "[material.m]\ndiffuse = \"white\"\n\
         [[repeat]]\ncount = 3\ntranslate = [2, 0, 0]\n\
         [[repeat.sphere]]\ncenter = [-4.5, 0, 0]\nradius = 1\nmaterial = \"m\"\n\
         [[directional_light]]\ncolor = [1, 1, 1]\ndirection = [0, -1, 0]\n",
    );
    let by_center = 0.5 / 0.75_f64.sqrt();
    let of_sphere = [("center x", [by_center; 3])];
    assert_slopes(&found, "[[repeat]] #1 [[sphere]] #1", &of_sphere);
    let of_repeat = [("translate x", [2.0 * by_center; 3])];
    assert_slopes(&found, "[[repeat]] #1", &of_repeat);
    assert_eq!(*response(&found, "[[repeat]] #1", "count"), Response::Whole);
}

/// Half a pixel is 0.0436, so the radius would be below 0. The ray passes the centre at the distance
/// 0.032468 (of 0.016991 and 0.027667), and the silhouette there is 0.0108 nearer than the radius.
#[test]
fn the_edge_of_a_ball_smaller_than_half_a_pixel_is_told() {
    let (x, z) = (
        0.016_990_718_715_626_872_f64,
        -0.027_667_163_523_198_115_f64,
    );
    let found = influences(&format!(
        "[world]\nbackground = [0, 0, 1]\n[material.m]\ndiffuse = [1, 0.5, 0.25]\n\
        [[sphere]]\ncenter = [{x}, 0, {z}]\nradius = 0.043252180503524904\nmaterial = \"m\"\n\
        [[directional_light]]\ncolor = [1, 1, 1]\ndirection = [0.3, -1, 0.2]\n"
    ));
    let (distance, jump) = edge(&found, "[[sphere]] #1", "radius");
    let expected = (x * x + z * z).sqrt() - 0.043_252_180_503_524_904;
    assert!((distance - expected).abs() <= 1e-6, "{distance} {expected}");
    assert!(jump[2] > 0.9, "{jump:?}");
}

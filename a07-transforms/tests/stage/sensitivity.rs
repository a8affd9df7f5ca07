//! How a pixel changes with the numbers of a scene file: against closed forms, and at edges.

use common::sensitivity::{self, Influence, Response, sort_by_strength};
use common::{Scene, Settings, Transfer};

use super::scene_files::open;

/// A picture of one pixel, whose ray goes straight down to the origin.
const DOWN: &str = "[picture]\nsize = [1, 1]\n\
    [camera]\neye = [0, 5, 0]\ngaze = [0, -1, 0]\nup = [0, 0, -1]\nangle = 1\n";

/// A grey floor that a lamp lights.
const LIT: &str = "[world]\nambient = [0.1, 0.1, 0.1]\n\
    [material.grey]\ndiffuse = [0.5, 0.25, 0.75]\n\
    [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"grey\"\n\
    [[point_light]]\ncolor = [0.8, 0.9, 1]\nposition = [1, 2, -3]\n";

fn influences(text: &str) -> Vec<Influence> {
    of_pixel(text, [0, 0])
}

fn of_pixel(text: &str, pixel: [u32; 2]) -> Vec<Influence> {
    let scene = open(text).unwrap();
    with_settings(&scene, &scene.defaults, pixel)
}

fn with_settings(scene: &Scene, settings: &Settings, pixel: [u32; 2]) -> Vec<Influence> {
    let rays = scene.rays().unwrap();
    let numbers = rays.numbers(settings).unwrap();
    let mut found = sensitivity::influences(rays, settings, pixel, &numbers, &()).unwrap();
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

fn slope(influences: &[Influence], table: &str, key: &str) -> [f64; 3] {
    match response(influences, table, key) {
        Response::Smooth { slope, .. } => *slope,
        Response::None => [0.0; 3],
        other => panic!("{table} {key}: {other:?}"),
    }
}

#[track_caller]
fn assert_near(actual: [f64; 3], expected: [f64; 3]) {
    for (actual, expected) in actual.into_iter().zip(expected) {
        let error = (actual - expected).abs();
        assert!(error <= 1e-6 * expected.abs(), "{actual:e} {expected:e}");
    }
}

#[test]
fn a_color_changes_its_own_channel_by_its_factor() {
    let text = format!("{DOWN}{LIT}");
    let found = influences(&text);
    // c = cd ca + cd cl n · l with n · l = 2/√14.
    let cosine = 2.0 / 14_f64.sqrt();
    let table = "[material.grey]";
    assert_near(
        slope(&found, table, "diffuse red"),
        [0.1 + 0.8 * cosine, 0.0, 0.0],
    );
    let blue = [0.0, 0.0, 0.1 + cosine];
    assert_near(slope(&found, table, "diffuse blue"), blue);
    let lamp = "[[point_light]] #1";
    assert_near(
        slope(&found, lamp, "color green"),
        [0.0, 0.25 * cosine, 0.0],
    );
    assert_near(slope(&found, "[world]", "ambient green"), [0.0, 0.25, 0.0]);
}

#[test]
fn lamberts_cosine_changes_with_the_place_of_the_light_and_of_the_plane() {
    // n · l = y/|l| with l = (1, 2, -3) has the derivatives -xy/|l|³, (x² + z²)/|l|³ and -yz/|l|³; a
    // higher plane brings the light nearer.
    for (eye, scale) in [(5.0, 1.0), (5e6, 1e6), (5e-6, 1e-6)] {
        let text = format!("{DOWN}{LIT}")
            .replace("eye = [0, 5, 0]", &format!("eye = [0, {eye:?}, 0]"))
            .replace(
                "[1, 2, -3]",
                &format!("[{:?}, {:?}, {:?}]", scale, 2.0 * scale, -3.0 * scale),
            );
        let found = influences(&text);
        let factors = [0.5 * 0.8, 0.25 * 0.9, 0.75];
        let cube = 14.0 * 14_f64.sqrt() * scale;
        let expected = |numerator: f64| factors.map(|factor| factor * numerator / cube);
        let lamp = "[[point_light]] #1";
        assert_near(slope(&found, lamp, "position x"), expected(-2.0));
        assert_near(slope(&found, lamp, "position y"), expected(10.0));
        assert_near(slope(&found, lamp, "position z"), expected(6.0));
        let plane = "[[plane]] #1";
        assert_near(slope(&found, plane, "point y"), expected(-10.0));
        assert_near(slope(&found, plane, "point x"), [0.0; 3]);
    }
}

#[test]
fn the_pixel_jumps_at_the_edge_of_a_sphere_and_of_its_shadow() {
    // The ray down the y axis touches the sphere, or passes at 1/100 of a pixel: the pixel is
    // 10 tan(0.5°) = 0.087 wide.
    for (radius, distance) in [("1", 0.0), ("0.999", 1e-3), ("1.001", -1e-3)] {
        let text = format!(
            "{DOWN}[world]\nbackground = [0, 0, 1]\n\
             [[sphere]]\ncenter = [1, 0, 0]\nradius = {radius}\ncolor = [1, 0.5, 0]\n"
        );
        let found = influences(&text);
        let Response::Edge(edge) = response(&found, "[[sphere]] #1", "radius") else {
            panic!("{found:#?}");
        };
        assert!((edge.distance - distance).abs() < 1e-9, "{edge:?}");
        // Outside of the sphere is the background.
        let inside = if distance < 0.0 { -1.0 } else { 1.0 };
        let expected = [1.0, 0.5, -1.0].map(|channel| channel * inside);
        // At the very edge the lesson decides whether the ray hits.
        assert_eq!(edge.jump.map(f64::abs), expected.map(f64::abs));
        assert!(distance == 0.0 || edge.jump == expected, "{edge:?}");
        assert!(matches!(found[0].response, Response::Edge(_)), "{found:#?}");
    }
    // The ball between the lamp at (1, 2, -3) and the origin, which the middle of its shadow's edge
    // touches.
    let text = format!(
        "{DOWN}{LIT}[[sphere]]\ncenter = [0.5, 1, -1.4]\nradius = 0.085\nmaterial = \"grey\"\n"
    );
    let found = influences(&text);
    // The distance of the centre from the line through the origin along (1, 2, -3)/√14.
    let along = (0.5 + 2.0 + 4.2) / 14_f64.sqrt();
    let distance = (0.25 + 1.0 + 1.96 - along * along).sqrt() - 0.085;
    let Response::Edge(edge) = response(&found, "[[sphere]] #1", "radius") else {
        panic!("{distance}: {found:#?}");
    };
    assert!(
        (edge.distance - distance).abs() < 1e-9,
        "{edge:?} {distance}"
    );
    // A smaller ball lets the light through.
    assert!(edge.distance < 0.0 && edge.jump.iter().all(|channel| *channel > 0.0));
}

#[test]
fn the_slope_jumps_where_the_light_begins_to_arrive() {
    // Lambert's cosine is 0 for a light below the plane, and y/|l| above: shadows are off, so that
    // nothing jumps.
    let text = format!("{DOWN}{LIT}shadows = false\n").replace("[1, 2, -3]", "[3, 0, 4]");
    let found = influences(&text);
    match response(&found, "[[point_light]] #1", "position y") {
        Response::Kink { below, above } => {
            assert_near(*below, [0.0; 3]);
            assert_near(*above, [0.5 * 0.8 / 5.0, 0.25 * 0.9 / 5.0, 0.75 / 5.0]);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn numbers_have_their_places_and_those_without_an_effect_are_told() {
    let text = format!(
        "{DOWN}[material.m]\ndiffuse = \"#ff8000\" # orange\nspecular = \"white\"\n  exponent = 4\n\
         [[group]]\ntransform = [{{ rotate_y = 10 }},\n  {{ translate = [0, 1, 0] }}]\n\
         [[group.sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n\
         [[repeat]]\ncount = 3\ntranslate = [0, 0, 2.5]\n\
         [[repeat.sphere]]\ncenter = [4,\n 0, 0]\nradius = 1\nmaterial = \"m\"\n\
         [[directional_light]]\ncolor = [1, 1, 1]\ndirection = [0, -1, -1]\n"
    );
    let mut found = influences(&text);
    found.sort_by_key(|influence| influence.number.bytes.start);
    let places: Vec<_> = found
        .iter()
        .map(|Influence { number, .. }| {
            let written = &text[number.bytes.clone()];
            let line = text.lines().nth(number.line - 1).unwrap();
            assert_eq!(
                &line[number.columns.start - 1..number.columns.end - 1],
                written
            );
            format!("{}: {} {}", written, number.table, number.key)
        })
        .collect();
    for expected in [
        "1: [picture] size 2",
        "-1: [camera] gaze y",
        "80: [material.m] diffuse green",
        "\"white\": [material.m] specular blue",
        "4: [material.m] exponent",
        "10: [[group]] #1 transform step 1: rotate_y",
        "1: [[group]] #1 transform step 2: translate y",
        "1: [[group]] #1 [[sphere]] #1 radius",
        "3: [[repeat]] #1 count",
        "2.5: [[repeat]] #1 translate z",
        "0: [[repeat]] #1 [[sphere]] #1 center y",
    ] {
        let count = places.iter().filter(|place| *place == expected).count();
        assert_eq!(count, 1, "{expected}: {places:#?}");
    }
    assert_eq!(*response(&found, "[[repeat]] #1", "count"), Response::Whole);
    assert_eq!(*response(&found, "[camera]", "gaze y"), Response::None);
    let radius = response(&found, "[[repeat]] #1 [[sphere]] #1", "radius");
    assert_eq!(*radius, Response::None);
    let green = found.iter().find(|it| it.number.key == "diffuse green");
    assert_eq!(green.unwrap().number.value, 128.0 / 255.0);
}

#[test]
fn a_number_of_a_repeat_moves_all_of_its_copies() {
    // The third copy, at 2 times the step, is below the camera: its top is at y = 1.
    let text = format!(
        "{DOWN}[material.m]\ndiffuse = \"white\"\n\
         [[repeat]]\ncount = 3\ntranslate = [2, 0, 0]\n\
         [[repeat.sphere]]\ncenter = [-4.5, 0, 0]\nradius = 1\nmaterial = \"m\"\n\
         [[directional_light]]\ncolor = [1, 1, 1]\ndirection = [0, -1, 0]\n"
    );
    let found = influences(&text);
    // The ray x = 0 hits the copy around x = c = -0.5 where n · l = √(1 - c²), whose derivative by c
    // is -c/√(1 - c²). The step moves c by twice its change.
    let by_center = 0.5 / 0.75_f64.sqrt();
    let center = slope(&found, "[[repeat]] #1 [[sphere]] #1", "center x");
    assert_near(center, [by_center; 3]);
    let step = slope(&found, "[[repeat]] #1", "translate x");
    assert_near(step, [2.0 * by_center; 3]);
}

#[test]
fn colors_in_bytes_are_those_of_the_chosen_transfer() {
    let text = format!("{DOWN}{LIT}").replace("[0.5, 0.25, 0.75]", "\"#808080\"");
    let scene = open(&text).unwrap();
    let settings = Settings {
        transfer: Transfer::Srgb,
        ..scene.defaults.clone()
    };
    let before = scene.render(&settings, &()).unwrap();
    let found = with_settings(&scene, &settings, [0, 0]);
    let diffuse = found.iter().find(|it| it.number.key == "diffuse red");
    let value = diffuse.unwrap().number.value;
    assert!((value - Transfer::Srgb.decode(128.0 / 255.0)).abs() < 1e-15);
    let cosine = 2.0 / 14_f64.sqrt();
    let expected = [0.1 + 0.8 * cosine, 0.0, 0.0];
    assert_near(slope(&found, "[material.grey]", "diffuse red"), expected);
    // The file is as it was.
    assert_eq!(scene.render(&settings, &()).unwrap(), before);
}

/// The distance of the edge at a number.
#[track_caller]
fn edge(influences: &[Influence], table: &str, key: &str) -> f64 {
    match response(influences, table, key) {
        Response::Edge(edge) => edge.distance,
        other => panic!("{table} {key}: {other:?}"),
    }
}

#[test]
fn the_rim_of_a_spot_is_found_beside_the_ray() {
    // The rim is at 1/100 of a pixel, where the light has fallen to 2/√5 by the cosine.
    let text = format!(
        "{DOWN}[material.m]\ndiffuse = [1, 1, 1]\n\
         [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n\
         [[spot_light]]\ncolor = [1, 0.5, 0.25]\nposition = [1, 2, 0]\n\
         direction = [-0.4, -1, 0]\nhalf_angle = 4.743641690726176\n"
    );
    let found = influences(&text);
    // The angle of the axis is atan 0.4, and that of the rim larger by the half angle.
    let half_angle = 4.743_641_690_726_176_f64.to_radians();
    let rim = 1.0 - 2.0 * libm::tan(libm::atan(0.4) + half_angle);
    assert!((rim - 8.72e-4).abs() < 1e-6, "{rim}");
    for (table, key, expected) in [
        ("[camera]", "eye x", rim),
        ("[[spot_light]] #1", "position x", -rim),
    ] {
        let distance = edge(&found, table, key);
        assert!((distance - expected).abs() < 1e-10, "{distance} {expected}");
    }
}

#[test]
fn the_nearest_edge_is_told_and_the_thinnest_box_is_found() {
    let boxes = |[a, b, c]: [f64; 3]| {
        format!(
            "{DOWN}[world]\nbackground = [0, 0, 1]\n\
             [[box]]\nlbf = [{a:?}, 0, -1]\nrun = [{b:?}, 0.01, 1]\ncolor = [0, 0.2, 1]\n\
             [[box]]\nlbf = [{b:?}, 0, -1]\nrun = [{c:?}, 0.01, 1]\ncolor = [1, 1, 0]\n"
        )
    };
    // A small jump before a large one.
    let found = influences(&boxes([0.018, 0.036, 0.5]));
    assert!((edge(&found, "[camera]", "eye x") - 0.018).abs() < 1e-9);
    // Half a pixel is 0.0436 wide: two boxes of a thousandth of it, and nothing behind.
    let mut seed = 1_u64;
    for _ in 0..40 {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let near = 0.04 * ((seed >> 11) as f64 / (1_u64 << 53) as f64) + 1e-4;
        let sides = [near, near + 2e-5, near + 4e-5];
        let found = influences(&boxes(sides));
        assert!(
            (edge(&found, "[camera]", "eye x") - near).abs() < 1e-9,
            "{near}"
        );
        assert!(
            (edge(&found, "[[box]] #1", "lbf x") + near).abs() < 1e-9,
            "{near}"
        );
    }
}

#[test]
fn a_turning_point_is_told_with_the_change_by_half_a_pixel() {
    let text = format!(
        "{DOWN}[material.m]\ndiffuse = [0.1, 0.1, 0.1]\nspecular = [1, 0.5, 0.25]\n\
         exponent = 20000\n\
         [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n\
         [[point_light]]\ncolor = [1, 1, 1]\nposition = [0, 2, 0]\n"
    );
    let found = influences(&text);
    let lamp = response(&found, "[[point_light]] #1", "position x");
    let Response::Turning {
        half_pixel, slope, ..
    } = lamp
    else {
        panic!("{lamp:?}");
    };
    // cos^20000 of atan(0.0436/2) is e^-4.76, so that 0.991 of the highlight is gone.
    assert!((half_pixel[0] + 0.991).abs() < 2e-3, "{lamp:?}");
    assert!(slope[0].abs() < 1e-6, "{lamp:?}");
}

#[test]
fn a_slope_between_two_bends_that_are_near_is_right() {
    // The light begins to arrive at 1e-5 below the lamp.
    let text = format!("{DOWN}{LIT}shadows = false\n").replace("[1, 2, -3]", "[3, 1e-5, 4]");
    let found = influences(&text);
    let lamp = "[[point_light]] #1";
    let by_height = [0.5 * 0.8 / 5.0, 0.25 * 0.9 / 5.0, 0.75 / 5.0];
    assert_near(slope(&found, lamp, "position y"), by_height);
    // A lamp that nearly touches the floor: y/|l|³ and -xy/|l|³ with a length of 1e-5.
    let text = format!("{DOWN}{LIT}shadows = false\n").replace("[1, 2, -3]", "[2e-5, 1e-5, 0]");
    let found = influences(&text);
    let cube = 5.0 * 5.0_f64.sqrt() * 1e-5;
    let by_x = [0.5 * 0.8, 0.25 * 0.9, 0.75].map(|factor| -2.0 * factor / cube);
    assert_near(slope(&found, lamp, "position x"), by_x);
}

//! How a pixel answers the numbers of a scene file: against closed forms, and at edges.

use super::ask;

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
const SPHERE: &str = "[[sphere]] #1";

const NONE: f64 = 0.0;
const SLOPE: f64 = 1.0;
const JUMP: f64 = 2.0;
const BEND: f64 = 3.0;

/// How a pixel answers a number.
#[derive(Debug)]
struct Response {
    kind: f64,
    channels: [f64; 3],
    error: f64,
    place: f64,
}

/// How the only pixel of a file answers the number of a table and a key.
fn response(text: &str, table: &str, key: &str) -> Response {
    let numbers = ask(&format!("numbers file\n{text}"), &[]);
    let name = format!("{table}\t{key}");
    let index = numbers.text.lines().position(|line| line == name);
    let index = index.unwrap_or_else(|| panic!("{name}: {numbers:?}"));
    let settings = [1.0, 1.0, 1.0, 0.0, 0.0, 6.0, 0.0, 0.0, 0.0, 1.0];
    let given = [&settings[..], &[0.0, 0.0, index as f64, 1.0]].concat();
    let answer = ask(&format!("responses file\n{text}"), &given);
    let [red, green, blue] = answer.get("changes")[..] else {
        panic!("one number: {answer:?}")
    };
    Response {
        kind: answer.get("kinds")[0],
        channels: [red, green, blue],
        error: answer.get("errors")[0],
        place: answer.get("places")[0],
    }
}

/// Asserts a slope of which two digits are told, and which is as exact as it says.
#[track_caller]
fn assert_slope(text: &str, table: &str, key: &str, exact: [f64; 3]) {
    let found = response(text, table, key);
    assert_eq!(found.kind, SLOPE, "{key}: {found:?}");
    let largest = exact.into_iter().map(f64::abs).fold(0.0, f64::max);
    assert!(found.error <= 1e-2 * largest, "{key}: {found:?}");
    for (found_channel, exact) in found.channels.into_iter().zip(exact) {
        let off = (found_channel - exact).abs();
        assert!(off <= found.error, "{key}: {found:?}, {exact}");
    }
}

/// Asserts a jump at a value, within the rounding of a hit, and its channels.
#[track_caller]
fn assert_jump(text: &str, table: &str, key: &str, place: f64) -> [f64; 3] {
    let found = response(text, table, key);
    assert_eq!(found.kind, JUMP, "{key}: {found:?}");
    assert!((found.place - place).abs() < 1e-9, "{found:?}, {place}");
    found.channels
}

/// c = cd ca + cd cl n · l with n · l = 2/√14, also where the colour is given in bytes.
#[test]
fn a_color_changes_its_own_channel_by_its_factor() {
    let text = format!("{DOWN}{LIT}");
    let cosine = 2.0 / 14_f64.sqrt();
    let red = [0.1 + 0.8 * cosine, 0.0, 0.0];
    let blue = [0.0, 0.0, 0.1 + cosine];
    assert_slope(&text, "[material.grey]", "diffuse red", red);
    assert_slope(&text, "[material.grey]", "diffuse blue", blue);
    assert_slope(&text, LAMP, "color green", [0.0, 0.25 * cosine, 0.0]);
    assert_slope(&text, "[world]", "ambient green", [0.0, 0.25, 0.0]);
    let in_bytes = text.replace("[0.5, 0.25, 0.75]", "\"#808080\"");
    assert_slope(&in_bytes, "[material.grey]", "diffuse red", red);
}

/// n · l = y/|l| with l = (1, 2, -3) has the derivatives -xy/|l|³, (x² + z²)/|l|³ and -yz/|l|³; a
/// higher plane brings the light nearer, and one that moves in itself changes nothing.
#[test]
fn lamberts_cosine_changes_with_the_place_of_the_light_and_of_the_plane() {
    for (eye, scale) in [(5.0, 1.0), (5e6, 1e6), (5e-6, 1e-6)] {
        let lamp = [1.0, 2.0, -3.0].map(|x| x * scale);
        let text = format!("{DOWN}{LIT}")
            .replace("eye = [0, 5, 0]", &format!("eye = [0, {eye:?}, 0]"))
            .replace("[1, 2, -3]", &format!("{lamp:?}"));
        let cube = 14.0 * 14_f64.sqrt() * scale;
        let slope = |numerator: f64| GREY.map(|factor| factor * numerator / cube);
        assert_slope(&text, LAMP, "position x", slope(-2.0));
        assert_slope(&text, LAMP, "position y", slope(10.0));
        assert_slope(&text, LAMP, "position z", slope(6.0));
        assert_slope(&text, "[[plane]] #1", "point y", slope(-10.0));
        assert_eq!(response(&text, "[[plane]] #1", "point x").kind, NONE);
    }
}

/// The ray down the y axis touches the sphere, or passes at 1/100 of a pixel, which is
/// 10 tan(0.5°) = 0.087 wide. Outside of the sphere is the background.
#[test]
fn the_pixel_jumps_at_the_edge_of_a_sphere() {
    for (radius, inside) in [("0.999", 1.0), ("1.001", -1.0)] {
        let text = format!(
            "{DOWN}[world]\nbackground = [0, 0, 1]\n\
             [[sphere]]\ncenter = [1, 0, 0]\nradius = {radius}\ncolor = [1, 0.5, 0]\n"
        );
        let expected = [1.0, 0.5, -1.0].map(|channel: f64| channel * inside);
        assert_eq!(assert_jump(&text, SPHERE, "radius", 1.0), expected);
        // The ray meets the edge where the centre is as far from it as the radius.
        let at = radius.parse().unwrap();
        let jump = assert_jump(&text, SPHERE, "center x", at);
        assert_eq!(jump, expected);
    }
}

/// At the very edge the lesson decides whether the ray hits; either way the pixel jumps there.
#[test]
fn a_number_on_an_edge_jumps_where_it_is() {
    let text = format!(
        "{DOWN}[world]\nbackground = [0, 0, 1]\n\
         [[sphere]]\ncenter = [1, 0, 0]\nradius = 1\ncolor = [1, 0.5, 0]\n"
    );
    let jump = assert_jump(&text, SPHERE, "radius", 1.0);
    assert_eq!(jump.map(f64::abs), [1.0, 0.5, 1.0]);
}

/// The ball is between the lamp at (1, 2, -3) and the origin, which the middle of its shadow's edge
/// touches. A smaller ball lets the light through. 0.0087 is 0.1 of a pixel.
#[test]
fn the_pixel_jumps_at_the_edge_of_a_shadow() {
    let text = format!(
        "{DOWN}{LIT}[[sphere]]\ncenter = [0.5, 1, -1.4]\nradius = 0.085\nmaterial = \"grey\"\n"
    );
    // The distance of the centre from the line through the origin along (1, 2, -3)/√14.
    let along = (0.5 + 2.0 + 4.2) / 14_f64.sqrt();
    let distance = (0.25 + 1.0 + 1.96 - along * along).sqrt();
    let jump = assert_jump(&text, SPHERE, "radius", distance);
    assert!(distance < 0.085 && jump.iter().all(|channel| *channel > 0.0));
}

/// Half a pixel is 0.0436, so that the radius would be below 0, and the step is shortened. The ray passes
/// the centre at the distance 0.032468 (of 0.016991 and 0.027667).
#[test]
fn the_edge_of_a_ball_smaller_than_half_a_pixel_is_told() {
    let [x, z] = [0.016_990_718_715_626_872_f64, -0.027_667_163_523_198_115];
    let text = format!(
        "{DOWN}[world]\nbackground = [0, 0, 1]\n[material.m]\ndiffuse = [1, 0.5, 0.25]\n\
         [[sphere]]\ncenter = [{x}, 0, {z}]\nradius = 0.043252180503524904\nmaterial = \"m\"\n\
         [[directional_light]]\ncolor = [1, 1, 1]\ndirection = [0.3, -1, 0.2]\n"
    );
    let jump = assert_jump(&text, SPHERE, "radius", (x * x + z * z).sqrt());
    assert!(jump[2] > 0.9, "{jump:?}");
}

/// Lambert's cosine is 0 for a light below the plane, and y/|l| above, where a slope of one side would be
/// told for both. Shadows are off, so that nothing jumps.
#[test]
fn two_sides_with_two_slopes_have_none_together() {
    let text = format!("{DOWN}{LIT}shadows = false\n").replace("[1, 2, -3]", "[3, 0, 4]");
    let found = response(&text, LAMP, "position y");
    assert_eq!(found.kind, BEND, "{found:?}");
}

/// The same lamp, higher by less than a step: the slope at its place, (x² + z²)/|l|³, is known from one side
/// only, and what the other side adds to it is in the error.
#[test]
fn a_bend_beside_the_number_is_in_the_error() {
    for i in 1..40 {
        let y = f64::from(i) / 1000.0;
        let lit = format!("{DOWN}{LIT}shadows = false\n");
        let found = response(
            &lit.replace("[1, 2, -3]", &format!("[3, {y}, 4]")),
            LAMP,
            "position y",
        );
        let slope = 25.0 / libm::pow(25.0 + y * y, 1.5);
        let off = (found.channels[0] - GREY[0] * slope).abs();
        assert!(found.kind == BEND || off <= found.error, "{y}: {found:?}");
    }
}

/// cos^20000 of atan(0.0436/2) is e^-4.76, so that half a pixel takes 0.991 of the highlight: it is
/// steep, and no jump.
#[test]
fn a_highlight_narrower_than_a_pixel_does_not_jump() {
    let text = format!(
        "{DOWN}[material.m]\ndiffuse = [0.1, 0.1, 0.1]\nspecular = [1, 0.5, 0.25]\nexponent = 20000\n\
         [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n\
         [[point_light]]\ncolor = [1, 1, 1]\nposition = [0, 2, 0]\n"
    );
    let found = response(&text, LAMP, "position x");
    assert_eq!(found.kind, BEND, "{found:?}");
    assert!((found.channels[0] + 0.991).abs() < 2e-3, "{found:?}");
    assert!((found.place.abs() - 0.0436).abs() < 1e-4, "{found:?}");
}

/// The third copy, at 2 times the step, is below the camera: the ray x = 0 hits it around x = c = -0.5
/// where n · l = √(1 - c²), whose derivative by c is -c/√(1 - c²).
#[test]
fn a_number_of_a_repeat_moves_all_of_its_copies() {
    let text = format!(
        "{DOWN}[material.m]\ndiffuse = \"white\"\n\
         [[repeat]]\ncount = 3\ntranslate = [2, 0, 0]\n\
         [[repeat.sphere]]\ncenter = [-4.5, 0, 0]\nradius = 1\nmaterial = \"m\"\n\
         [[directional_light]]\ncolor = [1, 1, 1]\ndirection = [0, -1, 0]\n"
    );
    let by_center = 0.5 / 0.75_f64.sqrt();
    let of_sphere = "[[repeat]] #1 [[sphere]] #1";
    assert_slope(&text, of_sphere, "center x", [by_center; 3]);
    assert_slope(&text, "[[repeat]] #1", "translate x", [2.0 * by_center; 3]);
}

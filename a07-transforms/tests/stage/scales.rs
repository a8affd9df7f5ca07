//! Groups in groups whose scales multiply to more than the square root of the largest double.

use common::{Color, Renderer, Settings};

use crate::scene_cases::open;

/// A shape of about the size 2 under two groups, each of which makes it `scale` times as large,
/// before an eye that is as far away.
fn scene(shape: &str, scale: &str, eye: &str) -> String {
    format!(
        "[picture]\nsize = [9, 9]\n[camera]\neye = [0, 0, {eye}]\ngaze = [0, 0, -1]\nangle = 40\n\
         [world]\nbackground = [0, 0, 1]\n[[group]]\ncolor = \"white\"\n\
         transform = [{{ scale = [{scale}, {scale}, {scale}] }}]\n[[group.group]]\n\
         transform = [{{ scale = [{scale}, {scale}, {scale}] }}]\n{shape}\n"
    )
}

/// The number of white pixels by each renderer.
fn white_pixels(text: &str) -> [usize; 3] {
    let scene = open(text).unwrap();
    Renderer::ALL.map(|renderer| {
        let settings = Settings {
            renderer,
            ..scene.defaults.clone()
        };
        let image = scene.render(&settings, &()).unwrap();
        let colors = image.rows().flatten();
        colors.filter(|color| **color == Color::WHITE).count()
    })
}

#[test]
fn every_shape_is_seen_under_scales_of_any_size() {
    let at = |n: i32| format!("1e{n}");
    for (shape, expected) in [
        (
            "[[group.group.sphere]]\ncenter = [0, 0, 0]\nradius = 2S",
            21,
        ),
        (
            "[[group.group.box]]\nlbf = [-2S, -2S, -2S]\nrun = [2S, 2S, 2S]",
            49,
        ),
        (
            "[[group.group.disc]]\ncenter = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 2S",
            21,
        ),
        (
            "[[group.group.plane]]\npoint = [0, 0, 0]\nnormal = [0, 0, 1]",
            81,
        ),
        (
            "[[group.group.triangle]]\ncorners = [[-2S, -2S, 0], [2S, -2S, 0], [0, 2S, 0]]",
            13,
        ),
    ] {
        for exponent in [0, 40, 81, 99, -40, -81, -99] {
            // As large in its own space as makes 2 times the scale around it.
            let shape = shape.replace('S', &format!("e{}", -exponent));
            let eye = format!("9e{exponent}");
            let found = white_pixels(&scene(&shape, &at(exponent), &eye));
            assert_eq!(found, [expected; 3], "{shape} under {exponent}");
        }
    }
}

#[test]
fn scales_that_multiply_beyond_the_range_are_an_error_with_their_line() {
    let deeper = "[[group.group.group]]\ntransform = [{ scale = [1e100, 1e100, 1e100] }]\n\
                  [[group.group.group.sphere]]\ncenter = [0, 0, 0]\nradius = 1";
    let error = open(&scene(deeper, "1e100", "9")).err().unwrap();
    assert!(error.starts_with("9:1:"), "{error}");
    assert!(error.contains("more than 1e200 times"), "{error}");
}

//! Colours and exponents that are refused.

use a05_lighting::{Lambert, LitWorld, Phong, SingleColor};
use common::{ArgumentError, Color};

fn refusal<T: std::fmt::Debug>(result: Result<T, ArgumentError>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn bad_colors_are_refused_by_name() {
    let white = Color::WHITE;
    for bad in [f64::NAN, f64::INFINITY, -1e-9, 1e51] {
        let color = Color::new(bad, 1.0, 1.0);
        for (said, name) in [
            (refusal(SingleColor::new(color)), "colour is"),
            (refusal(Lambert::new(color)), "diffuse is"),
            (refusal(Phong::new(color, white, 1.0)), "diffuse is"),
            (refusal(Phong::new(white, color, 1.0)), "specular is"),
            (refusal(LitWorld::new(color, white)), "background is"),
            (refusal(LitWorld::new(white, color)), "ambient light is"),
        ] {
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("channels from 0 to 1e50"), "{said}");
        }
    }
}

#[test]
fn bad_exponents_are_refused_by_name() {
    for bad in [-1.0, -1e-300, f64::NAN, f64::INFINITY] {
        let said = refusal(Phong::new(Color::WHITE, Color::WHITE, bad));
        assert!(said.starts_with("exponent is"), "{said}");
        assert!(said.contains("finite number of at least 0"), "{said}");
    }
}

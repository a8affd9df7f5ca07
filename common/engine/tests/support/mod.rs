//! Pictures of functions of the place, and the error of a picture.

#[path = "../../src/adaptive/random.rs"]
mod random;
mod stratified;

use common::{Color, Image, Settings, Size};

pub use stratified::{shown, stratified};

/// Settings for pictures of this error.
pub fn settings(max_error: f64) -> Settings {
    Settings {
        size: Size::new(80, 60).unwrap(),
        samples: 1024,
        max_error: Some(max_error),
        ..Settings::default()
    }
}

/// The root mean square difference of the channels as a screen shows them.
pub fn root_mean_square(a: &Image, b: &Image) -> f64 {
    let channels = |image: &Image| -> Vec<f64> {
        let shown = |color: &Color| shown(*color).channels();
        image.pixels().iter().flat_map(shown).collect()
    };
    let (a, b) = (channels(a), channels(b));
    assert_eq!(a.len(), b.len());
    let squares = a.iter().zip(&b).map(|(a, b)| (a - b) * (a - b));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

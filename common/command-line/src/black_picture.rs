//! `warn_if_black`: says why a picture is black, the question that students ask most.

use common::pixel_trace::digits;
use common::{Color, Image, Scene, Settings};

use crate::print::warn;

/// Prints a note with the reason if a picture is black all over, and the reason is sure.
pub fn warn_if_black(scene: &Scene, settings: &Settings, image: &Image) {
    let mut brightest: f64 = 0.0;
    for color in image.rows().flatten() {
        // Bytes take longer than this, and pictures begin with many black pixels.
        if *color == Color::BLACK {
            continue;
        }
        if settings.transfer.bytes(*color) != [0; 3] {
            return;
        }
        brightest = color.channels().into_iter().fold(brightest, f64::max);
    }
    let reason = if brightest > 0.0 {
        let brightest = digits(&[brightest]);
        Some(format!(
            "its brightest color is {brightest}, and white is 1"
        ))
    } else if let Ok(rays) = scene.rays() {
        rays.why_black(settings).ok().flatten()
    } else {
        None
    };
    if let Some(reason) = reason {
        warn(&format!("note: the picture is black: {reason}"));
    }
}

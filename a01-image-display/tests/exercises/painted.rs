//! A picture as the answer of a comparison: its size, and the places that are painted.

use crate::prelude::*;

/// The answer of a function that paints a picture of this width and height.
pub fn painted((w, h): (u32, u32), paint: impl Fn(Size) -> Result<Image, Error>) -> Answer {
    let described = |image: Image| {
        let places = image.pixels().iter().zip(0..).filter_map(|(color, i)| {
            let name = match *color {
                Color::BLACK => return None,
                Color::RED => "red",
                Color::BLUE => "blue",
                _ => "another colour",
            };
            Some(format!(", {name} at ({}, {})", i % w, i / w))
        });
        format!("{}{}", image.size(), places.collect::<String>())
    };
    let image = Size::new(w, h).map_err(Error::from).and_then(paint);
    Answer::words(image.map_or_else(|error| error.to_string(), described))
}

//! A picture as the answer of a comparison: its size, and its rows in letters.

use crate::prelude::*;

/// The letter of a pixel that is neither black nor red, green or blue.
const OTHER: char = '?';

/// The answer of a function that paints a picture of this width and height. In its rows, `.` is a
/// black pixel.
pub fn painted((w, h): (u32, u32), paint: impl Fn(Size) -> Result<Image, Error>) -> Answer {
    let image = match Size::new(w, h).map_err(Error::from).and_then(paint) {
        Ok(image) => image,
        Err(error) => return Answer::words(error.to_string()),
    };
    let mut answer = Answer::named("size", Answer::words(image.size().to_string()));
    for (row, pixels) in image.rows().enumerate() {
        let mut letters: String = pixels.iter().map(letter).collect();
        if let Some(other) = pixels.iter().find(|color| letter(color) == OTHER) {
            let channels = format!("{:?}", other.channels());
            letters.extend([", where ? is ", &channels]);
        }
        answer = answer.and(&format!("row {row}"), Answer::words(letters));
    }
    answer
}

fn letter(color: &Color) -> char {
    match *color {
        Color::BLACK => '.',
        Color::RED => 'r',
        Color::GREEN => 'g',
        Color::BLUE => 'b',
        _ => OTHER,
    }
}

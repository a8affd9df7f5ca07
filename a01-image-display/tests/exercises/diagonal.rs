//! Pictures of all shapes, compared with the solution.

use crate::prelude::*;

yours! { diagonal }

type Code = fn(Size) -> Result<Image, Error>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::scene("diagonal", |diagonal: &Code, settings| {
            diagonal(settings.size)
        }),
        ..Exercise::asked(|diagonal: &Code, size| painted(size, diagonal))
    }
}

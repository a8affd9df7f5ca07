//! Pictures of all shapes, compared with the solution.

use crate::prelude::*;

yours! { line }

type Code = fn(Size) -> Result<Image, Error>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(|line: &Code, settings| line(settings.size)),
        ..Exercise::asked(|line: &Code, size| painted(size, line))
    }
}

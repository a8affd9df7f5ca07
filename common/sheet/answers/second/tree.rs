use crate::functions::*; pub fn render(_: &str, _: u32) -> Result<Image, Error> { unimplemented!() }

//! The code in the chapters of the stages, which `cargo test` runs.

#[cfg(doctest)]
#[doc = include_str!("src/a01-image-display.md")]
mod a01_image_display {}
#[cfg(doctest)]
#[doc = include_str!("src/a02-math.md")]
mod a02_math {}
#[cfg(doctest)]
#[doc = include_str!("src/a03-rays-cameras.md")]
mod a03_rays_cameras {}
#[cfg(doctest)]
#[doc = include_str!("src/a04-intersections.md")]
mod a04_intersections {}
#[cfg(doctest)]
#[doc = include_str!("src/a05-lighting.md")]
mod a05_lighting {}
#[cfg(doctest)]
#[doc = include_str!("src/a06-shadows-reflection.md")]
mod a06_shadows_reflection {}
#[cfg(doctest)]
#[doc = include_str!("src/a07-transforms.md")]
mod a07_transforms {}

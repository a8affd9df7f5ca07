//! Assignment 5: lights, and materials that reflect their light.
//!
//! A [`Light`] computes direction, distance and colour of its light at a point. A
//! [`Material`] adds up the light that it reflects. It takes the light from
//! [`Lighting`], because a later stage has shadows.

mod adapter;
mod directional_light;
mod lambert;
mod light;
mod lighting;
mod lit_world;
mod material;
mod phong;
mod point_light;
#[doc(hidden)]
pub mod power;
#[doc(hidden)]
pub mod scenes;
mod single_color;
mod spot_light;

#[doc(hidden)]
pub use crate::adapter::instruments;
pub use crate::adapter::registry;
pub use crate::adapter::stage;
pub use directional_light::DirectionalLight;
pub use lambert::Lambert;
pub use light::{Illumination, Light};
pub use lighting::Lighting;
pub use lit_world::LitWorld;
pub use material::Material;
pub use phong::Phong;
pub use point_light::PointLight;
pub use single_color::SingleColor;
pub use spot_light::SpotLight;

//! Assignment 5: lights, and materials that answer them.
//!
//! A [`Light`] says from where, how far and in which colour it illuminates a
//! point. A [`Material`] adds up what of this reaches it; what does is asked
//! through [`Lighting`], because a later stage knows of shadows.

mod color_packet;
mod directional_light;
mod lab;
mod lambert;
mod light;
mod lighting;
mod lit_world;
mod material;
mod phong;
mod phong_packet;
mod point_light;
mod power;
mod scenes;
mod single_color;
mod spot_light;

pub use color_packet::ColorPacket;
pub use directional_light::DirectionalLight;
#[doc(hidden)]
pub use lab::protocol;
pub use lambert::Lambert;
pub use light::{Illumination, IlluminationPacket, Light};
pub use lighting::Lighting;
pub use lit_world::LitWorld;
pub use material::Material;
pub use phong::Phong;
pub use phong_packet::PhongPacket;
pub use point_light::PointLight;
pub use scenes::stage;
pub use single_color::SingleColor;
pub use spot_light::SpotLight;

/// The code in this stage's chapter is tested with it.
#[cfg(doctest)]
#[doc = include_str!("../../book/src/a05-lighting.md")]
mod book {}

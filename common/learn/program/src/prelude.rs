//! The names that the functions use. The types are the workbook's, such as vectors, colours and the list of
//! objects; where a function of yours has the same name as one of the workbook, yours is meant.

#![allow(
    unused_imports,
    reason = "an edited program may need more or fewer of them"
)]

pub use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI, TAU};

pub use a02_math::arrays::{array, point, vector};
pub use a02_math::*;
pub use a03_rays_cameras::*;
pub use a04_intersections::*;
pub use a05_lighting::*;
pub use a06_shadows_reflection::*;
pub use a07_transforms::*;
pub use common::*;

pub use crate::functions::axis_aligned_box::AxisAlignedBox;
pub use crate::functions::chain::chain;
pub use crate::functions::directional_light::directional_light;
pub use crate::functions::disc::Disc;
pub use crate::functions::lambert::lambert;
pub use crate::functions::leaving::secondary_ray;
pub use crate::functions::mirror::trace;
pub use crate::functions::nearest::nearest;
pub use crate::functions::node::Node;
pub use crate::functions::perspective::PerspectiveCamera;
pub use crate::functions::phong::phong;
pub use crate::functions::picture::picture;
pub use crate::functions::plane::Plane;
pub use crate::functions::point_light::point_light;
pub use crate::functions::ray::{at, t_of};
pub use crate::functions::shadowed::is_shadowed;
pub use crate::functions::sphere::Sphere;
pub use crate::functions::spot_light::spot_light;
pub use crate::functions::triangle::Triangle;
pub use crate::functions::under_transform::{normal_from_object, ray_to_object};
pub use crate::lights::{DirectionalLight, PointLight, RecursiveTracer, SpotLight};
pub use crate::materials::{Lambert, Reflective};
pub use crate::mesh::Mesh;
pub use crate::transform::{Step, Transform};

/// A value, or the argument of its constructor that is wrong.
pub type Made<T> = Result<T, ArgumentError>;

//! `Light`: the light that a source sends to one point and to four points.

use common::Color;
use fearless_simd::prelude::*;
use glam::DVec3;

use crate::lanes::{ColorPacket, Lanes, Vector3x4, bits_of, greater, is_set, lanes, splat};
use crate::vector::normalized;

/// A source of light.
pub struct Light<'a> {
    /// How it shines.
    pub kind: Emitter<'a>,
    /// Whether objects cast shadows in it.
    pub casts_shadows: bool,
}

/// The light of a source at a point, without shadows; none outside of its beam.
pub type LightFn<'a> = Box<dyn Fn(DVec3) -> Option<Illumination> + Send + Sync + 'a>;

/// How a light shines.
pub enum Emitter<'a> {
    /// Shines from one point in all directions.
    Point {
        /// Its colour.
        color: Color,
        /// Where it is.
        position: DVec3,
    },
    /// Shines from one point into a cone.
    Spot {
        /// Its colour.
        color: Color,
        /// Where it is.
        position: DVec3,
        /// The axis of the cone, of length 1.
        direction: DVec3,
        /// The cosine of half the angle of the cone.
        cos_half_angle: f64,
    },
    /// Shines everywhere in the same direction.
    Directional {
        /// Its colour.
        color: Color,
        /// The direction in which it travels, of length 1.
        direction: DVec3,
    },
    /// A light that the engine does not know: this function computes its light at a point.
    Other(LightFn<'a>),
}

/// The light that a source sends to a point, without shadows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Illumination {
    /// Its colour.
    pub color: Color,
    /// From the point to the source, of length 1.
    pub direction: DVec3,
    /// From the point to the source; infinite for a directional light.
    pub distance: f64,
}

/// The light that a source sends to up to four points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IlluminationPacket<S: Simd> {
    /// A bit for each point on which it shines.
    pub lit: u32,
    /// Its colours there.
    pub color: ColorPacket<S>,
    /// From the points to the source, of length 1.
    pub direction: Vector3x4<S>,
    /// From the points to the source.
    pub distance: Lanes<S>,
}

impl Light<'_> {
    /// Upper bound of its light at any point, also next to the lamp, per channel. A light that is
    /// brighter than its colour somewhere, such as one that falls off with the distance, needs a larger
    /// bound; infinite if there is none. The promise of `--max-error` relies on it.
    #[must_use]
    pub fn max_radiance(&self) -> Color {
        match self.kind {
            Emitter::Point { color, .. }
            | Emitter::Spot { color, .. }
            | Emitter::Directional { color, .. } => color,
            Emitter::Other(_) => Color::gray(f64::INFINITY),
        }
    }

    /// The light that it sends to the active of four points.
    #[inline(always)]
    pub(crate) fn illuminate<S: Simd>(
        &self,
        points: Vector3x4<S>,
        active: u32,
    ) -> IlluminationPacket<S> {
        let simd = points.x.simd;
        match self.kind {
            Emitter::Point { color, position } => from_point(color, position, points, active),
            Emitter::Spot {
                color,
                position,
                direction,
                cos_half_angle,
            } => {
                let mut light = from_point(color, position, points, active);
                let cosine = (-light.direction).dot(Vector3x4::splat(simd, direction));
                // Two opposite unit vectors may multiply to a little less than -1.
                let cosine = greater(cosine, splat(simd, -1.0));
                light.lit &= bits_of(cosine.simd_ge(cos_half_angle));
                light
            }
            Emitter::Directional { color, direction } => IlluminationPacket {
                lit: active,
                color: ColorPacket::splat(simd, color),
                direction: Vector3x4::splat(simd, -direction),
                distance: splat(simd, f64::INFINITY),
            },
            Emitter::Other(ref illumination) => one_by_one(illumination, points, active),
        }
    }
}

#[inline(always)]
fn from_point<S: Simd>(
    color: Color,
    position: DVec3,
    points: Vector3x4<S>,
    active: u32,
) -> IlluminationPacket<S> {
    let simd = points.x.simd;
    let to_light = Vector3x4::splat(simd, position) - points;
    let (direction, is_unit) = to_light.normalized();
    if active & !bits_of(is_unit) != 0 {
        let illumination = |point: DVec3| {
            let to_light = position - point;
            Some(Illumination {
                color,
                direction: normalized(to_light)?,
                distance: to_light.length(),
            })
        };
        return one_by_one(illumination, points, active);
    }
    IlluminationPacket {
        lit: active,
        color: ColorPacket::splat(simd, color),
        direction,
        distance: to_light.dot(to_light).sqrt(),
    }
}

#[inline(never)]
fn one_by_one<S: Simd>(
    illumination: impl Fn(DVec3) -> Option<Illumination>,
    points: Vector3x4<S>,
    active: u32,
) -> IlluminationPacket<S> {
    let simd = points.x.simd;
    let points = points.to_lanes();
    let one = |lane: usize| is_set(active, lane).then(|| illumination(points[lane]));
    let lights = [0, 1, 2, 3].map(|lane| one(lane).flatten());
    let lit = [0, 1, 2, 3].map(|lane| u32::from(lights[lane].is_some()) << lane);
    let lights = lights.map(Option::unwrap_or_default);
    IlluminationPacket {
        lit: lit.iter().sum(),
        color: ColorPacket::new(simd, lights.map(|light| light.color)),
        direction: Vector3x4::new(simd, lights.map(|light| light.direction)),
        distance: lanes(simd, lights.map(|light| light.distance)),
    }
}

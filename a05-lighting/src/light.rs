//! `Light`: what a light is to a point.

use std::fmt::Debug;

use a02_math::{Lanes, Point3, Vector3, Vector3x4};
use a03_rays_cameras::Focus;
use common::Color;

use crate::ColorPacket;

/// The light that a source sends to a point, nothing being in between.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
// ANCHOR: illumination
pub struct Illumination {
    /// Its colour.
    pub color: Color,
    /// From the point to the source; its length is 1.
    pub direction: Vector3,
    /// From the point to the source; infinite if the source is nowhere.
    pub distance: f64,
}
// ANCHOR_END: illumination

/// The light that a source sends to up to four points.
#[derive(Clone, Copy, Debug)]
pub struct IlluminationPacket {
    /// A bit for each point on which it shines.
    pub lit: u32,
    /// Its colours there.
    pub color: ColorPacket,
    /// From the points to the source; the lengths are 1.
    pub direction: Vector3x4,
    /// From the points to the source; infinite if the source is nowhere.
    pub distance: Lanes,
}

/// A source of light.
pub trait Light: Debug + Send + Sync {
    /// What the light sends to `point`, or none if that lies outside of its
    /// beam or in the source itself.
    fn illumination(&self, point: Point3) -> Option<Illumination>;

    /// The same for four points, of which those count whose bits are set in
    /// `active`.
    fn illuminations(&self, points: Vector3x4, active: u32) -> IlluminationPacket {
        one_by_one(self, points, active)
    }

    /// What its rays have in common. None if nothing, and where nothing can be
    /// gained from knowing.
    fn focus(&self) -> Option<Focus> {
        None
    }

    /// What no channel of its light exceeds anywhere, in magnitude. Infinite
    /// unless the light says better.
    fn brightest(&self) -> Color {
        Color::gray(f64::INFINITY)
    }

    /// Whether the light shines on `point`, nothing being in between.
    fn illuminates(&self, point: Point3) -> bool {
        self.illumination(point).is_some()
    }

    /// The direction of length 1 from `point` to the light, if it shines there.
    fn direction_from(&self, point: Point3) -> Option<Vector3> {
        self.illumination(point).map(|light| light.direction)
    }
}

/// Asks a light for each of four points alone.
pub(crate) fn one_by_one(
    light: &(impl Light + ?Sized),
    points: Vector3x4,
    active: u32,
) -> IlluminationPacket {
    let points = points.to_lanes().map(Point3::from_glam);
    let one = |lane: usize| (active >> lane & 1 != 0).then(|| light.illumination(points[lane]));
    let lights = [0, 1, 2, 3].map(|lane| one(lane).flatten());
    let lit = [0, 1, 2, 3].map(|lane| u32::from(lights[lane].is_some()) << lane);
    let lights = lights.map(Option::unwrap_or_default);
    IlluminationPacket {
        lit: lit.iter().sum(),
        color: ColorPacket::new(lights.map(|light| light.color)),
        direction: Vector3x4::new(lights.map(|light| light.direction.to_glam())),
        distance: Lanes::new(lights.map(|light| light.distance)),
    }
}

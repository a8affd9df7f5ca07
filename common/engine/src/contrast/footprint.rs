//! `Footprint`: the part of a surface that fills a pixel, and how much directions change on it.

use glam::DVec3;

use crate::lanes::{PacketHit, RayPacket};

/// The part of a surface that fills a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Footprint {
    /// A point of it, which the ray through a corner meets.
    pub point: DVec3,
    /// The unit normal there, on the side of the ray.
    pub normal: DVec3,
    /// The direction of that ray, of length 1.
    pub direction: DVec3,
    /// Upper bound of the length of the path on the surface between any two of its points.
    pub length: f64,
    /// Upper bound of the angle between any two of its normals.
    pub normal_angle: f64,
    /// Upper bound of the angle between the directions of any two rays.
    pub ray_angle: f64,
}

/// The longest distance of the ends of unit vectors that are 60 degrees apart.
const WIDEST: f64 = 1.0;

impl Footprint {
    /// The footprint of a pixel on a sphere or a flat surface of this curvature, which all rays
    /// meet from outside, from the rays through the corners.
    ///
    /// If a ray moves sideways by a length, its hit moves on the surface by that length divided
    /// by the cosine of incidence. Turned by an angle, a ray moves sideways by the angle times `t`.
    /// On a plane the rays that hit it beyond some `t`, or with less than some cosine, are those
    /// outside of a cone; on a sphere both grow with the distance from its middle. So the largest
    /// `t` and the least cosine of a pixel are those of a corner.
    pub fn new(rays: &RayPacket, hit: &PacketHit, curvature: f64) -> Self {
        let spread = Spread::new(rays);
        let (rays, hits) = (rays.to_rays(), hit.to_hits());
        let (mut t, mut cosine) = (0.0_f64, 1.0_f64);
        for (ray, hit) in rays.iter().zip(&hits) {
            t = t.max(hit.t);
            cosine = cosine.min(hit.geometric_normal.dot(ray.direction).abs());
        }
        let length = spread.at(t) / cosine;
        // Flat surfaces do not turn, however long they are.
        let normal_angle = if curvature == 0.0 {
            0.0
        } else {
            curvature * length
        };
        let [ray, ..] = rays;
        Self {
            point: ray.origin + ray.direction * hits[0].t,
            normal: hits[0].normal,
            direction: ray.direction,
            length,
            normal_angle,
            ray_angle: spread.angle,
        }
    }
}

/// How far the rays of a pixel are from each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spread {
    /// Upper bound of the distance of two origins.
    pub origins: f64,
    /// Upper bound of the angle between two directions.
    pub angle: f64,
}

impl Spread {
    /// The spread of a pixel, from the rays through its corners: two rays are the farthest apart
    /// in two corners. Rays more than 60 degrees apart have an infinite angle.
    pub fn new(rays: &RayPacket) -> Self {
        let rays = rays.to_rays();
        let chord = largest_distance(rays.map(|ray| ray.direction));
        let is_narrow = chord <= WIDEST;
        Self {
            origins: largest_distance(rays.map(|ray| ray.origin)),
            angle: if is_narrow {
                2.0 * libm::asin(chord / 2.0)
            } else {
                f64::INFINITY
            },
        }
    }

    /// Upper bound of the distance between the points of two rays at this `t`.
    pub fn at(self, t: f64) -> f64 {
        self.origins + t * self.angle
    }
}

/// The largest distance between two of four points.
fn largest_distance(points: [DVec3; 4]) -> f64 {
    let mut largest = 0.0_f64;
    for a in points {
        for b in points {
            largest = largest.max(a.distance(b));
        }
    }
    largest
}

//! `TiltedFloor`: a tilted floor, at whose points a light arrives or does not.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, Plane, World};
use a04_lab::support::Numbers;
use a05_lighting::Light;
use common::{Color, Error};
use measure::extremes::{AgainstProtocol, count_wrong};

use a06_shadows_reflection::is_shadowed;

/// A tilted floor through the origin, in a scene of this size.
pub struct TiltedFloor {
    floor: Plane,
    normal: Vector3,
    size: f64,
}

/// What is right for all points of a tilted floor.
pub struct Expected<'a> {
    pub world: &'a World<()>,
    pub light: &'a dyn Light,
    pub is_lit: bool,
}

impl TiltedFloor {
    pub fn new(size: f64) -> Result<Self, Error> {
        let normal = Vector3::new(0.3, 1.0, 0.2).unit("normal")?;
        let floor = Plane::new(Point3::ORIGIN, normal.as_normal())?;
        Ok(Self {
            floor,
            normal,
            size,
        })
    }

    /// The point at this height above the floor, in sizes of the scene.
    pub fn above(&self, height: f64) -> Point3 {
        Point3::ORIGIN + self.normal * (height * self.size)
    }

    /// The world of the floor alone.
    pub fn world(&self) -> Result<World<()>, Error> {
        Ok(World::new(Color::BLACK)?.with(self.floor, ()))
    }

    /// Of some points around the origin, computed as hits of rays, so that they lie a little
    /// above the floor or below, the number that is not lit as it should be: by our shadow
    /// rays, and by the protocol's.
    pub fn misjudged(
        &self,
        points: usize,
        expected: &Expected,
        is_lit_by_the_protocol: impl Fn(Point3) -> bool,
    ) -> Result<AgainstProtocol<usize>, Error> {
        count_wrong(0..points, |i| {
            let aside = self.normal.cross(Numbers::new(14, i).triple(-1.0, 1.0));
            let eye = self.above(3.0) + self.normal.cross(aside) * (4.0 * self.size);
            let target = Point3::ORIGIN + aside * (0.3 * self.size);
            let ray = Ray::new(eye, target - eye)?;
            let Some(hit) = self.floor.hit(&ray, Interval::AHEAD) else {
                return Ok(AgainstProtocol::default());
            };
            let point = ray.at(hit.t);
            let light = expected.light.illumination(point);
            let is_lit =
                light.is_some_and(|light| !is_shadowed(expected.world, &ray, &hit, &light));
            Ok(AgainstProtocol {
                ours: is_lit != expected.is_lit,
                theirs: is_lit_by_the_protocol(point) != expected.is_lit,
            })
        })
    }
}

//! Tests of `Accelerator`. Nearest hits are compared with the lessons in the tests of the stages.

use glam::DVec3;

use super::*;
use crate::adaptive::PixelRandom;
use crate::lanes::{Lanes, RayPacket, is_set};
use crate::shape::{Shape, Sphere};
use crate::{Plane, Ray};

/// A shadow ray is occluded exactly if its nearest hit lies before its end: in a linear scan and in
/// trees, in bundles and ray by ray, with rays that are not active among them.
#[test]
fn a_shadow_ray_is_occluded_by_its_nearest_hit() {
    let mut counts = [0; 3];
    for (seed, count) in [(1, 3), (2, 12), (3, 40), (4, 1_000)] {
        let random = PixelRandom::new(seed, 0, 0);
        let vector =
            |n: u32| DVec3::from([0, 1, 2].map(|i| 2.0 * random.uniform((4 * n + i).into()) - 1.0));
        let mut shapes = Shapes::default();
        for i in 0..count {
            let radius = 0.5 * random.uniform((4 * i + 3).into()) / libm::cbrt(count.into());
            let center = vector(i);
            shapes.push(Shape::Sphere(Sphere { center, radius }), i);
        }
        let (point, normal) = (DVec3::NEG_Y, DVec3::Y);
        shapes.push(Shape::Plane(Plane { point, normal }), count);
        let accelerator = Accelerator::new(shapes);
        for first in (10_000..).step_by(1_000).take(100) {
            // Sixteen packets of rays that are close to each other, or of rays that are not.
            let spread = [1e-3, 0.1, 1.0][first as usize / 1_000 % 3];
            let way = (vector(first) + 0.1).normalize();
            let ray = |i: u32| Ray {
                origin: vector(first + 1) * 2.0 + vector(first + 4 * i + 2) * spread,
                direction: (way + vector(first + 4 * i + 3) * spread).normalize(),
            };
            let packet = |i| RayPacket::new([0, 1, 2, 3].map(|lane| ray(4 * i + lane)).each_ref());
            let packets: [_; PACKETS] = std::array::from_fn(|i| (packet(i as u32), i as u32 | 1));
            let mut nearest = packets
                .each_ref()
                .map(|(p, active)| NearestQuery::new(p, *active));
            accelerator.traverse(&mut nearest, &mut ());
            let t = nearest
                .each_ref()
                .map(|query| accelerator.shapes.hits(query).hit.t);
            for after in [false, true] {
                let end = |t: f64| match (after, t.is_nan()) {
                    (_, true) => f64::INFINITY,
                    (false, _) => t,
                    (true, _) => t.next_up(),
                };
                let mut shadows: [_; PACKETS] = std::array::from_fn(|i| {
                    let t_max = Lanes::new(t[i].to_array().map(end));
                    ShadowQuery::new(&packets[i].0, t_max, packets[i].1)
                });
                accelerator.traverse(&mut shadows, &mut None);
                for (i, shadow) in shadows.iter().enumerate() {
                    for lane in (0..4).filter(|lane| is_set(packets[i].1, *lane)) {
                        let is_hit = is_set(nearest[i].hit_mask(), lane);
                        let is_occluded = !is_set(shadow.unoccluded, lane);
                        assert_eq!(is_occluded, after && is_hit);
                        counts[usize::from(is_hit) + usize::from(is_occluded)] += 1;
                    }
                }
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 1_000), "{counts:?}");
}

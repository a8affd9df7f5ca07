//! The same scene in other units or at another place: the strongest test for
//! lengths hidden in a formula, because every bit must stay.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, Sphere, Triangle};

/// The four shapes around the origin, in coordinates that are multiples of
/// 2^-20, `scale` times as large and moved by (`shift`, `shift`, `shift`).
fn shapes(scale: f64, shift: f64) -> [Box<dyn Geometry>; 4] {
    let at = |x: f64, y: f64, z: f64| place([x, y, z], scale, shift);
    let [a, b, c] = [
        at(-1.5, 0.25, 0.0),
        at(1.0, -1.25, 0.5),
        at(0.5, 1.5, -0.75),
    ];
    let normal = Vector3::new(1.0, 2.0, -3.0).as_normal();
    [
        Box::new(Plane::new(at(0.25, -0.5, 1.0), normal).unwrap()),
        Box::new(AxisAlignedBox::new(at(-0.75, -0.5, -1.0), at(0.5, 1.25, 0.75)).unwrap()),
        Box::new(Triangle::new(a, b, c).unwrap()),
        Box::new(Sphere::new(at(0.25, 0.125, -0.5), 1.25 * scale).unwrap()),
    ]
}

fn place(coordinates: [f64; 3], scale: f64, shift: f64) -> Point3 {
    Point3::from_glam(coordinates.map(|x| x * scale + shift).into())
}

/// Rays from around the shapes towards and past them; every eighth along an
/// axis. The directions do not depend on scale and place.
fn rays(scale: f64, shift: f64) -> Vec<Ray> {
    let one = |n: u32| {
        let random = PixelRandom::new(5, n, 0);
        // Multiples of 2^-20, so that a shift by 2^30 is exact.
        let grid = |i: u64, width: f64| {
            let u = random.uniform(i) - 0.5;
            (u * width * 1_048_576.0).round() / 1_048_576.0
        };
        let from = [0, 1, 2].map(|i| grid(i, 8.0));
        let mut d: [f64; 3] = std::array::from_fn(|i| grid(3 + i as u64, 2.0) - from[i]);
        if n.is_multiple_of(8) {
            d[(n as usize / 8) % 3] = 0.0;
            d[(n as usize / 8 + 1) % 3] = -0.0;
        }
        Ray::new(place(from, scale, shift), Vector3::from_glam(d.into())).unwrap()
    };
    (0..4000).map(one).collect()
}

fn hits(scale: f64, shift: f64) -> Vec<Option<f64>> {
    let shapes = shapes(scale, shift);
    let hit = |ray: &Ray| {
        let ts = shapes
            .each_ref()
            .map(|shape| shape.hit(ray, Interval::AHEAD));
        ts.map(|hit| hit.map(|hit| hit.t))
    };
    rays(scale, shift).iter().flat_map(hit).collect()
}

#[test]
fn a_scene_in_other_units_is_the_same_scene() {
    let expected = hits(1.0, 0.0);
    let met = expected.iter().flatten().count();
    assert!(met > 5000 && met < 15_000, "hits and misses: {met}");
    for exponent in (-300..=300).step_by(50) {
        let scale = libm::scalbn(1.0, exponent);
        let scaled = expected.iter().map(|t| t.map(|t| t * scale));
        assert!(
            hits(scale, 0.0).into_iter().eq(scaled),
            "times 2^{exponent}"
        );
    }
}

/// All differences between coordinates are exact, so nothing may change.
#[test]
fn a_scene_far_from_the_origin_is_the_same_scene() {
    let shift = libm::scalbn(1.0, 30);
    assert_eq!(hits(1.0, shift), hits(1.0, 0.0));
}

/// A direction twice as long halves `t` exactly.
#[test]
fn a_direction_of_another_length_changes_t_alone() {
    let shapes = shapes(1.0, 0.0);
    for ray in rays(1.0, 0.0) {
        for exponent in [-300, -100, -1, 1, 100, 300] {
            let length = libm::scalbn(1.0, exponent);
            let other = Ray::derived(ray.origin(), ray.direction() * length);
            for shape in &shapes {
                let [one, other] = [&ray, &other].map(|ray| shape.hit(ray, Interval::AHEAD));
                let (one, other) = (one.map(|h| (h.t, h.normal)), other.map(|h| (h.t, h.normal)));
                let scaled = other.map(|(t, normal)| (t * length, normal));
                assert_eq!(scaled, one, "{shape:?} {ray:?} 2^{exponent}");
            }
        }
    }
}

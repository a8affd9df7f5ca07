//! The experiments and extreme cases of the laboratory.

use a02_math::arrays::array;
use a02_math::{Normal3, Point3, Vector3};
use a04_lab::line::line;
use a06_lab::form::{Form, OnSurface};
use a06_lab::lit_points::{Look, Trial, trials};
use a06_lab::policy::{Policy, Test, error_bounds, relative_to_t, single, stepped};
use a06_lab::surface::{Surface, plane, sphere};

testing::check_lab! { a06_lab::laboratory() }

/// A rounding, which is at most this fraction of a number.
const U: f64 = f64::EPSILON / 2.0;

fn assert_near(v: Vector3, expected: [f64; 3]) {
    for (x, expected) in array(v).into_iter().zip(expected) {
        assert!(
            (x - expected).abs() <= 1e-12 * expected,
            "{v:?}, not {expected}"
        );
    }
}

/// γ(n) is n roundings, but for a part of 1e-15.
#[test]
fn points_are_reprojected_with_their_error_bounds() {
    let sphere = Form::Sphere {
        center: [1.0, -2.0, 3.0],
        radius: 2.0,
    };
    let OnSurface { point, error } = sphere.reproject(Point3::new(1.0, -2.0, 5.1));
    assert_eq!(point, Point3::new(1.0, -2.0, 5.0));
    // Three roundings of the centre's coordinates; and eight of a height of 2.
    assert_near(error, [3.0 * U, 6.0 * U, (9.0 + 16.0) * U]);

    let plane = Form::Plane {
        a: [0.0, 2.0, 0.0],
        normal: [0.0, 1.0, 0.0],
    };
    let OnSurface { point, error } = plane.reproject(Point3::new(3.0, 2.5, 4.0));
    assert_eq!(point, Point3::new(3.0, 2.0, 4.0));
    assert_near(error, [15.0 * U, 21.0 * U, 15.0 * U]);

    let triangle = Form::Triangle {
        corners: [[0.0, 0.0, 4.0], [4.0, 0.0, 4.0], [0.0, 4.0, 4.0]],
    };
    let OnSurface { point, error } = triangle.reproject(Point3::new(1.0, 1.0, 4.5));
    assert_eq!(point, Point3::new(1.0, 1.0, 4.0));
    assert_near(error, [7.0 * U, 7.0 * U, 28.0 * U]);

    let cuboid = Form::Box {
        least: [0.0; 3],
        greatest: [1.0, 2.0, 3.0],
    };
    let OnSurface { point, error } = cuboid.reproject(Point3::new(0.5, 1.9, 1.0));
    assert_eq!(point, Point3::new(0.5, 2.0, 1.0));
    assert_eq!(error, Vector3::default());
}

/// A lit point of a surface, seen from a place.
fn lit_point(surface: &Surface, eye: Point3, target: Point3) -> Trial {
    let look = |_: &mut _| {
        Ok(Look {
            surface: surface.clone(),
            eye,
            target,
        })
    };
    trials(1, 1, 1.0, look).unwrap().remove(0)
}

/// Straight above the point (3, 2, 4) of a level plane, at a height of 8.
fn above_a_plane() -> Trial {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let level = plane(Point3::new(0.0, 2.0, 0.0), up).unwrap();
    lit_point(
        &level,
        Point3::new(3.0, 10.0, 4.0),
        Point3::new(3.0, 2.0, 4.0),
    )
}

/// The steps of doubles near 2 are 4 roundings.
#[test]
fn shadow_rays_of_others_start_where_they_say() {
    let trial = above_a_plane();
    let origin = |policy: Policy| array(policy(&trial).ray.origin());
    // 21 roundings are 5 steps, and one more follows.
    assert_eq!(origin(error_bounds), [3.0, 2.0 + 24.0 * U, 4.0]);
    assert_eq!(error_bounds(&trial).test, Test::Certain);
    // 256 steps.
    assert_eq!(origin(stepped), [3.0, 2.0 + 1024.0 * U, 4.0]);
    // The largest number is 10, and a float has 29 binary digits less.
    let offset = 64.0 * libm::exp2(-23.0) * 10.0;
    let nearest = f64::from((2.0 + offset) as f32);
    assert_eq!(origin(single), [3.0, nearest, 4.0]);
    assert_eq!(single(&trial).test, Test::Single);
    let least = relative_to_t(&trial).within.min;
    assert!((least / (8e-3 * libm::exp2(-29.0)) - 1.0).abs() < 1e-15);

    // Near 0 the step is a length: 2⁻¹⁶, and 29 binary digits less.
    let ball = sphere(Point3::new(0.0, -1.0, 0.0), 1.0).unwrap();
    let trial = lit_point(&ball, Point3::new(0.0, 5.0, 0.0), Point3::ORIGIN);
    assert_eq!(
        array(stepped(&trial).ray.origin()),
        [0.0, libm::exp2(-45.0), 0.0]
    );
}

/// From the surface itself, `t` is 0 but for rounding, which an enclosure cannot tell.
#[test]
fn hits_at_the_origin_are_not_certain() {
    let trial = above_a_plane();
    let form = trial.surface.form.unwrap();
    let at = |height: f64| line([3.0, 2.0 + height, 4.0], [0.6, -0.8, 0.0]);
    assert!(form.is_certainly_hit(&at(1.0)));
    assert!(!form.is_certainly_hit(&at(-1.0)));
    assert!(!form.is_certainly_hit(&at(0.0)));
}

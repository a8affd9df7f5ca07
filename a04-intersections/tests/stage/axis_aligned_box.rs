//! Boxes: faces, edges, corners, and rays that run within a face.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval};
use approx::assert_abs_diff_eq;

fn point([x, y, z]: [f64; 3]) -> Point3 {
    Point3::new(x, y, z)
}

fn vector([x, y, z]: [f64; 3]) -> Vector3 {
    Vector3::new(x, y, z)
}

fn box_between(lbf: [f64; 3], run: [f64; 3]) -> AxisAlignedBox {
    AxisAlignedBox::new(point(lbf), point(run)).unwrap()
}

fn unit_box() -> AxisAlignedBox {
    box_between([0.0; 3], [1.0; 3])
}

/// The direction is taken as it is.
fn hit(aab: &AxisAlignedBox, o: [f64; 3], d: [f64; 3]) -> Option<Hit> {
    aab.hit(&Ray::derived(point(o), vector(d)), Interval::AHEAD)
}

/// Three zeros, but for `value` at `axis`.
fn along(axis: usize, value: f64) -> [f64; 3] {
    let mut all = [0.0; 3];
    all[axis] = value;
    all
}

#[test]
fn each_of_the_six_faces_is_met_from_outside_and_from_inside() {
    let half = [1.0, 2.0, 3.0];
    let aab = box_between(half.map(|x| -x), half);
    for (axis, half) in half.into_iter().enumerate() {
        for side in [1.0, -1.0] {
            let normal = vector(along(axis, side)).as_normal();
            let outside = hit(&aab, along(axis, 10.0 * side), along(axis, -side)).unwrap();
            assert_eq!(outside, Hit::new(10.0 - half, normal));
            let inside = hit(&aab, along(axis, 0.5 * side), along(axis, side)).unwrap();
            assert_eq!(inside, Hit::new(half - 0.5, normal));
        }
    }
}

/// Through the origin and (1, 1, 1), which is where the box begins.
#[test]
fn the_nearest_face_is_the_one_entered_last() {
    let aab = box_between([1.0, -9.0, -9.0], [4.0, 9.0, 9.0]);
    let entered = hit(&aab, [0.0; 3], [1.0, 1.0, 1.0]).unwrap();
    assert_eq!(entered, Hit::new(1.0, vector([-1.0, 0.0, 0.0]).as_normal()));
    let ray = Ray::derived(Point3::ORIGIN, vector([1.0, 1.0, 1.0]));
    let left = aab.hit(&ray, Interval { min: 1.0, max: 9.0 }).unwrap();
    assert_eq!(left, Hit::new(4.0, vector([1.0, 0.0, 0.0]).as_normal()));
}

#[test]
fn any_two_opposite_corners_make_the_same_box() {
    let expected = box_between([-1.0, -2.0, -3.0], [4.0, 5.0, 6.0]);
    for mirrored in 0..8 {
        let (mut a, mut b) = ([-1.0, -2.0, -3.0], [4.0, 5.0, 6.0]);
        for axis in (0..3).filter(|axis| mirrored >> axis & 1 == 1) {
            std::mem::swap(&mut a[axis], &mut b[axis]);
        }
        assert_eq!(box_between(a, b), expected);
    }
}

/// Along every axis, both ways, through the middle, within the faces, along
/// the edges, with zeros of both signs: the box is closed.
#[test]
fn rays_within_a_face_or_along_an_edge_meet_the_box() {
    for axis in 0..3 {
        let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
        for (from, way) in [(5.0, -1.0), (-4.0, 1.0)] {
            for (x, y) in [0.0, 0.5, 1.0]
                .map(|x| [0.0, 0.5, 1.0].map(|y| (x, y)))
                .concat()
            {
                for (zero_p, zero_q) in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)] {
                    let (mut o, mut d) = (along(axis, from), along(axis, way));
                    (o[p], o[q], d[p], d[q]) = (x, y, zero_p, zero_q);
                    let normal = vector(along(axis, -way)).as_normal();
                    assert_eq!(hit(&unit_box(), o, d), Some(Hit::new(4.0, normal)));
                    o[p] = if x < 0.5 { -5e-324 } else { 1_f64.next_up() };
                    assert_eq!(hit(&unit_box(), o, d), None, "just outside");
                }
            }
        }
    }
}

#[test]
fn diagonals_meet_corners_and_edges() {
    // Through the corner (1, 1, 1) and on to (0, 0, 0).
    let corner = hit(&unit_box(), [2.0; 3], [-1.0; 3]).unwrap();
    assert_eq!(corner.t, 1.0);
    // A ray that touches only the edge x = 1, y = 1.
    let edge = hit(&unit_box(), [0.0, 2.0, 0.5], [1.0, -1.0, 0.0]).unwrap();
    assert_eq!(edge.t, 1.0);
    // And one that touches only the corner (1, 1, 1).
    let touched = hit(&unit_box(), [0.0, 2.0, 3.0], [1.0, -1.0, -2.0]).unwrap();
    assert_eq!(touched.t, 1.0);
    let beside = 2.000_001;
    assert_eq!(hit(&unit_box(), [0.0, beside, 0.5], [1.0, -1.0, 0.0]), None);
    assert_eq!(
        hit(&unit_box(), [0.0, beside, 3.0], [1.0, -1.0, -2.0]),
        None
    );
}

#[test]
fn from_a_face_the_ray_sees_the_other_side_only() {
    let out = hit(&unit_box(), [0.5, 1.0, 0.5], [0.0, 1.0, 0.0]);
    assert_eq!(out, None);
    let through = hit(&unit_box(), [0.5, 1.0, 0.5], [0.0, -1.0, 0.0]).unwrap();
    assert_eq!(through, Hit::new(1.0, vector([0.0, -1.0, 0.0]).as_normal()));
    assert_eq!(hit(&unit_box(), [0.5, 3.0, 0.5], [0.0, 1.0, 0.0]), None);
}

#[test]
fn the_ends_of_the_interval_do_not_count() {
    let ray = Ray::derived(point([0.5, 0.5, 5.0]), vector([0.0, 0.0, -1.0]));
    let t = |min, max| {
        let hit = unit_box().hit(&ray, Interval { min, max });
        hit.map(|hit| hit.t)
    };
    assert_eq!(t(0.0, 4.0), None);
    assert_eq!(t(0.0, 4_f64.next_up()), Some(4.0));
    assert_eq!(t(4.0, 9.0), Some(5.0));
    assert_eq!(t(4.0, 5.0), None);
    assert_eq!(t(5.0, 9.0), None);
}

#[test]
fn t_counts_in_lengths_of_the_direction() {
    for length in [1e-100, 0.5, 8.0, 1e100] {
        let found = hit(&unit_box(), [0.5, 0.5, 5.0], [0.0, 0.0, -length]).unwrap();
        assert_abs_diff_eq!(found.t * length, 4.0, epsilon = 8.0 * f64::EPSILON);
    }
}

/// The cosine of a right angle is 6e-17 to a computer: rays that should run
/// within a face do so almost.
#[test]
fn rays_almost_within_a_face_meet_the_box_where_they_should() {
    for tilt in [6.1e-17, -6.1e-17, 1e-300, -1e-300, 5e-324, -5e-324] {
        let found = hit(&unit_box(), [0.5, 0.5, 5.0], [tilt, tilt, -1.0]).unwrap();
        assert_eq!(found.t, 4.0);
    }
}

#[test]
fn a_flat_box_is_a_rectangle_and_one_without_extent_a_point() {
    let flat = box_between([0.0, 1.0, 0.0], [2.0, 1.0, 2.0]);
    for (y, d) in [(4.0, -1.0), (-2.0, 1.0)] {
        let found = hit(&flat, [2.0, y, 0.5], [0.0, d, 0.0]).unwrap();
        assert_eq!(
            found,
            Hit::new(3.0, vector([0.0, -d, 0.0]).as_normal()),
            "towards the ray"
        );
        assert_eq!(hit(&flat, [2.5, y, 0.5], [0.0, d, 0.0]), None);
    }
    let speck = box_between([1.0, 2.0, 2.0], [1.0, 2.0, 2.0]);
    assert_eq!(hit(&speck, [0.0; 3], [1.0, 2.0, 2.0]).unwrap().t, 1.0);
    assert_eq!(hit(&speck, [0.0; 3], [1.0, 2.0, 2.1]), None);
}

#[test]
fn distance_and_size_cost_no_digit() {
    // Differences that are exact: 1e15 - 1, and powers of two.
    let far = hit(&unit_box(), [0.5, 0.5, 1e15], [0.0, 0.0, -1.0]).unwrap();
    assert_eq!(far.t, 1e15 - 1.0);
    for size in [1e-100, 1e100] {
        let aab = box_between([-size; 3], [size; 3]);
        let inside = hit(&aab, [0.0; 3], [0.0, -1.0, 0.0]).unwrap();
        assert_eq!(inside.t, size);
    }
}

/// Bound: 1.5 units of rounding in the first place of each distance, and as
/// much in the direction of a ray that is aimed: 4 eps of the distance, to the
/// hit or to the point aimed at, and of the coordinates.
fn assert_on_the_box(hit: Option<Hit>, ray: &Ray, aim: Point3, (lbf, run): ([f64; 3], [f64; 3])) {
    let hit = hit.unwrap_or_else(|| panic!("{ray:?} misses"));
    let distance = (aim - ray.origin()).magnitude();
    let bound = 4.0 * f64::EPSILON * (distance + ray.origin().largest_coordinate());
    assert!(hit.t <= distance + bound, "beyond the point aimed at");
    let (p, n) = (ray.at(hit.t).to_glam(), hit.normal.to_glam());
    for axis in 0..3 {
        assert!(p[axis] >= lbf[axis] - bound && p[axis] <= run[axis] + bound);
        if n[axis] != 0.0 {
            let face = if n[axis] > 0.0 { run } else { lbf };
            assert_abs_diff_eq!(p[axis], face[axis], epsilon = bound);
            assert!(n[axis] * ray.direction().to_glam()[axis] < 0.0);
        }
    }
}

#[test]
fn no_ray_aimed_at_the_box_misses_it() {
    let (lbf, run) = ([0.1, 0.2, 0.3], [0.7, 1.1, 0.9]);
    let aab = box_between(lbf, run);
    for n in 0..40_000_u32 {
        let random = PixelRandom::new(4, n, 0);
        // Of the three coordinates aimed at, none, one, two or three are those
        // of a face: a point inside, of a face, of an edge, or a corner.
        let aim: [f64; 3] = std::array::from_fn(|axis| {
            let share = match random.uniform(axis as u64) {
                u if (axis as u32) >= n % 4 => u,
                u => u.round(),
            };
            lbf[axis] * (1.0 - share) + run[axis] * share
        });
        let from = point([3, 4, 5].map(|i| 10.0 * random.uniform(i) - 5.0));
        if inside(from, lbf, run) {
            continue;
        }
        let ray = Ray::new(from, point(aim) - from).unwrap();
        let hit = aab.hit(&ray, Interval::AHEAD);
        assert_on_the_box(hit, &ray, point(aim), (lbf, run));
    }
}

fn inside(p: Point3, lbf: [f64; 3], run: [f64; 3]) -> bool {
    let p = p.to_glam();
    (0..3).all(|axis| lbf[axis] <= p[axis] && p[axis] <= run[axis])
}

#[test]
fn a_ray_of_no_numbers_meets_nothing() {
    assert_eq!(hit(&unit_box(), [f64::NAN; 3], [0.0, 0.0, -1.0]), None);
    assert_eq!(hit(&unit_box(), [0.5, 0.5, 5.0], [f64::NAN; 3]), None);
    assert_eq!(hit(&unit_box(), [0.5, 0.5, 5.0], [0.0; 3]), None);
}

#[test]
fn corners_beyond_the_allowed_range_are_refused_by_name() {
    for bad in [f64::NAN, f64::INFINITY, 1e101] {
        let wrong = point([0.0, bad, 0.0]);
        for (said, name) in [
            (AxisAlignedBox::new(wrong, Point3::ORIGIN), "corner lbf is"),
            (AxisAlignedBox::new(Point3::ORIGIN, wrong), "corner run is"),
        ] {
            let said = said.unwrap_err().to_string();
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("from -1e100 to 1e100"), "{said}");
        }
    }
}

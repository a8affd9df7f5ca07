//! Corners on a line, needles, and corners that are refused.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use a04_intersections::Triangle;

use super::{Z, ahead, hit, point, triangle};

/// There the products of three lengths would lose digits, and with them t.
#[test]
fn triangles_too_small_for_the_formula_are_refused() {
    for size in [1e-101, 1e-107, 1e-110] {
        let [a, b, c] = [[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.5, 0.0]]
            .map(|corner| point(corner.map(|x: f64| x * size)));
        let said = Triangle::new(a, b, c).unwrap_err().to_string();
        assert!(said.starts_with("longest edge is"), "{said}");
    }
}

/// Whole numbers, so that the corners lie on a line exactly.
#[test]
fn corners_on_a_line_are_refused() {
    for n in 0..1000 {
        let random = PixelRandom::new(1, n, 0);
        let whole = |i| (random.uniform(i) * 2000.0 - 1000.0).round();
        let start = Point3::new(whole(0), whole(1), whole(2));
        let way = Vector3::new(whole(3), whole(4), 1.0);
        let at = |steps: f64| start + way * steps;
        let [b, c] = [5, 6].map(|i| (random.uniform(i) * 100.0).ceil());
        for [a, b, c] in [[0.0, b, -c], [b, 0.0, b + c], [0.0, 0.0, c], [b, c, b]] {
            let said = Triangle::new(at(a), at(b), at(c)).unwrap_err().to_string();
            assert!(said.starts_with("triangle is"), "{said}");
            assert!(said.contains("three corners that are not on a line"));
        }
    }
    let all_one = Triangle::new(Point3::ORIGIN, Point3::ORIGIN, Point3::ORIGIN);
    assert!(all_one.is_err());
}

#[test]
fn thin_triangles_are_none_the_less_triangles() {
    let [a, b, c] = [[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-12, 0.0]].map(point);
    for [a, b, c] in [[a, b, c], [b, c, a], [c, a, b]] {
        let thin = Triangle::new(a, b, c).unwrap();
        let found = hit(&thin, &ahead(0.5, 5e-13)).unwrap();
        assert_eq!(found.face, Z);
        assert_eq!(hit(&thin, &ahead(0.5, 1.1e-12)), None);
    }
}

/// Thinner than rounding: refused in every order of the corners.
#[test]
fn it_does_not_matter_which_corner_comes_first() {
    let limit = 4.0 * f64::EPSILON;
    for (height, is_accepted) in [
        (1e-17, false),
        (limit, false),
        (limit.next_up(), true),
        (1e-14, true),
    ] {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, height, 0.0]].map(point);
        for first in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|i| corners[(first + i) % 3]);
            assert_eq!(Triangle::new(a, b, c).is_ok(), is_accepted, "{first}");
        }
    }
}

#[test]
fn bad_corners_and_normals_are_refused_by_name() {
    let good = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    for bad in [f64::NAN, f64::NEG_INFINITY, 1e101] {
        for (wrong, name) in ["corner a is", "corner b is", "corner c is"]
            .iter()
            .enumerate()
        {
            let mut corners = good;
            corners[wrong] = point([0.0, 0.0, bad]);
            let [a, b, c] = corners;
            let said = Triangle::new(a, b, c).unwrap_err().to_string();
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("from -1e100 to 1e100"), "{said}");
        }
    }
    for bad in [0.0, f64::NAN, f64::INFINITY] {
        for (wrong, name) in ["normal of a", "normal of b", "normal of c"]
            .iter()
            .enumerate()
        {
            let mut normals = [Z; 3];
            normals[wrong] = Normal3::new(bad, 0.0, 0.0);
            let said = triangle().with_normals(normals).unwrap_err().to_string();
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("not all of them 0"), "{said}");
        }
    }
}

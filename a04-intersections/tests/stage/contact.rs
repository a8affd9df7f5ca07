//! Contact: rays that start on a shape, and those that touch it at their origin alone. Planes are
//! the extreme cases B03 to B06 and B20.
//!
//! All numbers are small multiples of powers of two, so that each formula is exact.

use a02_math::Direction;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Sphere, Triangle};

use crate::test_shapes::{point, ray, vector};

/// An interval that begins just before the origin.
const FROM_ORIGIN: Interval = Interval {
    min: -0.125,
    max: 8.0,
};

/// A hit's `t` and normal.
type Expected = Option<(f64, [f64; 3])>;

/// A ray, and its nearest hits ahead, and from its origin on.
struct Contact {
    o: [f64; 3],
    d: [f64; 3],
    ahead: Expected,
    from_origin: Expected,
}

/// A ray that meets the shape at its own origin, with this normal, and nowhere else.
fn only_at_origin(o: [f64; 3], d: [f64; 3], normal: [f64; 3]) -> Contact {
    Contact {
        o,
        d,
        ahead: None,
        from_origin: Some((0.0, normal)),
    }
}

/// A ray whose nearest hit is ahead, or that has none; none is at its origin.
fn ahead(o: [f64; 3], d: [f64; 3], hit: Expected) -> Contact {
    Contact {
        o,
        d,
        ahead: hit,
        from_origin: hit,
    }
}

/// Compares the hits of rays, also with zeros of the other sign in the direction and with a
/// direction twice as long.
fn assert_contacts(shape: &dyn Geometry, contacts: &[Contact]) {
    for contact in contacts {
        let negative = contact.d.map(|x| if x == 0.0 { -x } else { x });
        for (d, length) in [(contact.d, 1.0), (negative, 1.0), (contact.d, 2.0)] {
            let ray = ray(contact.o, d.map(|x| x * length));
            for (within, expected) in [
                (Interval::AHEAD, contact.ahead),
                (FROM_ORIGIN, contact.from_origin),
            ] {
                let found = shape.hit(&ray, within).map(|hit| (hit.t, hit.normal));
                let expected = expected.map(|(t, normal)| (t / length, vector(normal).as_normal()));
                assert_eq!(found, expected, "{shape:?} {ray:?} {within:?}");
            }
        }
    }
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const LEFT: [f64; 3] = [-1.0, 0.0, 0.0];
const DOWN: [f64; 3] = [0.0, -1.0, 0.0];

#[test]
fn rays_from_a_sphere() {
    let sphere = Sphere::new(point([0.0; 3]), 1.0).unwrap();
    assert_contacts(
        &sphere,
        &[
            // Tangents: 0 / 0 is one of the quotients.
            only_at_origin(X, Z, X),
            only_at_origin(X, [0.0, -3.0, 4.0], X),
            only_at_origin(DOWN, [1.0, 0.0, 0.0], DOWN),
            // Outwards, and inwards.
            only_at_origin(X, X, X),
            Contact {
                o: X,
                d: LEFT,
                ahead: Some((2.0, LEFT)),
                from_origin: Some((0.0, X)),
            },
        ],
    );
}

/// `1² + 2² + 2² = 3²` and others of the kind, as the vectors from the centre to points of a
/// sphere, each with a vector of whole numbers at a right angle to it.
#[test]
fn tangents_of_spheres_of_all_sizes_touch_at_their_origin_alone() {
    for (radius, [x, y, z]) in [
        (3.0, [1.0, 2.0, 2.0]),
        (7.0, [2.0, 3.0, 6.0]),
        (9.0, [1.0, 4.0, 8.0]),
        (11.0, [2.0, 6.0, 9.0]),
        (13.0, [0.0, 5.0, 12.0]),
    ] {
        for exponent in [-300, -20, 0, 20, 300] {
            let size = libm::scalbn(1.0, exponent);
            let sphere = Sphere::new(point([0.0; 3]), radius * size).unwrap();
            for (from_centre, d) in [
                ([x, y, z], [y, -x, 0.0]),
                ([z, -x, y], [0.0, y, x]),
                ([-y, z, x], [x, 0.0, y]),
            ] {
                let tangent = ray(from_centre.map(|x| x * size), d);
                assert_eq!(sphere.hit(&tangent, Interval::AHEAD), None, "{tangent:?}");
                let hit = sphere.hit(&tangent, FROM_ORIGIN).unwrap();
                assert_eq!(hit.t, 0.0, "{tangent:?}");
                // The vector is normalised, with a rounding for each of its four steps.
                let cosine = hit.normal.dot(vector(from_centre)) / radius;
                assert!((cosine - 1.0).abs() < 4.0 * f64::EPSILON, "{cosine}");
            }
        }
    }
}

#[test]
fn rays_from_a_box_and_within_its_faces() {
    let cube = AxisAlignedBox::new(point([0.0; 3]), point([1.0; 3])).unwrap();
    let mut contacts = vec![
        // Within the faces y = 0, y = 1 and z = 1, and along an edge.
        ahead([0.5, 0.0, 0.5], X, Some((0.5, X))),
        ahead([0.25, 1.0, 0.5], X, Some((0.75, X))),
        ahead([0.5, 0.5, 1.0], X, Some((0.5, X))),
        ahead([0.5, 1.0, 1.0], X, Some((0.5, X))),
        // The corner (1, 1, 1) and the edge x = 1, y = 1 alone.
        only_at_origin([1.0, 1.0, 1.0], [1.0, -1.0, 0.0], Y),
        only_at_origin([1.0, 1.0, 0.5], [1.0, -1.0, 0.0], Y),
        ahead([0.5, 1.5, 0.5], X, None),
    ];
    // Outwards, and inwards.
    for y in [0.0, 0.5, 1.0] {
        for z in [0.0, 0.25, 1.0] {
            contacts.push(only_at_origin([1.0, y, z], X, X));
            contacts.push(Contact {
                o: [0.0, y, z],
                d: X,
                ahead: Some((1.0, X)),
                from_origin: Some((0.0, LEFT)),
            });
        }
    }
    assert_contacts(&cube, &contacts);
}

#[test]
fn rays_from_a_triangle_and_within_its_plane() {
    let [a, b, c] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(point);
    let triangle = Triangle::new(a, b, c).unwrap();
    let mut contacts = vec![ahead([2.0, 2.0, 0.0], Z, None)];
    // Inside, on each edge, and at each corner.
    for (x, y) in [
        (1.0, 1.0),
        (1.0, 0.0),
        (0.0, 2.0),
        (1.5, 1.5),
        (0.0, 0.0),
        (3.0, 0.0),
        (0.0, 3.0),
    ] {
        let o = [x, y, 0.0];
        for d in [Z, [0.0, 0.0, -1.0], [1.0, -1.0, 2.0]] {
            contacts.push(only_at_origin(o, d, Z));
        }
        for d in [X, LEFT, Y, DOWN, [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]] {
            contacts.push(ahead(o, d, None));
        }
    }
    assert_contacts(&triangle, &contacts);
}

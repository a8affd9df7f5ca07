//! The engine decides as the lesson's list where rounding decides: rays that just touch,
//! shapes at the same place, and shapes that rounding makes points.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Plane, Sphere, Triangle};
use a04_lab::support::Numbers;

use crate::hits::hits;

/// From a point to a point.
fn towards(from: Point3, to: Point3) -> Ray {
    Ray::new(from, to - from).unwrap()
}

/// A list of this many.
fn many<T>(count: usize, make: impl FnMut() -> T) -> Vec<T> {
    std::iter::repeat_with(make).take(count).collect()
}

/// A point of eighths from -2 to 2.
fn eighths(numbers: &mut Numbers) -> Point3 {
    let [x, y, z] = [(); 3].map(|()| numbers.between(-16.0, 17.0).floor() / 8.0);
    Point3::new(x, y, z)
}

/// A vector of numbers from -1 to 1.
fn any(numbers: &mut Numbers) -> Vector3 {
    numbers.triple(-1.0, 1.0)
}

/// The engine rejects rays beside a sphere before it computes their hits. It tests a single
/// sphere at once, and many by a tree.
#[test]
fn rays_that_just_touch_spheres() {
    let numbers = &mut Numbers::new(7, 0);
    let (mut met, mut all) = (0, 0);
    for size in [1e-95, 1e-6, 1.0, 1e95] {
        let at = |v: Vector3| Point3::ORIGIN + v * size;
        let (mut spheres, mut rays) = (Vec::new(), Vec::new());
        for _ in 0..200 {
            let (c, r, first) = (any(numbers), numbers.between(0.01, 0.2), rays.len());
            // Past the sphere by this fraction of the radius, inwards or outwards.
            for off in [0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-3] {
                let from = c + numbers.direction() * (r * numbers.between(1.1, 100.0));
                let aside = (c - from).cross(any(numbers)).normalized().unwrap();
                let reach = r * (1.0 + off * numbers.between(-1.0, 1.0));
                // Where a ray is at a right angle to the radius.
                let fraction = reach * reach / (c - from).dot(c - from);
                let touched = c + (from - c) * fraction + aside * (reach * (1.0 - fraction).sqrt());
                // On the surface, and along it.
                let (start, along) = (c + aside * reach, aside.cross(any(numbers)));
                let lines = [
                    (from, touched - from),
                    (start, any(numbers)),
                    (start, along),
                ];
                rays.extend(lines.map(|(from, way)| Ray::new(at(from), way).unwrap()));
            }
            spheres.push(Sphere::new(at(c), r * size).unwrap());
            met += hits(&spheres[spheres.len() - 1..], &rays[first..]);
        }
        assert!(hits(&spheres, &rays) > rays.len() / 4);
        all += rays.len();
    }
    assert!((all / 4..3 * all / 4).contains(&met), "{met} of {all}");
}

/// Far from the origin coordinates are multiples of 2^-9: the spheres are a few dozen of
/// these units wide, and rays towards their rims tell bounds apart that are half a unit
/// too small.
#[test]
fn rays_past_spheres_a_few_units_of_rounding_wide() {
    let (far, unit) = (1e13, 1.0 / 512.0);
    let numbers = &mut Numbers::new(17, 0);
    let mut point = |reach: f64| {
        let [x, y, z] = [0; 3].map(|_| numbers.between(-reach, reach).round() * unit);
        Point3::new(far + x, y - far, far + z)
    };
    let mut met = 0;
    for n in 0..200 {
        let radius = |i: i32| (5.0 + f64::from((7 * n + i) % 20) / 3.0) * unit;
        let spheres = (0..12).map(|i| Sphere::new(point(40.0), radius(i)).unwrap());
        let spheres: Vec<_> = spheres.collect();
        let rays = many(400, || towards(point(200.0), point(50.0)));
        met += hits(&spheres, &rays);
    }
    assert!((8_000..80_000).contains(&met), "{met}");
}

/// Rays from the points of a grid, in steps of a half, in the directions to all their neighbours:
/// some start on a shape, some within a face or a plane, some touch a shape at their origin alone.
/// A list of one shape is tested at once, and of many by a tree.
#[test]
fn rays_that_start_on_shapes() {
    let point = |[x, y, z]: [f64; 3]| Point3::new(x, y, z);
    let grid = |steps: i32| {
        let mut places = Vec::new();
        for x in -steps..=steps {
            for y in -steps..=steps {
                for z in -steps..=steps {
                    places.push([x, y, z].map(f64::from));
                }
            }
        }
        places
    };
    let mut rays = Vec::new();
    for origin in grid(2) {
        for direction in grid(1) {
            let zeros = direction.map(|x| if x == 0.0 { -x } else { x });
            for d in [direction, zeros] {
                let d = Vector3::new(d[0], d[1], d[2]);
                rays.extend(Ray::new(point(origin.map(|x| x / 2.0)), d));
            }
        }
    }
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap();
    let ball = Sphere::new(Point3::ORIGIN, 1.0).unwrap();
    let cube = AxisAlignedBox::new(point([-0.5; 3]), point([0.5; 3])).unwrap();
    let sheet = AxisAlignedBox::new(point([-0.5, 0.0, -0.5]), point([0.5, 0.0, 0.5])).unwrap();
    let [a, b, c] = [[-0.5, 0.5, 0.0], [1.0, 0.5, 0.0], [-0.5, -1.0, 0.0]].map(point);
    let triangle = Triangle::new(a, b, c).unwrap();
    for count in [1, 40] {
        let met = [
            hits(&vec![floor; count], &rays),
            hits(&vec![ball; count], &rays),
            hits(&vec![cube; count], &rays),
            hits(&vec![sheet; count], &rays),
            hits(&vec![triangle; count], &rays),
        ];
        for met in met {
            assert!((400..rays.len()).contains(&met), "{met} of {}", rays.len());
        }
    }
}

/// By rounding, these rays leave a box before they enter it.
#[test]
fn rays_through_edges_of_boxes() {
    let numbers = &mut Numbers::new(8, 0);
    let size = Vector3::new(0.3, 0.2, 0.1);
    let corners = many(5, || Point3::ORIGIN + any(numbers));
    let boxes = corners
        .iter()
        .map(|corner| AxisAlignedBox::new(*corner, *corner + size));
    let boxes: Vec<_> = boxes.map(Result::unwrap).collect();
    let eye = Vector3::new(4.0, 3.0, 5.0);
    let rays = (0..8000).map(|i| {
        // An edge that can be seen from where all rays come from.
        let along = numbers.between(0.1, 0.9);
        let (x, y) = [(0.3, along * 0.2), (along * 0.3, 0.2)][i % 2];
        let edge = corners[i % 5] + Vector3::new(x, y, [0.1, 0.0][i / 2 % 2]);
        let aside = Vector3::new(3.0, 3.0, 0.0) + any(numbers);
        towards(Point3::ORIGIN + [eye, aside][i / 4 % 2], edge)
    });
    assert!(hits(&boxes, &rays.collect::<Vec<_>>()) > 1000);
}

/// From so far away its corners are one point but for rounding, in any unit.
#[test]
fn rays_far_beside_a_triangle() {
    let numbers = &mut Numbers::new(9, 0);
    for scale in [1.0, 1.0 / (1_u64 << 60) as f64] {
        let corners = [[0.0, 1.5, 3.0], [10.0, 0.0, 8.5], [1.0, 0.0, 0.0]];
        let [a, b, c] = corners.map(|corner| Point3::from_glam(corner.map(|x| x * scale).into()));
        let far = 9_007_199_254_740_992.0 * scale;
        let rays = many(40_000, || {
            Ray::new(Point3::ORIGIN + any(numbers) * far, any(numbers)).unwrap()
        });
        hits(&[Triangle::new(a, b, c).unwrap()], &rays);
    }
}

/// From so far away that the radius is below rounding, a sphere has no normal.
#[test]
fn a_sphere_rounded_to_a_point() {
    let centre = Point3::new(0.5, 0.25, 0.75);
    let numbers = &mut Numbers::new(11, 0);
    let mut rays = vec![towards(Point3::new(0.5, 0.25, 1e20), centre); 40];
    for far in [1e14, 1e15, 1e16, 1e17, 1e18, 1e20] {
        rays.extend(many(200, || towards(centre + any(numbers) * far, centre)));
    }
    let met = hits(&[Sphere::new(centre, 1.0).unwrap()], &rays);
    assert!((200..rays.len()).contains(&met), "{met}");
    // The square of the normal is below all numbers.
    let beside = Sphere::new(Point3::new(0.0, 1e-300, 0.0), 1.0).unwrap();
    let rays = [towards(Point3::new(1e20, 0.0, 0.0), Point3::ORIGIN); 40];
    assert_eq!(hits(&[beside], &rays), 40);
}

/// The normals of two corners are opposite: half way between them is none.
#[test]
fn normals_that_cancel() {
    let corner = |x, y| Point3::new(x, y, 0.0);
    let [up, down] = [1.0, -1.0].map(|z| Normal3::new(0.0, 0.0, z));
    let flat = Triangle::new(corner(0.0, 0.0), corner(4.0, 0.0), corner(0.0, 4.0)).unwrap();
    let smooth = flat.with_normals([up, down, up]).unwrap();
    let rays = (0..400).map(|i| {
        let y = f64::from(i % 8) / 4.0;
        let x = [2.0, f64::from(i) / 200.0][usize::from(i % 4 == 1)];
        towards(Point3::new(x, y, 8.0), corner(x, y))
    });
    assert_eq!(hits(&[smooth], &rays.collect::<Vec<_>>()), 400);
}

/// Cuts by area alone take only a few of them off at each level.
#[test]
fn spheres_of_all_sizes() {
    let sizes = || (-300..=300).map(|exponent| (exponent, libm::ldexp(1.0, exponent)));
    let sphere = |size| Sphere::new(Point3::new(size, 0.0, 0.0), size / 4.0).unwrap();
    let spheres: Vec<_> = sizes().map(|(_, size)| sphere(size)).collect();
    let rays = sizes().map(|(exponent, before)| match exponent % 3 {
        0 => towards(Point3::new(-before, 0.0, 0.0), Point3::ORIGIN),
        1 => towards(
            Point3::new(2.0 * before, before, 0.0),
            Point3::new(1.0, 0.0, 0.0),
        ),
        _ => towards(Point3::new(before * 1.5, 0.0, 0.0), Point3::ORIGIN),
    });
    assert!(hits(&spheres, &rays.collect::<Vec<_>>()) > 400);
}

/// Rounding alone decides whether and where these rays hit, also outside of the bounds of
/// a triangle. With more than sixteen triangles the engine builds a tree.
#[test]
fn rays_in_the_plane_of_a_triangle() {
    const SHARES: [f64; 4] = [0.125, 0.25, 1.0 / 3.0, 0.5];
    let (mut met, mut all) = (0, 0);
    for seed in 0..400 {
        let numbers = &mut Numbers::new(18, seed);
        let (mut triangles, mut rays) = (Vec::new(), Vec::new());
        while triangles.len() < 20 {
            let [a, b, c] = [(); 3].map(|()| eighths(numbers));
            let Ok(triangle) = Triangle::new(a, b, c) else {
                continue;
            };
            triangles.push(triangle);
            // From a point of the plane beside the triangle to points around its middle.
            let at = |beta: f64, gamma: f64| a + (b - a) * beta + (c - a) * gamma;
            for beta in SHARES {
                rays.extend(SHARES.map(|gamma| towards(at(2.5, 1.25), at(beta, gamma))));
            }
        }
        met += hits(&triangles, &rays);
        all += rays.len();
    }
    assert!((all / 10..all).contains(&met), "{met} of {all}");
}

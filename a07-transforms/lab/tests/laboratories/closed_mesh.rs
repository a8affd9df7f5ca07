//! A closed mesh of triangles has no gap between them.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::Triangle;
use a04_lab::mesh::Mesh;
use a04_lab::support::{first, vector};

/// A vector of three random numbers from `-width` to `width`.
fn random_vector(random: PixelRandom, first: u64, width: f64) -> Vector3 {
    vector([0, 1, 2].map(|i| width * (2.0 * random.uniform(first + i) - 1.0)))
}

/// The middle and the corners of a sphere of triangles whose corners are moved by up to a
/// third towards the middle, so that faces are crooked and of unlike shapes; then flattened by
/// up to 64 along one axis and by up to 64² along another, at up to 10^9 from the origin.
fn moved(corners: &[Vector3], seed: u32) -> (Point3, Vec<Point3>) {
    let random = PixelRandom::new(61, seed, 0);
    let flat = libm::pow(64.0, -random.uniform(0));
    let away = [0.0, 1.0, 1e6, 1e9][(random.uniform(1) * 4.0) as usize];
    let middle = Point3::ORIGIN + random_vector(random, 2, away);
    let moved = |(n, corner): (u32, &Vector3)| {
        let height = 1.0 - 0.3 * PixelRandom::new(63, seed, n).uniform(0);
        let [x, y, z] = (*corner * (2.0 * height)).to_glam().to_array();
        let axes = [x, y * flat, z * flat * flat];
        middle + vector(std::array::from_fn(|axis| axes[(axis + seed as usize) % 3]))
    };
    (middle, (0..).zip(corners).map(moved).collect())
}

/// The side of a triangle on which the eye is, 1 or -1; 0 for almost in its plane.
fn side([a, b, c]: [Point3; 3], eye: Point3) -> f64 {
    let (normal, to_eye) = ((b - a).cross(c - a), eye - a);
    let cosine = normal.dot(to_eye) / (normal.magnitude() * to_eye.magnitude());
    if cosine.abs() < 1e-3 {
        0.0
    } else {
        cosine.signum()
    }
}

/// Random rays almost never hit an edge and would prove nothing: these aim at corners and
/// at edges, from inside, from outside and from far away. Only the faces at this corner or
/// edge are tested, so that no other face hides a gap. If the eye is clearly on one side of
/// all of them, they surround the point that the ray aims at, and one of them is hit,
/// whichever way rounding moves the ray.
#[test]
fn no_ray_is_lost_at_an_edge_or_a_corner() {
    let Mesh { corners, faces } = Mesh::icosphere(2);
    // The faces at an edge of each face, and at a corner.
    let fans = [false, true].map(|is_corner| {
        let fan = |[from, to, _]: &[usize; 3]| {
            let is_at = |f: &&[usize; 3]| f.contains(from) && (is_corner || f.contains(to));
            faces.iter().filter(is_at).collect::<Vec<_>>()
        };
        faces.iter().map(fan).collect::<Vec<_>>()
    });
    let mut rays = [0; 2];
    for seed in 0..200 {
        let (middle, corners) = moved(&corners, seed);
        for n in 0..2_000 {
            let random = PixelRandom::new(62, seed, n);
            let is_corner = n as usize % 2;
            let face = (random.uniform(0) * 320.0) as usize;
            let [from, to, _] = faces[face].map(|i| corners[i]);
            let fan = fans[is_corner][face].iter();
            let fan: Vec<_> = fan.map(|face| face.map(|i| corners[i])).collect();
            let fraction = [0.01 + 0.98 * random.uniform(1), 0.0][is_corner];
            let aim = from + (to - from) * fraction;
            let reach = [0.1, 3.0, 1e3][(random.uniform(2) * 3.0) as usize];
            let eye = middle + random_vector(random, 3, reach);
            let side_of_first = side(fan[0], eye);
            let are_all = fan
                .iter()
                .all(|corners| side(*corners, eye) == side_of_first);
            if side_of_first == 0.0 || !are_all {
                continue;
            }
            let ray = Ray::new(eye, aim - eye).unwrap();
            let is_hit = |[a, b, c]: &[Point3; 3]| {
                first(&Triangle::new(*a, *b, *c).unwrap(), &ray).is_some()
            };
            assert!(fan.iter().any(is_hit), "{ray:?}, mesh {seed}, ray {n}");
            rays[is_corner] += 1;
        }
    }
    assert!(rays.iter().all(|rays| *rays > 50_000), "{rays:?}");
}

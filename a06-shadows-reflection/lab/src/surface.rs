//! `Surface`: a shape whose rays are to leave it, alone in a world.
//!
//! Why the roundings of a sphere and of a triangle stay below the offset, in the steps that the page for the
//! sceptic leaves out. With u = 2^-53, and m the largest number that is rounded:
//!
//! **Sphere**, D = r² - l·l with l = f + b d, where f = o - c. An error ΔD becomes ΔD / (2 √D) in the root, which is
//! large at the rim. But only the error along the normal counts, and its factor |d·n| = √D / r leaves ΔD / (2r). So
//! r² costs half a rounding of r. The sum l·l costs one and a half, and that of l one, both times l² / r²; the
//! difference costs a half, and quotient, a and root three, both times D / r². As l² + D = r², these are at most three
//! and a half: with r², four roundings of r. In t₀ the square f·f is t₀ t₁ + r². Divided by t₁, and times √D / r, which
//! is at most t₁ / r, it leaves t₀ + r, which is at most 2m.
//!
//! **Triangle**, `t = α z_A + β z_B + γ z_C`. The corners are wrong by a few u of their distance from o, at most
//! t + L with the longest edge L. A mean with positive weights is no more wrong than the corners are: 15u t + 25u L at
//! the first test, 25u L at the second. The weights are areas, differences of two products of lengths up to
//! √3 L in the sheared space, wrong by up to 6u L² each, and divided by their sum. Along a flat ray this sum is
//! small, because it has the factor d·n; but only the error along the normal counts, which has the same factor above
//! the line. The rest of the sum is twice the area, L h with the least height h. With depths that differ by up
//! to L, the weights cost 12u L² / h at each test. So s = L² / h bounds both. It is least in a triangle with
//! equal sides, 1.15 L, hence L ≤ 0.87 s, and with the 4.5u m of the point all together is
//! 15u t + 50u L + 24u s + 4.5u m ≤ 87u m.

use std::rc::Rc;

use a02_math::{Normal3, Point3};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle, World};
use a04_lab::support::{Triple, point};
use common::{Color, Error};

/// A world of one shape.
pub type Surface = Rc<World<()>>;

/// A shape in a scene of this size.
pub type Shape = fn(f64) -> Result<Surface, Error>;

/// The shapes of this stage, leaning and perpendicular to an axis.
pub const SHAPES: [Shape; 6] = [
    |size| sphere(at(size, [0.1, 0.2, 0.3]), 0.7 * size),
    |size| plane(at(size, [0.1, 0.2, 0.3]), Normal3::new(0.3, 1.0, 0.2)),
    |size| plane(at(size, [0.1, 0.2, 0.3]), Normal3::new(0.0, 1.0, 0.0)),
    |size| cuboid(at(size, [-0.3, -0.5, -0.1]), at(size, [0.6, 0.7, 0.8])),
    |size| {
        let corners = [[-0.9, -0.3, -0.5], [1.2, 0.1, -0.6], [0.3, 0.4, 1.3]];
        triangle(corners.map(|corner| at(size, corner)))
    },
    |size| {
        let corners = [[-0.9, 0.2, -0.5], [1.2, 0.2, -0.6], [0.3, 0.2, 1.3]];
        triangle(corners.map(|corner| at(size, corner)))
    },
];

pub fn surface(shape: impl Geometry) -> Result<Surface, Error> {
    Ok(Rc::new(World::new(Color::BLACK)?.with(shape, ())))
}

pub fn sphere(center: Point3, radius: f64) -> Result<Surface, Error> {
    surface(Sphere::new(center, radius)?)
}

pub fn plane(a: Point3, normal: Normal3) -> Result<Surface, Error> {
    surface(Plane::new(a, normal)?)
}

/// A box between two opposite corners.
pub fn cuboid(least: Point3, greatest: Point3) -> Result<Surface, Error> {
    surface(AxisAlignedBox::new(least, greatest)?)
}

pub fn triangle([a, b, c]: [Point3; 3]) -> Result<Surface, Error> {
    surface(Triangle::new(a, b, c)?)
}

/// The point at a position of the scene of size 1, in a scene of this size.
pub fn at(size: f64, position: Triple) -> Point3 {
    point(position.map(|x| x * size))
}

//! Rodrigues' formula: `p cos + (k × p) sin + k (k · p) (1 - cos)`.

use a02_math::{Direction, Point3, Vector3};
use a04_intersections::{AxisAlignedBox, World};
use a07_transforms::{Node, Transform};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::shape::{TURNS, show};

const BOUND: Bound = Bound::Absolute(1e-14);

pub fn check(
    check: &mut Check,
    rotation: impl Fn(Vector3, f64) -> Result<Transform, ArgumentError>,
) {
    let mut random = Random::new(3);
    let axes = [
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, -1.0],
        [0.6, 0.0, -0.8],
        [0.48, 0.6, 0.64],
        [-0.36, -0.8, 0.48],
    ];
    let more: Vec<_> = (0..20).map(|_| random.unit()).collect();
    for k in axes.into_iter().chain(more) {
        let k = Vector3::from_glam(k.into());
        for (sin, cos) in TURNS {
            // An axis of any length.
            let Ok(turn) = rotation(k * 2.0, libm::atan2(sin, cos)) else {
                return;
            };
            for p in [
                Vector3::new(1.0, 0.0, 0.0),
                Vector3::new(0.0, 1.0, 0.0),
                Vector3::new(0.0, 0.0, 1.0),
            ] {
                let exact = p * cos + k.cross(p) * sin + k * (k.dot(p) * (1.0 - cos));
                let axis = k * 2.0;
                let about = format!("{} about {:.3}", p.to_glam(), axis.to_glam());
                let what = format!("{about}, turned by sine {sin:.3}, cosine {cos:.3}");
                let got = (turn.matrix() * p).to_glam().to_array();
                check.expect(what, exact.to_glam().to_array(), BOUND, got);
                let got = (turn.inverse() * exact).to_glam().to_array();
                let what = format!("{about}, turned back from sine {sin:.3}, cosine {cos:.3}");
                check.expect(what, p.to_glam().to_array(), BOUND, got);
            }
            let still = (turn.matrix() * Point3::ORIGIN).to_glam().to_array();
            check.expect("the origin stays", [0.0; 3], BOUND, still);
        }
    }

    // Three corners of a cube around its diagonal, each turned a third.
    let wheel = || {
        let mut world = World::new(Color::gray(0.08))?;
        for (third, color) in [(0.0, Color::RED), (1.0, Color::GREEN), (2.0, Color::BLUE)] {
            let angle = std::f64::consts::TAU / 3.0 * third;
            let turn = rotation(Vector3::new(1.0, 1.0, 1.0), angle)?;
            let (lbf, run) = (Point3::new(0.3, -0.4, -0.4), Point3::new(2.2, 0.4, 0.4));
            let node = Node::new(turn).with(AxisAlignedBox::new(lbf, run)?);
            world = world.with(node, color * 0.6 + Color::gray(0.4));
        }
        Ok(world)
    };
    let eye = Point3::new(4.0, 4.5, 5.0);
    show(check, wheel(), eye, Point3::new(0.6, 0.6, 0.6));
}

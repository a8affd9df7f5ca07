//! Nodes of one and of several balls under random transforms, and nodes in nodes.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Sphere};
use a05_lighting::Lambert;
use a07_transforms::Transform;
use common::Color;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::steps::{ABOVE, Step, expect_scene, frame, lit_from, on_ball, steps_of_box};

/// Rounding errors of coordinates up to 1e4.
const BOUND: Bound = Bound::Absolute(1e-8);

type Children = Vec<Box<dyn Geometry>>;

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(Transform, Children) -> G) {
    let mut random = Random::new(73);
    let middle = Point3::ORIGIN;
    for count in [0, 1, 2, 3, 1, 2, 3, 2] {
        let steps: Vec<_> = (0..count).map(|_| Step::random(&mut random)).collect();
        let transform = steps
            .iter()
            .fold(Transform::IDENTITY, |t, step| step.after(t));
        let axes = frame(&mut random);
        let (at, n) = on_ball(&transform, axes);
        let center = transform.matrix() * Point3::ORIGIN;
        let ray = Ray::derived(at + (at - center), center - at);
        let words = format!(
            "chain {steps:.2?}, ray from {:.2} along {:.2}",
            ray.origin().to_glam(),
            ray.direction().to_glam()
        );
        let ball = |place: Point3, r: f64| -> Children {
            Sphere::new(place, r)
                .map(|ball| Box::new(ball) as Box<dyn Geometry>)
                .into_iter()
                .collect()
        };
        let mut expect = |kind: &str, node: &dyn Geometry, within: Interval, is_hit: bool| {
            let got = node.hit(&ray, within);
            let (exact, t) = (is_hit.then_some(1.0), got.map(|hit| hit.t));
            check.expect(format!("t, {kind}; {words}"), exact, BOUND, t);
            if let (Some(hit), true) = (got, is_hit) {
                for (name, got) in [("normal", hit.normal), ("face", hit.face)] {
                    let [exact, got] = [n, got].map(|n| n.to_glam().to_array());
                    check.expect(format!("the {name}, {kind}; {words}"), exact, BOUND, got);
                }
            }
        };
        let ahead = Interval::AHEAD;
        expect("a ball", &new(transform, ball(middle, 1.0)), ahead, true);
        expect(
            "a ball, but the interval ends before",
            &new(transform, ball(middle, 1.0)),
            Interval::before(0.9),
            false,
        );
        expect("no child", &new(transform, Vec::new()), ahead, false);
        // A smaller ball inside is hit later, wherever it is in the list.
        let (outer, inner) = (ball(middle, 1.0), ball(middle, 0.5));
        expect(
            "a ball and a smaller one in it",
            &new(transform, outer.into_iter().chain(inner).collect()),
            ahead,
            true,
        );
        let (outer, inner) = (ball(middle, 1.0), ball(middle, 0.5));
        expect(
            "a small ball and a larger one around it",
            &new(transform, inner.into_iter().chain(outer).collect()),
            ahead,
            true,
        );
        let inside: Children = vec![Box::new(new(Transform::IDENTITY, ball(middle, 1.0)))];
        expect("a node in a node", &new(transform, inside), ahead, true);
    }
    expect_scene(check, "box-transformations", 10.0, || {
        let (lbf, run) = (Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5));
        let transform = steps_of_box()
            .iter()
            .fold(Transform::IDENTITY, |t, step| step.after(t));
        let node = new(transform, vec![Box::new(AxisAlignedBox::new(lbf, run)?)]);
        Ok(lit_from(ABOVE, false, 0.25)?.with(node, Box::new(Lambert::new(Color::YELLOW)?)))
    });
}

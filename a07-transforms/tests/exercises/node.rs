//! Nodes of balls and a smooth triangle under chains of steps, compared with the lesson's.

use crate::prelude::*;

type Children = Vec<Box<dyn Geometry>>;

/// A small ball in a large one, and a triangle whose corners have normals aslant.
fn children() -> Result<Children, ArgumentError> {
    let [small, large] = [0.5, 1.0].map(|r| Sphere::new(Point3::ORIGIN, r));
    Ok(vec![
        Box::new(small?),
        Box::new(large?),
        Box::new(smooth_triangle(2.0)?),
    ])
}

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(Transform, Children) -> G) {
    compare(
        check,
        "two balls and a triangle under {}",
        vec![],
        Step::random,
        |steps| {
            Ok(children()?
                .into_iter()
                .fold(Node::new(transform(&steps)), Node::with))
        },
        |steps| Ok(new(transform(&steps), children()?)),
    );
    locked_scene(check, "box-transformations", 10.0, || {
        let (lbf, run) = (Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5));
        let node = new(
            transform(&steps_of_box()),
            vec![Box::new(AxisAlignedBox::new(lbf, run)?)],
        );
        Ok(lit_from(ABOVE, false, 0.25)?.with(node, Box::new(Lambert::new(Color::YELLOW)?)))
    });
}

/// One of the hits of all children, which `choose` finds, with its face led out or not.
fn variant(
    c: &mut Check,
    choose: fn(&Children, &Ray, Interval) -> Option<Hit>,
    around: fn(&Transform, Normal3) -> Option<Normal3>,
) {
    check(c, move |t, children| {
        Own(move |ray: &Ray, within: Interval| {
            let hit = choose(&children, &t.ray_to_object(ray), within)?;
            let (normal, face) = (t.normal_from_object(hit.normal)?, around(&t, hit.face)?);
            Some(Hit {
                normal,
                face,
                ..hit
            })
        })
    });
}

fn first(children: &Children, ray: &Ray, within: Interval) -> Option<Hit> {
    let hits = children.iter().filter_map(|child| child.hit(ray, within));
    hits.min_by(|a, b| a.t.total_cmp(&b.t))
}

pub const VARIANTS: &[Variant] = &[
    right("all hits, and then the first", |c| {
        variant(c, first, Transform::normal_from_object)
    }),
    wrong("not the first of the list, but the nearest", |c| {
        let any = |children: &Children, ray: &Ray, i| children.iter().find_map(|g| g.hit(ray, i));
        variant(c, any, Transform::normal_from_object);
    }),
    wrong("both normals are led out of the node", |c| {
        variant(c, first, |_, face| Some(face))
    }),
    wrong("a hit before the interval hides one in it", |c| {
        let after = |children: &Children, ray: &Ray, i: Interval| {
            first(children, ray, Interval::AHEAD).filter(|hit| i.contains(hit.t))
        };
        variant(c, after, Transform::normal_from_object);
    }),
];

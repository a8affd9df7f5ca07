//! Nodes of balls and a smooth triangle under chains of steps, compared with the lesson's.

use crate::prelude::*;

type Children = Vec<Box<dyn Geometry>>;

/// At the outer ball, away from it, and from within both.
const SIMPLE: [[[f64; 3]; 2]; 3] = [
    [[0.0, 0.0, -4.0], [0.0, 0.0, 1.0]],
    [[0.0, 0.0, -4.0], [0.0, 0.0, -1.0]],
    [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
];

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
        (vec![], &SIMPLE),
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

/// One of the hits of all children, which `choose` finds and a function leads out of the node.
fn variant(
    c: &mut Check,
    choose: fn(&Children, &Ray, Interval) -> Option<Hit>,
    around: fn(&Transform, Hit) -> Option<Hit>,
) {
    check(c, move |t, children| {
        Own(move |ray: &Ray, within: Interval| {
            around(&t, choose(&children, &t.ray_to_object(ray), within)?)
        })
    });
}

fn first(children: &Children, ray: &Ray, within: Interval) -> Option<Hit> {
    let hits = children.iter().filter_map(|child| child.hit(ray, within));
    hits.min_by(|a, b| a.t.total_cmp(&b.t))
}

fn around(t: &Transform, hit: Hit) -> Option<Hit> {
    let [normal, face] = [hit.normal, hit.face].map(|n| t.normal_from_object(n));
    let (normal, face) = (normal?, face?);
    Some(Hit {
        normal,
        face,
        ..hit
    })
}

pub const VARIANTS: &[Variant] = &[
    right("all hits, and then the first", |c| {
        variant(c, first, around)
    }),
    wrong(
        "the nearest of all children counts, not the first of the list",
        |c| {
            variant(
                c,
                |children, ray, i| children.iter().find_map(|child| child.hit(ray, i)),
                around,
            );
        },
    ),
    wrong(
        "a hit has two normals, and both are led out of the node",
        |c| {
            variant(c, first, |t, hit| {
                Some(Hit {
                    normal: t.normal_from_object(hit.normal)?,
                    ..hit
                })
            });
        },
    ),
    wrong(
        "the interval belongs into the search: a hit before it hides one in it",
        |c| {
            variant(
                c,
                |children, ray, i| {
                    first(children, ray, Interval::AHEAD).filter(|hit| i.contains(hit.t))
                },
                around,
            );
        },
    ),
];

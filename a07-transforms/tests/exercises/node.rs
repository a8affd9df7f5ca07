//! Nodes of balls and a smooth triangle under chains of steps, compared with the lesson's.

use crate::prelude::*;

type Children = Vec<Shape>;

/// A small ball in a large one, and a triangle whose corners have normals aslant.
fn children() -> Made<Children> {
    let [small, large] = [0.5, 1.0].map(|r| Sphere::new(Point3::ORIGIN, r));
    let triangle = smooth_triangle(2.0)?;
    Ok(vec![Box::new(small?), Box::new(large?), Box::new(triangle)])
}

fn lesson(transform: Transform, children: Children) -> Node {
    children.into_iter().fold(Node::new(transform), Node::with)
}

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(Transform, Children) -> G) {
    compare(
        check,
        "two balls and a triangle under {}",
        vec![],
        Step::random,
        &|steps| Ok(Box::new(lesson(transform(&steps), children()?))),
        &|steps| Ok(Box::new(new(transform(&steps), children()?))),
    );
    box_scene(check, |child| {
        new(transform(&steps_of_box()), vec![Box::new(child)])
    });
}

/// One of the hits of all children, which `choose` finds, with its face led out or not.
fn variant(
    c: &mut Check,
    choose: fn(&mut dyn Iterator<Item = Hit>) -> Option<Hit>,
    around: fn(&Transform, Normal3) -> Option<Normal3>,
) {
    check(c, move |t, children| {
        Own(move |ray: &Ray, within: Interval| {
            let ray = t.ray_to_object(ray);
            let mut hits = children.iter().filter_map(|child| child.hit(&ray, within));
            let mut hit = choose(&mut hits)?;
            (hit.normal, hit.face) = (t.normal_from_object(hit.normal)?, around(&t, hit.face)?);
            Some(hit)
        })
    });
}

fn first(hits: &mut dyn Iterator<Item = Hit>) -> Option<Hit> {
    hits.min_by(|a, b| a.t.total_cmp(&b.t))
}

variants! { variant:
    yours => |t, children| children.into_iter().fold(Node::new(t), Node::with);
    right "all hits, and then the first" => first, Transform::normal_from_object;
    wrong "the nearest counts, not the first of the list" =>
        |hits| hits.next(), Transform::normal_from_object;
    wrong "both normals are led out of the node" => first, |_, face| Some(face);
}

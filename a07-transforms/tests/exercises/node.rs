//! Nodes of balls and a smooth triangle under chains of steps, compared with the lesson's.

use crate::prelude::*;

yours! {
    Node => new_shape(|crate::node::Parts { steps, children }| {
        let node = Node::new(transform(&steps));
        Ok(children()?.into_iter().fold(node, Node::with))
    })
}

/// The parts of a node: its steps, which questions name, and its children.
#[derive(Clone)]
pub struct Parts {
    pub steps: Vec<Step>,
    pub children: fn() -> Made<Vec<Shape>>,
}

impl Input for Parts {
    fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
        self.steps.for_each_number(f);
    }

    fn words(&self) -> Vec<String> {
        self.steps.words()
    }
}

type Code = NewShape<Parts>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: BOX_SCENE.with(|new: &Code, world| {
            let node = new(Parts {
                steps: steps_of_box().to_vec(),
                children: || Ok(vec![Box::new(upright_box()?)]),
            })?;
            Ok(world.with(node, yellow()?))
        }),
        right: vec![Other::new(
            "all hits, and then the first",
            of_all_hits(Choice {
                hit: first,
                geometric_normal: Transform::normal_from_object,
            }),
        )],
        wrong: vec![
            Other::new(
                "the nearest counts, not the first of the list",
                of_all_hits(Choice {
                    hit: |hits| hits.into_iter().next(),
                    geometric_normal: Transform::normal_from_object,
                }),
            ),
            Other::new(
                "both normals are led out of the node",
                of_all_hits(Choice {
                    hit: first,
                    geometric_normal: |_, face| Some(face),
                }),
            ),
        ],
        ..shapes(Shapes {
            words: "two balls and a triangle under {}",
            first: Parts {
                steps: vec![],
                children: balls_and_triangle,
            },
            any: |r| Parts {
                steps: Step::random(r),
                children: balls_and_triangle,
            },
        })
    }
}

/// A small ball in a large one, and a triangle whose corners have normals aslant.
fn balls_and_triangle() -> Made<Vec<Shape>> {
    let [small, large] = [0.5, 1.0].map(|r| Sphere::new(Point3::ORIGIN, r));
    let triangle = smooth_triangle(2.0)?;
    Ok(vec![Box::new(small?), Box::new(large?), Box::new(triangle)])
}

/// What becomes of the hits of all children.
#[derive(Clone, Copy)]
struct Choice {
    /// One of them.
    hit: fn(Vec<Hit>) -> Option<Hit>,
    /// Its geometric normal in the space around the node.
    geometric_normal: fn(&Transform, Normal3) -> Option<Normal3>,
}

fn of_all_hits(choice: Choice) -> Code {
    new_shape(move |Parts { steps, children }| {
        let (transform, children) = (transform(&steps), children()?);
        Ok(own(move |ray: &Ray, within| {
            let ray = transform.ray_to_object(ray);
            let mut hits = Vec::new();
            for child in &children {
                hits.extend(child.hit(&ray, within));
            }
            let mut hit = (choice.hit)(hits)?;
            hit.normal = transform.normal_from_object(hit.normal)?;
            hit.geometric_normal = (choice.geometric_normal)(&transform, hit.geometric_normal)?;
            Some(hit)
        }))
    })
}

fn first(hits: Vec<Hit>) -> Option<Hit> {
    hits.into_iter().min_by(|a, b| a.t.total_cmp(&b.t))
}

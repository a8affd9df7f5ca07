//! Nodes of balls and a smooth triangle under chains of steps, compared with the solution.

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

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: BOX_SCENE.with(|new: &Code, world| {
            let node = new(Parts {
                steps: steps_of_box().to_vec(),
                children: || Ok(vec![Box::new(upright_box()?)]),
            })?;
            Ok(world.with(node, yellow()?))
        }),
        ..shapes(Shapes {
            words: "two balls and a triangle under {}",
            first: Parts {
                steps: vec![],
                children: balls_and_triangle,
            },
            further: vec![
                Parts {
                    steps: vec![Step::Scale([2.0, 1.0, 0.5])],
                    children: balls_and_triangle,
                },
                Parts {
                    steps: vec![Step::Translate([0.5, 0.0, -1.0])],
                    children: balls_and_triangle,
                },
            ],
            on_surface: vec![
                [1.0, 0.0, 0.0],
                [0.0, 0.0, 1.0],
                [0.0, 0.5, 0.0],
                [0.0, 0.0, 2.0],
            ],
            own_rays: of_sizes(|size| Parts {
                steps: vec![Step::Scale([size; 3])],
                children: balls_and_triangle,
            }),
            middle: |parts| array(transform(&parts.steps).matrix() * Point3::ORIGIN),
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

//! Nodes of balls and a smooth triangle under chains of steps, compared with the solution.

use crate::prelude::*;

yours! {
    Node => |steps: &[Step], children: Vec<Shape>| -> Shape {
        let node = Node::new(transform(steps));
        Box::new(children.into_iter().fold(node, Node::with))
    }
}

/// A node of some steps and children.
type Code = fn(&[Step], Vec<Shape>) -> Shape;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        forms: hits_and_parts(|new: &Code, steps: Vec<Step>| {
            Ok(new(&steps, balls_and_triangle()?))
        }),
        picture: BOX_SCENE.with(|new: &Code, world| {
            let node = new(&steps_of_box(), vec![Box::new(upright_box()?)]);
            Ok(world.with(node, yellow()?))
        }),
        ..Exercise::default()
    }
}

/// A small ball in a large one, and a triangle whose corners have normals aslant.
fn balls_and_triangle() -> Made<Vec<Shape>> {
    let [small, large] = [0.5, 1.0].map(|r| Sphere::new(Point3::ORIGIN, r));
    let triangle = smooth_triangle(2.0)?;
    Ok(vec![Box::new(small?), Box::new(large?), Box::new(triangle)])
}

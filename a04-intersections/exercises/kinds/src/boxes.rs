//! Boxes between two corners, which two exercises ask, and rays within their faces.

use crate::rays::{RayWithin, ahead};
use crate::shape::Shapes;

/// The parameters of a box between two corners.
pub type Corners = ([f64; 3], [f64; 3]);

/// Boxes between two corners.
#[must_use]
pub fn boxes() -> Shapes<Corners> {
    Shapes {
        words: "box from {} to {}",
        first: ([-1.5; 3], [1.5; 3]),
        further: vec![],
        on_surface: vec![[1.5, 0.0, 0.0], [0.5, -1.5, 0.25], [-0.5, 0.5, 1.5]],
        own_rays: within_faces(),
        middle: |(lbf, run)| [0, 1, 2].map(|k| f64::midpoint(lbf[k], run[k])),
        any: |r| {
            let lbf = r.triple(5.0);
            (lbf, lbf.map(|low| low + r.between(0.1, 3.0)))
        },
    }
}

/// Rays within the faces of the first box, which belong to it: from outside and from inside of the
/// face, along its edges and aslant.
fn within_faces() -> Vec<RayWithin> {
    let mut within = Vec::new();
    for face in [-1.5, 1.5] {
        for sign in [1.0, -1.0] {
            for axis in 0..3 {
                let (along, across) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut origin = [0.5; 3];
                origin[axis] = face;
                let mut direction = [0.0; 3];
                direction[along] = sign;
                within.push(ahead(origin, direction));
                origin[along] = -4.0 * sign;
                within.push(ahead(origin, direction));
                // Zeros have signs, and a quotient by them, too.
                within.push(ahead(
                    origin,
                    direction.map(|x| if x == 0.0 { -0.0 } else { x }),
                ));
                // Past an edge, which it touches.
                let (mut outside, mut past) = ([0.25; 3], [0.0; 3]);
                (outside[axis], outside[along]) = (2.0 * face, 0.0);
                (past[axis], past[along]) = (-face, face * sign);
                within.push(ahead(outside, past));
                // Along an edge, aslant in the face, and beside the box.
                origin[across] = face;
                within.push(ahead(origin, direction));
                direction[across] = -face / 4.0;
                within.push(ahead(origin, direction));
                origin[across] = 3.0;
                direction[across] = 0.0;
                within.push(ahead(origin, direction));
            }
        }
    }
    within
}

//! Boxes anywhere, compared with the solution.

use crate::prelude::*;

yours! { AxisAlignedBox => new_box(AxisAlignedBox::new) }

type Code = NewShape<Corners>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-3", scene_3, ([-0.5, 0.0, -0.5], [0.5, 1.0, 0.5])),
        wrong: vec![
            Other::new(
                "edges belong to the box",
                slabs(Style {
                    is_crossed: |near, far| near < far,
                    ..RIGHT
                }),
            ),
            Other::new(
                "against an axis, a ray enters a slab at its larger coordinate",
                slabs(Style {
                    entry_and_exit: |a, b, _| [a, b],
                    ..RIGHT
                }),
            ),
            Other::new(
                "against an axis, a ray enters a slab at its larger coordinate",
                slabs(Style {
                    entry_and_exit: |a, b, direction| {
                        if direction == 0.0 {
                            entry_and_exit(a, b, direction)
                        } else {
                            [a, b]
                        }
                    },
                    ..RIGHT
                }),
            ),
            Other::new(
                "a ray within a face belongs to the box, and 0 times infinity is not a number",
                slabs(Style {
                    entry_and_exit: |a, b, _| [a.min(b), a.max(b)],
                    ..RIGHT
                }),
            ),
        ],
        ..shapes(boxes())
    }
}

/// A way to compute with slabs.
#[derive(Clone, Copy)]
struct Style {
    /// The `t` at which a ray enters a slab and leaves it: by those of its lower and its upper
    /// plane, and the direction along the axis.
    entry_and_exit: fn(f64, f64, f64) -> [f64; 2],
    /// Whether a ray crosses the box, by its last entry and its first exit.
    is_crossed: fn(f64, f64) -> bool,
}

const RIGHT: Style = Style {
    entry_and_exit,
    is_crossed: |near, far| near <= far,
};

fn entry_and_exit(a: f64, b: f64, direction: f64) -> [f64; 2] {
    // Within a plane of a slab the ray never leaves it.
    if a.is_nan() || b.is_nan() {
        [f64::NEG_INFINITY, f64::INFINITY]
    } else if direction < 0.0 {
        [b, a]
    } else {
        [a.min(b), a.max(b)]
    }
}

/// The slabs of all axes: a ray is in the box from the last entry to the first exit.
fn slabs(style: Style) -> Code {
    new_box(move |lbf, run| {
        let corners = [lbf, run].map(array);
        Ok(own(move |ray: &Ray, within| {
            let o = array(ray.origin());
            let d = array(ray.direction());
            let mut entry = (f64::NEG_INFINITY, 0);
            let mut exit = (f64::INFINITY, 0);
            for axis in 0..3 {
                let [a, b] = corners.map(|corner| (corner[axis] - o[axis]) / d[axis]);
                let [near, far] = (style.entry_and_exit)(a, b, d[axis]);
                if near > entry.0 {
                    entry = (near, axis);
                }
                if far < exit.0 {
                    exit = (far, axis);
                }
            }
            if !(style.is_crossed)(entry.0, exit.0) {
                return None;
            }
            let is_entered = within.contains(entry.0);
            let (t, axis) = if is_entered { entry } else { exit };
            let mut normal = [0.0; 3];
            normal[axis] = if is_entered { -d[axis] } else { d[axis] }.signum();
            let hit = Hit::new(t, vector(normal).as_normal());
            within.contains(t).then_some(hit)
        }))
    })
}

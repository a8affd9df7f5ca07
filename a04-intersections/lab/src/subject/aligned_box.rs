//! The box: two opposite corners.

use a03_rays_cameras::Ray;

use super::{ExactHit, Subject, triple};
use crate::certified::decide;
use crate::exact::DoubleDouble;
use crate::line::Line;
use crate::support::{Triple, point};
use crate::{condition, protocol};
use a04_intersections::{AxisAlignedBox, Geometry};

pub const BOX: Subject = Subject {
    name: "box",
    written: "AxisAlignedBox::new(Point3::new(#, #, #), Point3::new(#, #, #))",
    make,
    aim,
    through,
    decide,
    exact,
    protocol,
};

fn make(numbers: &[f64]) -> Option<Box<dyn Geometry>> {
    let [a, b] = [triple(numbers), triple(&numbers[3..])].map(point);
    Some(Box::new(AxisAlignedBox::new(a, b).ok()?))
}

fn aim(numbers: &[f64], aim: Triple) -> Triple {
    [0, 1, 2].map(|axis| {
        let (a, b) = (numbers[axis], numbers[axis + 3]);
        a + 0.5 * (b - a) * (aim[axis] + 1.0)
    })
}

/// The second corner lies there.
fn through(numbers: &mut [f64], point: Triple) {
    numbers[3..6].copy_from_slice(&point);
}

/// Where a ray meets a face of a box.
#[derive(Clone, Copy)]
struct FaceMeeting {
    t: DoubleDouble,
    /// The axis across the face, and the face's coordinate on it.
    axis: usize,
    face: f64,
}

impl FaceMeeting {
    fn new(line: &Line, axis: usize, face: f64) -> Self {
        let from_origin = DoubleDouble::from(face) - line.origin[axis].into();
        let t = from_origin / line.direction[axis].into();
        Self { t, axis, face }
    }
}

/// The ray is inside between the last slab that it enters and the first that it leaves.
fn exact(numbers: &[f64], line: &Line) -> Option<ExactHit> {
    let (mut last_entry, mut first_exit): (Option<FaceMeeting>, Option<FaceMeeting>) = (None, None);
    for axis in 0..3 {
        if line.direction[axis] == 0.0 {
            continue;
        }
        let a = FaceMeeting::new(line, axis, numbers[axis]);
        let b = FaceMeeting::new(line, axis, numbers[axis + 3]);
        let (entry, exit) = if a.t.value() < b.t.value() {
            (a, b)
        } else {
            (b, a)
        };
        if last_entry.is_none_or(|last| entry.t.value() >= last.t.value()) {
            last_entry = Some(entry);
        }
        if first_exit.is_none_or(|first| exit.t.value() < first.t.value()) {
            first_exit = Some(exit);
        }
    }
    let (entry, exit) = (last_entry?, first_exit?);
    let nearest = if entry.t.value() > 0.0 { entry } else { exit };
    let t = nearest.t;
    let mut normal = [0.0; 3];
    normal[nearest.axis] = 1.0;
    let starts_on_it = entry.t.value() == 0.0;
    let condition = if starts_on_it {
        f64::INFINITY
    } else {
        condition::of_plane(&[nearest.face; 3], normal, line, t.value())
    };
    Some(ExactHit { t, condition })
}

fn protocol(numbers: &[f64], ray: &Ray) -> Option<f64> {
    let low = [0, 1, 2].map(|axis| numbers[axis].min(numbers[axis + 3]));
    let high = [0, 1, 2].map(|axis| numbers[axis].max(numbers[axis + 3]));
    protocol::axis_aligned_box(point(low), point(high), ray, protocol::Compared::Three)
}

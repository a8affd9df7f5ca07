//! `Occupancy`: the shapes that can be seen in each pixel, by their projected bounds.
//!
//! The bounds of a shape cover a rectangle of the picture. A rectangle is added to a table of
//! sums in its four corners only, whatever its size. (Crow, Summed-Area Tables for Texture
//! Mapping, 1984.)

use common::Size;
use glam::DVec3;

use crate::accel::{Kind, ShapeId, Shapes};
use crate::shape::{Bounds, Shape};
use crate::{Basis, Camera};

/// The shapes that can be seen in a pixel, apart from planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Occupant {
    None,
    One(ShapeId),
    Several,
}

/// The shapes that can be seen in each pixel.
pub(super) struct Occupancy {
    /// The planes, which can be seen anywhere.
    pub planes: Vec<ShapeId>,
    /// The other shapes.
    bounded: Vec<ShapeId>,
    /// The number of entries in a row of `sums`.
    stride: usize,
    /// For each pixel, the sum over its shapes of `ONE` and of their indices in `bounded`.
    sums: Vec<u64>,
}

/// One shape in a sum. Each index is smaller, so no sum over several shapes is below twice this.
const ONE: u64 = 1 << 32;

/// A margin around projected bounds, in pixels, that is wider than the rounding of positions.
const MARGIN: f64 = 1.0 / 1024.0;

/// The relative rounding error of a projected point, and more.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

impl Occupancy {
    /// The shapes in each pixel; none if a shape or the camera is one that the engine does not
    /// know.
    pub fn new(shapes: &Shapes, camera: &Camera, size: Size) -> Option<Self> {
        let stride = size.width() as usize + 1;
        let length = stride * (size.height() as usize + 1);
        let mut sums = Vec::new();
        sums.try_reserve_exact(length).ok()?;
        sums.resize(length, 0);
        let mut occupancy = Self {
            planes: Vec::new(),
            bounded: Vec::new(),
            stride,
            sums,
        };
        for (shape, bounds) in shapes.bounds() {
            if bounds.are_finite() {
                let index = occupancy.bounded.len() as u64;
                occupancy.bounded.push(shape);
                if let Some(pixels) = pixels_of(&bounds, camera, size)? {
                    occupancy.add(pixels, ONE + index);
                }
            } else if is_plane(shapes, shape) {
                occupancy.planes.push(shape);
            } else {
                return None;
            }
        }
        occupancy.sum_up();
        Some(occupancy)
    }

    /// Adds a number to the sums of a rectangle, once they are summed up.
    fn add(&mut self, pixels: Pixels, number: u64) {
        let [left, right] = pixels.columns;
        let [top, bottom] = pixels.rows;
        for (row, column, number) in [
            (top, left, number),
            (top, right + 1, number.wrapping_neg()),
            (bottom + 1, left, number.wrapping_neg()),
            (bottom + 1, right + 1, number),
        ] {
            let sum = &mut self.sums[row as usize * self.stride + column as usize];
            *sum = sum.wrapping_add(number);
        }
    }

    /// Makes each entry the sum of all entries above it and to its left, itself included.
    fn sum_up(&mut self) {
        for row in self.sums.chunks_exact_mut(self.stride) {
            let mut sum = 0_u64;
            for entry in row {
                sum = sum.wrapping_add(*entry);
                *entry = sum;
            }
        }
        for i in self.stride..self.sums.len() {
            self.sums[i] = self.sums[i].wrapping_add(self.sums[i - self.stride]);
        }
    }

    /// The shapes that can be seen in the pixel of this column and row, apart from planes.
    pub fn occupant(&self, (column, row): (u32, u32)) -> Occupant {
        let sum = self.sums[row as usize * self.stride + column as usize];
        if sum == 0 {
            Occupant::None
        } else if sum < 2 * ONE {
            Occupant::One(self.bounded[(sum - ONE) as usize])
        } else {
            Occupant::Several
        }
    }
}

/// Whether a shape is a plane, which may be transformed.
fn is_plane(shapes: &Shapes, shape: ShapeId) -> bool {
    match shape.kind {
        Kind::Plane => true,
        Kind::Transformed => {
            let transformed = &shapes.transformed.shapes[shape.index as usize];
            matches!(*transformed.shape, Shape::Plane(_))
        }
        _ => false,
    }
}

/// A rectangle of pixels: the first and the last column and row.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pixels {
    columns: [u32; 2],
    rows: [u32; 2],
}

/// The pixels in which something inside these bounds can be seen; none if it cannot be seen, and no answer if the engine does not know the camera.
#[allow(
    clippy::option_option,
    reason = "an unknown answer is not an empty one"
)]
fn pixels_of(bounds: &Bounds, camera: &Camera, size: Size) -> Option<Option<Pixels>> {
    let [width, height] = [size.width(), size.height()].map(f64::from);
    let (basis, scale) = match camera {
        Camera::Perspective {
            basis,
            half_tangent,
        } => (basis, Scale::Perspective(height / 2.0 / half_tangent)),
        Camera::Orthographic { basis, scale } => {
            let aspect = width / height;
            let per_length = [
                (width - 1.0).max(1.0) / (aspect * scale),
                (height - 1.0).max(1.0) / scale,
            ];
            (basis, Scale::Orthographic(per_length))
        }
        Camera::Other(_) => return None,
    };
    Some(projected(bounds, basis, scale, [width, height]))
}

/// How a camera scales displacements from its axis.
#[derive(Clone, Copy)]
enum Scale {
    /// Pixels for each unit of the ratio of displacement and depth.
    Perspective(f64),
    /// Pixels for each unit of length, along both axes.
    Orthographic([f64; 2]),
}

/// The pixels in which something inside these bounds can be seen, in a picture of this extent.
fn projected(bounds: &Bounds, basis: &Basis, scale: Scale, extent: [f64; 2]) -> Option<Pixels> {
    let magnitude = largest(DVec3::from(bounds.magnitudes())) + largest(basis.e);
    let error = ROUNDING * magnitude;
    let corners = corners(bounds).map(|corner| {
        let from_eye = corner - basis.e;
        [basis.u, basis.v, -basis.w].map(|axis| from_eye.dot(axis))
    });
    let [_, _, depths] = ranges(&corners);
    if depths[1] < -error {
        return None;
    }
    let (points, margin) = match scale {
        Scale::Orthographic([across, up]) => {
            let points = corners.map(|[x, y, _]| [across * x, up * y]);
            (points, error * across.abs().max(up.abs()))
        }
        Scale::Perspective(z) => {
            if depths[0] <= error {
                // Beside the eye, bounds may be projected to anywhere.
                return within([[f64::NEG_INFINITY, f64::INFINITY]; 2], extent);
            }
            let points = corners.map(|[x, y, depth]| [z * x / depth, z * y / depth]);
            let farthest = points.iter().flatten().fold(z, |most, p| most.max(p.abs()));
            (points, 2.0 * farthest * error / depths[0])
        }
    };
    let margin = margin + MARGIN;
    let around = ranges(&points).map(|[least, most]| [least - margin, most + margin]);
    within(around, extent)
}

/// The part of a picture inside these bounds, which are counted from its middle.
fn within([x, y]: [[f64; 2]; 2], [width, height]: [f64; 2]) -> Option<Pixels> {
    // From the left, and from the top.
    let columns = clipped(x.map(|x| x + width / 2.0), width)?;
    let rows = clipped([y[1], y[0]].map(|y| height / 2.0 - y), height)?;
    Some(Pixels { columns, rows })
}

/// The first and the last of `count` cells of width 1 that an interval reaches. All if a border of
/// it is no number.
fn clipped([least, most]: [f64; 2], count: f64) -> Option<[u32; 2]> {
    if most < 0.0 || least >= count {
        return None;
    }
    let last = count - 1.0;
    Some([least.floor().max(0.0) as u32, most.floor().min(last) as u32])
}

fn corners(bounds: &Bounds) -> [DVec3; 8] {
    std::array::from_fn(|corner| {
        let side = |axis: usize| {
            let is_max = corner >> axis & 1 == 1;
            if is_max {
                bounds.max[axis]
            } else {
                bounds.min[axis]
            }
        };
        DVec3::new(side(0), side(1), side(2))
    })
}

/// The least and the greatest of each coordinate.
fn ranges<const N: usize>(points: &[[f64; N]; 8]) -> [[f64; 2]; N] {
    std::array::from_fn(|axis| {
        let of_axis = points.iter().map(|point| point[axis]);
        let empty = [f64::INFINITY, f64::NEG_INFINITY];
        of_axis.fold(empty, |[least, most], x| [least.min(x), most.max(x)])
    })
}

fn largest(v: DVec3) -> f64 {
    v.abs().max_element()
}

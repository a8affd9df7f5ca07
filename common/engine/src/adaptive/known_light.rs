//! `KnownLight`: what the scene says of the light of a picture before the first sample.
//!
//! Where a pixel shows the background alone, no object hides between its samples. The bounds of each
//! object cover a rectangle of the picture, and a plane covers the pixels on one side of its horizon:
//! one comparison tells whether anything covers a pixel.

use common::{Color, Size};
use glam::DVec3;

use crate::Camera;
use crate::accel::{Kind, Shapes};
use crate::shape::{Bounds, Plane};

/// What is known of the light of a picture.
pub struct KnownLight {
    /// No light is brighter; infinite if that is unknown.
    pub max_radiance: f64,
    /// The light where no object is.
    pub background: Color,
    /// Whether no object can be seen in a pixel, row after row from the top; empty if that is unknown.
    pub without_objects: Vec<bool>,
}

impl KnownLight {
    /// Nothing is known but that no light is brighter.
    #[must_use]
    pub const fn up_to(max_radiance: f64) -> Self {
        Self {
            max_radiance,
            background: Color::BLACK,
            without_objects: Vec::new(),
        }
    }

    /// The light of these shapes before this background.
    pub(crate) fn of(
        max_radiance: f64,
        background: Color,
        shapes: &Shapes,
        camera: &Camera,
        size: Size,
    ) -> Self {
        Self {
            max_radiance,
            background,
            without_objects: without_shapes(shapes, camera, size).unwrap_or_default(),
        }
    }
}

/// Whether no shape can be seen in a pixel, row after row; none if that is unknown.
fn without_shapes(shapes: &Shapes, camera: &Camera, size: Size) -> Option<Vec<bool>> {
    let [width, height] = [size.width(), size.height()].map(|side| side as usize);
    // A rectangle adds 1 in its first row and column, and takes it off behind the last ones: the sum of
    // all changes from the upper left corner to a pixel is the number of rectangles that cover it.
    let stride = width + 1;
    let mut changes = vec![0_i32; stride * (height + 1)];
    let mut horizons = Vec::new();
    for (id, bounds) in shapes.bounds() {
        if id.kind == Kind::Plane {
            let plane = &shapes.planes.shapes[id.index as usize];
            horizons.push(Horizon::of(plane, camera, size)?);
            continue;
        }
        let [left, right, low, high] = rectangle(bounds, camera, size)?;
        let last_row = height as f64 - 1.0;
        let columns = covered(left, right, width);
        let rows = covered(last_row - high, last_row - low, height);
        for (row, sign) in [(rows.start, 1), (rows.end, -1)] {
            changes[row * stride + columns.start] += sign;
            changes[row * stride + columns.end] -= sign;
        }
    }
    let mut without_shapes = Vec::with_capacity(size.pixels());
    let mut above = vec![0; stride];
    for (row, changes) in changes.chunks_exact(stride).take(height).enumerate() {
        let mut rectangles = 0;
        for column in 0..width {
            above[column] += changes[column];
            rectangles += above[column];
            let (x, y) = (column as f64, (height - 1 - row) as f64);
            let is_below = |horizon: &Horizon| horizon.covers(x, y);
            without_shapes.push(rectangles == 0 && !horizons.iter().any(is_below));
        }
    }
    Some(without_shapes)
}

/// The pixels of a row or column of `side` pixels that reach from `min` to `max`.
fn covered(min: f64, max: f64, side: usize) -> std::ops::Range<usize> {
    let [min, max] = [min + 0.5, max + 1.5].map(|place| place.clamp(0.0, side as f64) as usize);
    min..max
}

/// The rectangle of the picture, in camera coordinates, that holds all that these bounds hold: left,
/// right, low and high. None if it is unknown, as where bounds reach behind the eye.
fn rectangle(bounds: Bounds, camera: &Camera, size: Size) -> Option<[f64; 4]> {
    let (Camera::Perspective { basis, .. } | Camera::Orthographic { basis, .. }) = camera else {
        return None;
    };
    let [width, height] = [size.width(), size.height()].map(f64::from);
    let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for corner in 0..8 {
        let coordinate = |axis: usize| [bounds.min, bounds.max][corner >> axis & 1][axis];
        let place = DVec3::new(coordinate(0), coordinate(1), coordinate(2));
        let to_corner = place - basis.e;
        // Pixels per unit at the depth of the corner.
        let pixels = match camera {
            Camera::Perspective { half_tangent, .. } => {
                let depth = -to_corner.dot(basis.w);
                let is_ahead = depth > 1e-6 * to_corner.length();
                [if is_ahead {
                    (height / 2.0) / half_tangent / depth
                } else {
                    f64::NAN
                }; 2]
            }
            Camera::Orthographic { scale, .. } => {
                let [across, up] = [width, height].map(|side| (side - 1.0).max(1.0));
                [across / (width / height * scale), up / scale]
            }
            Camera::Other(_) => return None,
        };
        let axes = [(basis.u, width), (basis.v, height)];
        for (i, (axis, side)) in axes.into_iter().enumerate() {
            let at = to_corner.dot(axis) * pixels[i] + (side - 1.0) / 2.0;
            // Far more than rounding moves it.
            let margin = 1e-6 + 1e-12 * pixels[i] * (place.length() + basis.e.length());
            if !(at + margin).is_finite() {
                return None;
            }
            min[i] = min[i].min(at - margin);
            max[i] = max[i].max(at + margin);
        }
    }
    Some([min[0], max[0], min[1], max[1]])
}

/// The side of a picture on which a plane is seen: at the camera coordinates `(x, y)` with
/// `right * x + up * y > least`.
struct Horizon {
    right: f64,
    up: f64,
    least: f64,
}

impl Horizon {
    /// None if it is unknown.
    fn of(plane: &Plane, camera: &Camera, size: Size) -> Option<Self> {
        let Camera::Perspective {
            basis,
            half_tangent,
        } = camera
        else {
            return None;
        };
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let distance = plane.normal.dot(plane.point - basis.e);
        let normal = plane.normal * distance.signum();
        let [right, up] = [normal.dot(basis.u), normal.dot(basis.v)];
        let ahead = -normal.dot(basis.w) * (height / 2.0) / half_tangent;
        // A ray meets the plane if its direction goes to the side of the plane.
        let middle = right * (width - 1.0) / 2.0 + up * (height - 1.0) / 2.0;
        // The corner of a pixel that is nearest to the plane, and far more than rounding.
        let nearest = (right.abs() + up.abs()) * (0.5 + 1e-6);
        let rounding = 1e-12 * (width + height + height / half_tangent);
        let least = middle - ahead - nearest - rounding;
        (distance != 0.0 && least.is_finite()).then_some(Self { right, up, least })
    }

    /// Whether the plane may be seen in the pixel with this middle.
    fn covers(&self, x: f64, y: f64) -> bool {
        self.right * x + self.up * y > self.least
    }
}

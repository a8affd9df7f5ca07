//! `Fisheye`: a camera that sees sideways and behind.

use crate::prelude::*;

/// A camera in which the distance from the middle of the picture is the angle from the gaze.
#[derive(Clone, Copy, Debug)]
pub struct Fisheye {
    basis: Basis,
    /// From the lower to the upper edge of the picture, in radians.
    angle: f64,
}

impl Fisheye {
    /// A camera that sees `angle` radians from the lower edge to the upper one.
    pub fn new(basis: Basis, angle: f64) -> Self {
        Self { basis, angle }
    }
}

/// The place (`x`, `y`) is at `((x - (w-1)/2), (y - (h-1)/2))` from the middle.
impl Camera for Fisheye {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let Basis { e, u, v, w } = self.basis;
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let (x, y) = (x - (width - 1.0) / 2.0, y - (height - 1.0) / 2.0);
        missing!("the direction of the ray", Ray::derived(e, -w), {
            // In the middle any direction is right, but 0 / 0 is none.
            let r = libm::hypot(x, y).max(f64::MIN_POSITIVE);
            let (sin, cos) = libm::sincos(r / height * self.angle);
            let aside = u * (x / r) + v * (y / r);
            Ray::derived(e, aside * sin - w * cos)
        })
    }
}

testing::examples! {
    let [gaze, up] = [Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0)];
    let basis = Basis::new(Point3::ORIGIN, gaze, up).unwrap();
    let camera = Fisheye::new(basis, PI);
    let direction = |x, y| direction(&camera, Size::new(8, 4).unwrap(), x, y);
    assert_close!(direction(3.5, 1.5), [0.0, 0.0, -1.0]);
    assert_close!(direction(3.5, 3.5), [0.0, 1.0, 0.0]);
    assert_close!(direction(5.5, 1.5), [1.0, 0.0, 0.0]);
    assert_close!(direction(7.5, 1.5), [0.0, 0.0, 1.0]);
}

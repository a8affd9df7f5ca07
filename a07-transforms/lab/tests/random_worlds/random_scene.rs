//! Random scenes whose numbers are extreme: zeros of both signs, subnormal and huge numbers, in
//! shapes and rays.
//!
//! A renderer that traces one ray after the other is hard to get wrong. The engine traces bundles
//! of rays through a tree, and decides for a bundle what its rays may meet: so the rays of these
//! scenes come in bundles that differ in nothing but such numbers, and meet more shapes than a leaf
//! of the tree holds.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, OrthographicCamera, PerspectiveCamera, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle};
use a04_lab::support::{Numbers, Triple, vector};
use common::{ArgumentError, Color, Size};

/// Zeros, and numbers that are 0 beside any other: subnormal ones, those that are subnormal or 0 in
/// single precision, and those whose reciprocal is infinite there.
const ALMOST_ZERO: [f64; 8] = [0.0, 0.0, 5e-324, 1e-310, 1e-200, 1e-46, 1e-40, 1e-31];

/// Units of length.
const UNITS: [f64; 10] = [1.0, 1.0, 1.0, 1.0, 1.0, 1e-90, 1e-30, 1e-6, 1e6, 1e90];

/// Random numbers, and the place of a scene.
pub struct Place {
    /// The numbers.
    pub numbers: Numbers,
    unit: f64,
    middle: Vector3,
    /// The axis that most walls and rays face.
    axis: usize,
    /// Whether some coordinates are far outside of the scene.
    has_huge: bool,
}

impl Place {
    /// The place of the scene with this number.
    pub fn new(seed: u64) -> Self {
        let mut numbers = Numbers::new(seed, 0);
        let unit = UNITS[numbers.below(UNITS.len())];
        let middle = match numbers.below(5) {
            0 => numbers.triple(-1e6, 1e6) * unit,
            _ => Vector3::default(),
        };
        let axis = numbers.below(3);
        let has_huge = numbers.below(8) == 0;
        Self {
            numbers,
            unit,
            middle,
            axis,
            has_huge,
        }
    }

    /// A number with a sign of its own.
    pub fn signed(&mut self, magnitude: f64) -> f64 {
        if self.numbers.below(2) == 0 {
            magnitude
        } else {
            -magnitude
        }
    }

    /// 0 of either sign, or almost 0.
    pub fn almost_zero(&mut self) -> f64 {
        let magnitude = ALMOST_ZERO[self.numbers.below(ALMOST_ZERO.len())];
        self.signed(magnitude)
    }

    /// A coordinate in units: mostly halves up to 2, so that shapes and rays meet along axes, in
    /// edges and in corners.
    fn coordinate(&mut self) -> f64 {
        if self.has_huge && self.numbers.below(30) == 0 {
            let magnitude = [1e12, 1e31, 1e39, 1e100 / self.unit][self.numbers.below(4)];
            return self.signed(magnitude);
        }
        match self.numbers.below(8) {
            0 => self.almost_zero(),
            1 => self.numbers.between(-2.0, 2.0),
            _ => {
                let halves = self.numbers.below(5) as f64;
                self.signed(halves / 2.0)
            }
        }
    }

    /// A point at these coordinates, in units from the middle. A 0 keeps its sign in a scene
    /// whose middle is the origin.
    pub fn at(&self, coordinates: Triple) -> Point3 {
        let middle = self.middle.to_glam().to_array();
        let at = |axis: usize| {
            let from_middle = coordinates[axis] * self.unit;
            if middle[axis] == 0.0 {
                from_middle
            } else {
                middle[axis] + from_middle
            }
        };
        Point3::new(at(0), at(1), at(2))
    }

    /// A random point.
    pub fn point(&mut self) -> Point3 {
        let coordinates = std::array::from_fn(|_| self.coordinate());
        self.at(coordinates)
    }

    /// A direction of any length, in half of all cases along an axis, or almost.
    pub fn direction(&mut self) -> Vector3 {
        let axis = self.numbers.below(6);
        vector(std::array::from_fn(|i| match axis {
            0..3 if i == axis => self.signed(1.0),
            0..3 => self.almost_zero(),
            _ => self.coordinate().clamp(-2.0, 2.0),
        }))
    }

    /// A length of the scene.
    pub fn length(&mut self) -> f64 {
        self.unit * [0.25, 0.5, 1.0, 0.7][self.numbers.below(4)]
    }

    /// A colour.
    pub fn color(&mut self) -> Color {
        let [r, g, b] = [(); 3].map(|()| self.numbers.between(0.0, 1.0));
        Color::new(r, g, b)
    }

    /// A random shape, most of them small.
    fn shape(&mut self) -> Result<Box<dyn Geometry>, ArgumentError> {
        let (a, b, c) = (self.point(), self.point(), self.point());
        Ok(match self.numbers.below(12) {
            0 => Box::new(Plane::new(a, self.direction().as_normal())?),
            1..4 => Box::new(Sphere::new(a, self.length())?),
            4..8 => Box::new(AxisAlignedBox::new(a, b)?),
            8 => {
                let normals: [Normal3; 3] = std::array::from_fn(|_| self.direction().as_normal());
                Box::new(Triangle::new(a, b, c)?.with_normals(normals)?)
            }
            _ => Box::new(Triangle::new(a, b, c)?),
        })
    }

    /// A wall of shapes side by side, with gaps, mostly across the axis of the scene: rays along
    /// this axis that it mirrors stay neighbours, and others go on to the wall behind it.
    fn wall(&mut self) -> Result<Vec<Box<dyn Geometry>>, ArgumentError> {
        let axis = match self.numbers.below(5) {
            0 => self.numbers.below(3),
            _ => self.axis,
        };
        let depth = self.coordinate().clamp(-2.0, 2.0);
        let mut shapes: Vec<Box<dyn Geometry>> = Vec::new();
        for cell in 0..16 {
            let [right, up] = [cell / 4, cell % 4].map(|i| f64::from(i) - 2.0);
            let height = depth + self.numbers.below(2) as f64 / 4.0;
            let at = |x: f64, y: f64, z: f64| {
                let mut coordinates = [z; 3];
                coordinates[(axis + 1) % 3] = right + x;
                coordinates[(axis + 2) % 3] = up + y;
                self.at(coordinates)
            };
            let low = at(0.0, 0.0, height);
            let [right, across, up] = [
                at(1.0, 0.0, height),
                at(1.0, 1.0, height),
                at(0.0, 1.0, height),
            ];
            let (high, middle) = (at(1.0, 1.0, height + 0.1), at(0.5, 0.5, height));
            match self.numbers.below(6) {
                0 => shapes.push(Box::new(AxisAlignedBox::new(low, high)?)),
                1 => shapes.push(Box::new(AxisAlignedBox::new(low, across)?)),
                2 => shapes.push(Box::new(Sphere::new(middle, 0.3 * self.unit)?)),
                3 => {
                    shapes.push(Box::new(Triangle::new(low, right, across)?));
                    shapes.push(Box::new(Triangle::new(low, across, up)?));
                }
                _ => {}
            }
        }
        Ok(shapes)
    }

    /// The shapes of a scene: walls and single ones. In most scenes a shape far away makes the
    /// others small beside the whole, so that the engine bundles rays that meet several of them.
    pub fn shapes(&mut self) -> Vec<Box<dyn Geometry>> {
        let (walls, single) =
            [(0, 8), (1, 10), (3, 20), (4, 6), (6, 0), (2, 40)][self.numbers.below(6)];
        let walls: Vec<_> = (0..walls).filter_map(|_| self.wall().ok()).collect();
        let mut shapes: Vec<_> = walls.into_iter().flatten().collect();
        shapes.extend((0..single).filter_map(|_| self.shape().ok()));
        if self.numbers.below(4) > 0 {
            let far = self.signed(50.0);
            let corner = self.at([far, far, far]);
            if let Ok(sphere) = Sphere::new(corner, self.length()) {
                shapes.push(Box::new(sphere));
            }
        }
        shapes
    }

    /// A camera: of bundles, or one of the lesson's.
    pub fn camera(&mut self, seed: u64) -> Result<Box<dyn Camera>, ArgumentError> {
        let (eye, gaze, up) = (self.point(), self.direction(), self.direction());
        Ok(match self.numbers.below(4) {
            0 => Box::new(OrthographicCamera::new(eye, gaze, up, 4.0 * self.unit)?),
            1 => Box::new(PerspectiveCamera::new(eye, gaze, up, 0.7)?),
            _ => Box::new(Bundles { seed }),
        })
    }
}

/// A camera of bundles: the rays of up to 32 neighbouring columns and two rows start side by side,
/// and their directions differ in numbers near 0.
struct Bundles {
    seed: u64,
}

impl Camera for Bundles {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        let (column, row) = (x as usize, y as usize);
        let mut place = Place::new(self.seed);
        let columns = [8, 16, 32, 32][place.numbers.below(4)];
        // The numbers of all rays of a bundle.
        place.numbers = Numbers::new(self.seed, 1 + (row / 2) * 8 + column / columns);
        let width = [0.0, 1e-9, 0.2, 1.0, 3.0][place.numbers.below(5)];
        let axis = match place.numbers.below(5) {
            0 => place.numbers.below(3),
            _ => place.axis,
        };
        let (from, gaze) = (place.point(), place.direction());
        let is_along_axis = place.numbers.below(4) > 0;
        let forwards = place.signed(1.0);
        // What stands for 0 along each axis: zeros of both signs alone, or beside numbers of one
        // sign or of both.
        let beside_zero: [usize; 3] = std::array::from_fn(|_| place.numbers.below(6));
        // The numbers of this ray.
        place.numbers = Numbers::new(self.seed + 1, row * 64 + column);
        let mut aside = [0.0; 3];
        aside[(axis + 1) % 3] = width * (column % columns) as f64 / columns as f64;
        aside[(axis + 2) % 3] = width * (row % 2) as f64 / columns as f64;
        let from = if width == 0.0 {
            from
        } else {
            from + vector(aside) * place.unit
        };
        let gaze = gaze.to_glam().to_array();
        let direction: Triple = std::array::from_fn(|i| {
            if is_along_axis && i == axis {
                forwards
            } else if is_along_axis || gaze[i].abs() < 1e-30 {
                let number = place.almost_zero();
                match beside_zero[i] {
                    0 if number != 0.0 => number.abs(),
                    1 if number != 0.0 => -number.abs(),
                    2 => number,
                    _ => 0.0_f64.copysign(number),
                }
            } else {
                gaze[i]
            }
        });
        Ray::new(from, vector(direction))
            .unwrap_or(Ray::derived(from, Vector3::new(-0.0, 0.0, -1.0)))
    }
}

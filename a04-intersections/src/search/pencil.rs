//! `Pencil`: all rays that pass through one point, or all that are parallel.
//!
//! Most rays of a picture are of a pencil: those from the eye, and those to each
//! light. What can be met along them is found before the first ray: seen from
//! the point, space is parted into cells like the pixels of a picture, and each
//! keeps a list of the shapes that it shows.
//!
//! (For eyes this is Weghorst, Hooper and Greenberg's item buffer, Improved
//! Computational Methods for Ray Tracing, 1984; for lights the light buffer of
//! Haines and Greenberg, The Light Buffer: A Shadow-Testing Accelerator, 1986.)

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Focus, Ray};
use glam::DVec3;

use super::shapes::Shape;
use crate::{Bounds, Interval};

/// The cells of a pencil.
#[derive(Debug)]
pub struct Pencil {
    focus: Focus,
    /// To the right and up in the picture of cells, and into it.
    right: DVec3,
    up: DVec3,
    gaze: DVec3,
    /// Where the first cell begins, and how many there are in a unit.
    from: [f64; 2],
    per_unit: [f64; 2],
    side: usize,
    /// What a length is multiplied by to be in the unit of the pencil, in which
    /// all coordinates are up to 1.
    per_length: f64,
    /// How far a ray may pass from the focus and still be of the pencil.
    tolerance: f64,
    /// The largest coordinate that a ray may start at.
    reach: f64,
    starts: Vec<u32>,
    entries: Vec<Entry>,
}

/// A shape in a cell.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// No point of the shape is nearer to the focus, or earlier on its rays, in
    /// the unit of the pencil.
    pub near: f32,
    pub shape: Shape,
}

/// What is to be seen of a shape, and between which places.
type Appearance = (Entry, [f64; 2], [f64; 2]);

/// Bounds are made so much wider, relative to the largest coordinate: more than
/// the way by which rounding moves a hit, and by which a ray that leaves a
/// surface is lifted off it.
const SLACK: f64 = 1.0 / (1_u64 << 30) as f64;
/// Rays may start so many times farther out than shapes and focus lie.
const REACH: f64 = 16_384.0;

impl Pencil {
    /// The cells of these shapes, which have finite bounds. None if the focus
    /// does not see all of them on one side.
    pub fn new(focus: Focus, shapes: &[(Bounds, Shape)]) -> Option<Self> {
        let all = Bounds::of_all(shapes.iter().map(|(bounds, _)| *bounds));
        let middle = DVec3::from(all.middle());
        let (gaze, at) = match focus {
            Focus::Point(point) => (middle - point.to_glam(), point.largest_coordinate()),
            Focus::Direction(direction) => (direction.to_glam(), 0.0),
        };
        let gaze = Vector3::from_glam(gaze).normalized()?.to_glam();
        let corners = all.corners().map(Point3::largest_coordinate);
        let largest = corners.into_iter().fold(at, f64::max);
        let right = gaze.any_orthonormal_vector();
        let mut pencil = Self {
            focus,
            right,
            up: gaze.cross(right),
            gaze,
            from: [0.0; 2],
            per_unit: [0.0; 2],
            side: 0,
            per_length: 1.0 / largest,
            tolerance: largest * SLACK / 2.0,
            reach: largest * REACH,
            starts: Vec::new(),
            entries: Vec::new(),
        };

        let appearance = |(bounds, shape): &(Bounds, Shape)| {
            let bounds = bounds.wider(largest * SLACK);
            let (from, to) = pencil.extent(bounds)?;
            let near = pencil.nearest(bounds);
            Some((
                Entry {
                    near,
                    shape: *shape,
                },
                from,
                to,
            ))
        };
        let mut appearances: Vec<Appearance> =
            shapes.iter().map(appearance).collect::<Option<_>>()?;
        // Near ones come first, so that a search can end early.
        appearances.sort_by(|(a, ..), (b, ..)| a.near.total_cmp(&b.near));
        pencil.fill(&appearances)?;
        Some(pencil)
    }

    /// Enters each shape into all cells that show some of it.
    fn fill(&mut self, appearances: &[Appearance]) -> Option<()> {
        self.from = [0, 1].map(|axis| {
            let from = appearances.iter().map(|(_, from, _)| from[axis]);
            from.fold(f64::INFINITY, f64::min)
        });
        let extent = [0, 1].map(|axis| {
            let to = appearances.iter().map(|(.., to)| to[axis]);
            to.fold(f64::NEG_INFINITY, f64::max) - self.from[axis]
        });

        // About sixteen cells a shape, but fewer where shapes fill many.
        self.side = (4.0 * (appearances.len() as f64).sqrt()).clamp(64.0, 1024.0) as usize;
        let counts = loop {
            self.per_unit = extent.map(|extent| self.side as f64 / extent);
            if !self.per_unit.iter().all(|per_unit| per_unit.is_finite()) {
                return None;
            }
            let mut counts = vec![0_u32; self.side * self.side + 1];
            let mut total = 0;
            for (_, from, to) in appearances {
                for cell in self.cells(*from, *to) {
                    counts[cell + 1] += 1;
                    total += 1;
                }
            }
            if total <= 16 * (appearances.len() + 4096) || self.side == 1 {
                break counts;
            }
            self.side /= 2;
        };

        self.starts = counts;
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let nothing = Entry {
            near: 0.0,
            shape: Shape::Other(u32::MAX),
        };
        self.entries = vec![nothing; *self.starts.last()? as usize];
        let mut next = self.starts.clone();
        for (entry, from, to) in appearances {
            for cell in self.cells(*from, *to) {
                self.entries[next[cell] as usize] = *entry;
                next[cell] += 1;
            }
        }
        Some(())
    }

    /// The cells between two places.
    fn cells(&self, from: [f64; 2], to: [f64; 2]) -> impl Iterator<Item = usize> + use<> {
        let side = self.side;
        let cell = |place: [f64; 2]| {
            [0, 1].map(|axis| {
                let cell = (place[axis] - self.from[axis]) * self.per_unit[axis];
                (cell as usize).min(side - 1)
            })
        };
        let ([left, low], [right, high]) = (cell(from), cell(to));
        (low..=high).flat_map(move |y| (left..=right).map(move |x| y * side + x))
    }

    /// Where a point appears in the picture of cells. None beside and behind
    /// the focus.
    #[inline]
    fn place(&self, p: DVec3) -> Option<[f64; 2]> {
        let (x, y) = (p.dot(self.right), p.dot(self.up));
        match self.focus {
            Focus::Point(_) => {
                let depth = p.dot(self.gaze);
                (depth > 0.0).then(|| [x / depth, y / depth])
            }
            Focus::Direction(_) => Some([x, y]),
        }
    }

    /// The point as it is seen from the focus.
    #[inline]
    fn seen(&self, p: Point3) -> DVec3 {
        match self.focus {
            Focus::Point(focus) => (p - focus).to_glam(),
            Focus::Direction(_) => p.to_glam(),
        }
    }

    /// Between which places bounds appear. None if they are not well in front.
    fn extent(&self, bounds: Bounds) -> Option<([f64; 2], [f64; 2])> {
        let (mut from, mut to) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for corner in bounds.corners() {
            let p = self.seen(corner);
            // Beyond some 80 degrees the cells would be too unequal.
            if matches!(self.focus, Focus::Point(_)) && p.dot(self.gaze) < 0.15 * p.length() {
                return None;
            }
            let place = self.place(p)?;
            for axis in 0..2 {
                from[axis] = from[axis].min(place[axis]);
                to[axis] = to[axis].max(place[axis]);
            }
        }
        Some((from, to))
    }

    /// How near to the focus bounds come, or how early on its rays.
    fn nearest(&self, bounds: Bounds) -> f32 {
        let near = match self.focus {
            Focus::Point(focus) => {
                let focus = focus.to_glam();
                let inside = focus.clamp(bounds.min.into(), bounds.max.into());
                (inside - focus).length()
            }
            Focus::Direction(_) => {
                let depths = bounds
                    .corners()
                    .map(|corner| corner.to_glam().dot(self.gaze));
                depths.into_iter().fold(f64::INFINITY, f64::min)
            }
        };
        ((near - near.abs() / 1e6) * self.per_length) as f32
    }

    /// What a ray that comes from the focus may meet, near ones first, and how
    /// near a `t` of the ray is. None if it is not of the pencil.
    #[inline]
    pub fn outwards(&self, ray: &Ray) -> Option<(&[Entry], impl Fn(f64) -> f64)> {
        let (o, d) = (ray.origin(), ray.direction());
        let (p, start) = match self.focus {
            Focus::Point(focus) if o == focus => (d.to_glam(), 0.0),
            Focus::Direction(direction) if d == direction && self.reaches(o) => {
                (o.to_glam(), o.to_glam().dot(self.gaze))
            }
            _ => return None,
        };
        let near = move |t: f64| (start + t) * self.per_length;
        Some((self.entries(p), near))
    }

    /// What a ray that goes to the focus, and ends there, may meet: nothing that
    /// is farther from the focus than its start. None if it is not of the pencil.
    #[inline]
    pub fn inwards(&self, ray: &Ray, within: Interval) -> Option<impl Iterator<Item = Shape>> {
        let (o, d) = (ray.origin(), ray.direction().to_glam());
        let p = self.seen(o);
        let start = match self.focus {
            Focus::Point(_) => {
                // Where the ray comes nearest to the focus.
                let t = -p.dot(d);
                let passes = (p + d * t).abs().max_element() <= self.tolerance;
                (passes && within.max <= t + self.tolerance).then_some(t)
            }
            Focus::Direction(direction) => (d == -direction.to_glam()).then(|| p.dot(self.gaze)),
        };
        let start = start.filter(|_| self.reaches(o))? * self.per_length;
        let between = self.entries(p).iter();
        let between = between.take_while(move |entry| f64::from(entry.near) <= start);
        Some(between.map(|entry| entry.shape))
    }

    #[inline]
    fn reaches(&self, point: Point3) -> bool {
        point.largest_coordinate() < self.reach
    }

    /// The shapes that a point of the pencil's picture may show.
    #[inline]
    fn entries(&self, p: DVec3) -> &[Entry] {
        let Some([x, y]) = self.place(p) else {
            return &[];
        };
        let x = (x - self.from[0]) * self.per_unit[0];
        let y = (y - self.from[1]) * self.per_unit[1];
        let side = self.side as f64;
        if !((0.0..side).contains(&x) && (0.0..side).contains(&y)) {
            return &[];
        }
        let cell = y as usize * self.side + x as usize;
        &self.entries[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }
}

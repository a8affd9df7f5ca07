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

use a02_math::vector3x4::select;
use a02_math::{Lanes, Point3, Vector3, Vector3x4};
use a03_rays_cameras::{Focus, Ray, RayPacket};
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
    /// How wide the narrowest is that each cell shows some of, unless many are there
    /// together.
    narrowest: Vec<f32>,
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
/// So many shapes in a cell may each be alone. Where there are more, as in a mesh or
/// a crowd, rays that miss one meet another.
const ALONE: usize = 3;
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
            narrowest: Vec::new(),
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
            if total <= 16 * (appearances.len() + 4096) {
                break counts;
            }
            self.side /= 2;
        };

        self.starts = counts;
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let end = *self.starts.last()?;
        self.starts.push(end);
        let nothing = Entry {
            near: 0.0,
            shape: Shape::Other(u32::MAX),
        };
        self.entries = vec![nothing; *self.starts.last()? as usize];
        let mut next = self.starts.clone();
        self.narrowest = vec![f32::INFINITY; self.side * self.side];
        for (entry, from, to) in appearances {
            // Only a sphere is as wide as its bounds, from wherever it is seen.
            let width = match entry.shape {
                Shape::Sphere(_) => (to[0] - from[0]).min(to[1] - from[1]) as f32,
                _ => 0.0,
            };
            for cell in self.cells(*from, *to) {
                self.entries[next[cell] as usize] = *entry;
                next[cell] += 1;
                self.narrowest[cell] = self.narrowest[cell].min(width);
            }
        }
        for cell in 0..self.narrowest.len() {
            if self.entries_of(cell).len() > ALONE {
                self.narrowest[cell] = f32::INFINITY;
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
        let points = bounds.corners().map(|corner| self.seen(corner));
        // Beyond some 80 degrees the cells would be too unequal.
        let is_aside = |p: &DVec3| p.dot(self.gaze) < 0.15 * p.length();
        if matches!(self.focus, Focus::Point(_)) && points.iter().any(is_aside) {
            return None;
        }
        self.around(&points)
    }

    /// Between which places points appear.
    fn around(&self, points: &[DVec3]) -> Option<([f64; 2], [f64; 2])> {
        let (mut from, mut to) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            let place = self.place(*point)?;
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

    /// Whether a shape may be seen between four rays from the focus, the corners of a
    /// square, that is alone and narrower than this share of its side. None if they
    /// are not of the pencil.
    pub fn may_hide(&self, corners: &[Ray; 4], narrow: f64) -> Option<bool> {
        let Focus::Point(focus) = self.focus else {
            return None;
        };
        if corners.iter().any(|ray| ray.origin() != focus) {
            return None;
        }
        let directions = corners.each_ref().map(|ray| ray.direction().to_glam());
        let (from, to) = self.around(&directions)?;
        let narrow = narrow * (to[0] - from[0]).max(to[1] - from[1]);
        let is_beside = |axis: usize| {
            let end = self.from[axis] + self.side as f64 / self.per_unit[axis];
            to[axis] < self.from[axis] || from[axis] > end
        };
        if is_beside(0) || is_beside(1) {
            return Some(false);
        }
        let mut cells = self.cells(from, to);
        Some(cells.any(|cell| f64::from(self.narrowest[cell]) < narrow))
    }

    /// What each of four rays that come from the focus may meet. None if any of
    /// those in the lanes of the mask is not of the pencil.
    #[inline]
    pub fn outwards_together(&self, rays: &RayPacket, active: u32) -> Option<Cells<'_>> {
        let (o, d) = (rays.origin, rays.direction);
        let (p, start) = match self.focus {
            Focus::Point(focus) if is_all(o, focus.to_glam(), active) => (d, Lanes::ZERO),
            Focus::Direction(direction) if is_all(d, direction.to_glam(), active) => {
                let reach = Lanes::splat(self.reach);
                let reaches = o.largest_coordinate().simd_lt(reach).to_bitmask();
                let start = o.dot(Vector3x4::splat(self.gaze));
                (active & !reaches == 0).then_some((o, start))?
            }
            _ => return None,
        };
        Some(self.cells_together(p, start, active))
    }

    /// What each of four rays that go to the focus, and end there, may meet.
    /// None if any of those in the lanes of the mask is not of the pencil.
    #[inline]
    pub fn inwards_together(&self, rays: &RayPacket, max: Lanes, active: u32) -> Option<Cells<'_>> {
        let (o, d) = (rays.origin, rays.direction);
        let (p, start) = match self.focus {
            Focus::Point(focus) => {
                let p = o - Vector3x4::splat(focus.to_glam());
                let t = -p.dot(d);
                let tolerance = Lanes::splat(self.tolerance);
                let beside = (p + d * t).largest_coordinate();
                let passes = beside.simd_le(tolerance) & max.simd_le(t + tolerance);
                (active & !passes.to_bitmask() == 0).then_some((p, t))?
            }
            Focus::Direction(direction) => {
                let is_parallel = is_all(d, -direction.to_glam(), active);
                let start = o.dot(Vector3x4::splat(self.gaze));
                is_parallel.then_some((o, start))?
            }
        };
        let reach = Lanes::splat(self.reach);
        let reaches = o.largest_coordinate().simd_lt(reach).to_bitmask();
        (active & !reaches == 0).then(|| self.cells_together(p, start, active))
    }

    #[inline]
    fn cells_together(&self, p: Vector3x4, start: Lanes, active: u32) -> Cells<'_> {
        Cells {
            pencil: self,
            of_rays: self.cells_of(p),
            active,
            start: start * Lanes::splat(self.per_length),
        }
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
        self.entries_of(self.cell(x, y))
    }

    /// The cells that four points of the pencil's picture are in.
    #[inline]
    fn cells_of(&self, p: Vector3x4) -> [usize; 4] {
        let mut x = p.dot(Vector3x4::splat(self.right));
        let mut y = p.dot(Vector3x4::splat(self.up));
        if let Focus::Point(_) = self.focus {
            let depth = p.dot(Vector3x4::splat(self.gaze));
            // Behind the focus they are nowhere.
            let depth = select(depth.simd_gt(Lanes::ZERO), depth, Lanes::splat(f64::NAN));
            (x, y) = (x / depth, y / depth);
        }
        let x = (x - Lanes::splat(self.from[0])) * Lanes::splat(self.per_unit[0]);
        let y = (y - Lanes::splat(self.from[1])) * Lanes::splat(self.per_unit[1]);
        let (x, y) = (x.to_array(), y.to_array());
        let cell = |lane: usize| self.cell(x[lane], y[lane]);
        [cell(0), cell(1), cell(2), cell(3)]
    }

    /// The cell at a place counted in cells: beside all, the empty one behind the
    /// last.
    #[inline]
    fn cell(&self, x: f64, y: f64) -> usize {
        let side = self.side as f64;
        if (0.0..side).contains(&x) && (0.0..side).contains(&y) {
            (y as u32 * self.side as u32 + x as u32) as usize
        } else {
            self.side * self.side
        }
    }

    /// The shapes that a cell may show.
    #[inline]
    fn entries_of(&self, cell: usize) -> &[Entry] {
        &self.entries[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }
}

/// What four rays of a pencil may meet.
pub struct Cells<'a> {
    pencil: &'a Pencil,
    /// The cell of each ray.
    of_rays: [usize; 4],
    active: u32,
    /// How near the starts of the rays are: what goes to the focus meets nothing
    /// that is farther away.
    pub start: Lanes,
}

impl<'a> Cells<'a> {
    /// The entries of the next cell, and a bit for each ray that is in it.
    #[inline]
    pub fn next(&mut self) -> Option<(&'a [Entry], u32)> {
        if self.active == 0 {
            return None;
        }
        let cell = self.of_rays[self.active.trailing_zeros() as usize % 4];
        let is_in = |lane: usize| u32::from(self.of_rays[lane] == cell) << lane;
        let lanes = self.active & (is_in(0) | is_in(1) | is_in(2) | is_in(3));
        self.active &= !lanes;
        Some((self.pencil.entries_of(cell), lanes))
    }

    /// How near an entry must be that rays from the focus meet before `t`.
    #[inline]
    pub fn near(&self, t: Lanes) -> Lanes {
        self.start + t * Lanes::splat(self.pencil.per_length)
    }
}

/// Whether all vectors in the lanes of the mask are this one.
#[inline]
fn is_all(vectors: Vector3x4, one: DVec3, active: u32) -> bool {
    let one = Vector3x4::splat(one);
    let same = vectors.x.simd_eq(one.x) & vectors.y.simd_eq(one.y) & vectors.z.simd_eq(one.z);
    active & !same.to_bitmask() == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    const EYE: Focus = Focus::Point(Point3::ORIGIN);

    /// A cube of this size with its middle there.
    fn cube(size: f64, middle: [f64; 3]) -> (Bounds, Shape) {
        let bounds = Bounds {
            min: middle.map(|x| x - size / 2.0),
            max: middle.map(|x| x + size / 2.0),
        };
        (bounds, Shape::Sphere(0))
    }

    fn side(shapes: &[(Bounds, Shape)]) -> usize {
        Pencil::new(EYE, shapes).expect("a pencil").side
    }

    /// 30² shapes, each of them in few cells: 120² are sixteen for each.
    #[test]
    fn there_are_sixteen_cells_for_a_shape() {
        let shapes: Vec<_> = (0..900)
            .map(|i| cube(1e-3, [f64::from(i % 30), f64::from(i / 30), -100.0]))
            .collect();
        assert_eq!(side(&shapes), 120);
        assert_eq!(side(&shapes[..9]), 64, "not too few");
    }

    /// Each of these is in all 64² cells: 16 make 16 · 4096 entries, which are as
    /// many as there may be for none and sixteen more for each.
    #[test]
    fn where_shapes_fill_many_cells_there_are_fewer() {
        assert_eq!(side(&[cube(1.0, [0.0, 0.0, -10.0]); 16]), 64);
        assert_eq!(side(&[cube(1.0, [0.0, 0.0, -10.0]); 17]), 32);
    }

    /// Shapes on both sides, at such angles to the gaze between them: some 80
    /// degrees are the most, however large the scene is.
    #[test]
    fn what_is_too_far_aside_makes_no_cells() {
        for size in [1e-3, 1.0, 1e3] {
            let is_seen = |degrees: f64| {
                let angle = degrees.to_radians();
                let (before, aside) = (size * libm::cos(angle), size * libm::sin(angle));
                let one = |aside| cube(size * 1e-3, [aside, 0.0, -before]);
                Pencil::new(EYE, &[one(aside), one(-aside)]).is_some()
            };
            assert_eq!(
                [30.0, 80.0, 83.0, 89.0].map(is_seen),
                [true, true, false, false]
            );
        }
    }

    /// A rectangle 1 in front of the eye, where places are coordinates.
    fn flat([left, low]: [f64; 2], [right, high]: [f64; 2]) -> (Bounds, Shape) {
        let bounds = Bounds {
            min: [left, low, -1.0],
            max: [right, high, -1.0],
        };
        (bounds, Shape::Sphere(0))
    }

    /// Fills the picture of cells, 64 x 64 of them, each 1/32 wide: wide, and so hides
    /// nowhere.
    fn wall() -> (Bounds, Shape) {
        flat([-1.0, -1.0], [1.0, 1.0])
    }

    /// Rays from the eye to the corners of a rectangle 1 in front of it.
    fn corners([left, low]: [f64; 2], [right, high]: [f64; 2]) -> [Ray; 4] {
        [(left, high), (right, high), (left, low), (right, low)]
            .map(|(x, y)| Ray::derived(Point3::ORIGIN, Vector3::new(x, y, -1.0)))
    }

    /// Whether one of the shapes may hide in a square whose lower left corner is there.
    fn hides(shapes: &[(Bounds, Shape)], [left, low]: [f64; 2], side: f64, narrow: f64) -> bool {
        let corners = corners([left, low], [left + side, low + side]);
        let pencil = Pencil::new(EYE, shapes).expect("a pencil");
        let may_hide = pencil.may_hide(&corners, narrow);
        may_hide.expect("rays of the pencil")
    }

    /// Its face is 10 away and 1 wide, so that it appears 0.1 wide, which is a twentieth
    /// of a square of side 2.
    #[test]
    fn a_cube_hides_if_it_is_narrower_than_the_share_of_the_square() {
        let alone = [cube(1.0, [0.0, 0.0, -10.5])];
        for at in [[-1.0, -1.0], [0.02, -1.0], [-1.0, 0.02], [-2.02, -2.02]] {
            assert!(hides(&alone, at, 2.0, 0.0501), "{at:?}");
            assert!(!hides(&alone, at, 2.0, 0.0499), "{at:?}");
        }
        assert!(hides(&alone, [-2.0, -2.0], 4.0, 0.0251));
        assert!(!hides(&alone, [-2.0, -2.0], 4.0, 0.0249));
    }

    /// A camera that is turned sees the square turned, too.
    #[test]
    fn of_what_is_no_square_the_longer_side_counts() {
        let pencil = Pencil::new(EYE, &[cube(1.0, [0.0, 0.0, -10.5])]).expect("a pencil");
        for (from, to) in [([-1.0, -0.2], [1.0, 0.2]), ([-0.2, -1.0], [0.2, 1.0])] {
            let corners = corners(from, to);
            let hides = [0.0501, 0.0499].map(|narrow| pencil.may_hide(&corners, narrow));
            assert_eq!(hides, [Some(true), Some(false)]);
        }
    }

    /// Both are 0.1 on one side and 0.6 on the other, which is an eighth of the square
    /// and three quarters.
    #[test]
    fn what_is_narrow_one_way_hides() {
        let upright = flat([0.5, 0.3], [0.6, 0.9]);
        let lying = flat([0.3, 0.5], [0.9, 0.6]);
        let (Bounds { min, max }, shape) = wall();
        let [min, max] = [min, max].map(|corner| corner.map(|x| 2.0 * x));
        let far_wall = (Bounds { min, max }, shape);
        for stick in [upright, lying] {
            // Seen from the eye, one wall comes before the stick, the other behind it.
            for shapes in [[stick, wall()], [stick, far_wall]] {
                assert!(hides(&shapes, [0.2, 0.2], 0.8, 0.126));
                assert!(!hides(&shapes, [0.2, 0.2], 0.8, 0.124));
            }
        }
    }

    /// It is in the cells that begin at 3/32 and end at 7/32, both ways.
    #[test]
    fn a_shape_hides_in_the_cells_that_show_it() {
        let shapes = [wall(), flat([0.1, 0.1], [0.2, 0.2])];
        let hides = |at| hides(&shapes, at, 0.5, 1.0);
        for inside in [[-0.1, -0.1], [-0.39, 0.19], [0.19, 0.19], [0.19, -0.39]] {
            assert!(hides(inside), "{inside:?}");
        }
        for beside in [0.22, 0.3, -0.41, -0.5] {
            for across in [-0.39, -0.1, 0.19] {
                assert!(!hides([beside, across]), "{beside}, {across}");
                assert!(!hides([across, beside]), "{across}, {beside}");
            }
            assert!(!hides([beside, beside]), "{beside}");
        }
    }

    /// The cells end where it does: squares that reach beyond still find it.
    #[test]
    fn nothing_hides_beside_all() {
        let upright = flat([-0.1, -0.2], [0.1, 0.2]);
        let lying = flat([-0.2, -0.1], [0.2, 0.1]);
        for (alone, [x, y]) in [(upright, [0.1, 0.2]), (lying, [0.2, 0.1])] {
            let hides = |at| hides(&[alone], at, 2.0, 0.2);
            for (beyond, is_in) in [(0.01, false), (-0.01, true)] {
                let (right, above) = (x + beyond, y + beyond);
                let (left, below) = (-2.0 - right, -2.0 - above);
                for at in [[right, -1.0], [left, -1.0], [-1.0, above], [-1.0, below]] {
                    assert_eq!(hides(at), is_in, "{at:?}");
                }
                for at in [[right, above], [right, below], [left, above], [left, below]] {
                    assert_eq!(hides(at), is_in, "{at:?}");
                }
            }
        }
    }

    #[test]
    fn up_to_three_in_a_cell_may_hide() {
        let hides = |count| {
            let shapes = vec![cube(1.0, [0.0, 0.0, -10.5]); count];
            hides(&shapes, [-1.0, -1.0], 2.0, 0.1)
        };
        assert_eq!([1, 2, 3, 4, 5].map(hides), [true, true, true, false, false]);
    }

    /// A band 0.05 high that is one of two to the left and one of four to the right.
    #[test]
    fn a_crowd_hides_nothing_where_it_is() {
        let band = flat([-0.9, 0.0], [0.9, 0.05]);
        let right = flat([0.1, -1.0], [1.0, 1.0]);
        let hides = |left| hides(&[wall(), right, band, right], [left, -0.4], 0.6, 0.1);
        assert_eq!([-0.9, -0.3, 0.2].map(hides), [true, true, false]);
    }

    #[test]
    fn nothing_is_known_of_rays_from_elsewhere() {
        let pencil = Pencil::new(EYE, &[cube(1.0, [0.0, 0.0, -10.5])]).expect("a pencil");
        let of_pencil = corners([-1.0, -1.0], [1.0, 1.0]);
        assert_eq!(pencil.may_hide(&of_pencil, 0.1), Some(true));
        for i in 0..4 {
            let mut corners = of_pencil;
            let beside = Point3::new(0.0, 1e-12, 0.0);
            corners[i] = Ray::derived(beside, corners[i].direction());
            assert_eq!(pencil.may_hide(&corners, 0.1), None, "corner {i}");
        }
    }

    #[test]
    fn nothing_is_known_of_rays_that_look_back() {
        let pencil = Pencil::new(EYE, &[cube(1.0, [0.0, 0.0, -10.5])]).expect("a pencil");
        for i in 0..4 {
            let mut corners = corners([-1.0, -1.0], [1.0, 1.0]);
            corners[i] = Ray::derived(Point3::ORIGIN, -corners[i].direction());
            assert_eq!(pencil.may_hide(&corners, 0.1), None, "corner {i}");
        }
    }

    #[test]
    fn nothing_is_known_of_what_parallel_rays_see() {
        let ahead = Vector3::new(0.0, 0.0, -1.0);
        let alone = [cube(1.0, [0.0, 0.0, -10.5])];
        let pencil = Pencil::new(Focus::Direction(ahead), &alone).expect("a pencil");
        let parallel = corners([-1.0, -1.0], [1.0, 1.0])
            .map(|ray| Ray::derived(Point3::ORIGIN + ray.direction(), ahead));
        assert_eq!(pencil.may_hide(&parallel, 0.1), None);
        assert_eq!(
            pencil.may_hide(&corners([-1.0, -1.0], [1.0, 1.0]), 0.1),
            None
        );
    }

    /// A needle across its bounds is narrower than they are.
    #[test]
    fn of_what_is_no_sphere_the_bounds_do_not_tell_how_wide_it_is() {
        let (bounds, sphere) = cube(1.0, [0.0, 0.0, -10.5]);
        let hides = |shape| hides(&[(bounds, shape)], [-1.0, -1.0], 2.0, 0.01);
        assert!(!hides(sphere));
        for shape in [Shape::Other(0), Shape::Triangle(0), Shape::Box(0)] {
            assert!(hides(shape), "{shape:?}");
        }
    }
}

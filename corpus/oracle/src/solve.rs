//! The exact answer for a ray and a shape.

use std::cmp::Ordering;

use num_traits::{One, Signed, Zero};

use crate::exact::{Q, Q3, Surd, cross, difference, dot};

/// A shape and a ray in exact numbers.
#[derive(Clone, Debug)]
pub struct Problem {
    pub shape: Shape,
    pub under: Vec<Step>,
    pub origin: Q3,
    pub direction: Q3,
    /// The ends of the interval; `None` is infinite.
    pub within: [Option<Q>; 2],
    /// Whether the ends belong to the interval. The file's intervals are open.
    pub is_closed: bool,
}

/// See `corpus::Shape`.
#[derive(Clone, Debug)]
pub enum Shape {
    Plane { point: Q3, normal: Q3 },
    Sphere { center: Q3, radius: Q },
    Box { low: Q3, high: Q3 },
    Disc { center: Q3, normal: Q3, radius: Q },
    Tube { from: Q3, to: Q3, radius: Q },
    Triangles(Vec<[Q3; 3]>),
}

/// See `corpus::Step`.
#[derive(Clone, Debug)]
pub enum Step {
    Translate(Q3),
    Scale(Q3),
}

/// The part of a shape on which a hit lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of a plane or disc.
    Whole,
    /// The root of the quadratic equation, the lesser one or the greater one.
    Root { is_greater: bool },
    /// The face of a box across this axis, with its least coordinate or its greatest one.
    Face { axis: usize, is_high: bool },
    /// The triangle with this number.
    Triangle(usize),
}

/// The exact answer. There is one at a time, so its size does not matter.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug)]
pub enum Solution {
    Hit {
        t: Surd,
        /// The normal, not of length 1; `None` on an edge.
        normal: Option<[Surd; 3]>,
        /// All parts that are hit at this `t`.
        parts: Vec<Part>,
    },
    Miss,
    Coplanar,
}

impl Problem {
    /// The exact answer.
    pub fn solve(&self) -> Solution {
        let (o, d) = self.local_ray();
        match &self.shape {
            Shape::Plane { point, normal } => self.flat(&o, &d, point, normal, |_| true, || true),
            Shape::Disc {
                center,
                normal,
                radius,
            } => {
                let is_inside = |t: &Q| {
                    let out = difference(&at(&o, &d, t), center);
                    dot(&out, &out) <= radius * radius
                };
                let is_met_along = || {
                    let roots = sphere_roots(&o, &d, center, radius);
                    roots.is_some_and(|[enter, leave]| self.overlaps(&enter, &leave))
                };
                self.flat(&o, &d, center, normal, is_inside, is_met_along)
            }
            Shape::Sphere { center, radius } => {
                let Some(roots) = sphere_roots(&o, &d, center, radius) else {
                    return Solution::Miss;
                };
                let normal = |t: &Surd| {
                    let out = difference(&o, center);
                    std::array::from_fn(|i| t.scaled(&out[i], &d[i]))
                };
                self.first_root(roots, |_| true, normal)
            }
            Shape::Tube { from, to, radius } => self.tube(&o, &d, from, to, radius),
            Shape::Box { low, high } => self.slabs(&o, &d, low, high),
            Shape::Triangles(triangles) => self.triangles(&o, &d, triangles),
        }
    }

    /// The `t` at which the ray meets the plane, sphere or tube of a part, which go on beyond its
    /// borders. `None` if there is none.
    pub fn t_of(&self, part: Part) -> Option<Surd> {
        let (o, d) = self.local_ray();
        match (&self.shape, part) {
            (Shape::Plane { point, normal }, _) => plane_t(&o, &d, point, normal),
            (Shape::Disc { center, normal, .. }, _) => plane_t(&o, &d, center, normal),
            (Shape::Sphere { center, radius }, Part::Root { is_greater }) => {
                let [lesser, greater] = sphere_roots(&o, &d, center, radius)?;
                Some(if is_greater { greater } else { lesser })
            }
            (Shape::Tube { from, to, radius }, Part::Root { is_greater }) => {
                let [lesser, greater] = tube_roots(&o, &d, from, to, radius)?;
                Some(if is_greater { greater } else { lesser })
            }
            (Shape::Box { low, high }, Part::Face { axis, is_high }) => {
                let face = if is_high { high } else { low };
                let t = (!d[axis].is_zero()).then(|| (&face[axis] - &o[axis]) / &d[axis]);
                t.map(Surd::rational)
            }
            (Shape::Triangles(triangles), Part::Triangle(number)) => {
                let [a, b, c] = &triangles[number];
                let normal = cross(&difference(b, a), &difference(c, a));
                plane_t(&o, &d, a, &normal)
            }
            _ => None,
        }
    }

    /// The ray in the space of the shape. `t` stays the same.
    fn local_ray(&self) -> (Q3, Q3) {
        let (mut o, mut d) = (self.origin.clone(), self.direction.clone());
        for step in &self.under {
            match step {
                Step::Translate(by) => o = difference(&o, by),
                Step::Scale(by) => {
                    o = std::array::from_fn(|i| &o[i] / &by[i]);
                    d = std::array::from_fn(|i| &d[i] / &by[i]);
                }
            }
        }
        (o, d)
    }

    /// A normal of the shape in the space of the ray: multiplied by the transposed inverse.
    fn around(&self, mut normal: [Surd; 3]) -> [Surd; 3] {
        for step in self.under.iter().rev() {
            if let Step::Scale(by) = step {
                normal = std::array::from_fn(|i| normal[i].scaled(&Q::zero(), &by[i].recip()));
            }
        }
        normal
    }

    fn contains(&self, t: &Surd) -> bool {
        let [min, max] = &self.within;
        let is_after =
            |order: Ordering| order == Ordering::Greater || (self.is_closed && order.is_eq());
        min.as_ref().is_none_or(|min| is_after(t.compare(min)))
            && max
                .as_ref()
                .is_none_or(|max| is_after(t.compare(max).reverse()))
    }

    /// Whether a closed part of the ray has a point in the open interval.
    fn overlaps(&self, from: &Surd, to: &Surd) -> bool {
        let [min, max] = &self.within;
        min.as_ref()
            .is_none_or(|min| to.compare(min) == Ordering::Greater)
            && max
                .as_ref()
                .is_none_or(|max| from.compare(max) == Ordering::Less)
    }

    fn hit(&self, t: Surd, normal: Option<[Surd; 3]>, parts: Vec<Part>) -> Solution {
        Solution::Hit {
            t,
            normal: normal.map(|normal| self.around(normal)),
            parts,
        }
    }

    fn flat(
        &self,
        o: &Q3,
        d: &Q3,
        point: &Q3,
        normal: &Q3,
        is_inside: impl Fn(&Q) -> bool,
        is_met_along: impl Fn() -> bool,
    ) -> Solution {
        let Some(t) = plane_t(o, d, point, normal) else {
            let is_in_plane = dot(&difference(point, o), normal).is_zero();
            return if is_in_plane && is_met_along() {
                Solution::Coplanar
            } else {
                Solution::Miss
            };
        };
        if self.contains(&t) && is_inside(&t.a) {
            let normal = normal.clone().map(Surd::rational);
            self.hit(t, Some(normal), vec![Part::Whole])
        } else {
            Solution::Miss
        }
    }

    fn first_root(
        &self,
        roots: [Surd; 2],
        is_inside: impl Fn(&Surd) -> bool,
        normal: impl Fn(&Surd) -> [Surd; 3],
    ) -> Solution {
        for (t, is_greater) in roots.into_iter().zip([false, true]) {
            if self.contains(&t) && is_inside(&t) {
                let normal = normal(&t);
                return self.hit(t, Some(normal), vec![Part::Root { is_greater }]);
            }
        }
        Solution::Miss
    }

    fn tube(&self, o: &Q3, d: &Q3, from: &Q3, to: &Q3, radius: &Q) -> Solution {
        let Some(roots) = tube_roots(o, d, from, to, radius) else {
            return Solution::Miss;
        };
        let (axis, out) = (difference(to, from), difference(o, from));
        let length_squared = dot(&axis, &axis);
        let is_inside = |t: &Surd| {
            let along = t.scaled(&dot(&out, &axis), &dot(d, &axis));
            along.sign() >= 0 && along.compare(&length_squared) != Ordering::Greater
        };
        let normal = |t: &Surd| {
            let [out, d] = [across(&out, &axis), across(d, &axis)];
            std::array::from_fn(|i| t.scaled(&out[i], &d[i]))
        };
        self.first_root(roots, is_inside, normal)
    }

    fn slabs(&self, o: &Q3, d: &Q3, low: &Q3, high: &Q3) -> Solution {
        // The faces through which the ray enters and leaves each slab that it is not parallel to.
        let (mut enters, mut leaves) = (Vec::new(), Vec::new());
        for axis in 0..3 {
            if d[axis].is_zero() {
                if o[axis] < low[axis] || o[axis] > high[axis] {
                    return Solution::Miss;
                }
                continue;
            }
            let [to_low, to_high] = [low, high].map(|face| (&face[axis] - &o[axis]) / &d[axis]);
            let [low, high] = [false, true].map(|is_high| Part::Face { axis, is_high });
            if d[axis].is_positive() {
                enters.push((to_low, low));
                leaves.push((to_high, high));
            } else {
                enters.push((to_high, high));
                leaves.push((to_low, low));
            }
        }
        let near = enters.iter().map(|(t, _)| t).max();
        let far = leaves.iter().map(|(t, _)| t).min();
        let (Some(near), Some(far)) = (near, far) else {
            return Solution::Miss;
        };
        if near > far {
            return Solution::Miss;
        }
        for (t, faces) in [(near, &enters), (far, &leaves)] {
            if self.contains(&Surd::rational(t.clone())) {
                let hit_faces = faces.iter().filter(|(face_t, _)| face_t == t);
                let parts = hit_faces.map(|(_, part)| *part).collect();
                let normal = box_normal(&at(o, d, t), low, high);
                return self.hit(Surd::rational(t.clone()), normal, parts);
            }
        }
        Solution::Miss
    }

    fn triangles(&self, o: &Q3, d: &Q3, triangles: &[[Q3; 3]]) -> Solution {
        let mut nearest: Option<Q> = None;
        let mut parts = Vec::new();
        let mut normals: Vec<Q3> = Vec::new();
        let mut is_coplanar = false;
        for (number, triangle) in triangles.iter().enumerate() {
            let [a, b, c] = triangle;
            let normal = cross(&difference(b, a), &difference(c, a));
            if normal.iter().all(Zero::is_zero) {
                continue;
            }
            let Some(t) = plane_t(o, d, a, &normal) else {
                let is_in_plane = dot(&difference(a, o), &normal).is_zero();
                is_coplanar |= is_in_plane && self.is_met_along(o, d, triangle, &normal);
                continue;
            };
            let point = at(o, d, &t.a);
            let is_inside = edges(triangle).iter().all(|[from, to]| {
                let area = cross(&difference(to, from), &difference(&point, from));
                !dot(&area, &normal).is_negative()
            });
            if !is_inside || !self.contains(&t) {
                continue;
            }
            match nearest.as_ref().map(|nearest| t.a.cmp(nearest)) {
                Some(Ordering::Greater) => continue,
                Some(Ordering::Equal) => {}
                Some(Ordering::Less) | None => {
                    parts.clear();
                    normals.clear();
                    nearest = Some(t.a);
                }
            }
            parts.push(Part::Triangle(number));
            normals.push(normal);
        }
        match nearest {
            Some(t) => {
                let is_one = normals.windows(2).all(|pair| {
                    let [one, other] = pair else { return true };
                    let is_parallel = cross(one, other).iter().all(Zero::is_zero);
                    is_parallel && dot(one, other).is_positive()
                });
                let normal = is_one.then(|| normals[0].clone().map(Surd::rational));
                self.hit(Surd::rational(t), normal, parts)
            }
            None if is_coplanar => Solution::Coplanar,
            None => Solution::Miss,
        }
    }

    /// Whether a ray in the plane of a triangle meets it within the interval: what is left of the line
    /// after it is cut at each edge.
    fn is_met_along(&self, o: &Q3, d: &Q3, triangle: &[Q3; 3], normal: &Q3) -> bool {
        let [mut from, mut to] = self.within.clone();
        let mut is_open = [true, true];
        for [start, end] in edges(triangle) {
            let inwards = cross(normal, &difference(end, start));
            let height = dot(&difference(o, start), &inwards);
            let slope = dot(d, &inwards);
            if slope.is_zero() {
                if height.is_negative() {
                    return false;
                }
                continue;
            }
            let t = -height / &slope;
            if slope.is_positive() {
                if from.as_ref().is_none_or(|from| t > *from) {
                    (from, is_open[0]) = (Some(t), false);
                }
            } else if to.as_ref().is_none_or(|to| t < *to) {
                (to, is_open[1]) = (Some(t), false);
            }
        }
        match (from, to) {
            (Some(from), Some(to)) => from < to || (from == to && is_open == [false, false]),
            _ => true,
        }
    }
}

fn at(o: &Q3, d: &Q3, t: &Q) -> Q3 {
    std::array::from_fn(|i| &o[i] + &d[i] * t)
}

fn edges([a, b, c]: &[Q3; 3]) -> [[&Q3; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn plane_t(o: &Q3, d: &Q3, point: &Q3, normal: &Q3) -> Option<Surd> {
    let approach = dot(d, normal);
    let t = (!approach.is_zero()).then(|| dot(&difference(point, o), normal) / approach);
    t.map(Surd::rational)
}

/// The roots of `a t² + 2 b t + c = 0`, with `a` above 0.
fn roots(a: &Q, b: &Q, c: &Q) -> Option<[Surd; 2]> {
    if a.is_zero() {
        return None;
    }
    let middle = -b / a;
    let d = &middle * &middle - c / a;
    let root = |sign: i32| Surd {
        a: middle.clone(),
        b: Q::from_integer(sign.into()),
        d: d.clone(),
    };
    (!d.is_negative()).then(|| [root(-1), root(1)])
}

fn sphere_roots(o: &Q3, d: &Q3, center: &Q3, radius: &Q) -> Option<[Surd; 2]> {
    let out = difference(o, center);
    roots(
        &dot(d, d),
        &dot(&out, d),
        &(dot(&out, &out) - radius * radius),
    )
}

/// The part of a vector across an axis.
fn across(vector: &Q3, axis: &Q3) -> Q3 {
    let along = dot(vector, axis) / dot(axis, axis);
    std::array::from_fn(|i| &vector[i] - &along * &axis[i])
}

fn tube_roots(o: &Q3, d: &Q3, from: &Q3, to: &Q3, radius: &Q) -> Option<[Surd; 2]> {
    let axis = difference(to, from);
    let [out, d] = [across(&difference(o, from), &axis), across(d, &axis)];
    roots(
        &dot(&d, &d),
        &dot(&out, &d),
        &(dot(&out, &out) - radius * radius),
    )
}

/// The outward normal at a point of the surface of a box; `None` on its edges.
fn box_normal(point: &Q3, low: &Q3, high: &Q3) -> Option<[Surd; 3]> {
    let mut normal: Q3 = std::array::from_fn(|_| Q::zero());
    let mut faces = 0;
    for axis in 0..3 {
        for (face, sign) in [(low, -Q::one()), (high, Q::one())] {
            if point[axis] == face[axis] {
                normal[axis] = sign;
                faces += 1;
            }
        }
    }
    (faces == 1).then(|| normal.map(Surd::rational))
}

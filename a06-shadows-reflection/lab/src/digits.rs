//! The rounding errors of the pixels of the scene `sphere`: estimated, and exact.
//!
//! The lesson's tracer stands here once more, for this scene and over types of numbers: in doubles it
//! gives the lesson's colours, in [`RandomlyRounded`] numbers those of runs with other roundings, and
//! in [`DoubleDouble`] numbers the exact ones.

use std::ops::Neg;

use a04_lab::exact::DoubleDouble;
use a04_lab::line::Line;
use a04_lab::number::{Number, Triple, difference, dot};
use a04_lab::random_rounding::RandomlyRounded;
use common::{Error, Size};

use a06_shadows_reflection::scenes;

/// Numbers of a ray that is traced. Decisions, such as which hit is nearer, are those of the nearest
/// doubles.
pub trait Traced: Number {
    /// The nearest double.
    fn value(self) -> f64;
}

impl Traced for f64 {
    fn value(self) -> f64 {
        self
    }
}

impl Traced for RandomlyRounded {
    fn value(self) -> f64 {
        Self::value(self)
    }
}

impl Traced for DoubleDouble {
    fn value(self) -> f64 {
        Self::value(self)
    }
}

/// A shape with its material, a [`Reflective`](a06_shadows_reflection::Reflective) of exponent 64 that
/// reflects one half.
struct Object {
    shape: Shape,
    diffuse: Triple,
    specular: f64,
}

enum Shape {
    /// The plane y = 0.
    Floor,
    /// Of radius 1.
    Sphere { center: Triple },
}

/// The objects of the scene, in its order.
const OBJECTS: [Object; 4] = [
    Object {
        shape: Shape::Floor,
        diffuse: [0.1; 3],
        specular: 0.0,
    },
    ball(-3.0, [1.0, 0.0, 0.0]),
    ball(0.0, [0.0, 1.0, 0.0]),
    ball(3.0, [0.0, 0.0, 1.0]),
];

const fn ball(x: f64, diffuse: Triple) -> Object {
    Object {
        shape: Shape::Sphere {
            center: [x, 1.0, 0.0],
        },
        diffuse,
        specular: 1.0,
    }
}

const LIGHT: Triple = [8.0; 3];
const AMBIENT: f64 = 0.25;
const REFLECTANCE: f64 = 0.5;

/// A hit, whose normal is on the side of the ray.
struct Hit<N> {
    t: N,
    normal: Triple<N>,
    /// See the lesson's hit.
    scale: f64,
}

impl Object {
    /// The nearest hit whose `t` is above 0 and below `max`, by the lesson's formulas.
    fn hit<N: Traced>(&self, Line { origin, direction }: &Line<N>, max: f64) -> Option<Hit<N>> {
        let is_valid = |t: &N| 0.0 < t.value() && t.value() < max;
        match self.shape {
            Shape::Floor => {
                let (zero, one) = (N::of(0.0), N::of(1.0));
                let normal = [zero, one, zero];
                let to_floor = difference(&[zero; 3], origin);
                let t = dot(&to_floor, &normal) / dot(direction, &normal);
                is_valid(&t).then(|| Hit {
                    t,
                    normal,
                    scale: to_floor[1].value().abs(),
                })
            }
            Shape::Sphere { center } => {
                let f = difference(origin, &center.map(N::of));
                let a = dot(direction, direction);
                let middle = -dot(&f, direction) / a;
                let l = along(&f, direction, middle);
                let discriminant = N::of(1.0) - dot(&l, &l);
                if discriminant.value() < 0.0 {
                    return None;
                }
                let half = (discriminant / a).sqrt();
                let t1 = middle + if middle.value() < 0.0 { -half } else { half };
                let t0 = (dot(&f, &f) - N::of(1.0)) / (a * t1);
                let is_first = t0.value() < t1.value();
                let in_order = if is_first { [t0, t1] } else { [t1, t0] };
                let t = in_order.into_iter().find(is_valid)?;
                Some(Hit {
                    t,
                    normal: unit(&along(&f, direction, t)),
                    scale: 1.0,
                })
            }
        }
    }
}

/// `a + b t`.
fn along<N: Number>(a: &Triple<N>, b: &Triple<N>, t: N) -> Triple<N> {
    [0, 1, 2].map(|axis| a[axis] + b[axis] * t)
}

fn unit<N: Number>(v: &Triple<N>) -> Triple<N> {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

/// The vector mirrored at a normal.
fn reflected<N: Number>(v: &Triple<N>, normal: &Triple<N>) -> Triple<N> {
    let twice = N::of(2.0) * dot(normal, v);
    [0, 1, 2].map(|axis| normal[axis] * twice - v[axis])
}

/// How far off the surface secondary rays start, in offsets of the lesson.
pub type Offset = f64;

/// The lesson's.
pub const OFFSET: Offset = 1.0;

/// One that 31 digits still need, and nobody sees in 16.
pub const NO_OFFSET: Offset = 1e-15;

/// A ray that is traced, with the offset of those that follow it.
struct Ray<N> {
    line: Line<N>,
    offset: Offset,
}

impl<N: Traced> Ray<N> {
    fn nearest(&self) -> Option<(Hit<N>, &'static Object)> {
        let mut max = f64::INFINITY;
        let mut nearest = None;
        for object in &OBJECTS {
            if let Some(hit) = object.hit(&self.line, max) {
                max = hit.t.value();
                nearest = Some((hit, object));
            }
        }
        let (hit, object) = nearest?;
        let is_from_behind = dot(&hit.normal, &self.line.direction).value() > 0.0;
        let normal = if is_from_behind {
            hit.normal.map(Neg::neg)
        } else {
            hit.normal
        };
        Some((Hit { normal, ..hit }, object))
    }

    fn at(&self, t: N) -> Triple<N> {
        along(&self.line.origin, &self.line.direction, t)
    }

    /// The bound of the rounding error of a hit.
    fn rounding_error(&self, hit: &Hit<N>) -> f64 {
        let mut largest = hit.t.value().max(hit.scale);
        for coordinate in self.line.origin.into_iter().chain(self.at(hit.t)) {
            largest = largest.max(coordinate.value().abs());
        }
        64.0 * f64::EPSILON * largest
    }

    /// The ray that leaves a hit in a direction.
    fn secondary(&self, hit: &Hit<N>, direction: Triple<N>) -> Self {
        let side = dot(&hit.normal, &direction).value();
        let offset = self.offset * self.rounding_error(hit).copysign(side);
        let origin = along(&self.at(hit.t), &hit.normal, N::of(offset));
        Self {
            line: Line { origin, direction },
            offset: self.offset,
        }
    }

    fn is_shadowed(&self, hit: &Hit<N>, to_light: &Triple<N>, distance: f64) -> bool {
        let shadow_ray = self.secondary(hit, *to_light);
        // No shape of this scene is near the light.
        let mut objects = OBJECTS.iter();
        objects.any(|object| object.hit(&shadow_ray.line, distance).is_some())
    }

    /// The light that a hit reflects from the lamp.
    fn color(&self, hit: &Hit<N>, object: &Object) -> Triple<N> {
        let diffuse = object.diffuse.map(N::of);
        let mut color = diffuse.map(|diffuse| diffuse * N::of(AMBIENT));
        let to_light = difference(&LIGHT.map(N::of), &self.at(hit.t));
        let distance = dot(&to_light, &to_light).sqrt().value();
        let to_light = unit(&to_light);
        let cosine = dot(&hit.normal, &to_light);
        if cosine.value() <= 0.0 || self.is_shadowed(hit, &to_light, distance) {
            return color;
        }
        let to_eye = self.line.direction.map(Neg::neg);
        let mut highlight = dot(&to_eye, &reflected(&to_light, &hit.normal));
        if object.specular == 0.0 || highlight.value() <= 0.0 {
            highlight = N::of(0.0);
        } else if highlight.value() > 1.0 {
            highlight = N::of(1.0);
        }
        // To the power of 64.
        for _ in 0..6 {
            highlight = highlight * highlight;
        }
        for channel in 0..3 {
            color[channel] = color[channel] + (diffuse[channel] * cosine + highlight);
        }
        color
    }
}

/// The colour that a ray brings back from at most `depth` surfaces.
pub fn color<N: Traced>(line: &Line, depth: u32, offset: Offset) -> Triple<N> {
    let mut ray = Ray {
        line: line.to::<N>(),
        offset,
    };
    let mut color = [N::of(0.0); 3];
    let mut mirrored = N::of(1.0);
    for _ in 0..depth {
        let Some((hit, object)) = ray.nearest() else {
            break;
        };
        let own = ray.color(&hit, object);
        for channel in 0..3 {
            color[channel] = color[channel] + mirrored * own[channel];
        }
        mirrored = mirrored * N::of(REFLECTANCE);
        let direction = reflected(&ray.line.direction.map(Neg::neg), &hit.normal);
        ray = ray.secondary(&hit, direction);
    }
    color
}

/// How often a pixel is traced with random roundings.
const RUNS: u64 = 8;

/// The estimated error: the greatest difference of a channel between runs with random roundings, of
/// the `n`-th ray.
pub fn spread(line: &Line, depth: u32, n: u64) -> f64 {
    let (mut least, mut greatest) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for run in 0..RUNS {
        RandomlyRounded::seed(RUNS * n + run);
        let color = color::<RandomlyRounded>(line, depth, OFFSET);
        for channel in 0..3 {
            least[channel] = least[channel].min(color[channel].value());
            greatest[channel] = greatest[channel].max(color[channel].value());
        }
    }
    let mut spread: f64 = 0.0;
    for channel in 0..3 {
        spread = spread.max(greatest[channel] - least[channel]);
    }
    spread
}

/// The greatest error of a channel of the lesson's colour, against 31 digits with this offset.
pub fn error(line: &Line, depth: u32, offset: Offset) -> f64 {
    let lesson = color::<f64>(line, depth, OFFSET);
    let exact = color::<DoubleDouble>(line, depth, offset);
    let mut error: f64 = 0.0;
    for channel in 0..3 {
        error = error.max(exact[channel].error_of(lesson[channel]).abs());
    }
    error
}

/// The rays through the middles of the pixels of the scene, row by row.
pub fn lines(size: Size) -> Result<Vec<Line>, Error> {
    let camera = scenes::sphere()?.camera;
    let mut lines = Vec::new();
    for y in 0..size.height() {
        for x in 0..size.width() {
            let ray = camera.ray_for(size, f64::from(x), f64::from(y));
            lines.push(Line::of(&ray));
        }
    }
    Ok(lines)
}

//! The rays of a trace from the side and from above, among the objects, as SVG.
//!
//! Rays through a grid of places find the objects, so that shapes of any type are drawn by
//! their own `hit`.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use a02_math::{Direction, Point3, Vector3};
use common::steps::{Outcome, Step, StepKind};
use common::svg::{Svg, color};

use crate::{Ray, TracedWorld, View};

/// Width and height of a view in pixels, and the side of a square in which one ray finds the
/// object.
const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 360.0;
const CELL: f64 = 3.0;

/// The height of the name of an object.
const KEY: f64 = 18.0;

/// A line of the drawing.
pub struct Line {
    /// Its ends.
    pub ends: [Point3; 2],
    /// Its class, which has the number of the ray.
    class: String,
}

/// The lines of the first sample; and the eye and the lights by name.
#[derive(Default)]
pub struct Lines {
    /// The lines.
    pub lines: Vec<Line>,
    /// The places that have a name.
    pub named: BTreeMap<String, Point3>,
}

impl Lines {
    /// The lines of a trace.
    pub fn new(trace: &[Step]) -> Self {
        let vector = |step: &Step, symbol| step.value(symbol).map(|v| Vector3::from_glam(v.into()));
        let point = |v| Point3::ORIGIN + v;
        let eye = trace.iter().find_map(|step| vector(step, "o"));
        let eye = eye.unwrap_or_default();
        // A ray that hits nothing ends beyond the middle of the scene.
        let far = 1.5 * eye.magnitude().max(2.0);
        let (mut lines, mut ray) = (Self::default(), 0);
        lines.named.insert("eye".to_owned(), point(eye));
        let sample = trace.chunk_by(|_, next| next.level > 0).next();
        for step in sample.unwrap_or_default() {
            let [o, d, p, l] = ["o", "d", "p", "l"].map(|symbol| vector(step, symbol));
            let length = match step.kind {
                StepKind::CameraRay => Some(far),
                StepKind::ReflectedRay => Some(far / 3.0),
                _ => None,
            };
            if let (Some(length), Some(o), Some(d)) = (length, o, d) {
                ray += 1;
                lines.lines.push(Line {
                    ends: [o, o + d * length].map(point),
                    class: format!("curve ray{ray}"),
                });
            }
            let last = lines.lines.len().saturating_sub(1);
            let Some(Line { ends: [_, end], .. }) = lines.lines.last_mut() else {
                continue;
            };
            if let Some(p) = p {
                *end = point(p);
            } else if let (Some(l), Some([distance])) = (l, step.value("distance")) {
                let ends = [*end, *end + l * distance.min(far)];
                let dashed = match step.outcome {
                    Outcome::Arrives => "",
                    _ => " estimate",
                };
                let class = format!("curve{dashed} ray{ray}");
                // The last line remains the ray that has hit.
                lines.lines.insert(last, Line { ends, class });
                if let (Some(number), true) = (step.number, distance.is_finite()) {
                    lines.named.insert(format!("light {number}"), ends[1]);
                }
            }
        }
        lines
    }
}

/// A parallel projection of a world.
struct Projection<'a> {
    world: &'a dyn TracedWorld,
    /// The directions to the right, upwards and towards the reader.
    axes: [Vector3; 3],
    /// The point in the middle, and the length of a pixel.
    middle: Point3,
    pixel: f64,
    /// The upper left corner in the drawing.
    corner: [f64; 2],
}

impl Projection<'_> {
    /// The place of a point in the drawing.
    fn place(&self, p: Point3) -> [f64; 2] {
        let [x, y] = [0, 1].map(|i| (p - self.middle).dot(self.axes[i]) / self.pixel);
        let [left, top] = self.corner;
        [left + WIDTH / 2.0 + x, top + HEIGHT / 2.0 - y]
    }

    /// The number of the first object, and its distance in pixels, on the ray from a place of
    /// the view at this height against an axis.
    fn nearest(&self, x: f64, y: f64, height: f64, axis: usize) -> Option<(usize, f64)> {
        let [right, up, front] = self.axes;
        let o = right * (x - WIDTH / 2.0) + up * (HEIGHT / 2.0 - y) + front * height;
        let ray = Ray::derived(self.middle + o * self.pixel, -self.axes[axis]);
        let (object, t) = self.world.nearest(&ray)?;
        Some((object, t / self.pixel))
    }

    /// The strokes of each object where it is seen, by its number. A plane seen from its edge is
    /// seen nowhere: it is drawn where rays downwards meet it first, at the depth of the middle.
    fn objects(&self) -> BTreeMap<usize, String> {
        let middles = |side: f64| (0..(side / CELL) as u32).map(|i| (f64::from(i) + 0.5) * CELL);
        let mut strokes = Vec::new();
        for y in middles(HEIGHT) {
            for x in middles(WIDTH) {
                if let Some((object, _)) = self.nearest(x, y, 100.0 * WIDTH, 2) {
                    strokes.push((object, x, y));
                }
            }
        }
        let seen: BTreeSet<_> = strokes.iter().map(|(object, ..)| *object).collect();
        for x in middles(WIDTH) {
            if let Some((object, y)) = self.nearest(x, 0.0, 0.0, 1)
                && y < HEIGHT
                && !seen.contains(&object)
            {
                strokes.push((object, x, y));
            }
        }
        let mut objects = BTreeMap::<_, String>::new();
        for (object, x, y) in strokes {
            let (x, y) = (self.corner[0] + x - CELL / 2.0, self.corner[1] + y);
            let path = objects.entry(object).or_default();
            let _ = write!(path, "M{x:.1} {y:.1}h{CELL}");
        }
        objects
    }

    /// Draws the view, and returns its height with the names of its objects.
    fn draw(&self, svg: &mut Svg, title: &str, lines: &Lines) -> f64 {
        let [left, top] = self.corner;
        svg.text("", [left, top - 10.0], title);
        let objects = self.objects().into_iter();
        let mut objects: Vec<_> = objects
            .map(|(number, path)| (self.world.object_name(number), number, path))
            .collect();
        objects.sort();
        let height = top + HEIGHT + KEY * objects.len() as f64 + 10.0;
        for (i, (name, number, path)) in (1..).zip(objects) {
            let color = color(number);
            svg.path(&format!("object {color}"), &path);
            let y = top + HEIGHT + KEY * f64::from(i);
            svg.line(&format!("key {color}"), &[[left, y], [left + 12.0, y]]);
            svg.text("", [left + 18.0, y + 5.0], &name);
        }
        for line in &lines.lines {
            svg.line(&line.class, &line.ends.map(|p| self.place(p)));
        }
        for (i, (name, point)) in (1..).zip(&lines.named) {
            let [x, y] = self.place(*point);
            svg.mark(1, [x, y]);
            // Eye and light are often at the same place.
            svg.text("", [x, y + 16.0 * f64::from(i)], name);
        }
        height
    }
}

/// A drawing of two views beside each other.
pub struct Drawing {
    /// The file.
    pub svg: String,
    /// Left, top, width and height in it of the view from the side, and of that from above.
    pub views: [[f64; 4]; 2],
}

impl View {
    /// The rays of the first sample of these steps from the side and from above, as SVG, whose
    /// title has a name of the scene.
    #[must_use]
    pub fn drawing(&self, steps: &[Step], name: &str) -> Drawing {
        draw(&*self.world, steps, name)
    }
}

/// The rays of the first sample of a trace, in a world.
fn draw(world: &dyn TracedWorld, trace: &[Step], scene: &str) -> Drawing {
    let lines = Lines::new(trace);
    let points = lines.lines.iter().flat_map(|line| line.ends);
    let points = points.map(Point3::to_glam);
    let low = points
        .clone()
        .reduce(|low, p| p.min(low))
        .unwrap_or_default();
    let high = points.reduce(|high, p| p.max(high)).unwrap_or_default();
    let [across, up, down] = (high - low).to_array();
    let pixel = 1.6 * (across / WIDTH).max(up.max(down) / HEIGHT).max(1e-3);
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        .map(|axis: [f64; 3]| Vector3::from_glam(axis.into()));
    let title = format!("The rays of a pixel of {scene}");
    let mut svg = Svg::new([2.0 * WIDTH + 30.0, HEIGHT + 200.0], &title);
    let side = ("from the side: x to the right, y up", [x, y, z], 10.0);
    let above = (
        "from above: x to the right, z down",
        [x, -z, y],
        WIDTH + 20.0,
    );
    let views = [side, above].map(|(title, axes, left)| {
        let projection = Projection {
            world,
            axes,
            middle: Point3::from_glam(low.midpoint(high)),
            pixel,
            corner: [left, 30.0],
        };
        let height = projection.draw(&mut svg, title, &lines);
        [left - 5.0, 0.0, WIDTH + 10.0, height]
    });
    Drawing {
        svg: svg.finish(),
        views,
    }
}

//! The rays of a trace from the side and from above, among the objects, as SVG.
//!
//! Rays through a grid of places find the objects, so that shapes of any type are drawn by
//! their own `hit`.

use std::collections::BTreeMap;
use std::fmt::Write;

use a02_math::{Direction, Point3, Vector3};
use common::steps::{RAY, REFLECTED, Step};
use common::svg::{Svg, color};

use super::turned::nearest;
use crate::{Ray, TracedWorld};

/// Width and height of a view in pixels, and the side of a square in which one ray finds the
/// object.
const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 360.0;
const CELL: f64 = 3.0;

/// The lines of the first sample, with their classes, which have the number of the ray; and the eye
/// and the lights by name.
pub type Lines<'a> = (Vec<([Point3; 2], String)>, BTreeMap<&'a str, Point3>);

/// The lines of a trace.
pub fn lines(trace: &[Step]) -> Lines<'_> {
    let vector = |step: &Step, symbol| step.value(symbol).map(|v| Vector3::from_glam(v.into()));
    let point = |v| Point3::ORIGIN + v;
    let eye = trace.iter().find_map(|step| vector(step, "o"));
    let eye = eye.unwrap_or_default();
    // A ray that hits nothing ends beyond the middle of the scene.
    let far = 1.5 * eye.magnitude().max(2.0);
    let mut lines = vec![];
    let (mut named, mut ray) = (BTreeMap::from([("eye", point(eye))]), 0);
    let sample = trace.chunk_by(|_, next| next.level > 0).next();
    for step in sample.unwrap_or_default() {
        let [o, d, p, l] = ["o", "d", "p", "l"].map(|symbol| vector(step, symbol));
        if let (RAY | REFLECTED, Some(o), Some(d)) = (step.kind, o, d) {
            let length = if step.kind == RAY { far } else { far / 3.0 };
            ray += 1;
            lines.push(([o, o + d * length].map(point), format!("curve ray{ray}")));
        }
        let Some(([_, end], _)) = lines.last_mut() else {
            continue;
        };
        if let Some(p) = p {
            *end = point(p);
        } else if let (Some(l), Some([distance])) = (l, step.value("distance")) {
            let light = [*end, *end + l * distance.min(far)];
            let dashed = if step.outcome == "arrives" {
                ""
            } else {
                " estimate"
            };
            // The last line remains the ray that has hit.
            lines.insert(lines.len() - 1, (light, format!("curve{dashed} ray{ray}")));
            if distance.is_finite() {
                named.insert(step.name.split(':').next().unwrap_or_default(), light[1]);
            }
        }
    }
    (lines, named)
}

/// A parallel projection.
struct View<'a> {
    world: &'a dyn TracedWorld,
    /// The directions to the right, upwards and towards the reader.
    axes: [Vector3; 3],
    /// The point in the middle, and the length of a pixel.
    middle: Point3,
    pixel: f64,
    /// The upper left corner in the drawing.
    corner: [f64; 2],
}

impl View<'_> {
    /// The place of a point in the drawing.
    fn place(&self, p: Point3) -> [f64; 2] {
        let [x, y] = [0, 1].map(|i| (p - self.middle).dot(self.axes[i]) / self.pixel);
        let [left, top] = self.corner;
        [left + WIDTH / 2.0 + x, top + HEIGHT / 2.0 - y]
    }

    /// The name of the first object, and its distance in pixels, on the ray from a place of
    /// the view at this height against an axis.
    fn nearest(&self, x: f64, y: f64, height: f64, axis: usize) -> Option<(String, f64)> {
        let [right, up, front] = self.axes;
        let o = right * (x - WIDTH / 2.0) + up * (HEIGHT / 2.0 - y) + front * height;
        let ray = Ray::derived(self.middle + o * self.pixel, -self.axes[axis]);
        nearest(self.world, &ray).map(|(name, t)| (name, t / self.pixel))
    }

    /// The strokes of each object where it is seen; and for an object that is seen nowhere, as
    /// a plane from its edge, the first below the top of the view, at the depth of the middle.
    fn objects(&self) -> BTreeMap<String, String> {
        let middles = |side: f64| (0..(side / CELL) as u32).map(|i| (f64::from(i) + 0.5) * CELL);
        let cells = middles(HEIGHT).flat_map(|y| middles(WIDTH).map(move |x| (x, y)));
        let seen = cells.filter_map(|(x, y)| Some((self.nearest(x, y, 100.0 * WIDTH, 2)?.0, x, y)));
        let mut strokes = seen.collect::<Vec<_>>();
        let edges = middles(WIDTH).filter_map(|x| {
            let (name, y) = self.nearest(x, 0.0, 0.0, 1)?;
            let is_edge = y < HEIGHT && strokes.iter().all(|(seen, ..)| *seen != name);
            is_edge.then_some((name, x, y))
        });
        strokes.extend(edges.collect::<Vec<_>>());
        let mut objects = BTreeMap::<_, String>::new();
        for (name, x, y) in strokes {
            let (x, y) = (self.corner[0] + x - CELL / 2.0, self.corner[1] + y);
            let _ = write!(objects.entry(name).or_default(), "M{x:.1} {y:.1}h{CELL}");
        }
        objects
    }

    fn draw(&self, svg: &mut Svg, title: &str, (lines, named): &Lines) {
        let [left, top] = self.corner;
        svg.text("", [left, top - 10.0], title);
        for (i, (name, path)) in (1..).zip(self.objects()) {
            let number = name.split([' ', ':']).nth(1).map(str::parse);
            let color = color(number.and_then(Result::ok).unwrap_or(0));
            svg.path(&format!("object {color}"), &path);
            let y = top + HEIGHT + 18.0 * f64::from(i);
            svg.line(&format!("key {color}"), &[[left, y], [left + 12.0, y]]);
            svg.text("", [left + 18.0, y + 5.0], &name);
        }
        for (line, class) in lines {
            svg.line(class, &line.map(|p| self.place(p)));
        }
        for (i, (name, point)) in (1..).zip(named) {
            let [x, y] = self.place(*point);
            svg.mark(1, [x, y]);
            // Eye and light are often at the same place.
            svg.text("", [x, y + 16.0 * f64::from(i)], name);
        }
    }
}

/// The rays of the first sample of a trace, in a world with wrappers that record its steps.
pub fn svg(world: &dyn TracedWorld, trace: &[Step], scene: &str) -> String {
    let lines = lines(trace);
    let points = lines.0.iter().flat_map(|(line, _)| line);
    let points = points.map(|point| point.to_glam());
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
    for (title, axes, left) in [side, above] {
        let view = View {
            world,
            axes,
            middle: Point3::from_glam(low.midpoint(high)),
            pixel,
            corner: [left, 30.0],
        };
        view.draw(&mut svg, title, &lines);
    }
    svg.finish()
}

//! The picture of this stage: the operations on vectors, drawn as arrows.

use a01_image_display::Canvas;
use common::{Color, Error, Image, Size};

use crate::{Normal3, Vector3};

/// Four panels, one for each operation.
pub fn vectors(size: Size) -> Result<Image, Error> {
    let mut canvas = Canvas::new(size, PAPER)?;
    let panels: [(fn(&mut Panel), _, _); 4] = [
        (sum, (0.0, 0.0), (40.0, 185.0)),
        (cross_product, (1.0, 0.0), (80.0, 182.0)),
        (projection, (0.0, 1.0), (40.0, 185.0)),
        (reflection, (1.0, 1.0), (160.0, 185.0)),
    ];
    for (draw, place, origin) in panels {
        draw(&mut Panel::new(&mut canvas, size, place, origin));
    }
    Ok(canvas.into_image())
}

const PAPER: Color = Color::gray(1.0);
const INK: Color = Color::gray(0.15);
const PENCIL: Color = Color::gray(0.7);
const FIRST: Color = Color::new(0.1, 0.3, 0.8);
const SECOND: Color = Color::new(0.1, 0.5, 0.2);
const RESULT: Color = Color::new(0.8, 0.1, 0.1);

// Offset of a label from the tip of its vector.
const ABOVE: (f64, f64) = (-4.0, -22.0);
const BELOW: (f64, f64) = (-30.0, 10.0);
const RIGHT: (f64, f64) = (10.0, -8.0);
const LEFT: (f64, f64) = (-26.0, -8.0);

fn sum(panel: &mut Panel) {
    let (a, b) = (Vector3::new(3.0, 1.0, 0.0), Vector3::new(1.0, 1.5, 0.0));
    let sum = a + b;
    let (x, y, z) = (sum.x(), sum.y(), sum.z());
    panel.title("Sum", &format!("a + b = ({x}, {y}, {z})"));
    panel.helper_line(a, sum);
    panel.helper_line(b, sum);
    panel.vector(a, FIRST, "a", RIGHT);
    panel.vector(b, SECOND, "b", ABOVE);
    panel.vector(sum, RESULT, "a+b", ABOVE);
}

fn cross_product(panel: &mut Panel) {
    let (a, b) = (Vector3::new(2.5, 0.0, 1.0), Vector3::new(1.0, 0.0, -0.6));
    let (cross, area) = (a.cross(b), a.parallelogram_area(b));
    panel.title("Cross product", &format!("area |a \u{d7} b| = {area}"));
    panel.helper_line(a, a + b);
    panel.helper_line(b, a + b);
    panel.vector(a, FIRST, "a", RIGHT);
    panel.vector(b, SECOND, "b", ABOVE);
    panel.vector(cross, RESULT, "a \u{d7} b", RIGHT);
}

fn projection(panel: &mut Panel) {
    let (a, b) = (Vector3::new(2.0, 2.0, 0.0), Vector3::new(4.5, 0.9, 0.0));
    let projection = a.projected_on(b).unwrap_or_default();
    let angle = a.angle(b).to_degrees();
    panel.title("Projection", &format!("angle: {angle:.1}\u{b0}"));
    panel.helper_line(a, projection);
    panel.vector(a, FIRST, "a", ABOVE);
    panel.vector(b, SECOND, "b", ABOVE);
    panel.vector(projection, RESULT, "a on b", BELOW);
}

fn reflection(panel: &mut Panel) {
    let (v, n) = (Vector3::new(-2.0, 1.8, 0.0), Normal3::new(0.0, 1.0, 0.0));
    let reflected = v.reflected_on(n);
    let surface = Vector3::new(2.6, 0.0, 0.0);
    panel.title("Reflection", "r = 2 (n\u{b7}v) n - v");
    panel.helper_line(-surface, surface);
    panel.helper_line(v, reflected);
    panel.vector(v, FIRST, "v", LEFT);
    panel.vector(Vector3::from(n), SECOND, "n", RIGHT);
    panel.vector(reflected, RESULT, "r", RIGHT);
}

/// A quarter of the picture, with coordinate axes of its own.
struct Panel<'a> {
    canvas: &'a mut Canvas,
    /// Scale: pixels of the picture for one unit of the 640 x 480 layout.
    pixel: f64,
    corner: (f64, f64),
    origin: (f64, f64),
}

impl<'a> Panel<'a> {
    /// The panel in a column and row, with its axes at `origin` inside of it.
    fn new(
        canvas: &'a mut Canvas,
        size: Size,
        (column, row): (f64, f64),
        origin: (f64, f64),
    ) -> Self {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let corner = (column * width / 2.0, row * height / 2.0);
        let pixel = (width / 640.0).min(height / 480.0);
        let origin = (corner.0 + origin.0 * pixel, corner.1 + origin.1 * pixel);
        Self {
            canvas,
            pixel,
            corner,
            origin,
        }
    }

    /// Position in the picture of the tip of a vector from the origin. The z axis
    /// points out of the paper: it is drawn down to the left at half its length.
    fn tip(&self, v: Vector3) -> (f64, f64) {
        let unit = 55.0 * self.pixel;
        let (right, up) = (v.x() - 0.35 * v.z(), v.y() - 0.35 * v.z());
        (self.origin.0 + right * unit, self.origin.1 - up * unit)
    }

    fn vector(&mut self, v: Vector3, color: Color, label: &str, place: (f64, f64)) {
        let tip = self.tip(v);
        self.canvas.arrow(self.origin, tip, 2.5 * self.pixel, color);
        let (right, down) = (place.0 * self.pixel, place.1 * self.pixel);
        self.text((tip.0 + right, tip.1 + down), color, label);
    }

    fn helper_line(&mut self, from: Vector3, to: Vector3) {
        let (from, to) = (self.tip(from), self.tip(to));
        self.canvas.line(from, to, 1.5 * self.pixel, PENCIL);
    }

    fn title(&mut self, name: &str, note: &str) {
        for (down, text) in [(12.0, name), (216.0, note)] {
            let (right, down) = (12.0 * self.pixel, down * self.pixel);
            self.text((self.corner.0 + right, self.corner.1 + down), INK, text);
        }
    }

    fn text(&mut self, at: (f64, f64), color: Color, text: &str) {
        // Rounded down; 0 in the smallest picture, which has no letters.
        let dot = (2.0 * self.pixel) as u32;
        self.canvas.text(at, dot, color, text);
    }
}

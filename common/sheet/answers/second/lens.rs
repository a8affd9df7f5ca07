//! A lens: from the strata of a square, bent into a disc, to a point in the plane in focus.

use crate::functions::*;

/// A flat shape across the gaze: white to the left of x = 0, or a lamp.
enum Flat {
    Rectangle { left: f64, low: f64, high: f64 },
    Lamp { radius: f64, glow: f64 },
}

/// The glow of the first shape, from the eye on, that the way from (x, y) of the lens to (x, y) + z (dx, dy) at the
/// depth z meets.
fn seen(shapes: &[(f64, Flat)], [x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
    for (depth, shape) in shapes {
        let [x, y] = [x + depth * dx, y + depth * dy];
        match *shape {
            Flat::Rectangle { left, low, high } => {
                if left < x && x < 0.0 && low < y && y < high {
                    return 1.0;
                }
            }
            Flat::Lamp { radius, glow } => {
                if libm::hypot(x, y) < radius {
                    return glow;
                }
            }
        }
    }
    0.0
}

/// The point of the disc of radius 1 to which a point of the square from -1 to 1 goes: squares become circles
/// (Shirley, Chiu: A Low Distortion Map Between Disk and Square, 1997).
fn on_disc([a, b]: [f64; 2]) -> [f64; 2] {
    if a == 0.0 && b == 0.0 {
        return [0.0; 2];
    }
    let (radius, angle) = if a.abs() > b.abs() {
        (a, FRAC_PI_4 * b / a)
    } else {
        (b, FRAC_PI_2 - FRAC_PI_4 * a / b)
    };
    [radius * libm::cos(angle), radius * libm::sin(angle)]
}

pub fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    let lamp = [(
        5.0,
        Flat::Lamp {
            radius: 0.12,
            glow: 10.0,
        },
    )];
    let edges = [
        (
            1.25,
            Flat::Rectangle {
                left: -4.0,
                low: -4.0,
                high: -0.5,
            },
        ),
        (
            2.0,
            Flat::Rectangle {
                left: -2.5,
                low: -0.2,
                high: 0.2,
            },
        ),
        (
            5.0,
            Flat::Rectangle {
                left: -20.0,
                low: 2.0,
                high: 10.0,
            },
        ),
    ];
    let shapes: &[(f64, Flat)] = if scene == "lens-light" { &lamp } else { &edges };
    let focus = if scene == "lens-infinity" { 1e30 } else { 2.0 };
    let radius = if matches!(scene, "lens-pinhole" | "lens-camera" | "lens-rays") {
        0.0
    } else {
        0.5
    };
    let cells = if radius > 0.0 { samples.isqrt() } else { 1 };
    let mut image = Image::black(Size::new(300, 200)?)?;
    for (row, pixels) in (0..).zip(image.rows_mut()) {
        for (column, pixel) in (0..).zip(pixels) {
            let random = PixelRandom::new(crate::seed() ^ 0xF0C5, column, row);
            let aim = [f64::from(column) - 149.5, 99.5 - f64::from(row)].map(|way| way / 100.0);
            let mut sum = 0.0;
            for i in 0..cells * cells {
                let square = [(i % cells, 0), (i / cells, 1)].map(|(cell, n)| {
                    let inside = random.uniform(u64::from(2 * i + n));
                    2.0 * (f64::from(cell) + inside) / f64::from(cells) - 1.0
                });
                let from = on_disc(square).map(|c| c * radius);
                // To the point (aim, 1) times the focus.
                let way = [0, 1].map(|k| (aim[k] * focus - from[k]) / focus);
                sum += seen(shapes, from, way);
            }
            let rays = f64::from(cells * cells);
            *pixel = Color::gray(if scene == "lens-rays" {
                rays / f64::from(samples)
            } else {
                sum / rays
            });
        }
    }
    Ok(image)
}

//! More kinds of pictures; some were kept aside while the sampler was tuned.

use common::Color;

use crate::kinds::{Kind, Light, Numbers, PIXEL};

pub const UNSEEN: [Kind; 8] = [
    kind("foliage", foliage),
    kind("narrowing rings", rings),
    kind("crossing wires", wires),
    kind("glaring highlights", highlights),
    kind("glints on waves", glints),
    kind("a lone box", lone),
    kind("gravel", gravel),
    kind("stars at dusk", stars),
];

const fn kind(name: &'static str, make: fn(Numbers) -> Light) -> Kind {
    Kind { name, make }
}

/// Overlapping leaves of many sizes.
fn foliage(mut numbers: Numbers) -> Light {
    let leaves = numbers.list(30.0, 90.0, |numbers| {
        let long = numbers.between(0.003, 0.08);
        (
            numbers.place(),
            numbers.turn(),
            long,
            numbers.between(0.05, 0.5),
            numbers.color(),
        )
    });
    Box::new(move |x, y| {
        for ((left, low), (sin, cos), long, flat, color) in &leaves {
            let (dx, dy) = (x - left, y - low);
            let (along, across) = (dx * cos + dy * sin, dy * cos - dx * sin);
            if along.abs() + across.abs() / flat < *long {
                return *color;
            }
        }
        Color::new(0.5, 0.7, 0.9)
    })
}

fn rings(mut numbers: Numbers) -> Light {
    let ((left, low), rate) = (numbers.place(), numbers.between(50.0, 3000.0));
    Box::new(move |x, y| {
        let squared = (x - left) * (x - left) + (y - low) * (y - low);
        Color::gray(0.5 + 0.5 * libm::cos(rate * squared))
    })
}

/// Wires before light that changes evenly.
fn wires(mut numbers: Numbers) -> Light {
    let dark = Color::gray(numbers.between(0.0, 0.5));
    let wires = numbers.list(2.0, 10.0, |numbers| {
        (
            numbers.place(),
            numbers.turn(),
            numbers.between(0.1, 0.8) * PIXEL,
        )
    });
    Box::new(move |x, y| {
        let mut wires = wires.iter();
        let is_on = wires.any(|((left, low), (sin, cos), width)| {
            2.0 * ((x - left) * sin - (y - low) * cos).abs() < *width
        });
        if is_on {
            dark
        } else {
            Color::new(0.4 + 0.5 * x, 0.6, 0.9 - 0.3 * y)
        }
    })
}

/// Highlights brighter than white, on balls.
fn highlights(mut numbers: Numbers) -> Light {
    let balls = numbers.list(1.0, 30.0, |numbers| {
        let (radius, power) = (numbers.between(0.01, 0.2), numbers.between(5.0, 2000.0));
        (numbers.place(), radius, power, numbers.color())
    });
    Box::new(move |x, y| {
        for ((left, low), radius, power, color) in &balls {
            let (u, v) = ((x - left) / radius, (y - low) / radius);
            let squared = u * u + v * v;
            if squared < 1.0 {
                let lit = (0.4 * u + 0.5 * v + 0.77 * (1.0 - squared).sqrt()).max(0.0);
                return *color * (0.1 + 0.7 * lit) + Color::gray(3.0 * libm::pow(lit, *power));
            }
        }
        Color::gray(0.1)
    })
}

/// Discs up to eight times as bright as white.
fn glints(mut numbers: Numbers) -> Light {
    let rate = numbers.between(5.0, 40.0);
    let glints = numbers.list(1.0, 25.0, |numbers| {
        let radius = numbers.between(0.1, 0.8) * PIXEL;
        (numbers.place(), radius, numbers.between(1.0, 8.0))
    });
    Box::new(move |x, y| {
        for ((left, low), radius, bright) in &glints {
            if (x - left) * (x - left) + (y - low) * (y - low) < radius * radius {
                return Color::gray(*bright);
            }
        }
        let wave = libm::sin(rate * x) * libm::cos(1.7 * rate * y);
        Color::new(0.1, 0.2, 0.4) * (1.0 + 0.3 * wave)
    })
}

fn lone(mut numbers: Numbers) -> Light {
    let ((left, low), color) = (numbers.place(), numbers.color());
    let half = numbers.between(0.2, 1.5) * PIXEL;
    Box::new(move |x, y| {
        let is_inside = (x - left).abs().max((y - low).abs()) < half;
        if is_inside { color } else { Color::BLACK }
    })
}

/// Stones of all sizes: each place shows the stone whose middle is nearest, and the joint
/// where two are about as near.
fn gravel(mut numbers: Numbers) -> Light {
    let stones = numbers.list(10.0, 120.0, |numbers| (numbers.place(), numbers.color()));
    let joint = numbers.between(0.2, 2.0) * PIXEL;
    Box::new(move |x, y| {
        let (mut nearest, mut next, mut seen) = (f64::INFINITY, f64::INFINITY, Color::BLACK);
        for ((left, low), color) in &stones {
            let distance = ((x - left) * (x - left) + (y - low) * (y - low)).sqrt();
            if distance < nearest {
                (next, nearest, seen) = (nearest, distance, *color);
            } else {
                next = next.min(distance);
            }
        }
        if next - nearest < joint {
            Color::gray(0.1)
        } else {
            seen * (1.0 - 2.0 * nearest)
        }
    })
}

/// Small discs, most of them far smaller than a pixel, before light that changes evenly.
fn stars(mut numbers: Numbers) -> Light {
    let (zenith, horizon) = (numbers.between(0.0, 0.1), numbers.color());
    let stars = numbers.list(1.0, 60.0, |numbers| {
        let share = numbers.between(0.2, 1.0);
        (
            numbers.place(),
            0.6 * PIXEL * share * share,
            numbers.color(),
        )
    });
    Box::new(move |x, y| {
        for ((left, low), radius, color) in &stars {
            if (x - left) * (x - left) + (y - low) * (y - low) < radius * radius {
                return *color;
            }
        }
        Color::gray(zenith) + horizon * (0.5 * (1.0 - y / 0.75) * (1.0 - y / 0.75))
    })
}

//! Kinds of pictures with which the sampler was tuned.

use common::Color;

use crate::kinds::{Kind, Light, Numbers, PIXEL, ball};

pub const TUNED: [Kind; 9] = [
    kind("needles", needles),
    kind("rims of spot lights", spots),
    kind("small far spheres", far_spheres),
    kind("bars and spheres in a mirror", mirrored),
    kind("checkered floor to the horizon", horizon),
    kind("fence thinner than a pixel", fence),
    kind("flat ellipsoids", ellipsoids),
    kind("almost level edges", level),
    kind("thin poles and their shadows", poles),
];

const fn kind(name: &'static str, make: fn(Numbers) -> Light) -> Kind {
    Kind { name, make }
}

fn needles(mut numbers: Numbers) -> Light {
    let back = Color::gray(numbers.between(0.0, 0.1));
    let needles = numbers.list(3.0, 15.0, |numbers| {
        let ((x, y), (sin, cos)) = (numbers.place(), numbers.turn());
        let (length, width) = (numbers.between(0.2, 1.0), numbers.between(0.3, 2.5) * PIXEL);
        (x, y, sin, cos, length, width, numbers.color())
    });
    Box::new(move |x, y| {
        for (left, low, sin, cos, length, width, color) in &needles {
            let (dx, dy) = (x - left, y - low);
            let (along, across) = (dx * cos + dy * sin, dy * cos - dx * sin);
            let share = 1.0 - along / length;
            if along > 0.0 && 2.0 * across.abs() < width * share {
                return *color;
            }
        }
        back
    })
}

fn spots(mut numbers: Numbers) -> Light {
    let spots = numbers.list(1.0, 6.0, |numbers| {
        let (radius, flat) = (numbers.between(0.005, 0.06), numbers.between(0.3, 1.0));
        (numbers.place(), radius, flat, numbers.color())
    });
    Box::new(move |x, y| {
        let mut light = Color::gray(0.05);
        for ((left, low), radius, flat, color) in &spots {
            let (dx, dy) = ((x - left) / radius, (y - low) / (flat * radius));
            let squared = dx * dx + dy * dy;
            if squared < 1.0 {
                light += *color * (1.0 - 0.5 * squared);
            }
        }
        light
    })
}

fn far_spheres(mut numbers: Numbers) -> Light {
    let spheres = numbers.list(5.0, 120.0, |numbers| {
        let radius = numbers.between(0.15, 1.2) * PIXEL;
        (numbers.place(), radius, numbers.color())
    });
    Box::new(move |x, y| {
        let lit = |((left, low), radius, color): &((f64, f64), f64, Color)| {
            Some(*color * ball((x - left) / radius, (y - low) / radius)?)
        };
        spheres.iter().find_map(lit).unwrap_or(Color::gray(0.02))
    })
}

fn mirrored(mut numbers: Numbers) -> Light {
    let (left, low) = (numbers.between(0.3, 0.7), numbers.between(0.25, 0.5));
    let (radius, mirrors) = (numbers.between(0.1, 0.3), numbers.between(0.3, 0.9));
    let (bars, spheres) = (numbers.between(20.0, 120.0), numbers.between(5.0, 30.0));
    Box::new(move |x, y| {
        let (dx, dy) = ((x - left) / radius, (y - low) / radius);
        let squared = dx * dx + dy * dy;
        if squared >= 1.0 {
            return Color::gray(0.2 + 0.3 * y);
        }
        // The mirrored ray meets a wall of bars and spheres.
        let z = (1.0 - squared).sqrt();
        let towards = 2.0 * z / (2.5 - 2.0 * z * z);
        let (u, v) = (towards * dx, towards * dy);
        let is_bar = v > 0.0 && (u * bars).rem_euclid(6.0) < 0.5;
        let in_cell = |at: f64| ((at * spheres).rem_euclid(2.0) - 1.0) / 0.3;
        let seen = if is_bar {
            0.9
        } else {
            ball(in_cell(u), in_cell(v)).unwrap_or(0.1)
        };
        Color::gray(0.1) + Color::new(1.0, 0.9, 0.8) * (mirrors * seen)
    })
}

fn horizon(mut numbers: Numbers) -> Light {
    let (height, near) = (numbers.between(0.2, 0.5), numbers.between(0.05, 0.5));
    let ((sin, cos), shift) = (numbers.turn(), numbers.between(0.0, 1.0));
    let (light, dark) = (numbers.color(), numbers.color());
    Box::new(move |x, y| {
        if y >= height {
            return Color::new(0.5, 0.6, 0.9);
        }
        let far = near / (height - y);
        let (u, v) = (4.0 * far * (x - 0.5), far + shift);
        let square = (u * cos - v * sin).floor() + (u * sin + v * cos).floor();
        if square.rem_euclid(2.0) < 1.0 {
            light
        } else {
            dark
        }
    })
}

fn fence(mut numbers: Numbers) -> Light {
    let (pitch, share) = (
        numbers.between(0.8, 6.0) * PIXEL,
        numbers.between(0.05, 0.4),
    );
    let (slant, color) = (numbers.between(-0.2, 0.2), numbers.color());
    let (top, bottom) = (numbers.between(0.4, 0.7), numbers.between(0.05, 0.3));
    Box::new(move |x, y| {
        let post = ((x + slant * y) / pitch).rem_euclid(1.0) < share;
        if post && y < top && y > bottom {
            color
        } else {
            Color::gray(0.3 + 0.4 * y)
        }
    })
}

fn ellipsoids(mut numbers: Numbers) -> Light {
    let all = numbers.list(2.0, 20.0, |numbers| {
        let (long, flat) = (numbers.between(0.02, 0.3), numbers.between(0.002, 0.03));
        (numbers.place(), numbers.turn(), long, flat, numbers.color())
    });
    Box::new(move |x, y| {
        for ((left, low), (sin, cos), long, flat, color) in &all {
            let (dx, dy) = (x - left, y - low);
            let (along, across) = (dx * cos + dy * sin, dy * cos - dx * sin);
            if let Some(lit) = ball(along / long, across / (long * flat)) {
                return *color * lit;
            }
        }
        Color::gray(0.05 + 0.2 * x)
    })
}

fn level(mut numbers: Numbers) -> Light {
    let mut edges = numbers.list(1.0, 4.0, |numbers| {
        let slope = numbers.between(-0.1, 0.1);
        (
            numbers.between(0.0, 0.75),
            slope * slope * slope,
            numbers.color(),
        )
    });
    edges.sort_by(|a, b| a.0.total_cmp(&b.0));
    Box::new(move |x, y| {
        let above = |(low, slope, _): &&(f64, f64, Color)| y < low + slope * x;
        edges
            .iter()
            .find(above)
            .map_or(Color::gray(0.9), |edge| edge.2)
    })
}

fn poles(mut numbers: Numbers) -> Light {
    let dark = numbers.between(0.3, 0.8);
    let poles = numbers.list(3.0, 18.0, |numbers| {
        let (width, height) = (
            numbers.between(0.15, 1.5) * PIXEL,
            numbers.between(0.1, 0.5),
        );
        (numbers.place(), width, height, numbers.between(-1.0, 1.0))
    });
    Box::new(move |x, y| {
        let mut light = Color::gray(0.9 / (1.0 + (x - 0.4) * (x - 0.4) + (y - 0.3) * (y - 0.3)));
        for ((left, low), width, height, slant) in &poles {
            let up = y - low;
            if (x - left).abs() < 0.5 * width && up > 0.0 && up < *height {
                return Color::new(0.6, 0.3, 0.2);
            }
            let down = -up / 0.4;
            let beside = (x - left - slant * down).abs();
            if down > 0.0 && down < *height && beside < 0.5 * width * (1.0 - down) {
                light = Color::gray(dark);
            }
        }
        light
    })
}

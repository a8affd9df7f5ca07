//! Parts that the benchmarks share: scenes, random numbers, samples of a pixel, rows of tables.
#![allow(dead_code, reason = "no benchmark uses all of them")]

mod objects;
pub mod scene;

use engine::adaptive::PixelRandom;
use engine::{Basis, Camera, Sampler};
use glam::DVec3;

/// The camera at an eye that looks along a direction, held upright.
pub fn camera(e: DVec3, gaze: DVec3, half_tangent: f64) -> Camera<'static> {
    let w = -gaze.normalize();
    let u = DVec3::Y.cross(w).normalize();
    let v = w.cross(u);
    let basis = Basis { e, u, v, w };
    Camera::Perspective {
        basis,
        half_tangent,
    }
}

/// Random numbers, one after the other.
pub struct Numbers {
    random: PixelRandom,
    next: u64,
}

impl Numbers {
    /// Other numbers for each seed and index.
    pub fn new(seed: u64, index: u32) -> Self {
        Self {
            random: PixelRandom::new(seed, index, 0),
            next: 0,
        }
    }

    /// A number between two others.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        self.next += 1;
        least + (most - least) * self.random.uniform(self.next - 1)
    }

    /// A point in a box between two corners.
    pub fn in_box(&mut self, least: DVec3, most: DVec3) -> DVec3 {
        let [x, y, z] = [0, 1, 2].map(|axis| self.between(least[axis], most[axis]));
        DVec3::new(x, y, z)
    }

    /// A point in a cube around the origin, whose edge is twice as long as `half`.
    pub fn in_cube(&mut self, half: f64) -> DVec3 {
        self.in_box(DVec3::splat(-half), DVec3::splat(half))
    }
}

/// Samples on a square grid in each pixel, with this number of cells in each direction. With
/// a seed, each sample lies anywhere in its cell, otherwise in the middle.
pub struct Grid(pub u32, pub Option<u64>);

impl Sampler for Grid {
    fn samples(&self) -> u32 {
        self.0 * self.0
    }

    fn place(&self, i: u32, column: u32, row: u32) -> (f64, f64) {
        let (dx, dy) = match self.1 {
            None if self.0 == 1 => return (0.5, 0.5),
            None => (0.5, 0.5),
            Some(seed) => {
                let (random, first) = (PixelRandom::new(seed, column, row), 2 * u64::from(i));
                (random.uniform(first), random.uniform(first + 1))
            }
        };
        let in_cell = |cell: u32, d: f64| (f64::from(cell) + d) / f64::from(self.0);
        (in_cell(i % self.0, dx), in_cell(i / self.0, dy))
    }
}

/// The numbers among the words of a text.
pub fn numbers_in(text: &str) -> Vec<f64> {
    let words = text.split(' ').filter_map(|word| word.parse().ok());
    words.collect()
}

/// Prints a row of a table: a name, and numbers, of which missing ones are NaN.
pub fn print_row(name: &str, numbers: impl IntoIterator<Item = f64>) {
    let numbers = numbers.into_iter();
    let numbers = numbers.map(|number| format!(" {number:>8.2} |"));
    println!("| {name:<32} |{}", numbers.collect::<String>());
}

/// Prints the head of a table, whose columns are eight letters wide.
pub fn print_head(name: &str, columns: &[&str]) {
    let heads = columns.iter().map(|head| format!(" {head:>8} |"));
    println!("| {name:<32} |{}", heads.collect::<String>());
    println!("|---|{}", "---:|".repeat(columns.len()));
}

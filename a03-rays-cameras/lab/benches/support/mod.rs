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

/// Samples in the middles of the cells of a square grid in each pixel.
pub struct Grid {
    /// The number of cells in each direction.
    pub side: u32,
}

impl Grid {
    /// One sample in the middle of the pixel.
    pub const ONE: Self = Self { side: 1 };
}

impl Sampler for Grid {
    fn samples(&self) -> u32 {
        self.side * self.side
    }

    fn place(&self, i: u32, _column: u32, _row: u32) -> (f64, f64) {
        let middle = |cell: u32| (f64::from(cell) + 0.5) / f64::from(self.side);
        (middle(i % self.side), middle(i / self.side))
    }
}

/// The numbers among the words of a text.
pub fn numbers_in(text: &str) -> Vec<f64> {
    text.split(' ')
        .filter_map(|word| word.parse().ok())
        .collect()
}

/// Prints a row of a table: a name, and numbers, of which missing ones are NaN.
pub fn print_row(name: &str, numbers: impl IntoIterator<Item = f64>) {
    print!("| {name:<32} |");
    for number in numbers {
        print!(" {number:>8.2} |");
    }
    println!();
}

/// Prints the head of a table, whose columns are eight letters wide.
pub fn print_head(name: &str, columns: &[&str]) {
    print!("| {name:<32} |");
    for column in columns {
        print!(" {column:>8} |");
    }
    println!("\n|---|{}", "---:|".repeat(columns.len()));
}

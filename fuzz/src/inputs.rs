//! Inputs that are the same every time: seeds, changes of them, and random
//! bytes.

use std::fs;
use std::path::Path;

use a03_rays_cameras::PixelRandom;

/// Numbers at which lengths and sizes turn over.
const TURNS: [u8; 6] = [0, 1, 0x7F, 0x80, 0xFE, 0xFF];

/// Checks the files in a folder of `seeds/`, and then this number of inputs that
/// are nearly right: each file in turn with a few changes.
///
/// # Panics
///
/// If the check does, or if the folder cannot be read.
pub fn check_near(seeds: &str, inputs: u32, check: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("seeds")
        .join(seeds);
    let files = fs::read_dir(folder).expect("the seeds");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    // In one order on every system.
    paths.sort();
    let seeds: Vec<_> = paths
        .iter()
        .map(|path| fs::read(path).expect("a seed"))
        .collect();
    for seed in &seeds {
        check(seed);
    }
    for (number, seed) in (0..inputs).zip(seeds.iter().cycle()) {
        check(&changed(seed, number));
    }
}

/// Checks this number of inputs of random bytes, of all lengths below `longest`.
///
/// # Panics
///
/// If the check does.
pub fn check_random(longest: u32, inputs: u32, check: fn(&[u8])) {
    (0..inputs).for_each(|number| check(&random(number % longest, number)));
}

/// The bytes with one to eight changes: some flipped, taken away, repeated,
/// replaced by an extreme or cut off. The same `number` makes the same changes.
fn changed(bytes: &[u8], number: u32) -> Vec<u8> {
    let random = PixelRandom::new(0, number, bytes.len() as u32);
    let mut drawn = 0..;
    let mut below = |limit: usize| {
        let uniform = drawn.next().map_or(0.0, |n| random.uniform(n));
        (uniform * limit as f64) as usize
    };
    let mut bytes = bytes.to_owned();
    for _ in 0..=below(8) {
        let at = below(bytes.len() + 1);
        let some = (at + 1 + below(16)).min(bytes.len());
        match below(6) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at.min(some)..some)),
            2 => {
                let again = bytes[at.min(some)..some].to_vec();
                bytes.splice(at..at, again);
            }
            3 => bytes.insert(at, below(256) as u8),
            4 => bytes
                .get_mut(at)
                .into_iter()
                .for_each(|b| *b = TURNS[below(6)]),
            _ => bytes
                .get_mut(at)
                .into_iter()
                .for_each(|b| *b ^= 1 << below(8)),
        }
    }
    bytes
}

fn random(length: u32, number: u32) -> Vec<u8> {
    let random = PixelRandom::new(1, number, length);
    let bytes = (0..length).map(|n| (random.uniform(n.into()) * 256.0) as u8);
    bytes.collect()
}

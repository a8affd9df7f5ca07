//! The targets with random inputs, the same ones every time.

mod numbers;

use std::fs;
use std::path::Path;

use fuzz::{images, scenes};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::RngSeed;

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..ProptestConfig::default()
    }
}

/// The files of `seeds/images`.
fn seeds() -> Vec<Vec<u8>> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/seeds/images");
    let files = fs::read_dir(Path::new(folder)).expect("the seeds");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    // In the same order on every system.
    paths.sort();
    let files = paths.iter().map(|path| fs::read(path).expect("a seed"));
    files.collect()
}

/// A change of some bytes: its kind, its place, and a byte or a length.
type Change = (u8, Index, u8);

fn change() -> impl Strategy<Value = Change> {
    // Bytes with which lengths and signs change most.
    let extremes = select(vec![0, 1, 0x7F, 0x80, 0xFE, 0xFF]);
    (0..6_u8, any::<Index>(), prop_oneof![extremes, any::<u8>()])
}

fn changed(mut bytes: Vec<u8>, changes: &[Change]) -> Vec<u8> {
    for (kind, at, value) in changes {
        let at = at.index(bytes.len() + 1);
        let some = at..(at + 1 + usize::from(value % 16)).min(bytes.len()).max(at);
        match kind {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(some)),
            2 => {
                let again = bytes[some].to_vec();
                bytes.splice(at..at, again);
            }
            3 => bytes.insert(at, *value),
            _ => bytes.iter_mut().skip(at).take(1).for_each(|b| *b = *value),
        }
    }
    bytes
}

#[test]
fn seeds_of_pictures_do_no_harm() {
    for seed in seeds() {
        images::check(&seed);
    }
}

proptest! {
    #![proptest_config(config(10_000))]

    #[test]
    fn changed_pictures_do_no_harm(seed in select(seeds()), changes in vec(change(), 1..=8)) {
        images::check(&changed(seed, &changes));
    }
}

proptest! {
    #![proptest_config(config(3000))]

    #[test]
    fn scenes_do_no_harm(bytes in vec(any::<u8>(), 0..1000)) {
        scenes::check(&bytes);
    }
}

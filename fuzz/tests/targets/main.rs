//! The targets with random inputs, the same ones every time.

mod numbers;

use std::fs::{self, DirEntry};

use arbitrary::Unstructured;
use fuzz::{images, scene_files, scenes};
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

/// The files of `seeds/images`, in the same order on every system.
fn seeds() -> Vec<Vec<u8>> {
    let files = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/seeds/images"));
    let read = |file: Result<DirEntry, _>| fs::read(file.expect("a file").path());
    let seeds = files.expect("the seeds").map(read);
    let mut seeds: Vec<_> = seeds.map(|seed| seed.expect("a seed")).collect();
    seeds.sort();
    seeds
}

/// A change of some bytes: its kind, its place, and a byte or a length.
fn change() -> impl Strategy<Value = (u8, Index, u8)> {
    // Bytes with which lengths and signs change most.
    let extremes = select(vec![0, 1, 0x7F, 0x80, 0xFE, 0xFF]);
    (0..6_u8, any::<Index>(), prop_oneof![extremes, any::<u8>()])
}

fn changed(mut bytes: Vec<u8>, changes: &[(u8, Index, u8)]) -> Vec<u8> {
    for (kind, at, value) in changes {
        let at = at.index(bytes.len() + 1);
        let some = at..(at + 1 + usize::from(value % 16)).min(bytes.len()).max(at);
        match kind {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(some)),
            2 => bytes.insert(at, *value),
            _ => bytes.iter_mut().skip(at).take(1).for_each(|b| *b = *value),
        }
    }
    bytes
}

proptest! {
    #![proptest_config(config(10_000))]

    #[test]
    fn pictures_do_no_harm(seed in select(seeds()), changes in vec(change(), 0..=8)) {
        images::check(&changed(seed, &changes));
    }
}

proptest! {
    #![proptest_config(config(3000))]

    #[test]
    fn scene_files_do_no_harm(changes in vec(change(), 0..=8)) {
        let example = include_bytes!("../../../a07-transforms/scenes/shapes.toml");
        scene_files::check(&changed(example.to_vec(), &changes));
        let star = include_bytes!("../../../a07-transforms/scenes/star.ply");
        scene_files::check(&changed(star.to_vec(), &changes));
        let smooth = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//-1 2//1 -1//1\n";
        scene_files::check(&changed(smooth.to_vec(), &changes));
    }

    #[test]
    fn structures_of_scene_files_do_no_harm(bytes in vec(any::<u8>(), 0..1000)) {
        scene_files::check_structure(&bytes);
    }

    #[test]
    fn scenes_do_no_harm(bytes in vec(any::<u8>(), 0..1000)) {
        scenes::check(&bytes);
    }
}

proptest! {
    #![proptest_config(config(50_000))]

    /// Every result of a constructor agrees with its documentation. Too few bytes end the
    /// check early.
    #[test]
    fn numbers_do_no_harm(bytes in vec(any::<u8>(), 0..400)) {
        let _ = numbers::check(&mut Unstructured::new(&bytes));
    }
}

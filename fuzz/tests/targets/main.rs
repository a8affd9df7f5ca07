//! The targets with random inputs, the same ones every time.

mod numbers;

use std::fs;

use arbitrary::Unstructured;
use fuzz::{images, scenes};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::{RngSeed, TestRunner};

/// Calls a target with this number of random inputs.
fn check<S: Strategy>(cases: u32, inputs: &S, target: impl Fn(S::Value)) {
    let config = ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..ProptestConfig::default()
    };
    let target = |input| {
        target(input);
        Ok(())
    };
    let checked = TestRunner::new(config).run(inputs, target);
    checked.unwrap_or_else(|error| panic!("{error}"));
}

/// The files of `seeds/images`.
fn seeds() -> Vec<Vec<u8>> {
    let files = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/seeds/images"));
    let files = files.expect("the seeds");
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
            2 => bytes.insert(at, *value),
            _ => bytes.iter_mut().skip(at).take(1).for_each(|b| *b = *value),
        }
    }
    bytes
}

#[test]
fn pictures_do_no_harm() {
    for seed in seeds() {
        images::check(&seed);
    }
    let changed_seeds = (select(seeds()), vec(change(), 1..=8));
    check(10_000, &changed_seeds, |(seed, changes)| {
        images::check(&changed(seed, &changes));
    });
}

#[test]
fn scenes_do_no_harm() {
    check(3000, &vec(any::<u8>(), 0..1000), |bytes| {
        scenes::check(&bytes);
    });
}

/// Every result of a constructor agrees with its documentation. Too few bytes end the
/// check early.
#[test]
fn numbers_do_no_harm() {
    check(50_000, &vec(any::<u8>(), 0..400), |bytes| {
        let _ = numbers::check(&mut Unstructured::new(&bytes));
    });
}

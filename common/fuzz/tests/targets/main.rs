//! The targets with random inputs, the same ones every time: `libfuzzer` searches for others.

mod numbers;

use std::fs;

use a07_transforms::kinds::example_files;
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
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/seeds/images");
    let mut seeds = Vec::new();
    for file in fs::read_dir(folder).expect("the seeds") {
        let path = file.expect("a file").path();
        seeds.push(fs::read(path).expect("a seed"));
    }
    seeds.sort();
    seeds
}

/// Meshes in all forms that are read: normals, a face over two lines, a concave and a crossing
/// face, and PLY in three formats.
fn meshes() -> Vec<Vec<u8>> {
    let corners = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 1 1 0\nv 0 3 0\n";
    let faces = [
        "vn 0 0 1\nf 1//-1 2//1 -1//1\n",
        "f 1// 2/1/ 3 \\\n4\\\r\n 5\nf 5 3 2",
        "f 1 2 3 4 5 1\nf 1 3 2 5 4\nf 1 2\n",
        "vn nan 0 inf\nf 1//0 2//1 3//7\n",
    ];
    let mut meshes = vec![example_files::STAR.to_vec()];
    meshes.extend(faces.map(|faces| [corners, faces].concat().into_bytes()));
    meshes.push(binary_ply("binary_little_endian", i16::to_le_bytes));
    meshes.push(binary_ply("binary_big_endian", i16::to_be_bytes));
    meshes
}

/// A mesh of a face of five corners in PLY.
fn binary_ply(encoding: &str, to_bytes: fn(i16) -> [u8; 2]) -> Vec<u8> {
    let header = format!(
        "ply\nformat {encoding} 1.0\ncomment \u{fc}\nelement vertex 5\nproperty short x\n\
         property short y\nproperty short z\nelement face 1\n\
         property list short short vertex_indices\nend_header\n"
    );
    let mut bytes = header.into_bytes();
    let corners = [0, 0, 0, 3, 0, 0, 3, 3, 0, 1, 1, 0, 0, 3, 0];
    let face = [5, 0, 1, 2, 3, 4];
    for number in corners.into_iter().chain(face) {
        bytes.extend(to_bytes(number));
    }
    bytes
}

/// A change of some bytes.
#[derive(Clone, Debug)]
struct Change {
    kind: ChangeKind,
    at: Index,
    /// A byte, or a length.
    value: u8,
}

#[derive(Clone, Copy, Debug)]
enum ChangeKind {
    Truncate,
    Remove,
    Insert,
    Replace,
}

/// Any change. Half of them replace a byte.
fn change() -> impl Strategy<Value = Change> {
    use ChangeKind::{Insert, Remove, Replace, Truncate};
    let kind = select(vec![Truncate, Remove, Insert, Replace, Replace, Replace]);
    // Bytes with which lengths and signs change most.
    let extremes = select(vec![0, 1, 0x7F, 0x80, 0xFE, 0xFF]);
    let value = prop_oneof![extremes, any::<u8>()];
    (kind, any::<Index>(), value).prop_map(|(kind, at, value)| Change { kind, at, value })
}

fn changed(mut bytes: Vec<u8>, changes: &[Change]) -> Vec<u8> {
    for change in changes {
        let at = change.at.index(bytes.len() + 1);
        match change.kind {
            ChangeKind::Truncate => bytes.truncate(at),
            ChangeKind::Remove => {
                let end = at + 1 + usize::from(change.value % 16);
                bytes.drain(at..end.min(bytes.len()));
            }
            ChangeKind::Insert => bytes.insert(at, change.value),
            ChangeKind::Replace => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte = change.value;
                }
            }
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
        let example = example_files::SHAPES.as_bytes().to_vec();
        scene_files::check(&changed(example, &changes));
    }

    #[test]
    fn meshes_do_no_harm(mesh in select(meshes()), changes in vec(change(), 0..=8)) {
        scene_files::check(&changed(mesh, &changes));
    }

    #[test]
    fn scenes_do_no_harm(bytes in vec(any::<u8>(), 0..1000)) {
        scenes::check(&bytes);
    }
}

proptest! {
    #![proptest_config(config(1000))]

    #[test]
    fn structures_of_scene_files_do_no_harm(bytes in vec(any::<u8>(), 0..1000)) {
        scene_files::check_structure(&bytes);
    }
}

proptest! {
    #![proptest_config(config(20_000))]

    /// Every result of a constructor agrees with its documentation. Too few bytes end the
    /// check early.
    #[test]
    fn numbers_do_no_harm(bytes in vec(any::<u8>(), 0..400)) {
        let _ = numbers::check(&mut Unstructured::new(&bytes));
    }
}

//! The targets with random inputs, the same ones every time.

mod numbers;

use std::fs::{self, DirEntry};

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
    let files = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/seeds/images"));
    let read = |file: Result<DirEntry, _>| fs::read(file.expect("a file").path());
    let seeds = files.expect("the seeds").map(read);
    let mut seeds: Vec<_> = seeds.map(|seed| seed.expect("a seed")).collect();
    seeds.sort();
    seeds
}

/// Meshes in all forms that are read: normals, a face over two lines, a concave and a crossing
/// face, and PLY in three formats, with strips.
fn meshes() -> Vec<Vec<u8>> {
    let corners = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 1 1 0\nv 0 3 0\n";
    let faces = [
        "vn 0 0 1\nf 1//-1 2//1 -1//1\n",
        "f 1// 2/1/ 3 \\\n4\\\r\n 5\nf 5 3 2",
        "f 1 2 3 4 5 1\nf 1 3 2 5 4\nf 1 2\n",
        "vn nan(ind) 0 1.#INF\nf 1//0 2//1 3//7\n",
    ];
    let mut meshes = vec![example_files::STAR.to_vec()];
    meshes.extend(faces.map(|faces| [corners, faces].concat().into_bytes()));
    for (encoding, strips) in [
        ("binary_little_endian", false),
        ("binary_big_endian", false),
        ("binary_big_endian", true),
    ] {
        let element = ["face", "tristrips"][usize::from(strips)];
        let header = format!(
            "ply\rformat {encoding} 1.0\rcomment \u{fc}\relement vertex 5\rproperty short x\r\
             property short y\rproperty short z\relement {element} 1\r\
             property list short short vertex_indices\rend_header\r"
        );
        let corners = [0_i16, 0, 0, 3, 0, 0, 3, 3, 0, 1, 1, 0, 0, 3, 0];
        let indices = if strips {
            vec![9, 0, 1, 4, 3, 2, -1, 0, 1, 2]
        } else {
            vec![5, 0, 1, 2, 3, 4]
        };
        let bytes = if encoding.contains("big") {
            i16::to_be_bytes
        } else {
            i16::to_le_bytes
        };
        let numbers = corners.into_iter().chain(indices).flat_map(bytes);
        meshes.push(header.bytes().chain(numbers).collect());
    }
    meshes
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
        let example = example_files::SHAPES.as_bytes().to_vec();
        scene_files::check(&changed(example, &changes));
    }

    #[test]
    fn meshes_do_no_harm(mesh in select(meshes()), changes in vec(change(), 0..=8)) {
        scene_files::check(&changed(mesh, &changes));
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

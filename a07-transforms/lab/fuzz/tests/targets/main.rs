//! The targets with random inputs, the same ones every time: `libfuzzer` searches for others.

mod numbers;

use std::fs;

use a07_transforms::registry::example_files;
use arbitrary::Unstructured;
use fuzz::{images, scene_files, scenes};
use testing::{Random, for_seeds};

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

/// Bytes with which lengths and signs change most.
const EXTREMES: [u8; 6] = [0, 1, 0x7F, 0x80, 0xFE, 0xFF];

/// The bytes with up to eight changes, half of which replace a byte.
fn changed(mut bytes: Vec<u8>, random: &mut Random) -> Vec<u8> {
    for _ in 0..random.below(9) {
        let at = random.below(bytes.len() as u32 + 1) as usize;
        let byte = match random.below(2) {
            0 => EXTREMES[random.below(6) as usize],
            _ => random.below(256) as u8,
        };
        match random.below(6) {
            0 => bytes.truncate(at),
            1 => {
                let end = at + 1 + usize::from(byte % 16);
                bytes.drain(at..end.min(bytes.len()));
            }
            2 => bytes.insert(at, byte),
            _ => {
                if let Some(replaced) = bytes.get_mut(at) {
                    *replaced = byte;
                }
            }
        }
    }
    bytes
}

/// Fewer bytes than these, each any byte.
fn any_bytes(end: u32, random: &mut Random) -> Vec<u8> {
    let count = random.below(end);
    (0..count).map(|_| random.below(256) as u8).collect()
}

#[test]
fn pictures_do_no_harm() {
    let seeds = seeds();
    for_seeds(10_000, |random| {
        let seed = seeds[random.below(seeds.len() as u32) as usize].clone();
        images::check(&changed(seed, random));
    });
}

#[test]
fn scene_files_do_no_harm() {
    for_seeds(1000, |random| {
        let example = example_files::SHAPES.as_bytes().to_vec();
        scene_files::check(&changed(example, random));
    });
}

#[test]
fn meshes_do_no_harm() {
    let meshes = meshes();
    for_seeds(1000, |random| {
        let mesh = meshes[random.below(meshes.len() as u32) as usize].clone();
        scene_files::check(&changed(mesh, random));
    });
}

#[test]
fn scenes_do_no_harm() {
    // A debug build takes several times as long, and `.ci/run` asks the release build, too.
    let count = if cfg!(debug_assertions) { 500 } else { 2000 };
    for_seeds(count, |random| scenes::check(&any_bytes(1000, random)));
}

#[test]
fn structures_of_scene_files_do_no_harm() {
    for_seeds(1000, |random| {
        scene_files::check_structure(&any_bytes(1000, random));
    });
}

/// Every result of a constructor agrees with its documentation. Too few bytes end the
/// check early.
#[test]
fn numbers_do_no_harm() {
    for_seeds(20_000, |random| {
        let bytes = any_bytes(400, random);
        let _ = numbers::check(&mut Unstructured::new(&bytes));
    });
}

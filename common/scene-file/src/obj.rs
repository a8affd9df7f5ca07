//! Reads OBJ files (Wavefront, *Advanced Visualizer*, appendix B, *Object Files*): corners, normals
//! and faces.

use std::str::SplitWhitespace;

use crate::mesh::{Mesh, NONE};

/// The corners, normals and faces, cut into triangles from their first corner. The error is a
/// clause.
pub fn read(bytes: &[u8]) -> Result<Mesh, String> {
    let mut mesh = Mesh::default();
    for (number, line) in (1..).zip(String::from_utf8_lossy(bytes).lines()) {
        let added = add(line, &mut mesh);
        added.map_err(|right| format!("line {number} is \"{line}\", but {right}"))?;
    }
    Ok(mesh)
}

/// Adds the content of a line, if a mesh has it.
fn add(line: &str, mesh: &mut Mesh) -> Result<(), &'static str> {
    let line = line.split('#').next().unwrap_or_default();
    let mut words = line.split_whitespace();
    match words.next() {
        Some("v") => {
            let corner = vector(words).ok_or("a corner is three numbers, as v 0 1 0")?;
            mesh.corners.push(corner);
        }
        Some("vn") => {
            let normal = vector(words).ok_or("a normal is three numbers, as vn 0 1 0")?;
            mesh.normals.push(normal);
        }
        Some("f") => {
            let corners = words.map(|word| corner(word, mesh));
            let corners = corners.collect::<Option<Vec<_>>>();
            let face = corners.and_then(|corners| mesh.add_face(&corners));
            face.ok_or("a face is the numbers of three corners or more, as f 1 2 3")?;
        }
        _ => (),
    }
    Ok(())
}

fn vector(words: SplitWhitespace) -> Option<[f64; 3]> {
    let numbers = words.take(3).map(|word| word.parse().ok());
    numbers.collect::<Option<Vec<_>>>()?.try_into().ok()
}

/// The indices of a corner and of its normal, as in `1`, `1/2`, `1//3` and `1/2/3`.
fn corner(word: &str, mesh: &Mesh) -> Option<[u32; 2]> {
    let mut parts = word.split('/');
    let corner = index(parts.next()?, mesh.corners.len())?;
    let normal = parts.nth(1).map(|part| index(part, mesh.normals.len()));
    Some([corner, normal.unwrap_or(Some(NONE))?])
}

/// An index from 0, by a number from 1, or by one below 0 that counts back from the last line.
fn index(number: &str, lines: usize) -> Option<u32> {
    let index = match number.parse::<i64>().ok()? {
        back if back < 0 => lines as i64 + back,
        number => number - 1,
    };
    index.try_into().ok()
}

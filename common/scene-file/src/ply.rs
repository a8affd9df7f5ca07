//! Reads PLY files (Turk, *The PLY Polygon File Format*, 1994): text, and bytes with the least
//! first.

use crate::mesh::{Mesh, NONE};

/// The properties of a vertex: its place and its normal.
const COORDINATES: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// The vertices with their normals, and the faces, cut into triangles from their first corner.
/// The error is a clause.
pub fn read(bytes: &[u8]) -> Result<Mesh, String> {
    let (mut is_text, mut rest) = (true, bytes);
    // Names and counts, and the words of each property behind the first.
    let mut elements: Vec<(&str, u64, Vec<Vec<&str>>)> = Vec::new();
    loop {
        let end = rest.iter().position(|byte| *byte == b'\n');
        let (line, below) = rest.split_at(end.ok_or("it has no end_header")?);
        rest = &below[1..];
        let line = str::from_utf8(line).map_err(|_| "its header is no text")?;
        let words: Vec<_> = line.split_whitespace().collect();
        match (&words[..], elements.last_mut()) {
            (["ply" | "comment" | "obj_info", ..], _) => (),
            (["format", "ascii", ..], _) => is_text = true,
            (["format", "binary_little_endian", ..], _) => is_text = false,
            (["element", name, count], _) if let Ok(count) = count.parse() => {
                elements.push((name, count, Vec::new()));
            }
            (["property", words @ ..], Some((.., properties))) => properties.push(words.to_vec()),
            (["end_header"], _) => break,
            _ => return Err(format!("its header has the unknown line \"{line}\"")),
        }
    }
    let vertices = elements.iter().filter(|(name, ..)| *name == "vertex");
    let mut properties = vertices.flat_map(|(.., properties)| properties);
    let has_normals = properties.any(|words| words.ends_with(&["nx"]));
    let mut mesh = Mesh::default();
    let mut numbers = Numbers {
        is_text,
        has_normals,
        rest,
    };
    for (name, count, properties) in elements {
        // Things without properties take no bytes, so that any number of them may be promised.
        for i in 0..if properties.is_empty() { 0 } else { count } {
            let added = numbers.add(name, &properties, &mut mesh);
            added.ok_or_else(|| format!("{name} {i} lacks numbers"))?;
        }
    }
    Ok(mesh)
}

/// The numbers behind the header.
struct Numbers<'a> {
    is_text: bool,
    has_normals: bool,
    rest: &'a [u8],
}

impl Numbers<'_> {
    /// Adds a vertex or a face with these properties to the mesh; none if a number is missing.
    fn add(&mut self, element: &str, properties: &[Vec<&str>], mesh: &mut Mesh) -> Option<()> {
        let (mut vertex, mut list) = ([f64::NAN; 6], Vec::new());
        for property in properties {
            let (count, kind, name) = match property[..] {
                [kind, name] => (1, kind, name),
                ["list", count, kind, name] => (self.next(count)? as u64, kind, name),
                _ => return None,
            };
            list.clear();
            for _ in 0..count {
                list.push(self.next(kind)?);
            }
            match (element, COORDINATES.iter().position(|known| *known == name)) {
                ("vertex", Some(i)) => vertex[i] = *list.first()?,
                ("face", _) if name.starts_with("vertex_ind") => {
                    let index = |i: &f64| (i.fract() == 0.0 && *i >= 0.0).then_some(*i as u32);
                    let corner = |i| index(i).map(|i| [i, if self.has_normals { i } else { NONE }]);
                    mesh.add_face(&list.iter().map(corner).collect::<Option<Vec<_>>>()?)?;
                }
                _ => (),
            }
        }
        if element == "vertex" {
            let [x, y, z, normal @ ..] = vertex;
            mesh.corners.push([x, y, z]);
            mesh.normals.extend(self.has_normals.then_some(normal));
        }
        Some(())
    }

    /// The next number of a type.
    fn next(&mut self, kind: &str) -> Option<f64> {
        if self.is_text {
            let text = self.rest.trim_ascii_start();
            let end = text.iter().position(u8::is_ascii_whitespace);
            let word;
            (word, self.rest) = text.split_at(end.unwrap_or(text.len()));
            return str::from_utf8(word).ok()?.parse().ok();
        }
        Some(match kind {
            "char" | "int8" => i8::from_le_bytes(self.bytes()?).into(),
            "uchar" | "uint8" => u8::from_le_bytes(self.bytes()?).into(),
            "short" | "int16" => i16::from_le_bytes(self.bytes()?).into(),
            "ushort" | "uint16" => u16::from_le_bytes(self.bytes()?).into(),
            "int" | "int32" => i32::from_le_bytes(self.bytes()?).into(),
            "uint" | "uint32" => u32::from_le_bytes(self.bytes()?).into(),
            "float" | "float32" => f32::from_le_bytes(self.bytes()?).into(),
            "double" | "float64" => f64::from_le_bytes(self.bytes()?),
            _ => return None,
        })
    }

    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let bytes;
        (bytes, self.rest) = self.rest.split_first_chunk()?;
        Some(*bytes)
    }
}

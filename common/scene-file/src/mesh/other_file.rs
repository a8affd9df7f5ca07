//! Names of files that are no meshes of ours, for errors: those that students have instead.

use super::text::lines;

/// Bytes at the beginning, and the kind of file that has them.
const FIRST_BYTES: [(&[u8], &str); 13] = [
    (b"\x1F\x8B", "packed by gzip: unpack it first"),
    (b"PK\x03\x04", "packed by zip: unpack it first"),
    (b"\xFF\xFE", "text in UTF-16: save it as UTF-8"),
    (b"\xFE\xFF", "text in UTF-16: save it as UTF-8"),
    (b"glTF", "a glTF file: export it as OBJ or PLY"),
    (b"Kaydara FBX", "an FBX file: export it as OBJ or PLY"),
    (b"; FBX", "an FBX file: export it as OBJ or PLY"),
    (b"BLENDER", "a Blender file: export it as OBJ or PLY"),
    (
        b"\x28\xB5\x2F\xFD",
        "a Blender file: export it as OBJ or PLY",
    ),
    (b"OFF", "an OFF file: export it as OBJ or PLY"),
    (
        b"<?xml",
        "an XML file, such as COLLADA: export it as OBJ or PLY",
    ),
    (b"<", "a web page"),
    (
        b"version https://git-lfs",
        "a pointer of Git LFS: git lfs pull fetches the file",
    ),
];

const STL: &str = "an STL file: export it as OBJ or PLY";

/// The kind of a file whose first bytes no mesh has.
pub fn by_first_bytes(bytes: &[u8]) -> Option<&'static str> {
    for (first, kind) in FIRST_BYTES {
        if bytes.starts_with(first) {
            return Some(kind);
        }
    }
    match bytes.get(80..84) {
        None if bytes.is_empty() => Some("empty"),
        // The number of triangles behind a head of 80 bytes, which take 50 bytes each.
        Some(&[a, b, c, d]) => {
            let triangles = u64::from(u32::from_le_bytes([a, b, c, d]));
            let length = bytes.len() as u64;
            (triangles > 0 && length == 84 + 50 * triangles).then_some(STL)
        }
        _ => None,
    }
}

/// The kind of a text that has no faces of ours.
pub fn by_text(bytes: &[u8]) -> Option<&'static str> {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
    let has_line = |begin: &str| lines(&text).any(|line| line.trim_start().starts_with(begin));
    if text.starts_with("solid") {
        Some(STL)
    } else if text.trim_start().starts_with('{') {
        Some("a glTF file, or another one in JSON: export it as OBJ or PLY")
    } else if has_line("[") && text.contains('=') {
        Some("a TOML file, such as a scene")
    } else if has_line("newmtl") {
        Some("a file of materials (MTL), which belongs to an OBJ file")
    } else if has_line("cstype") || has_line("surf ") {
        Some("an OBJ file of curved surfaces only: export it with faces")
    } else {
        None
    }
}

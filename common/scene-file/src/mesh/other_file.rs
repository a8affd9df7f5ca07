//! Names of files that are no meshes of ours, for errors: those that people have instead.

/// Bytes at the beginning, and the kind of file that has them.
const FIRST_BYTES: [(&[u8], &str); 14] = [
    (b"\x1F\x8B", "packed by gzip: unpack it first"),
    (b"PK\x03\x04", "packed by zip: unpack it first"),
    (b"\xFF\xFE", UTF_16),
    (b"\xFE\xFF", UTF_16),
    (b"glTF", "a glTF file: export it as OBJ or PLY"),
    (
        b"{",
        "a glTF file, or another one in JSON: export it as OBJ or PLY",
    ),
    (b"Kaydara FBX", "an FBX file: export it as OBJ or PLY"),
    (b"; FBX", "an FBX file: export it as OBJ or PLY"),
    (b"BLENDER", "a Blender file: export it as OBJ or PLY"),
    (
        b"\x28\xB5\x2F\xFD",
        "a Blender file, or packed by zstd: export it as OBJ or PLY",
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

const UTF_16: &str = "text in UTF-16: save it as UTF-8";
const STL: &str = "an STL file: export it as OBJ or PLY";

/// Beginnings of lines, and the kind of text that has them but no faces of ours.
const LINES: [(&str, &str); 5] = [
    ("facet ", STL),
    ("[", "a TOML file, such as a scene"),
    (
        "newmtl",
        "a file of materials (MTL), which belongs to an OBJ file",
    ),
    ("cstype", CURVES),
    ("surf ", CURVES),
];

const CURVES: &str = "an OBJ file of curved surfaces only: export it with faces";

/// The kind of a file that begins as no mesh of ours does.
pub fn by_first_bytes(bytes: &[u8]) -> Option<&'static str> {
    // Web pages begin with empty lines.
    let begin = bytes.trim_ascii_start();
    let mut kinds = FIRST_BYTES.iter();
    let found = kinds.find(|(first, _)| begin.starts_with(first));
    match (found, bytes) {
        (Some((_, kind)), _) => Some(kind),
        (None, []) => Some("empty"),
        // Each Latin letter of UTF-16 has a byte 0.
        (None, [first, 0, ..] | [0, first, ..]) if first.is_ascii_graphic() => Some(UTF_16),
        (None, _) => is_binary_stl(bytes).then_some(STL),
    }
}

/// The kind of a text without faces.
pub fn by_lines(bytes: &[u8]) -> Option<&'static str> {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
    LINES.iter().find_map(|(begin, kind)| {
        let mut lines = text.split(['\n', '\r']).map(str::trim_start);
        lines.any(|line| line.starts_with(begin)).then_some(*kind)
    })
}

/// Behind a head of 80 bytes stands the number of triangles, which take 50 bytes each.
fn is_binary_stl(bytes: &[u8]) -> bool {
    let Some((count, triangles)) = bytes.get(80..).and_then(<[u8]>::split_first_chunk) else {
        return false;
    };
    let count = u64::from(u32::from_le_bytes(*count));
    count > 0 && triangles.len() as u64 == 50 * count
}

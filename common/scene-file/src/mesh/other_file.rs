//! Names of files that are no meshes of ours, by what they begin with, for errors.

/// Bytes at the beginning, and the kind of file that has them.
const FIRST_BYTES: [(&[u8], &str); 35] = [
    (b"\x1F\x8B", "packed by gzip: unpack it first"),
    (
        b"PK\x03\x04",
        "a zip archive, or a format that is one: unpack it first",
    ),
    (b"BZh", "packed by bzip2: unpack it first"),
    (b"\xFD7zXZ", "packed by xz: unpack it first"),
    (
        b"\x28\xB5\x2F\xFD",
        "packed by zstd, as newer Blender files are",
    ),
    (b"7z\xBC\xAF\x27\x1C", "a 7z archive: unpack it first"),
    (b"Rar!", "a rar archive: unpack it first"),
    (b"\xFF\xFE", "text in UTF-16: save it as UTF-8"),
    (b"\xFE\xFF", "text in UTF-16: save it as UTF-8"),
    (b"glTF", "a glTF file (GLB): export it as OBJ or PLY"),
    (
        b"Kaydara FBX Binary",
        "an FBX file: export it as OBJ or PLY",
    ),
    (b"; FBX", "an FBX file: export it as OBJ or PLY"),
    (b"BLENDER", "a Blender file: export it as OBJ or PLY"),
    (b"#VRML", "a VRML file: export it as OBJ or PLY"),
    (b"#usda", "a USD file: export it as OBJ or PLY"),
    (b"PXR-USDC", "a USD file: export it as OBJ or PLY"),
    (b"# vtk", "a VTK file: export it as OBJ or PLY"),
    (
        b"3D Geometry File Format",
        "a Rhino file: export it as OBJ or PLY",
    ),
    (b"ISO-10303-21", "a STEP file: export it as OBJ or PLY"),
    (b"\x89HDF", "an HDF5 file"),
    (b"Ogawa", "an Alembic file: export it as OBJ or PLY"),
    (b"\x89PNG", "a PNG picture"),
    (b"\xFF\xD8\xFF", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"%PDF", "a PDF file"),
    (
        b"<?xml",
        "an XML file, such as COLLADA or X3D: export it as OBJ or PLY",
    ),
    (b"<COLLADA", "a COLLADA file: export it as OBJ or PLY"),
    (b"<!DOCTYPE", "a web page"),
    (b"<!doctype", "a web page"),
    (b"<html", "a web page"),
    (
        b"version https://git-lfs",
        "only a pointer of Git LFS: git lfs pull fetches the file",
    ),
    (b"OFF", "an OFF file: export it as OBJ or PLY"),
    (b"COFF", "an OFF file: export it as OBJ or PLY"),
    (b"NOFF", "an OFF file: export it as OBJ or PLY"),
    (b"\x7FELF", "a program"),
];

/// The kind of a file whose first bytes no mesh has.
pub fn by_first_bytes(bytes: &[u8]) -> Option<&'static str> {
    let mut kinds = FIRST_BYTES.iter();
    let known = kinds.find(|(first, _)| bytes.starts_with(first));
    if let Some((_, kind)) = known {
        return Some(kind);
    }
    if bytes.is_empty() {
        return Some("empty");
    }
    // Letters of UTF-16 have a byte 0, here without a byte order mark.
    if let [a, b, c, d, ..] = *bytes
        && ([a, c] == [0, 0] || [b, d] == [0, 0])
        && (a | b).is_ascii_graphic()
        && (c | d).is_ascii()
        && c | d != 0
    {
        return Some("text in UTF-16: save it as UTF-8");
    }
    is_binary_stl(bytes).then_some(STL)
}

const STL: &str = "an STL file: export it as OBJ or PLY";

/// Whether the bytes have the length of the number of triangles behind a head of 80 bytes.
fn is_binary_stl(bytes: &[u8]) -> bool {
    let Some((count, triangles)) = bytes.get(80..).and_then(|bytes| bytes.split_first_chunk())
    else {
        return false;
    };
    let count = u64::from(u32::from_le_bytes(*count));
    count > 0 && triangles.len() as u64 == 50 * count
}

/// The kind of a text that has no faces of ours.
pub fn by_text(bytes: &[u8]) -> Option<&'static str> {
    let start = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
    let text = start.trim_start();
    let has_line =
        |begin: &str| super::text::lines(text).any(|line| line.trim_start().starts_with(begin));
    if text.starts_with("solid") && has_line("facet")
        || text.starts_with("solid") && has_line("endsolid")
    {
        return Some(STL);
    }
    if bytes.starts_with(b"solid") && bytes.len() > 84 && bytes.contains(&0) {
        return Some(STL);
    }
    if text.starts_with('{') {
        return Some(
            if text.contains("\"asset\"") || text.contains("\"meshes\"") {
                "a glTF file: export it as OBJ or PLY"
            } else {
                "a JSON file"
            },
        );
    }
    if has_line("[") && text.contains('=') {
        return Some("a TOML file, such as a scene");
    }
    if has_line("newmtl") {
        return Some("a file of materials (MTL), which belongs to an OBJ file");
    }
    if has_line("SECTION") {
        return Some("a DXF file: export it as OBJ or PLY");
    }
    let has_curves = ["cstype", "curv", "surf "]
        .iter()
        .any(|begin| has_line(begin));
    has_curves.then_some("an OBJ file of curved surfaces only: export it with faces")
}

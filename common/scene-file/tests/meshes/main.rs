//! Meshes as programs write them, most of them as data: `obj.txt` and `ply.txt` have changes of
//! a square, between empty lines, and after each the note or the error that it must get.

mod smooth;

use scene_file::Mesh;

/// A square of side 1, whose corners go round to the left; the lines of `obj.txt` stand behind it.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The same, in which `ply.txt` changes words.
const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
    property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

fn read(bytes: &[u8]) -> Mesh {
    let text = String::from_utf8_lossy(bytes);
    Mesh::read(bytes).unwrap_or_else(|error| panic!("{error}:\n{text}"))
}

/// Asserts that a file is the square, flat, and returns its notes.
fn assert_square(bytes: &[u8]) -> Vec<String> {
    let mesh = read(bytes);
    let text = String::from_utf8_lossy(bytes);
    let mut area = 0.0;
    for ([a, b, c], _) in mesh.triangles() {
        area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0;
    }
    assert_eq!(area, 1.0, "{text}");
    let mut corners: Vec<_> = mesh.triangles().flat_map(|(corners, _)| corners).collect();
    corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
    corners.dedup();
    let square = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]].map(|[x, y]| [x, y, 0.0]);
    assert_eq!(corners, square, "{text}");
    let is_flat = mesh.triangles().all(|(_, normals)| normals.is_none());
    assert!(is_flat, "{text}");
    mesh.notes()
}

/// Checks the cases of a file, which `change` makes files of.
fn check(cases: &str, change: impl Fn(&str) -> String) {
    for case in cases.trim_end().split("\n\n") {
        let ends = ["# square", "# error: "]
            .iter()
            .filter_map(|end| case.find(end));
        let (text, expected) = case.split_at(ends.min().expect(case));
        let file = change(text);
        if let Some(expected) = expected.strip_prefix("# error: ") {
            let error = Mesh::read(file.as_bytes()).expect_err(&file);
            assert_eq!(error, expected, "{file}");
            continue;
        }
        for file in [
            file.clone(),
            file.replace('\n', "\r\n"),
            file.replace('\n', "\r"),
            format!("\u{FEFF}{file}"),
        ] {
            let mut found = "# square".to_owned();
            for note in assert_square(file.as_bytes()) {
                found.push_str("\n# note: ");
                found.push_str(&note);
            }
            assert_eq!(found, expected, "{file}");
        }
    }
}

#[test]
fn each_obj_is_the_square_or_gets_its_error() {
    check(include_str!("obj.txt"), |lines| SQUARE.to_owned() + lines);
    // A corner beside three with a normal has none.
    let file = [
        SQUARE,
        "vn 0 0 1\nvn 1 0 0 \\\n\nf 1//1 2//1 3//1\nf 1//2 3 4//2",
    ]
    .concat();
    let mesh = read(file.as_bytes());
    let normals: Vec<_> = mesh.triangles().map(|(_, normals)| normals).collect();
    assert_eq!(normals, [Some([[0.0, 0.0, 1.0]; 3]), None]);
}

#[test]
fn each_ply_is_the_square_or_gets_its_error() {
    check(include_str!("ply.txt"), |changes| {
        let mut file = PLY.to_owned();
        for change in changes.lines() {
            let (from, to) = change.split_once(" => ").expect(change);
            assert!(file.contains(from), "{change}");
            file = file.replacen(from, to, if from == "float" { 3 } else { 1 });
        }
        file
    });
}

/// In a strip of PLY, two equal corners are a triangle without area, which changes the direction of the next ones.
#[test]
fn a_strip_goes_round_the_other_way_behind_equal_corners() {
    let change = ["element face", "uchar", "4 0 1 2 3"];
    let strip = ["element tristrips", "int", "5 0 0 1 3 2"];
    let mut file = PLY.to_owned();
    for (from, to) in change.into_iter().zip(strip) {
        file = file.replace(from, to);
    }
    let mut areas = Vec::new();
    for ([a, b, c], _) in read(file.as_bytes()).triangles() {
        areas.push(((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0);
    }
    assert_eq!(areas, [0.0, -0.5, -0.5]);
}

#[test]
fn other_files_are_called_by_their_kind() {
    let utf_16: Vec<u8> = SQUARE.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let with_mark = [b"\xFF\xFE", &utf_16[..]].concat();
    let mut stl = vec![b' '; 80];
    stl.extend(1_u32.to_le_bytes());
    stl.extend([0; 50]);
    for (file, expected) in [
        (
            &b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"[..],
            "an STL file",
        ),
        (&stl, "an STL file"),
        (b"\x1F\x8B\x08\x00", "packed by gzip"),
        (b"PK\x03\x04rest", "packed by zip"),
        (&utf_16, "text in UTF-16"),
        (&with_mark, "text in UTF-16"),
        (b"[camera]\neye = [0, 0, 1]\n", "a TOML file"),
        (b"glTF\x02\0\0\0", "a glTF file"),
        (b"{ \"asset\": { \"version\": \"2.0\" } }", "a glTF file"),
        (b"OFF\n4 1 0\n0 0 0\n", "an OFF file"),
        (
            b"version https://git-lfs.github.com/spec/v1\n",
            "a pointer of Git LFS",
        ),
        (b"newmtl gold\nKd 1 1 0\n", "a file of materials"),
        (b"\0v\0 \x000", "text in UTF-16"),
        (b"\n\n<!DOCTYPE html>", "a web page"),
        (b"", "empty"),
    ] {
        let error = Mesh::read(file).err().unwrap();
        assert!(error.starts_with(&format!("it is {expected}")), "{error}");
        assert_eq!(error.matches("OBJ").count(), 1, "{error}");
    }
}

/// Files of Rhino 6 and of Draco have lines that end with CR alone.
#[test]
fn the_first_byte_of_a_number_in_ply_may_look_like_the_end_of_a_line() {
    let (header, _) = PLY.split_once("0 0 0").unwrap();
    let header = header.replace("ascii", "binary_little_endian");
    for line_end in ["\n", "\r", "\r\n"] {
        let mut file = header.replace('\n', line_end).into_bytes();
        let small = f32::from_le_bytes([b'\n', 0, 0, 0]);
        for coordinate in [small, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0] {
            file.extend(coordinate.to_le_bytes());
        }
        file.push(4);
        (0..4_i32).for_each(|i| file.extend(i.to_le_bytes()));
        let x = read(&file).triangles().next().unwrap().0[0][0];
        assert_eq!(x, f64::from(small), "{line_end:?}");
    }
}

#[test]
fn comments_of_ply_have_any_bytes() {
    let mut file =
        b"ply\nformat ascii 1.0\ncomment C:\\M\xFCller\nobj_info \xFF\x00 1\n\n".to_vec();
    file.extend(&PLY.as_bytes()["ply\nformat ascii 1.0\n".len()..]);
    assert_eq!(assert_square(&file), [""; 0]);
}

/// Other properties stand between those that count, and the normal of a face is not that of its
/// corners. The numbers 0 to 9 fit in every type.
#[test]
fn ply_has_properties_of_any_type_in_any_order() {
    let header = "ply\nformat ENCODING 1.0\nelement light 0\nelement marker 5\nelement vertex 4\n\
        property KIND z\nproperty KIND quality\nproperty list KIND KIND uses\nproperty KIND x\n\
        property KIND y\nelement face 1\nproperty KIND nx\n\
        property list KIND KIND vertex_indices\nproperty list KIND KIND texcoord\nend_header\n";
    let numbers = "0 9 0 0 0  0 9 1 5 1 0  0 9 2 5 6 1 1  0 9 0 0 1  7 4 0 1 2 3 1 8";
    for (kinds, size) in [
        ("char int8 uchar uint8", 1),
        ("short int16 ushort uint16", 2),
        ("int int32 uint uint32", 4),
        ("float float32", 4),
        ("double float64", 8),
    ] {
        for kind in kinds.split(' ') {
            check_types(header, numbers, kind, size);
        }
    }
}

/// Checks the file of these numbers with properties of a type, in both orders of bytes and as text.
fn check_types(header: &str, numbers: &str, kind: &str, size: usize) {
    let ascii = header.replace("ENCODING", "ascii").replace("KIND", kind);
    assert_square([&ascii, numbers].concat().as_bytes());
    for encoding in ["binary_little_endian", "binary_big_endian"] {
        let mut file = header
            .replace("ENCODING", encoding)
            .replace("KIND", kind)
            .into_bytes();
        for word in numbers.split_whitespace() {
            let mut bytes = if kind.starts_with("float") && size == 4 {
                word.parse::<f32>().unwrap().to_le_bytes().to_vec()
            } else if size == 8 {
                word.parse::<f64>().unwrap().to_le_bytes().to_vec()
            } else {
                word.parse::<u32>().unwrap().to_le_bytes()[..size].to_vec()
            };
            if encoding == "binary_big_endian" {
                bytes.reverse();
            }
            file.extend(bytes);
        }
        assert_square(&file);
        for end in 0..file.len() {
            assert!(Mesh::read(&file[..end]).is_err());
        }
    }
}

/// Normals of vertices count where they are a direction, also where the faces stand first.
#[test]
fn normals_of_ply_are_those_of_the_vertices() {
    let normals = "property float nx\nproperty float ny\nproperty float nz\nelement face 1";
    let file = PLY.replace("element face 1", normals);
    let (header, _) = file.split_once("0 0 0").unwrap();
    let vertices = "0 0 0 0 0 1  1 0 0 0 0 2  1 1 0 0 0 3  0 1 0 0 0 nan ";
    let (format, elements) = header.split_at("ply\nformat ascii 1.0\n".len());
    let (of_vertices, of_faces) = elements.split_at(elements.find("element face").unwrap());
    let of_faces = of_faces.replace("end_header\n", "");
    for file in [
        format!("{header}{vertices} 4 0 1 2 3"),
        format!("{format}{of_faces}{of_vertices}end_header\n4 0 1 2 3 {vertices}"),
    ] {
        let mesh = read(file.as_bytes());
        let normals: Vec<_> = mesh.triangles().map(|(_, normals)| normals).collect();
        let expected = [1.0, 2.0, 3.0].map(|z| [0.0, 0.0, z]);
        assert_eq!(normals, [Some(expected), None]);
        assert_eq!(mesh.notes().len(), 1);
    }
}

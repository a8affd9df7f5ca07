//! Meshes as programs write them: each file with the triangles, the note or the error that it must
//! have.

use scene_file::Mesh;

/// A square of side 1, whose corners go round to the left.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
    property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

fn read(bytes: &[u8]) -> Mesh {
    let text = String::from_utf8_lossy(bytes);
    Mesh::read(bytes).unwrap_or_else(|error| panic!("{error}:\n{text}"))
}

fn error(bytes: &[u8]) -> String {
    let Err(error) = Mesh::read(bytes) else {
        panic!("accepted: {}", String::from_utf8_lossy(bytes));
    };
    assert!(error.len() < 300, "a short sentence: {error}");
    assert!(!error.contains(char::is_control), "{error:?}");
    error
}

/// The sum of the triangles in the plane z = 0, where those that go round to the right count as
/// negative.
fn signed_area(mesh: &Mesh) -> f64 {
    let mut sum = 0.0;
    for ([a, b, c], _) in mesh.triangles() {
        sum += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0;
    }
    sum
}

/// Asserts that a file is the square, flat, with these notes.
fn assert_square(bytes: &[u8], notes: &[&str]) {
    let mesh = read(bytes);
    let text = String::from_utf8_lossy(bytes);
    assert_eq!(signed_area(&mesh), 1.0, "{text}");
    let mut corners: Vec<_> = mesh.triangles().flat_map(|(corners, _)| corners).collect();
    corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
    corners.dedup();
    let square = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]].map(|[x, y]| [x, y, 0.0]);
    assert_eq!(corners, square, "{text}");
    assert!(
        mesh.triangles().all(|(_, normals)| normals.is_none()),
        "{text}"
    );
    assert_eq!(mesh.notes(), notes, "{text}");
}

#[test]
fn a_concave_face_has_its_area() {
    let t = "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\nv 3 1 0\nv 3 0 0\n";
    let mesh = read(format!("{t}f 1 2 3 4 5 6 7 8\n").as_bytes());
    assert_eq!((signed_area(&mesh), mesh.triangles().count()), (-4.0, 6));
    let mesh = read(format!("{t}f 8 7 6 5 4 3 2 1 8\n").as_bytes());
    assert_eq!((signed_area(&mesh), mesh.triangles().count()), (4.0, 6));
}

#[test]
fn faces_of_obj_have_every_form() {
    let flat = "1 face is flat, with normals that are missing or have no direction";
    for (lines, notes) in [
        ("f 1// 2// 3// 4//", &[][..]),
        ("f 1/1/ 2/2/ 3/3/ 4/4/", &[]),
        ("f 1/ 2/ 3/ 4/", &[]),
        ("f 1/7 2/8 3/9 4/9", &[]),
        ("f -4 -3 -2 -1", &[]),
        ("f 1 2 3 \\\n4", &[]),
        ("f \\\n1 2\\\n 3 \\\n\\\n4\n", &[]),
        ("f 1 2 3 4 \\", &[]),
        ("usemtl a\\b\\\nf 1 2 3 4", &[]),
        ("# C:\\models\\\nf 1 2 3 4 # C:\\", &[]),
        ("g v\nusemtl f\nf 1 2 3 4", &[]),
        ("vn 0 0 1\nf 1 2 3 4", &[]),
        ("f 1//1 2//2 3//3 4//4", &[flat]),
        ("f 1//0 2//0 3//0 4//0", &[flat]),
        ("vn 0 0 1\nf 1//2 2//2 3//2 4//-2", &[flat]),
        ("vn 0 0 1\nf 1//9999999999 2//1 3//1 4//0", &[flat]),
        (
            "vn -nan(ind) -nan(ind) -nan(ind)\nf 1//1 2//1 3//1 4//1",
            &[flat],
        ),
        ("vn 0 0 1.#IND\nf 1//1 2//1 3//1 4//1", &[flat]),
        ("vn 0 0 -1.#IND00\nf 1//1 2//1 3//1 4//1", &[flat]),
        ("vn 0 0 1.#QNAN\nf 1//1 2//1 3//1 4//1", &[flat]),
        ("vn 0 0 1.#INF # infinity\nf 1//1 2//1 3//1 4//1", &[flat]),
        (
            "vn nan(0x8000000000000) NaN -NAN\nf 1//1 2//1 3//1 4//1",
            &[flat],
        ),
        ("vn 0 0 0\nf 1//1 2//1 3//1 4//1", &[flat]),
        ("vn n. def.\nf 1//1 2//1 3//1 4//1", &[flat]),
        (
            "f 1 2\nf 3\nf\nf 1 2 3 4",
            &["3 faces of fewer than three corners are left out"],
        ),
        (
            "f 1 2\nf 1 2 3 4",
            &["1 face of fewer than three corners is left out"],
        ),
        ("f 1 2 3 4 1", &[]),
        ("f 1 1 2 2 3 4 4", &[]),
        ("f 1 2 3 4\nf 1 1 1\nf 1 2 1 2", &[]),
    ] {
        let file = [SQUARE, lines].concat();
        assert_square(file.as_bytes(), notes);
        assert_square(file.replace('\n', "\r\n").as_bytes(), notes);
        assert_square(file.replace('\n', "\r").as_bytes(), notes);
        assert_square(file.replacen('\n', "\r", 3).as_bytes(), notes);
        assert_square(["\u{feff}", &file].concat().as_bytes(), notes);
    }
    // A corner over several lines, and after the face; a number of it nobody uses.
    assert_square(
        b"f 1 2 3 4\nv 0 0 \\\n0\nv 1 \\\n0 0\nv 1 1 0\nv 0 1 0\nv nan 0 0",
        &[],
    );
    // A corner without a normal beside three with one.
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
fn mistakes_in_obj_are_named_with_their_line() {
    for (lines, expected) in [
        (
            "f 1 2 7",
            "the face in line 5 has the corner 7 of 4, from 1",
        ),
        (
            "\n\nf 1 2 3\nf 0 1 2",
            "the face in line 8 has the corner 0 of 4, from 1",
        ),
        (
            "f 1 2 3\nf -5 1 2",
            "the face in line 6 has the corner -5 of 4, from 1",
        ),
        (
            "f 1 2 3 \\\n9\nf 1 2 3",
            "the face in line 5 has the corner 9 of 4, from 1",
        ),
        (
            "f 1 2 9999999999",
            "the face in line 5 has the corner 9999999999 of 4, from 1",
        ),
        (
            "v nan 0 0\nf 1 2 5",
            "line 5 has the x NaN, but a coordinate is from -1e100 to 1e100",
        ),
        (
            "v 0 0 -1.#INF\nf 1 2 5",
            "line 5 has the z -inf, but a coordinate is from -1e100 to 1e100",
        ),
        (
            "v 0 1e200 0\nf 1 2 5",
            "line 5 has the y 1e200, but a coordinate is from -1e100 to 1e100",
        ),
        (
            "v 0 1",
            "line 5 is \"v 0 1\", but a corner is three numbers, as v 0 1 0",
        ),
        (
            "v 0,0 1,5 2",
            "line 5 is \"v 0,0 1,5 2\", but a corner is three numbers, as v 0 1 0",
        ),
        (
            "f 1 2 x\u{7}",
            "line 5 is \"f 1 2 x \", but a face is the numbers of three corners or more, as f 1 2 3",
        ),
    ] {
        let error = error([SQUARE, lines].concat().as_bytes());
        assert_eq!(error, format!("a mistake in this OBJ: {expected}"));
    }
}

/// The text of the square as bytes of another format.
fn binary(
    encoding: &str,
    bytes_of: impl Fn(f32) -> [u8; 4],
    index: impl Fn(i32) -> [u8; 4],
) -> Vec<u8> {
    let (header, _) = PLY.split_once("0 0 0").unwrap();
    let mut file = header.replace("ascii", encoding).into_bytes();
    for coordinate in [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0] {
        file.extend(bytes_of(coordinate as f32));
    }
    file.push(4);
    (0..4).for_each(|i| file.extend(index(i)));
    file
}

#[test]
fn ply_has_three_formats_and_every_line_end() {
    assert_square(PLY.as_bytes(), &[]);
    assert_square(PLY.replace('\n', "\r").as_bytes(), &[]);
    assert_square(PLY.replace('\n', "\r\n").as_bytes(), &[]);
    assert_square(PLY.replacen('\n', "\r\n", 4).as_bytes(), &[]);
    assert_square(PLY.replacen('\n', "\r", 5).as_bytes(), &[]);
    assert_square(["\u{feff}", PLY].concat().as_bytes(), &[]);
    let little = binary("binary_little_endian", f32::to_le_bytes, i32::to_le_bytes);
    let big = binary("binary_big_endian", f32::to_be_bytes, i32::to_be_bytes);
    for file in [&little, &big] {
        assert_square(file, &[]);
        for end in 0..file.len() {
            error(&file[..end]);
        }
    }
    // The first number begins with a byte that looks like LF.
    let (header, _) = PLY.split_once("0 0 0").unwrap();
    let header = header.replace("ascii", "binary_little_endian");
    for line_end in ["\n", "\r", "\r\n"] {
        let mut file = header.replace('\n', line_end).into_bytes();
        let small = f32::from_le_bytes([10, 0, 0, 0]);
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
fn ply_has_comments_of_any_bytes_and_every_spelling_of_a_type() {
    for line in [
        &b"comment C:\\Users\\M\xFCller"[..],
        b"obj_info \xFF\x00 1",
        b"comment",
        b"",
    ] {
        let mut file = b"ply\nformat ascii 1.0\n".to_vec();
        file.extend(line);
        file.extend(&PLY.as_bytes()["ply\nformat ascii 1.0".len()..]);
        assert_square(&file, &[]);
    }
    let types = "char int8 uchar uint8 short int16 ushort uint16 int int32 uint uint32";
    for kind in types.split(' ') {
        let list = format!("list {kind} {kind}");
        assert_square(PLY.replace("list uchar int", &list).as_bytes(), &[]);
    }
    for kind in ["float32", "double", "float64"] {
        assert_square(PLY.replace("float", kind).as_bytes(), &[]);
    }
    assert_square(
        PLY.replace("vertex_indices", "vertex_index").as_bytes(),
        &[],
    );
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
    let ascii = header.replace("ENCODING", "ascii").replace("KIND", "uchar");
    assert_square([&ascii, numbers].concat().as_bytes(), &[]);
    for (kind, size) in [
        ("char", 1),
        ("uint8", 1),
        ("short", 2),
        ("ushort", 2),
        ("int", 4),
        ("uint32", 4),
        ("float", 4),
        ("double", 8),
    ] {
        for encoding in ["binary_little_endian", "binary_big_endian"] {
            let mut file = header
                .replace("ENCODING", encoding)
                .replace("KIND", kind)
                .into_bytes();
            for word in numbers.split_whitespace() {
                let mut bytes = match kind {
                    "float" => word.parse::<f32>().unwrap().to_le_bytes().to_vec(),
                    "double" => word.parse::<f64>().unwrap().to_le_bytes().to_vec(),
                    _ => word.parse::<u32>().unwrap().to_le_bytes()[..size].to_vec(),
                };
                if encoding == "binary_big_endian" {
                    bytes.reverse();
                }
                file.extend(bytes);
            }
            assert_square(&file, &[]);
            for end in 0..file.len() {
                error(&file[..end]);
            }
        }
    }
}

/// Normals of vertices count where they are a direction.
#[test]
fn normals_of_ply_are_those_of_the_vertices() {
    let normals = "property float nx\nproperty float ny\nproperty float nz\nelement face 1";
    let file = PLY.replace("element face 1", normals);
    let file = file.split_once("0 0 0").unwrap().0.to_owned();
    let vertices = "0 0 0 0 0 1  1 0 0 0 0 2  1 1 0 0 0 3  0 1 0 0 0 0  4 0 1 2 3";
    let mesh = read((file.clone() + vertices).as_bytes());
    let normals: Vec<_> = mesh.triangles().map(|(_, normals)| normals).collect();
    let expected = [1.0, 2.0, 3.0].map(|z| [0.0, 0.0, z]);
    assert_eq!(normals, [Some(expected), None]);
    assert_eq!(mesh.notes().len(), 1);
    let nan = vertices.replace("0 0 0 0 0 1", "0 0 0 nan(ind) 0 1");
    assert!(
        read((file + &nan).as_bytes())
            .triangles()
            .all(|(_, normals)| normals.is_none())
    );
}

#[test]
fn strips_of_ply_go_round_in_turns() {
    let strips = PLY
        .replace("element face", "element tristrips")
        .replace("uchar", "int");
    for list in [
        "7 0 1 3 -1 1 2 3",
        "4 0 1 3 2",
        "8 0 1 3 2 -1 -1 -1 -1",
        "5 0 0 1 3 2",
    ] {
        let file = strips.replace("4 0 1 2 3", list);
        // Two equal corners are a triangle without area, which changes the turn.
        if list.starts_with('5') {
            assert_eq!(signed_area(&read(file.as_bytes())), -1.0);
        } else {
            assert_square(file.as_bytes(), &[]);
        }
    }
    let file = strips.replace("4 0 1 2 3", "7 0 1 3 2 -1 0 1");
    assert_square(
        file.as_bytes(),
        &["1 face of fewer than three corners is left out"],
    );
    let error = error(strips.replace("4 0 1 2 3", "4 0 1 2 9").as_bytes());
    assert!(
        error.ends_with("tristrips 0 has the vertex 9 of 4, from 0"),
        "{error}"
    );
}

#[test]
fn mistakes_in_ply_are_named_with_their_face() {
    let two = PLY.replace("face 1", "face 2") + "2 0 1\n";
    assert_square(
        two.as_bytes(),
        &["1 face of fewer than three corners is left out"],
    );
    for (change, expected) in [
        (
            ("4 0 1 2 3", "4 0 1 2 -1"),
            "face 0 has the vertex -1, but vertices are numbered from 0",
        ),
        (
            ("4 0 1 2 3", "4 0 1 2 7"),
            "face 0 has the vertex 7 of 4, from 0",
        ),
        (
            ("4 0 1 2 3", "4 0 1 2"),
            "it ends within face 0 of 1, from 0: it is cut off",
        ),
        (
            ("face 1", "face 4000000000"),
            "it ends within face 1 of 4000000000, from 0: it is cut off",
        ),
        (
            ("vertex 4", "vertex 4000000000"),
            "it ends within vertex 5 of 4000000000, from 0: it is cut off",
        ),
        (
            ("4 0 1 2 3", "-4 0 1 2 3"),
            "face 0 has a list of -4 numbers",
        ),
        (
            ("4 0 1 2 3", "4 0 -1 2 3"),
            "face 0 has the vertex -1, but vertices are numbered from 0",
        ),
        (
            ("4 0 1 2 3", "4 0 1.5 2 3"),
            "face 0 has the vertex 1.5, but vertices are numbered from 0",
        ),
        (
            ("4 0 1 2 3", "4 0 x 2 3"),
            "face 0 has \"x\" where a number should be",
        ),
        (
            ("0 0 0", "nan 0 0"),
            "vertex 0 has the x NaN, but a coordinate is from -1e100 to 1e100",
        ),
        (
            ("property float z\n", ""),
            "its vertices lack the property z",
        ),
        (
            ("uchar int v", "uchar int64 v"),
            "its property vertex_indices has the unknown type int64; there is char, uchar, short, \
             ushort, int, uint, float and double",
        ),
        (
            ("ascii", "binary_middle_endian"),
            "its format is \"binary_middle_endian\", but there is ascii, binary_little_endian and \
             binary_big_endian",
        ),
        (
            ("end_header", "end header"),
            "its header has the unknown line \"end header\"",
        ),
        (
            ("vertex_indices", "corners"),
            "its faces lack the list vertex_indices",
        ),
        (
            ("element vertex 4", "element vertex -4"),
            "its header has \"element vertex -4\", without a count",
        ),
    ] {
        let (from, to) = change;
        let error = error(PLY.replacen(from, to, 1).as_bytes());
        assert_eq!(error, format!("a mistake in this PLY: {expected}"));
    }
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
        (b"PK\x03\x04rest", "a zip archive"),
        (&utf_16, "text in UTF-16"),
        (&with_mark, "text in UTF-16"),
        (b"[camera]\neye = [0, 0, 1]\n", "a TOML file"),
        (b"glTF\x02\0\0\0", "a glTF file"),
        (b"{ \"asset\": { \"version\": \"2.0\" } }", "a glTF file"),
        (b"newmtl gold\nKd 1 1 0\n", "a file of materials"),
        (b"", "empty"),
    ] {
        let error = error(file);
        assert!(error.starts_with(&format!("it is {expected}")), "{error}");
        assert_eq!(error.matches("OBJ").count(), 1, "{error}");
    }
    let points =
        "it has no faces, only 4 points, perhaps with lines between them; a mesh needs faces";
    assert_eq!(error(SQUARE.as_bytes()), points);
    assert_eq!(error([SQUARE, "l 1 2 3\np 4"].concat().as_bytes()), points);
    assert_eq!(
        error(
            PLY.split_once("element face")
                .map(|(head, _)| { format!("{head}end_header\n0 0 0 1 0 0 1 1 0 0 1 0") })
                .unwrap()
                .as_bytes()
        ),
        points
    );
    let none = "none of its faces has three corners";
    assert_eq!(error([SQUARE, "f 1 2"].concat().as_bytes()), none);
}

/// At the corner (0, 0, 0) a right angle of the plane z = 0, divided into two faces, meets right
/// angles of the planes x = 0 and y = 0: weighted by angle, the three planes count the same.
#[test]
fn smooth_computes_the_normals_that_a_file_lacks() {
    let corner = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n\
                  f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n";
    let mut mesh = read(corner.as_bytes());
    mesh.set_smooth(true);
    for (corners, normals) in mesh.triangles() {
        let normals = normals.unwrap();
        let at = corners
            .iter()
            .position(|corner| *corner == [0.0; 3])
            .unwrap();
        let length = normals[at].iter().map(|x| x * x).sum::<f64>().sqrt();
        for x in normals[at] {
            assert!(
                (x / length - 1.0 / 3_f64.sqrt()).abs() < 1e-15,
                "{normals:?}"
            );
        }
    }
    let note = "smooth, with computed normals for 4 of 4 triangles, for which the file has none";
    assert_eq!(mesh.notes(), [note]);
    mesh.set_smooth(false);
    assert!(mesh.triangles().all(|(_, normals)| normals.is_none()));
    // Normals of the file stay.
    let file = [SQUARE, "vn 1 0 0\nf 1//1 2//1 3//1\nf 1//1 3 4//7"].concat();
    let mut mesh = read(file.as_bytes());
    mesh.set_smooth(true);
    let normals: Vec<_> = mesh
        .triangles()
        .map(|(_, normals)| normals.unwrap())
        .collect();
    assert_eq!(normals[0], [[1.0, 0.0, 0.0]; 3]);
    assert_eq!(normals[1][0], [1.0, 0.0, 0.0]);
    assert!(normals[1][1][0] == 0.0 && normals[1][1][2] > 0.0 && normals[1][2][2] > 0.0);
    // Triangles with corners of their own are smooth, too.
    let soup = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 4 5 6\n";
    let mut mesh = read(soup.as_bytes());
    mesh.set_smooth(true);
    let normals: Vec<_> = mesh
        .triangles()
        .map(|(_, normals)| normals.unwrap()[0])
        .collect();
    assert_eq!(normals[0], normals[1]);
}

//! Texts whose triangles, or whose broken line, are known.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::{Interval, Triangle, World};
use common::Color;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::shape::{TURNS, show_world, turned};

/// Three corners, to which lines are added.
const CORNERS: &str = "v 0 0 0\nv 4 0 0\nv 0 5e-1 -3\n";

/// A cube from -1 to 1 of six squares.
const CUBE: &str = "\
# Eight corners, near ones first.
o cube
v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1
vn 0 0 1

f 1//1 2//1 3//1 4//1
f -3 -4 -1 -2
f 2/1 6/2 7/3 3/4
f 5 1 4 8
f 4/1/1 3/2/1 7/3/1 8/4/1
f 5 6 2 1
";

/// A house whose gables have five corners.
const HOUSE: &str = "\
v -1 0 1\nv 1 0 1\nv 1 1 1\nv 0 1.8 1\nv -1 1 1
v -1 0 -1.5\nv 1 0 -1.5\nv 1 1 -1.5\nv 0 1.8 -1.5\nv -1 1 -1.5
f 1 2 3 4 5\nf 10 9 8 7 6\nf 2 7 8 3\nf 6 1 5 10\nf 3 8 9 4\nf 4 9 10 5
";

pub fn check(check: &mut Check, read_obj: impl Fn(&str) -> Result<Vec<Triangle>, String>) {
    let read = |text: &str| read_obj(text).map(|triangles| triangles.len());
    check.expect(
        "triangles in an empty text",
        Some(0),
        Bound::Equal,
        read("").ok(),
    );
    check.expect(
        "triangles of three corners alone",
        Some(0),
        Bound::Equal,
        read(CORNERS).ok(),
    );

    let [a, b, c] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 0.5, -3.0]];
    let [a, b, c] = [a, b, c].map(|xyz: [f64; 3]| Point3::from_glam(xyz.into()));
    let exact = Triangle::new(a, b, c).ok().map(|triangle| vec![triangle]);
    for face in [
        "f 1 2 3",
        "  f   1 2\t3  ",
        "# f 1 1 1\n\nf 1/7 2/8 3/9",
        "vt 0 0\nf 1//1 2//1 3//1",
        "f -3 -2 -1",
        "f 1/1/1 -2/1/1 3/1/1\nv 9 9 9",
    ] {
        let got = read_obj(&format!("{CORNERS}{face}\n"));
        let what = format!(
            "the one triangle of {face:?}, after three corners{}",
            not(&got)
        );
        let got = got.ok() == exact;
        check.expect(what, true, Bound::Equal, got);
    }

    for broken in [
        "v 1 2",
        "v 1 2 three",
        "f 1 2",
        "f",
        "f 1 2 4",
        "f 0 1 2",
        "f -4 -2 -1",
        "f 1 2 x",
        "f 1 1 2",
    ] {
        let got = read_obj(&format!("{CORNERS}{broken}\nv 1 1 1\n"));
        let what = format!(
            "{broken:?} ends in an error that begins with \"line 4: \"{}",
            not(&got)
        );
        let told = got.is_err_and(|error| error.starts_with("line 4: "));
        check.expect(what, true, Bound::Equal, told);
    }

    let mut random = Random::new(6);
    for _ in 0..20 {
        expect_mesh(check, &read_obj, &mut random);
    }

    check.expect(
        "triangles of a cube",
        Some(12),
        Bound::Equal,
        read(CUBE).ok(),
    );
    let cube = world(read_obj(CUBE));
    for turn in TURNS {
        for height in [-0.9, -0.2, 0.4, 1.7] {
            // The largest coordinate of a point says how far outside it lies.
            let way = turned(turn, 0.9, height, 0.1);
            let exact = 1.0 / way.to_glam().abs().max_element();
            let ray = Ray::derived(Point3::ORIGIN, way);
            let t = cube
                .as_ref()
                .and_then(|cube| cube.hit(&ray, Interval::AHEAD));
            let what = format!("t from the middle of a cube along {}", way.to_glam());
            let t = t.map(|(hit, ())| hit.t);
            check.expect(what, Some(exact), Bound::Absolute(1e-14), t);
        }
    }

    let Some(house) = world(read_obj(HOUSE)) else {
        return;
    };
    let (eye, at) = (Point3::new(4.0, 3.0, 5.0), Point3::new(0.0, 0.8, -0.2));
    show_world(check, Ok(house), eye, at, |_, normal| {
        let [r, g, b] = normal.to_glam().abs().to_array();
        Color::new(r, g, b)
    });
}

/// The error, for the end of a message.
fn not(got: &Result<Vec<Triangle>, String>) -> String {
    let error = got.as_ref().err();
    error.map_or(String::new(), |error| format!(", not {error:?}"))
}

/// A random face among random corners, which are named in all ways.
fn expect_mesh(
    check: &mut Check,
    read_obj: impl Fn(&str) -> Result<Vec<Triangle>, String>,
    random: &mut Random,
) {
    let count = 6 + random.below(7);
    let corners: Vec<[f64; 3]> = (0..count)
        .map(|_| [(); 3].map(|()| random.between(-9.0, 9.0)))
        .collect();
    let lines: Vec<_> = corners
        .iter()
        .map(|[x, y, z]| format!("v {x} {y} {z}\n"))
        .collect();
    let mut text = lines.concat();
    // Different corners in a row.
    let (first, sides) = (random.below(count), 3 + random.below(4));
    let around: Vec<u32> = (0..sides).map(|i| (first + i) % count).collect();
    text.push('f');
    for &corner in &around {
        let name = match random.below(4) {
            0 => format!(" {}", i64::from(corner) - i64::from(count)),
            1 => format!(" {}/{}", corner + 1, 1 + random.below(9)),
            2 => format!(" {}//{}", corner + 1, 1 + random.below(9)),
            _ => format!(" {}", corner + 1),
        };
        text.push_str(&name);
    }
    text.push_str("\nv 0 0 0\n");

    let face = text.lines().nth(count as usize).unwrap_or_default();
    let got = read_obj(&text);
    let triangles = got.as_ref().map(Vec::len).ok();
    let what = format!("triangles of {face:?} after {count} corners{}", not(&got));
    check.expect(what, Some(around.len() - 2), Bound::Equal, triangles);
    for (k, pair) in around[1..].windows(2).enumerate() {
        let joined = [around[0], pair[0], pair[1]];
        let [a, b, c] = joined.map(|corner| Point3::from_glam(corners[corner as usize].into()));
        let is_right =
            got.as_ref().ok().and_then(|got| got.get(k)) == Triangle::new(a, b, c).ok().as_ref();
        let joined = joined.map(|corner| corner + 1);
        let what = format!(
            "triangle {} of {face:?} after {count} corners joins {joined:?}",
            k + 1
        );
        check.expect(what, true, Bound::Equal, is_right);
    }
}

fn world(triangles: Result<Vec<Triangle>, String>) -> Option<World<()>> {
    let world = World::new(Color::gray(0.1)).ok()?;
    let triangles = triangles.ok()?;
    Some(
        triangles
            .into_iter()
            .fold(world, |world, triangle| world.with(triangle, ())),
    )
}

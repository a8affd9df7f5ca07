//! Scenes and triangles with large rounding errors: far from the origin, large, or thin. No
//! surface shades itself, and no ceiling takes the light of its lamp. Large shapes, and those seen from
//! far away, are the beds 9 and 11 of the experiment `acne`.

use std::fs;
use std::path::Path;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Interval, Plane, Sphere, Triangle, World};
use a05_lighting::Illumination;
use a06_shadows_reflection::{is_shadowed, secondary_ray, stage};
use common::{Color, Renderer, Scene, Settings, Transfer};

/// The text of a scene file.
fn text(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scenes");
    fs::read_to_string(folder.join(name)).unwrap()
}

/// A scene file with this text.
fn scene(text: &str) -> Scene {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, text).unwrap();
    (stage().open.unwrap())(&path).unwrap()
}

/// The bytes of its picture.
fn bytes(scene: &Scene, renderer: Renderer) -> Vec<u8> {
    let settings = Settings {
        renderer,
        ..scene.defaults.clone()
    };
    let image = scene.render(&settings, &()).unwrap();
    image.to_rgb8(Transfer::Linear)
}

/// The picture of `room-far-away.toml`, row by row, in red, green and blue: computed with
/// 80 digits from the numbers of the file.
const ROOM: [&str; 9] = [
    "7a3423 853926 923f2a a1452e 0a1f14 0a1f14 0a1f14 0a1f14 0a1f14 0a1f14 0a1f14 0a1f14",
    "7a3423 863926 943f2a a4462f b44d34 d26449 0a1f14 0a1f14 0a1f14 0a1f14 0a1f14 0a1f14",
    "783322 833826 913e2a a1452e b34d34 ef8267 ffad91 be543a 0a1f14 0a1f14 0a1f14 0a1f14",
    "743221 7f3624 8c3c28 9a422c a84830 b85238 bf573d af4b32 a2452e 0a1f14 0a1f14 0a1f14",
    "1a4f35 1c5539 1f5c3d 3b1911 ffb59e 25704b 26714b 256e49 226745 206040 1e593b 0a1f14",
    "26714b 297a52 2c8559 240f0a 240f0a 36a36d 37a66e 36a26c 339a67 308f5f 2c8458 287951",
    "2b8156 2d885b 309060 329765 359e69 36a26c 37a46d 36a36d 359f6a 339966 319261 2e8a5c",
    "2c8559 2e8a5c 308f5f 319362 329764 339966 339a67 339a67 339966 329664 319261 2f8d5e",
    "2c8559 2e895b 2f8c5d 2f8e5f 309060 319261 319362 319362 319261 309160 308f5f 2f8c5d",
];

#[test]
fn a_lamp_on_the_roof_of_a_far_room_lights_it() {
    let scene = scene(&text("room-far-away.toml"));
    for renderer in Renderer::ALL {
        let bytes = bytes(&scene, renderer);
        for (row, expected) in bytes.chunks(3 * 12).zip(ROOM) {
            let pixels = row.chunks(3).map(|pixel| {
                let [r, g, b] = [pixel[0], pixel[1], pixel[2]];
                format!("{r:02x}{g:02x}{b:02x}")
            });
            assert_eq!(
                pixels.collect::<Vec<_>>().join(" "),
                expected,
                "{renderer:?}"
            );
        }
        assert_eq!(bytes.len(), 3 * 12 * ROOM.len());
    }
}

/// Nothing else is there that could cast a shadow.
#[test]
fn a_large_floor_looks_as_without_shadows() {
    let text = text("large-floor.toml");
    let lamp = "[[point_light]]\n";
    assert!(text.contains(lamp));
    let without_shadows = text.replace(lamp, &format!("{lamp}shadows = false\n"));
    let expected = bytes(&scene(&without_shadows), Renderer::Lesson);
    for renderer in Renderer::ALL {
        assert!(bytes(&scene(&text), renderer) == expected, "{renderer:?}");
    }
}

/// Whether a ray that leaves the hit of a triangle hits it again, which is flat; none if there
/// is no triangle, no hit, or a grazing ray, for which either is right.
fn shades_itself(corners: [Point3; 3], [eye, target]: [Point3; 2], light: Vector3) -> Option<bool> {
    let [a, b, c] = corners;
    let triangle = Triangle::new(a, b, c).ok()?;
    let ray = Ray::new(eye, target - eye).unwrap();
    let hit = triangle.hit(&ray, Interval::AHEAD)?;
    let light = light.normalized()?;
    let leaving = secondary_ray(&ray, &hit, light);
    let is_grazing = light.dot(hit.geometric_normal).abs() < 1e-3;
    (!is_grazing).then(|| triangle.hit(&leaving, Interval::AHEAD).is_some())
}

/// The random vector of this number, of coordinates from `-width` to `width`.
fn vector(random: PixelRandom, number: u64, width: f64) -> Vector3 {
    let [x, y, z] = [0, 1, 2].map(|i| width * (2.0 * random.uniform(3 * number + i) - 1.0));
    Vector3::new(x, y, z)
}

/// Leaning, and perpendicular to an axis.
#[test]
fn needles_of_all_widths_do_not_shade_themselves() {
    for width in [1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let mut answers = [0; 2];
        for n in 0..20_000 {
            let random = PixelRandom::new(5, n, 0);
            let (mut along, mut across) = (vector(random, 0, 1.0), vector(random, 1, 1.0));
            if n % 2 == 0 {
                (along, across) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 1.0));
            }
            let a = Point3::ORIGIN + vector(random, 2, 1.0);
            let tip = along * random.uniform(20) + across * width;
            let [beta, gamma] = [21, 22].map(|i| 0.5 * random.uniform(i));
            let target = a + along * beta + tip * gamma;
            let eye = target + vector(random, 3, 3.0);
            let light = vector(random, 4, 1.0);
            let shades = shades_itself([a, a + along, a + tip], [eye, target], light);
            if let Some(shades) = shades {
                answers[usize::from(shades)] += 1;
            }
        }
        assert!(
            answers[0] > 10_000 && answers[1] == 0,
            "{width}: {answers:?}"
        );
    }
}

/// A lamp just below a roof, in it, and just above it, for a point on the floor of a room that
/// is far from the origin: the roof blocks the last one only.
#[test]
fn a_roof_blocks_a_lamp_above_it() {
    for (far, above) in [(0.0, 1e-12), (1e4, 1e-9), (1e8, 1e-4)] {
        let at = |x: f64, y: f64, z: f64| Point3::new(far + x, y, far + z);
        let slope = Normal3::new(1.0, 2.0, 0.0);
        let roof = Plane::new(at(0.5, 3.0, 0.0), slope).unwrap();
        let floor = Plane::new(at(0.0, 0.0, 0.0), Normal3::new(0.0, 1.0, 0.0)).unwrap();
        let world = World::new(Color::BLACK)
            .unwrap()
            .with(floor, ())
            .with(roof, ());
        for (height, expected) in [(-above, false), (0.0, false), (above, true)] {
            for n in 0..1_000 {
                let random = PixelRandom::new(6, n, 0);
                let [x, z] = [0, 1].map(|i| 2.0 * random.uniform(i) - 1.0);
                let eye = at(x, 1.5, z);
                let [x, z] = [2, 3].map(|i| 8.0 * random.uniform(i) - 4.0);
                let target = at(x, 0.0, z);
                let ray = Ray::new(eye, target - eye).unwrap();
                let hit = floor.hit(&ray, Interval::AHEAD).unwrap();
                let lamp = at(0.5, 3.0 + height, 0.0);
                let to_lamp = lamp - ray.at(hit.t);
                let light = Illumination {
                    color: Color::WHITE,
                    direction: to_lamp.normalized().unwrap(),
                    distance: to_lamp.magnitude(),
                };
                let is_dark = is_shadowed(&world, &ray, &hit, &light);
                assert_eq!(is_dark, expected, "{far} {height}, ray {n}");
            }
        }
    }
}

/// A directional light has no distance, and a ball that its ray just touches blocks it.
#[test]
fn a_ball_that_is_just_touched_blocks_the_sun() {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let ball = Sphere::new(Point3::new(1.0, 4.0, 0.0), 1.0).unwrap();
    let world = World::new(Color::BLACK).unwrap().with(ball, ());
    let ray = Ray::new(Point3::new(0.0, 2.0, 0.0), -Vector3::from(up)).unwrap();
    let hit = Plane::new(Point3::ORIGIN, up)
        .unwrap()
        .hit(&ray, Interval::AHEAD)
        .unwrap();
    let sun = Illumination {
        color: Color::WHITE,
        direction: up.into(),
        distance: f64::INFINITY,
    };
    assert!(is_shadowed(&world, &ray, &hit, &sun));
}

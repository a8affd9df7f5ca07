//! Scenes and triangles with large rounding errors: far from the origin, large, or thin. No
//! surface shades itself, and no ceiling takes the light of its lamp.

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

/// Random numbers from -1 to 1.
struct Numbers {
    random: PixelRandom,
    next: u64,
}

impl Numbers {
    fn new(seed: u64) -> Self {
        let random = PixelRandom::new(seed, 0, 0);
        Self { random, next: 0 }
    }

    fn number(&mut self) -> f64 {
        self.next += 1;
        2.0 * self.random.uniform(self.next) - 1.0
    }

    fn vector(&mut self) -> Vector3 {
        Vector3::new(self.number(), self.number(), self.number())
    }

    /// A point of a triangle.
    fn point_of(&mut self, [a, b, c]: [Point3; 3]) -> Point3 {
        let (mut beta, mut gamma) = (self.number().abs(), self.number().abs());
        if beta + gamma > 1.0 {
            (beta, gamma) = (1.0 - beta, 1.0 - gamma);
        }
        a + (b - a) * beta + (c - a) * gamma
    }
}

/// Whether a ray that leaves the hit of a triangle hits it again, which is flat; none if there
/// is no hit, or a grazing ray, for which either is right.
fn shades_itself(corners: [Point3; 3], [eye, target]: [Point3; 2], light: Vector3) -> Option<bool> {
    let [a, b, c] = corners;
    let triangle = Triangle::new(a, b, c).unwrap();
    let ray = Ray::new(eye, target - eye).unwrap();
    let hit = triangle.hit(&ray, Interval::AHEAD)?;
    let light = light.normalized()?;
    let leaving = secondary_ray(&ray, &hit, light);
    let is_grazing = light.dot(hit.geometric_normal).abs() < 1e-3;
    (!is_grazing).then(|| triangle.hit(&leaving, Interval::AHEAD).is_some())
}

/// Asserts that of these trials, most of which are to have an answer, none is true.
fn assert_never(name: &str, trials: u64, trial: impl Fn(&mut Numbers) -> Option<bool>) {
    let answers = (0..trials).filter_map(|seed| trial(&mut Numbers::new(seed)));
    let answers: Vec<bool> = answers.collect();
    assert!(
        2 * answers.len() as u64 > trials,
        "{name}: {}",
        answers.len()
    );
    let wrong = answers.iter().filter(|is_wrong| **is_wrong).count();
    assert_eq!(wrong, 0, "{name}: wrong of {}", answers.len());
}

/// Perpendicular to each axis, rotated around it, and leaning, a little and much; from near
/// and from far away.
#[test]
fn floors_of_all_sizes_do_not_shade_themselves() {
    for half_size in [1.0, 1e2, 1e3, 1e4, 1e5, 1e6] {
        for eye_distance in [2.0, 1e6] {
            for (rotation, lean) in [(0.0, 0.0), (0.3, 0.0), (0.0, 1e-3), (0.0, 0.4), (2.0, 0.4)] {
                let name = format!("{half_size} {eye_distance} {rotation} {lean}");
                assert_never(&name, 2_000, |numbers| {
                    let mut axes = [
                        Vector3::new(1.0, 0.0, 0.0),
                        Vector3::new(0.0, 1.0, 0.0),
                        Vector3::new(0.0, 0.0, 1.0),
                    ];
                    axes.rotate_left((3.0 * numbers.number().abs()) as usize);
                    let [x, y, z] = axes;
                    let (x, z) = rotated(x, z, rotation);
                    let (x, y) = rotated(x, y, lean);
                    let at = |across: f64, along: f64| Point3::ORIGIN + x * across + z * along;
                    let s = half_size;
                    let corners = [at(-s, s), at(s, s), at(-s, -s)];
                    // Near the middle of the floor, or anywhere.
                    let reach = if numbers.number() > 0.0 {
                        s
                    } else {
                        s.min(5.0)
                    };
                    let aside = -numbers.number().abs() * reach;
                    let target = at(aside, numbers.number().abs() * reach);
                    let up = y * (1.05 + numbers.number());
                    let eye =
                        target + (x * numbers.number() + up + z * numbers.number()) * eye_distance;
                    shades_itself(corners, [eye, target], numbers.vector())
                });
            }
        }
    }
}

/// Two vectors of length 1 at right angles, rotated in their plane.
fn rotated(a: Vector3, b: Vector3, angle: f64) -> (Vector3, Vector3) {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    (a * cos + b * sin, b * cos - a * sin)
}

/// Leaning, and perpendicular to an axis.
#[test]
fn needles_of_all_widths_do_not_shade_themselves() {
    for width in [1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        for is_leaning in [false, true] {
            assert_never(&format!("{width} {is_leaning}"), 10_000, |numbers| {
                let (mut along, mut across) = (numbers.vector(), numbers.vector());
                if !is_leaning {
                    (along, across) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 1.0));
                }
                let a = Point3::ORIGIN + numbers.vector();
                let tip = a + along * numbers.number().abs() + across * width;
                let corners = [a, a + along, tip];
                let target = numbers.point_of(corners);
                let eye = target + numbers.vector() * 3.0;
                shades_itself(corners, [eye, target], numbers.vector())
            });
        }
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
            for seed in 0..1_000 {
                let mut numbers = Numbers::new(seed);
                let eye = at(numbers.number(), 1.5, numbers.number());
                let target = at(4.0 * numbers.number(), 0.0, 4.0 * numbers.number());
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
                assert_eq!(is_dark, expected, "{far} {height}, seed {seed}");
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

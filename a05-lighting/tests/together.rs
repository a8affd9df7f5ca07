//! Four hits are lit together as each of them is alone, to the last bit.

use std::array;

use a02_math::vector3x4::mask;
use a02_math::{Lanes, Point3, Vector3, Vector3x4};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::Hit;
use a05_lighting::{
    ColorPacket, DirectionalLight, Illumination, IlluminationPacket, Lambert, Light, Lighting,
    Material, Phong, PhongPacket, PointLight, SingleColor, SpotLight,
};
use common::Color;
use measure::tally::{Work, counted};

const ORANGE: Color = Color::new(1.0, 0.5, 0.25);
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);

fn bits(color: Color) -> [u64; 3] {
    color.channels().map(f64::to_bits)
}

/// The colours of the lanes are these, bit by bit.
#[track_caller]
fn assert_same(packet: ColorPacket, alone: [Color; 4]) {
    assert_eq!(packet.to_lanes().map(bits), alone.map(bits), "{packet:?}");
}

#[test]
fn arithmetic_is_that_of_one_colour() {
    let channels = [0.0, -0.0, 0.3, 7.0];
    let color = |i: usize| {
        let channel = |n: usize| channels[n % channels.len()];
        Color::new(channel(i), channel(i / 4), channel(i / 16))
    };
    for i in 0..64 {
        let a: [Color; 4] = array::from_fn(|lane| color(i + lane));
        let b: [Color; 4] = array::from_fn(|lane| color(5 * (i + lane)));
        let (v, w) = (ColorPacket::new(a), ColorPacket::new(b));
        assert_same(v, a);
        assert_same(ColorPacket::splat(a[0]), [a[0]; 4]);
        assert_same(v + w, array::from_fn(|lane| a[lane] + b[lane]));
        assert_same(v * w, array::from_fn(|lane| a[lane] * b[lane]));
        assert_same(v * w.r, array::from_fn(|lane| a[lane] * b[lane].r));
        for chosen in 0..16 {
            let is_chosen = |lane: usize| chosen >> lane & 1 != 0;
            let shown = |lane: usize| {
                if is_chosen(lane) {
                    a[lane]
                } else {
                    Color::BLACK
                }
            };
            assert_same(v.masked(mask(chosen)), array::from_fn(shown));
        }
        let black = (0..4).filter(|lane| a[*lane] == Color::BLACK);
        assert_eq!(v.are_black(), black.map(|lane| 1 << lane).sum(), "{a:?}");
    }
}

/// A light that says nothing of four points.
#[derive(Debug)]
struct Unknown(SpotLight);

impl Light for Unknown {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        self.0.illumination(point)
    }
}

const LAMP: Point3 = Point3::new(1.0, 4.0, 2.0);

fn lights() -> [Box<dyn Light>; 4] {
    let spot = SpotLight::new(ORANGE, LAMP, DOWN, 0.7).unwrap();
    [
        Box::new(PointLight::new(ORANGE, LAMP).unwrap()),
        Box::new(DirectionalLight::new(ORANGE, Vector3::new(1.0, -2.0, -1.0)).unwrap()),
        Box::new(spot),
        Box::new(Unknown(spot)),
    ]
}

/// In the beam and beside it, in the lamp itself, and so near to it and so far away
/// that the square of the way is no number of use.
#[test]
fn four_points_are_lit_as_each_alone() {
    let points = [
        Point3::ORIGIN,
        Point3::new(9.0, 4.0, -2.0),
        LAMP,
        Point3::new(0.0, -1e200, 0.0),
        Point3::new(1.0, 4.0_f64.next_down(), 2.0),
        Point3::new(-0.5, 0.25, 3.0),
        Point3::new(1e200, -1e200, 0.0),
    ];
    for light in lights() {
        for i in 0..points.len() {
            let points: [Point3; 4] = array::from_fn(|lane| points[(i + lane) % points.len()]);
            let alone = points.map(|point| light.illumination(point));
            for active in 0..16 {
                let together = Vector3x4::new(points.map(Point3::to_glam));
                let found = light.illuminations(together, active);
                let (colors, distances) = (found.color.to_lanes(), found.distance.to_array());
                let directions = found.direction.to_lanes();
                for (lane, alone) in alone.iter().enumerate() {
                    let found = (found.lit >> lane & 1 != 0).then(|| Illumination {
                        color: colors[lane],
                        direction: Vector3::from_glam(directions[lane]),
                        distance: distances[lane],
                    });
                    let expected = alone.filter(|_| active >> lane & 1 != 0);
                    assert_eq!(found, expected, "{light:?} {:?}", points[lane]);
                }
            }
        }
    }
}

/// One light, and some that comes from everywhere.
struct Lit(Option<Illumination>);

const AMBIENT: Color = Color::new(0.1, 0.2, 0.3);

impl Lighting for Lit {
    fn ambient(&self) -> Color {
        AMBIENT
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.0.iter().for_each(shade);
    }
}

/// Random directions; between two of them any angle.
fn directions(n: u32) -> [Vector3; 4] {
    [0, 1, 2, 3].map(|lane| {
        let random = PixelRandom::new(5, n, lane);
        let [x, y, z] = [0, 1, 2].map(|i| 2.0 * random.uniform(i) - 1.0);
        Vector3::new(x, y, z).normalized().unwrap()
    })
}

/// With and without a diffuse colour and a highlight, and with exponents that are
/// whole or not.
fn materials() -> Vec<Phong> {
    let (white, black) = (Color::WHITE, Color::BLACK);
    let shiny = |diffuse, specular, exponent| Phong::new(diffuse, specular, exponent).unwrap();
    let matt = Lambert::new(Color::gray(0.5)).unwrap();
    vec![
        shiny(Color::gray(0.5), ORANGE, 3.0),
        shiny(black, white, 3.0),
        shiny(white, black, 3.0),
        shiny(black, black, 0.0),
        shiny(ORANGE, Color::gray(0.25), 0.0),
        shiny(ORANGE, Color::gray(0.25), 2.5),
        matt.as_phong().expect("Lambert's is one of Phong's"),
    ]
}

/// Four hits and their light, which is there in the lanes whose bits are set.
#[derive(Clone, Copy)]
struct Four {
    materials: [Phong; 4],
    rays: [Ray; 4],
    normals: [Vector3; 4],
    lights: [Illumination; 4],
    lit: u32,
}

impl Four {
    fn new(n: u32, materials: [Phong; 4], lit: u32) -> Self {
        let ways = directions(3 * n);
        Self {
            materials,
            rays: directions(3 * n + 1).map(|way| Ray::new(Point3::ORIGIN, way).unwrap()),
            normals: directions(3 * n + 2),
            lights: array::from_fn(|lane| Illumination {
                color: Color::new(1.0, 0.5, 1.0 + lane as f64),
                direction: ways[lane],
                distance: 1.0,
            }),
            lit,
        }
    }

    fn together(&self, materials: &PhongPacket) -> [Color; 4] {
        let vectors = |v: [Vector3; 4]| Vector3x4::new(v.map(Vector3::to_glam));
        let light = IlluminationPacket {
            lit: self.lit,
            color: ColorPacket::new(self.lights.map(|light| light.color)),
            direction: vectors(self.lights.map(|light| light.direction)),
            distance: Lanes::ONE,
        };
        let ways = vectors(self.rays.map(|ray| ray.direction()));
        let shade = materials.shade(ways, vectors(self.normals), &light, self.lit);
        (materials.ambient(AMBIENT) + shade).to_lanes()
    }

    fn alone(&self) -> [Color; 4] {
        array::from_fn(|lane| {
            let hit = Hit::new(1.0, self.normals[lane].as_normal());
            let is_lit = self.lit >> lane & 1 != 0;
            let light = is_lit.then_some(self.lights[lane]);
            self.materials[lane].color_for(&self.rays[lane], &hit, &Lit(light))
        })
    }
}

/// Neither way computes a power that the other does not.
#[test]
fn four_hits_are_shaded_as_each_alone() {
    let kinds = materials();
    for (i, kind) in kinds.iter().enumerate() {
        let others: [Phong; 4] = array::from_fn(|lane| kinds[(i + lane) % kinds.len()]);
        for (materials, packet) in [
            ([*kind; 4], PhongPacket::splat(kind)),
            (others, PhongPacket::new(others)),
        ] {
            for lit in 0..16 {
                let fours = || (0..50).map(move |n| Four::new(n, materials, lit));
                let all = |shade: &(dyn Fn(Four) -> [Color; 4] + Sync)| {
                    let shade = || fours().map(shade).collect::<Vec<_>>();
                    let (colors, work) = counted(shade).unwrap();
                    (colors, work[Work::Power])
                };
                let together = all(&|four| four.together(&packet));
                assert_eq!(together, all(&|four| four.alone()), "{materials:?} {lit}");
            }
        }
    }
}

#[test]
fn a_packet_knows_who_answers_light() {
    let kinds = materials();
    for (i, one) in kinds.iter().enumerate() {
        let of_four = PhongPacket::splat(one).answer_light();
        assert_eq!(of_four, if one.answers_light() { 0b1111 } else { 0 });
        let others: [Phong; 4] = array::from_fn(|lane| kinds[(i + lane) % kinds.len()]);
        let expected = (0..4).filter(|lane| others[*lane].answers_light());
        let found = PhongPacket::new(others).answer_light();
        assert_eq!(found, expected.map(|lane| 1 << lane).sum());
    }
    let single = SingleColor::new(ORANGE).unwrap();
    assert_eq!(single.as_phong(), None, "the same from everywhere");
    assert_eq!(kinds[0].as_phong(), Some(kinds[0]));
}

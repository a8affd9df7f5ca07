//! Compares lights: from before and behind, in them, far away, and just inside and outside
//! of a border.

use std::array;

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a05_lighting::{Illumination, LitWorld, stage};
use testing::exercise::{Answer, Check, Input, Random, random};

use crate::material::{FROM_ABOVE, Lights, balls, seen};
use crate::scene::{Scene, array, point, scene, show};

/// The light that arrives at a point.
pub type Arriving = Option<Illumination>;

/// Where the lights are whose parameters are simple.
pub const LAMP: [f64; 3] = [0.0, 4.0, 0.0];

/// Below the lamp, aslant, in its plane, above it, and in it.
const SIMPLE: [[f64; 3]; 5] = [
    [0.0, 2.0, 0.0],
    [4.0, 0.0, 0.0],
    [3.0, 4.0, 4.0],
    [0.0, 4.5, 0.0],
    LAMP,
];

type Mistake = fn(Illumination) -> Illumination;

const MISTAKES: &[(&str, Mistake)] = &[
    ("the direction leads to the light", |light| Illumination {
        direction: -light.direction,
        ..light
    }),
    ("the direction has length 1", |light| Illumination {
        direction: light.direction * light.distance.min(9.0),
        ..light
    }),
    ("the distance says which objects cast shadows", |light| {
        let distance = 1.0;
        Illumination { distance, ..light }
    }),
];

/// Compares the light that arrives at points with the lesson's, for the `first` parameters
/// and for `any`; the words have `{}` in the place of each of them.
pub fn compare_lights<P: Input>(
    check: &mut Check,
    words: &str,
    first: &P,
    any: impl FnMut(&mut Random) -> P,
    lesson: impl Fn(P, Point3) -> Arriving,
    yours: impl Fn(P, Point3) -> Arriving,
) {
    let mistake = check.usual(MISTAKES).unwrap_or(|light| light);
    let mut places = Random::new(2);
    let points = |light: P| {
        let is_lit = |p| lesson(light.clone(), point(p)).is_some();
        let [p, q] = [(); 2].map(|()| places.triple(9.0));
        let between = |share: f64| array::from_fn(|i| p[i] + share * (q[i] - p[i]));
        // Between a point that is lit and one that is not, there is a border.
        let (mut near, mut far) = (0.0, 1.0);
        for _ in 0..40 {
            let share = f64::midpoint(near, far);
            let is_near = is_lit(between(share)) == is_lit(p);
            *if is_near { &mut near } else { &mut far } = share;
        }
        [
            p,
            p.map(|x| 1e6 * x),
            between(near - 1e-6),
            between(far + 1e-6),
        ]
        .map(|p| (light.clone(), p))
    };
    check.compare(
        &format!("{words}, seen from {{}}"),
        SIMPLE.map(|p| (first.clone(), p)),
        random(any).flat_map(points),
        |(light, p)| answer(lesson(light, point(p))),
        |(light, p)| answer(yours(light, point(p)).map(mistake)),
    );
}

fn answer(light: Arriving) -> Answer {
    light.map_or(Answer::words("no light"), |light| {
        Answer::named("colour", light.color.channels())
            .and("direction", array(light.direction))
            .and("distance", light.distance)
    })
}

/// Compares the picture of a scene in the student's light.
pub fn scene_in(
    check: &mut Check,
    name: &str,
    view: Scene<LitWorld>,
    light: impl Fn(Point3) -> Arriving + Sync,
) {
    scene(check, &stage(), name, view, |world, ray, _| {
        lit(world, ray, &light)
    });
}

/// Shows balls in the student's light.
pub fn show_in(check: &mut Check, light: impl Fn(Point3) -> Arriving + Sync) {
    show(check, FROM_ABOVE, balls(), |world, ray| {
        lit(world, ray, &light)
    });
}

fn lit(world: &LitWorld, ray: &Ray, light: impl Fn(Point3) -> Arriving) -> common::Color {
    seen(world, ray, |hit, material, _| {
        let lights = light(ray.at(hit.t)).into_iter().collect();
        material.color_for(ray, hit, &Lights(world.ambient(), lights))
    })
}

//! Compares lights: from before and behind, in them, far away, and just inside and outside
//! of a border.

use std::array;

use a05_lighting::instruments::recorded::push_light;

use crate::prelude::*;

/// The light that arrives at a point.
pub type Arriving = Option<Illumination>;

/// Where the lights are whose parameters are simple.
pub const LAMP: [f64; 3] = [0.0, 4.0, 0.0];

/// Below the lamp, aslant, and in it.
const PLACES: [[f64; 3]; 3] = [[0.0, 2.0, 0.0], [3.0, 0.0, 0.0], LAMP];

type Mistake = fn(&mut Illumination);

const MISTAKES: &[(&str, Mistake)] = &[
    ("the direction leads to the light", |light| {
        light.direction = -light.direction;
    }),
    ("the direction has length 1", |light| {
        light.direction = light.direction * light.distance.min(9.0);
    }),
    ("the distance says which objects cast shadows", |light| {
        light.distance = 1.0;
    }),
];

/// Compares the light that arrives at points with the lesson's, for the `first` parameters
/// and for `any`; the words have `{}` in the place of each of them.
pub fn compare_lights<P: Input>(
    check: &mut Check,
    words: &str,
    first: &P,
    any: fn(&mut Random) -> P,
    lesson: &dyn Fn(P, Point3) -> Arriving,
    yours: &dyn Fn(P, Point3) -> Arriving,
) {
    let mistake = check.usual(MISTAKES).unwrap_or(|_| ());
    let mut places = Random::new(2);
    let border = |light: P| {
        let is_lit = |p| lesson(light.clone(), point(p)).is_some();
        let p = places.triple(9.0);
        // Between a point that is lit and one that is not, there is a border.
        let mut ends = [p, places.triple(9.0)];
        for _ in 0..20 {
            let middle = array::from_fn(|i| f64::midpoint(ends[0][i], ends[1][i]));
            ends[usize::from(is_lit(middle) != is_lit(p))] = middle;
        }
        [p, ends[0], ends[1]]
    };
    let borders = check.recorded(|| random(any).map(border).collect());
    let points = random(any)
        .zip(borders)
        .flat_map(|(light, [p, a, b])| [p, p.map(|x| 1e6 * x), a, b].map(|p| (light.clone(), p)));
    check.compare(
        &format!("{words}, seen from {{}}"),
        PLACES.map(|p| (first.clone(), p)),
        points,
        [(lesson, (|_| ()) as Mistake), (yours, mistake)],
        |(light, mistake), (parameters, p)| {
            let mut arriving = light(parameters, point(p));
            arriving.iter_mut().for_each(mistake);
            arriving.map_or(Answer::words("no light"), |light| {
                Answer::named("colour", light.color.channels())
                    .and("direction", array(light.direction))
                    .and("distance", light.distance)
            })
        },
    );
}

/// The picture of a scene of shiny objects in the student's light, whose type is `name`.
pub fn lit(
    view: Made<View<LitWorld>>,
    name: &str,
    light: impl Fn(Point3) -> Arriving + Sync,
) -> impl FnOnce(&Settings) -> Result<Image, Error> {
    shaded(view, move |diffuse, ray, hit, world| {
        let light = light(ray.at(hit.t));
        let lights = Lights(world.ambient(), Vec::from_iter(light));
        push_light(1, name, light);
        let shiny = Phong::new(diffuse, Color::WHITE, 64.0);
        shiny.map_or(Color::BLACK, |shiny| shiny.color_for(ray, hit, &lights))
    })
}

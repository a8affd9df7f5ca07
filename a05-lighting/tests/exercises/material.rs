//! Compares materials: in light from before, from behind and along the surface, with normals
//! aslant to the face, for eyes at all distances.

use a04_intersections::instruments::recorded::push_background;
use a05_lighting::instruments::recorded;
use a05_lighting::kinds::KINDS;

use crate::prelude::*;

/// Direction to the eye and its distance, normal and face, ambient light, and the colour of
/// each light and the direction to it. Directions have any length.
type Seen = ([f64; 3], f64, [[f64; 3]; 2], [f64; 3], Vec<[[f64; 3]; 2]>);

const SEEN: &str = "eye towards {} at the distance {}, normal and face {}, ambient light {}, \
    colours of lights and where they are {}";

/// An eye above and light from there, aslant, from behind, none but ambient light, and
/// a normal aslant to the face.
fn simple() -> [Seen; 5] {
    let [none, up, aslant, pink] = [[0.0; 3], [0.0, 1.0, 0.0], [3.0, 4.0, 0.0], [1.0, 0.5, 0.5]];
    let seen = |normal, ambient, lights: &[_]| {
        let lights = lights.iter().map(|l| [pink, *l]).collect();
        (up, 1.0, [normal, up], ambient, lights)
    };
    [
        seen(up, none, &[up]),
        seen(up, none, &[aslant]),
        seen(up, none, &[[3.0, -4.0, 0.0]]),
        seen(up, pink, &[]),
        seen(aslant, none, &[up]),
    ]
}

/// An eye before a surface, and two lights, one of which shines along it.
fn any_seen(r: &mut Random) -> Seen {
    let [normal, bend, eye, light] = [(); 4].map(|()| vector(r.triple(1.0)));
    let face = normal + bend * 0.4;
    let eye = eye * eye.dot(face).signum();
    let grazing = normal.cross(light) + normal * (1e-6 * r.between(-1.0, 1.0));
    let [eye, normal, face, light, grazing] = [eye, normal, face, light, grazing].map(array);
    let lights = [light, grazing].map(|l| [channels(r), l]).to_vec();
    (eye, r.scale(), [normal, face], channels(r), lights)
}

/// The ambient light, and lights that reach every hit.
pub struct Lights(pub Color, pub Vec<Illumination>);

impl Lighting for Lights {
    fn ambient(&self) -> Color {
        self.0
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.1.iter().for_each(shade);
    }
}

type Mistake = fn(&mut Hit, &mut Illumination);

const MISTAKES: &[(&str, Mistake)] = &[
    ("the normal counts, not the face", |hit, _| {
        hit.normal = hit.face;
    }),
    ("a surface reflects the colour of the light", |_, light| {
        light.color = Color::WHITE;
    }),
    ("light from behind adds nothing", |hit, light| {
        light.direction = light.direction * hit.normal.dot(light.direction).signum();
    }),
];

/// Compares materials with the lesson's, for the `first` parameters and for `any`; the words
/// have `{}` in the place of each of them.
pub fn compare_materials<P: Input>(
    check: &mut Check,
    words: &str,
    first: &P,
    any: fn(&mut Random) -> P,
    lesson: &dyn Fn(P, &Ray, &Hit, &dyn Lighting) -> Color,
    yours: &dyn Fn(P, &Ray, &Hit, &dyn Lighting) -> Color,
) {
    let mistake = check.usual(MISTAKES).unwrap_or(|_, _| ());
    check.compare(
        &format!("{words}, {SEEN}"),
        simple().map(|seen| (first.clone(), seen)),
        random(|r| (any(r), any_seen(r))),
        [(lesson, (|_, _| ()) as Mistake), (yours, mistake)],
        |(material, mistake), (parameters, seen)| {
            let (ray, hit, lights) = parts(seen, mistake);
            material(parameters, &ray, &hit, &lights).channels()
        },
    );
}

/// The ray, the hit and the lights, with directions of length 1, after a mistake.
fn parts((eye, t, normals, ambient, lights): Seen, mistake: Mistake) -> (Ray, Hit, Lights) {
    let ray = Ray::derived(Point3::ORIGIN + unit(eye) * t, -unit(eye));
    let [normal, face] = normals.map(|n| unit(n).as_normal());
    let mut hit = Hit::new(t, normal);
    hit.face = face;
    let lights = lights.into_iter().map(|[light, direction]| {
        let mut arriving = Illumination::default();
        (arriving.color, arriving.direction) = (color(light), unit(direction));
        mistake(&mut hit, &mut arriving);
        arriving
    });
    let lights = Lights(color(ambient), lights.collect());
    (ray, hit, lights)
}

/// The ambient light that a surface reflects, and the reflected part `of` each light.
pub fn sum(
    diffuse: Color,
    ray: &Ray,
    hit: &Hit,
    lights: &dyn Lighting,
    of: impl Fn(&Illumination) -> Color,
) -> Color {
    let mut sum = diffuse * lights.ambient();
    lights.for_each_light(ray, hit, &mut |light| sum += of(light));
    sum
}

/// The picture of a scene in the colours of this function, which takes the diffuse colour of
/// the material, the ray, its hit, and the lights.
pub fn shaded(
    view: Made<View<LitWorld>>,
    color: impl Fn(Color, &Ray, &Hit, &dyn Lighting) -> Color + Sync,
) -> impl FnOnce(&Settings) -> Result<Image, Error> {
    let view = view.map(|view| {
        view.map(|world| recorded::map_world(world, |_, own| own, |own| own, recorded::light))
    });
    rendered(view, move |world: &LitWorld, ray, _| {
        let background = world.objects().background();
        let nearest = world.objects().hit(ray, Interval::AHEAD);
        let shown = nearest.map_or(background, |(hit, material)| {
            let diffuse = material.color_for(ray, &hit, &Lights(Color::WHITE, Vec::new()));
            let shaded = || color(diffuse, ray, &hit, world);
            let shaded = || recorded::shaded(ray, &hit, KINDS, &**material, shaded);
            shaded()
        });
        push_background(background);
        shown
    })
}

//! What lights and materials tell so that work can be left out, and what a plan
//! tells the reader of it.

use std::cell::Cell;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Focus, PixelRandom, Ray};
use a04_intersections::{Hit, Plane};
use a05_lighting::{
    DirectionalLight, Illumination, Lambert, Light, Lighting, LitWorld, Material, Phong,
    PointLight, SingleColor, SpotLight,
};
use common::{Color, Plan};

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const ORANGE: Color = Color::new(1.0, 0.5, 0.0);

fn lambert(diffuse: Color) -> Lambert {
    Lambert::new(diffuse).unwrap()
}

fn phong(diffuse: Color, specular: Color) -> Phong {
    Phong::new(diffuse, specular, 2.0).unwrap()
}

/// Says nothing of itself but that it is there.
#[derive(Debug)]
struct Unknown;

impl Light for Unknown {
    fn illumination(&self, _: Point3) -> Option<Illumination> {
        None
    }
}

impl Material for Unknown {
    fn color_for(&self, _: &Ray, _: &Hit, _: &dyn Lighting) -> Color {
        Color::WHITE
    }
}

#[test]
fn lights_are_never_brighter_than_their_colour() {
    let place = Point3::new(1.0, 2.0, 3.0);
    let lights: [&dyn Light; 3] = [
        &PointLight::new(ORANGE, place).unwrap(),
        &DirectionalLight::new(ORANGE, UP).unwrap(),
        &SpotLight::new(ORANGE, place, UP, 1.0).unwrap(),
    ];
    assert_eq!(lights.map(Light::brightest), [ORANGE; 3]);
}

/// All ways to a point light meet in it; those to the sun are parallel.
#[test]
fn lights_tell_what_their_rays_have_in_common() {
    let place = Point3::new(1.0, 2.0, 3.0);
    let point = PointLight::new(ORANGE, place).unwrap();
    let spot = SpotLight::new(ORANGE, place, UP, 1.0).unwrap();
    let sun = DirectionalLight::new(ORANGE, UP * 5.0).unwrap();
    assert_eq!(point.focus(), Some(Focus::Point(place)));
    assert_eq!(spot.focus(), Some(Focus::Point(place)));
    assert_eq!(sun.focus(), Some(Focus::Direction(UP)));
}

/// Nothing may be left out on the word of one that gives none.
#[test]
fn who_says_nothing_may_be_anything() {
    let anything = Color::gray(f64::INFINITY);
    assert_eq!(Light::brightest(&Unknown), anything);
    assert_eq!(Unknown.focus(), None);
    assert_eq!(Material::brightest(&Unknown, ORANGE, ORANGE), anything);
    assert!(Unknown.answers_light() && !Unknown.has_highlight());
}

/// `cd (ca + Σ cl)`, and `cs Σ cl` more where it shines.
#[test]
fn bounds_of_materials_are_what_full_light_makes_of_them() {
    let (diffuse, specular) = (Color::new(0.5, 0.25, 0.0), Color::new(0.0, 0.5, 0.25));
    let (ambient, lights) = (Color::new(0.5, 1.0, 2.0), Color::new(1.5, 3.0, 2.0));
    let bounds: [(&dyn Material, Color); 3] = [
        (&lambert(diffuse), Color::new(1.0, 1.0, 0.0)),
        (&phong(diffuse, specular), Color::new(1.0, 2.5, 0.5)),
        (&SingleColor::new(ORANGE).unwrap(), ORANGE),
    ];
    for (material, bound) in bounds {
        assert_eq!(material.brightest(ambient, lights), bound, "{material:?}");
    }
}

/// Both are reached where light, eye and normal have one direction.
#[test]
fn no_colour_exceeds_the_bound_of_its_material() {
    let (ambient, light) = (Color::new(0.5, 1.0, 2.0), Color::new(1.5, 3.0, 2.0));
    let material = phong(Color::new(0.5, 0.25, 1.0), ORANGE);
    let seen = |towards: Vector3| {
        let world = LitWorld::new(Color::BLACK, ambient)
            .unwrap()
            .lit_by(Box::new(DirectionalLight::new(light, -towards).unwrap()));
        let ray = Ray::new(Point3::ORIGIN + UP, -UP).unwrap();
        let hit = Hit::new(1.0, UP.as_normal());
        material.color_for(&ray, &hit, &world)
    };
    let bound = material.brightest(ambient, light);
    assert_eq!(seen(UP), bound);
    for n in 0..1000 {
        let random = PixelRandom::new(4, n, 0);
        let [x, y, z] = [0, 1, 2].map(|i| random.uniform(i) - 0.5);
        let color = seen(Vector3::new(x, y, z));
        assert!(color.r <= bound.r && color.g <= bound.g && color.b <= bound.b);
    }
}

#[test]
fn only_what_light_can_change_answers_it() {
    let (white, black) = (Color::WHITE, Color::BLACK);
    let materials: [(&dyn Material, bool, bool); 7] = [
        (&SingleColor::new(white).unwrap(), false, false),
        (&lambert(white), true, false),
        (&lambert(black), false, false),
        (&phong(white, white), true, true),
        (&phong(black, white), true, true),
        (&phong(white, black), true, false),
        (&phong(black, black), false, false),
    ];
    for (material, answers_light, has_highlight) in materials {
        assert_eq!(material.answers_light(), answers_light, "{material:?}");
        assert_eq!(material.has_highlight(), has_highlight, "{material:?}");
    }
}

/// Counts who asks for the lights.
struct Counting {
    omits: bool,
    asked: Cell<u32>,
}

impl Lighting for Counting {
    fn ambient(&self) -> Color {
        Color::BLACK
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, _: &mut dyn FnMut(&Illumination)) {
        self.asked.set(self.asked.get() + 1);
    }

    fn omits(&self) -> bool {
        self.omits
    }
}

/// Black ones ask only where nothing is left out, others always.
#[test]
fn what_answers_no_light_asks_for_none() {
    let (white, black) = (Color::WHITE, Color::BLACK);
    let materials: [(&dyn Material, u32); 5] = [
        (&SingleColor::new(white).unwrap(), 0),
        (&lambert(black), 0),
        (&phong(black, black), 0),
        (&lambert(white), 1),
        (&phong(black, white), 1),
    ];
    for (material, needed) in materials {
        for (omits, expected) in [(true, needed), (false, 1)] {
            let asked = Cell::new(0);
            let lighting = Counting { omits, asked };
            let ray = Ray::derived(Point3::ORIGIN + UP, -UP);
            material.color_for(&ray, &Hit::new(1.0, UP.as_normal()), &lighting);
            assert_eq!(lighting.asked.get(), expected, "{material:?}");
        }
    }
}

/// A floor of each of these materials, under a light.
fn plan_of(materials: Vec<Box<dyn Material>>, are_lit: bool) -> Plan {
    let mut world = LitWorld::new(Color::BLACK, Color::BLACK).unwrap();
    for material in materials {
        let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap();
        world = world.with(floor, material);
    }
    if are_lit {
        world = world.lit_by(Box::new(PointLight::new(ORANGE, Point3::ORIGIN).unwrap()));
    }
    world.plan(Plan::default())
}

/// Each kind of omission is in the plan of a world with the reason for it, and
/// in no other.
#[test]
fn the_plan_tells_what_need_not_be_lit() {
    let shiny = || -> Box<dyn Material> { Box::new(phong(Color::WHITE, Color::WHITE)) };
    let matt = || -> Box<dyn Material> { Box::new(lambert(Color::WHITE)) };
    let dull = || -> Box<dyn Material> { Box::new(SingleColor::new(ORANGE).unwrap()) };
    let search = "a search for a ray alone";
    let by_lights = "all shading by lights";
    let behind = "powers where a light is behind, or mirrored away from the eye";
    for (materials, are_lit, omitted) in [
        (vec![shiny()], false, vec![search, by_lights]),
        (vec![shiny()], true, vec![search, behind]),
        (vec![matt()], true, vec![search, "powers on 1 of 1 objects"]),
        (
            vec![matt(), shiny(), dull()],
            true,
            vec![
                search,
                "light on 1 of 3 objects",
                "powers on 2 of 3 objects",
                behind,
            ],
        ),
    ] {
        let objects = format!("objects: {}", materials.len());
        let lights = format!("lights: {}", u32::from(are_lit));
        let plan = plan_of(materials, are_lit);
        assert_eq!(plan.needs, [objects, lights]);
        let what: Vec<_> = plan.omissions.iter().map(|o| o.what.as_str()).collect();
        assert_eq!(what, omitted);
    }
}

//! The lesson leaves work out that changes no colour: with all work it is the
//! same, to the last bit.

use crate::numbers::Numbers;
use a03_rays_cameras::Ray;
use a05_lighting::{DirectionalLight, Lambert, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::all_work::{self, NaiveTracer};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface};
use common::Color;

fn surface(numbers: &mut Numbers) -> Box<dyn Surface> {
    let (diffuse, specular) = (numbers.color(), numbers.color());
    let exponent = [0.0, 1.0, 2.5, 64.0][numbers.one_of(4) as usize];
    match numbers.one_of(5) {
        0 => Box::new(SingleColor::new(diffuse).unwrap()),
        1 => Box::new(Lambert::new(diffuse).unwrap()),
        2 => Box::new(Phong::new(diffuse, specular, exponent).unwrap()),
        _ => {
            let reflection = numbers.color();
            Box::new(Reflective::new(diffuse, specular, exponent, reflection).unwrap())
        }
    }
}

fn light(numbers: &mut Numbers) -> LightSource {
    let (color, place, direction) = (numbers.color(), numbers.point(), numbers.vector());
    let casts_shadows = numbers.one_of(4) > 0;
    match numbers.one_of(3) {
        0 => LightSource::new(PointLight::new(color, place).unwrap(), casts_shadows),
        1 => LightSource::new(
            DirectionalLight::new(color, direction).unwrap(),
            casts_shadows,
        ),
        _ => {
            let spot = SpotLight::new(color, place, direction, 0.7).unwrap();
            LightSource::new(spot, casts_shadows)
        }
    }
}

fn world(numbers: &mut Numbers) -> ShadowedWorld {
    let mut world = ShadowedWorld::empty(numbers.color(), numbers.color()).unwrap();
    for _ in 0..=numbers.one_of(6) {
        world = world.with(numbers.geometry(), surface(numbers));
    }
    for _ in 0..numbers.one_of(4) {
        world = world.lit_by(light(numbers));
    }
    world
}

#[test]
fn with_all_work_every_ray_brings_back_the_same_color() {
    let mut is_met = 0;
    for seed in 0..100 {
        let lesson = world(&mut Numbers::new(seed));
        let all = all_work::world(world(&mut Numbers::new(seed))).unwrap();
        let mut numbers = Numbers::new(1000 + seed);
        for _ in 0..100 {
            let ray = Ray::new(numbers.point(), numbers.vector()).unwrap();
            let depth = numbers.one_of(6);
            let color = RecursiveTracer::new(&lesson).trace(&ray, depth);
            let same = NaiveTracer::new(&all).trace(&ray, depth);
            let [expected, got] = [color, same].map(Color::channels);
            assert_eq!(expected.map(f64::to_bits), got.map(f64::to_bits), "{seed}");
            is_met += u32::from(color != lesson.objects().background());
        }
    }
    assert!(is_met > 3000, "{is_met} of 10000 rays met an object");
}

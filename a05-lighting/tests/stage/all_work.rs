//! The lesson leaves work out that changes no colour: with all work it is the
//! same, to the last bit.

use crate::numbers::Numbers;
use a03_rays_cameras::Ray;
use a05_lighting::{
    DirectionalLight, Lambert, Light, LitWorld, Material, Phong, PointLight, SingleColor,
    SpotLight, all_work,
};
use common::Color;

fn material(numbers: &mut Numbers) -> Box<dyn Material> {
    match numbers.one_of(3) {
        0 => Box::new(SingleColor::new(numbers.color()).unwrap()),
        1 => Box::new(Lambert::new(numbers.color()).unwrap()),
        _ => {
            let exponent = [0.0, 1.0, 2.5, 64.0][numbers.one_of(4) as usize];
            Box::new(Phong::new(numbers.color(), numbers.color(), exponent).unwrap())
        }
    }
}

fn light(numbers: &mut Numbers) -> Box<dyn Light> {
    let color = numbers.color();
    match numbers.one_of(3) {
        0 => Box::new(PointLight::new(color, numbers.point()).unwrap()),
        1 => Box::new(DirectionalLight::new(color, numbers.vector()).unwrap()),
        _ => Box::new(SpotLight::new(color, numbers.point(), numbers.vector(), 0.7).unwrap()),
    }
}

fn world(numbers: &mut Numbers) -> LitWorld {
    let mut world = LitWorld::new(numbers.color(), numbers.color()).unwrap();
    for _ in 0..=numbers.one_of(6) {
        world = world.with(numbers.geometry(), material(numbers));
    }
    for _ in 0..numbers.one_of(4) {
        world = world.lit_by(light(numbers));
    }
    world
}

#[test]
fn with_all_work_every_ray_brings_back_the_same_color() {
    let mut is_lit = 0;
    for seed in 0..100 {
        let lesson = world(&mut Numbers::new(seed));
        let all = all_work::world(world(&mut Numbers::new(seed))).unwrap();
        let mut numbers = Numbers::new(1000 + seed);
        for _ in 0..100 {
            let ray = Ray::new(numbers.point(), numbers.vector()).unwrap();
            let color = lesson.color_for(&ray);
            let [expected, got] = [color, all.color_for(&ray)].map(Color::channels);
            assert_eq!(expected.map(f64::to_bits), got.map(f64::to_bits), "{seed}");
            is_lit += u32::from(color != lesson.objects().background());
        }
    }
    assert!(is_lit > 3000, "{is_lit} of 10000 rays met an object");
}

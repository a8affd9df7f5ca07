//! The picture at the top of the README: one of its rows, by the lesson.

use std::path::Path;

use a03_rays_cameras::{Camera, Sampler, View, camera_coordinates};
use a06_shadows_reflection::RecursiveTracer;
use common::{Color, Transfer, picture_file};

#[path = "../../examples/dahlia.rs"]
#[expect(dead_code, reason = "the example's own main")]
mod example;

/// A row through the petals, the drops and the mirror.
const ROW: u32 = 420;

#[test]
fn every_third_pixel_of_a_row_is_right() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../book/src/pictures/dahlia.png");
    let picture = picture_file::open(&path).unwrap();
    let settings = &example::stage().scenes[0].defaults;
    assert_eq!(picture.size(), settings.size);
    let View { camera, world } = example::dahlia().unwrap();
    let (tracer, sampler) = (RecursiveTracer::new(&world), Sampler::new(settings));
    for column in (0..settings.size.width()).step_by(3) {
        let light = sampler.places(column, ROW).map(|place| {
            let (x, y) = camera_coordinates(settings.size, column, ROW, place);
            tracer.trace(&camera.ray_for(settings.size, x, y), settings.depth)
        });
        let sum = light.fold(Color::BLACK, |sum, light| sum + light);
        let mean = sum.map(|sum| sum / f64::from(settings.samples));
        let bytes = Transfer::Srgb.bytes(mean);
        let expected = picture.get(column, ROW).map(Color::to_bytes);
        assert_eq!(Some(bytes), expected, "column {column} of {ROW}");
    }
}

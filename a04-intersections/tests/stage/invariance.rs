//! The same scene in other units or at another place: the strongest test for
//! lengths hidden in a formula, because every bit must stay.

use a03_rays_cameras::Ray;

use super::support::{HERE, Place, hit, random_ray, random_shape};

const PAIRS: u32 = 8000;

/// The `t` of random rays at random shapes.
fn distances(place: Place) -> Vec<Option<f64>> {
    let pairs = (0..PAIRS).map(|n| (random_shape(n / 8, place), random_ray(n, place)));
    pairs
        .map(|(shape, ray)| Some(hit(&*shape, &ray)?.t))
        .collect()
}

#[test]
fn a_scene_in_other_units_is_the_same_scene() {
    let expected = distances(HERE);
    let hits = expected.iter().flatten().count();
    assert!(
        (PAIRS / 4..PAIRS / 2).contains(&(hits as u32)),
        "{hits} hits"
    );
    for exponent in (-300..=300).step_by(50) {
        let scale = libm::scalbn(1.0, exponent);
        let scaled = expected.iter().map(|t| t.map(|t| t * scale));
        let found = distances(Place { scale, ..HERE });
        assert!(found.into_iter().eq(scaled), "times 2^{exponent}");
    }
}

/// All differences between coordinates are exact, so nothing may change.
#[test]
fn a_scene_far_from_the_origin_is_the_same_scene() {
    let shift = libm::scalbn(1.0, 30);
    assert!(distances(Place { shift, ..HERE }) == distances(HERE));
}

/// A direction twice as long halves `t` exactly.
#[test]
fn a_direction_of_another_length_changes_t_alone() {
    for n in 0..PAIRS {
        let (shape, ray) = (random_shape(n / 8, HERE), random_ray(n, HERE));
        let found = |ray: &Ray| hit(&*shape, ray).map(|hit| (hit.t, hit.normal, hit.face));
        for exponent in [-300, -1, 1, 300] {
            let length = libm::scalbn(1.0, exponent);
            let scaled = found(&Ray::derived(ray.origin(), ray.direction() * length));
            let scaled = scaled.map(|(t, normal, face)| (t * length, normal, face));
            assert_eq!(scaled, found(&ray), "{shape:?} {ray:?} 2^{exponent}");
        }
    }
}

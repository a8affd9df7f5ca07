//! The depth of recursion that an error needs.

use a06_shadows_reflection::RecursiveTracer;
use a06_shadows_reflection::lab::experiments::recursion_depth::{CURVES, depth, rays, world};
use measure::experiment::HALF_GREY_LEVEL;

#[test]
fn the_depth_is_the_least_that_reaches_half_a_grey_level() {
    let depths = CURVES.map(|(k, _)| depth(k, HALF_GREY_LEVEL));
    assert_eq!(depths, [10, 36, 82, 180, 1079]);
}

#[test]
fn each_level_leaves_the_share_k_of_the_error() {
    for (k, _) in CURVES {
        let world = world(k).unwrap();
        let ray = rays(1)[0];
        let error = |depth| 1.0 / (1.0 - k) - RecursiveTracer::new(&world).trace(&ray, depth).r;
        for depth in 1..20 {
            let per_level = libm::log10(error(depth + 1) / error(depth));
            assert!(
                (per_level - libm::log10(k)).abs() < 1e-8,
                "{k} {depth} {per_level}"
            );
        }
    }
}

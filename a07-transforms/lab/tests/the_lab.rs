//! The experiments and extreme cases of the laboratory, its certified values, and its search.

use std::collections::HashSet;
use std::fs;

use a02_lab::exact::DoubleDouble;
use a03_rays_cameras::View;
use a04_lab::certified::{Uncertified, picture};
use a04_lab::search::INPUTS;
use a05_lighting::LitWorld;
use a05_lighting::instruments::recorded;
use a06_lab::experiments::secondary_rays::NEAR;
use a06_lab::policy::offset;
use a06_shadows_reflection::RecursiveTracer;
use a07_lab::certified::geometry;
use a07_lab::experiments::nested_nodes::lit_points;
use a07_lab::search::{self, TRANSFORM};
use measure::Effort;
use measure::extremes::{Bound, Case, Condition};

testing::check_lab! { a07_lab::laboratory() }

/// The world with geometries whose decisions are certified.
fn certified<S, L>(world: LitWorld<S, L>) -> LitWorld<S, L> {
    recorded::map_world(
        world,
        |_, shape| geometry(shape),
        |surface| surface,
        |(_, light)| light,
    )
}

/// A handful of roundings lie between the given numbers and `t`.
#[test]
fn the_worst_disc_is_as_good_as_its_plane() {
    let subject = &search::SUBJECTS[0];
    let worst = subject.worst(&|x, ray| subject.lesson(x, ray), INPUTS);
    assert!(
        worst.error < 8.0 && worst.wrong.is_empty() && worst.endless.is_none(),
        "{worst:?}"
    );
}

/// The protocol loses the rim of a disc, as in case B12, and points within it whose rounded distance is the radius,
/// as in case B13.
#[test]
fn the_search_finds_the_lost_rims() {
    let subject = &search::SUBJECTS[0];
    let worst = subject.worst(&subject.protocol, INPUTS);
    let beyond: Vec<_> = worst
        .borders
        .iter()
        .filter_map(|x| beyond_the_rim(x))
        .collect();
    assert!(beyond.contains(&0.0), "B12");
    assert!(beyond.iter().any(|squared| *squared < 0.0), "B13");
}

/// The square of the distance from the middle of a disc less that of the radius, for a ray along an axis across
/// the disc, which needs no rounding.
fn beyond_the_rim(numbers: &[f64]) -> Option<f64> {
    let [cx, cy, cz, nx, ny, nz, radius, ox, oy, oz, dx, dy, dz] = *numbers else {
        return None;
    };
    let exact = |x: f64| DoubleDouble::from(x);
    let mut squared = -(exact(radius) * exact(radius));
    let mut crossed = 0;
    for [c, n, o, d] in [[cx, nx, ox, dx], [cy, ny, oy, dy], [cz, nz, oz, dz]] {
        if n != 0.0 && d != 0.0 {
            crossed += 1;
        } else if n == 0.0 && d == 0.0 {
            let out = exact(o) - exact(c);
            squared = squared + out * out;
        } else {
            return None;
        }
    }
    (crossed == 1).then_some(squared.value())
}

/// Each hit, and which of two is nearer, for the rays as they were rounded.
#[test]
fn every_decision_in_the_lit_pictures_is_right() {
    use a05_lighting::scenes as lit;
    for (name, scene) in [
        ("lighting-1", lit::lighting_1()),
        ("lambert", lit::lambert()),
        ("phong", lit::phong()),
        ("phong-directional", lit::phong_directional()),
        ("phong-spot", lit::phong_spot()),
        ("phong-spot-ambient", lit::phong_spot_ambient()),
    ] {
        let View { camera, world } = scene.unwrap();
        let world = certified(world);
        let counts = picture(&*camera, |ray| world.color_for(ray));
        assert_eq!(counts, Uncertified::default(), "{name}");
    }
}

/// Likewise for shadow rays and reflected rays.
#[test]
fn every_decision_in_the_shadowed_pictures_is_right() {
    use a06_shadows_reflection::scenes as shadowed;
    use a07_transforms::scenes as transformed;
    for (name, scene) in [
        ("sphere", shadowed::sphere()),
        ("aab", shadowed::aab()),
        (
            "sphere-transformation",
            transformed::sphere_transformation(),
        ),
        ("box-transformations", transformed::box_transformations()),
        ("disc", transformed::disc()),
    ] {
        let View { camera, world } = scene.unwrap();
        let world = certified(world);
        let counts = picture(&*camera, |ray| RecursiveTracer::new(&world).trace(ray, 6));
        assert_eq!(counts, Uncertified::default(), "{name}");
    }
}

/// Of three million points a condition, none has acne or a leak:
/// `cargo test --release -p a07-lab --test the_lab -- --ignored`.
#[test]
#[ignore = "takes minutes"]
fn thirty_million_points_under_nodes_are_right() {
    for condition in [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9] {
        for trial in (1_000..1_300).flat_map(|seed| lit_points(10_000, seed, condition).unwrap()) {
            assert!(!trial.shades_itself(offset), "acne, {condition}");
            assert!(!NEAR.iter().any(|near| trial.leaks(offset, *near)));
        }
    }
}

/// The extreme cases of all stages.
fn all_cases() -> Vec<Case> {
    let laboratories = [
        a01_lab::laboratory(),
        a02_lab::laboratory(),
        a03_lab::laboratory(),
        a04_lab::laboratory(),
        a05_lab::laboratory(),
        a06_lab::laboratory(),
        a07_lab::laboratory(),
    ];
    laboratories
        .iter()
        .flat_map(|laboratory| (laboratory.extremes)(Effort::Quick))
        .collect()
}

/// No bound is far above the condition of its case, but where many roundings add up, or a byte is computed.
#[test]
fn bounds_are_those_of_the_problem() {
    const OF_MANY_ROUNDINGS: [&str; 5] = ["Q07", "Q08", "M11", "G15", "G28"];
    const OF_BYTES: [&str; 2] = ["Q13", "L04"];
    let mut loose = Vec::new();
    for case in all_cases() {
        let magnitude = case
            .exact
            .numbers()
            .iter()
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        let ulps = match case.bound {
            Bound::Equal => 0.0,
            Bound::Ulps(ulps) => ulps,
            Bound::Absolute(bound) => bound / (f64::EPSILON * magnitude),
        };
        if let Condition::Known(condition) = case.condition
            && ulps > 16.0 * condition.max(1.0)
        {
            loose.push(case.id);
        }
    }
    loose.sort_unstable();
    let mut expected = [&OF_MANY_ROUNDINGS[..], &OF_BYTES].concat();
    expected.sort_unstable();
    assert_eq!(loose, expected);
}

/// The rows of the tables of all stages have ids of their own, and the errata page names
/// them as its evidence.
#[test]
fn ids_are_unique_and_the_errata_name_existing_rows() {
    let mut ids = HashSet::new();
    for case in all_cases() {
        assert!(ids.insert(case.id), "{} stands twice", case.id);
    }
    assert!(ids.len() > 300, "all stages have tables");

    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/errata.md");
    let page = fs::read_to_string(page).unwrap();
    let spans = page.split('`').skip(1).step_by(2);
    let named: Vec<_> = spans.filter(|span| is_row(span)).collect();
    assert!(named.len() > 50, "the page names its rows in code spans");
    for row in named {
        assert!(ids.contains(row), "there is no row {row}");
    }
}

/// A letter, two digits, and perhaps another letter.
fn is_row(span: &str) -> bool {
    let bytes = span.as_bytes();
    matches!(bytes.len(), 3 | 4)
        && bytes[0].is_ascii_uppercase()
        && bytes[1..3].iter().all(u8::is_ascii_digit)
        && bytes[3..].iter().all(u8::is_ascii_lowercase)
}

/// The protocol scales a normal like a vector. A handful of roundings lie between the given numbers and the direction.
#[test]
fn the_worst_direction_is_right() {
    let theirs = TRANSFORM.worst(TRANSFORM.protocol);
    assert!(theirs.error > 1e6, "{theirs:?}");
    let ours = TRANSFORM.worst(TRANSFORM.lesson);
    assert!(ours.error < 8.0 && ours.lost.is_none(), "{ours:?}");
}

//! Points under nested nodes: none shades itself, and none misses an object near it.

use a06_lab::experiments::secondary_rays::NEAR;
use a06_lab::policy::offset;
use a07_lab::nested_nodes::lit_points;

/// Of four thousand points a condition, none has acne or a leak.
#[test]
fn points_under_nested_nodes_are_right() {
    for condition in [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9] {
        for lit in lit_points(4_096, 13, condition).unwrap() {
            assert!(!lit.shades_itself(offset), "acne, {condition}");
            assert!(!NEAR.iter().any(|near| lit.leaks(offset, *near)));
        }
    }
}

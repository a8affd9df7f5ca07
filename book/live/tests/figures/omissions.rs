//! What the switches of the page save, against counts by hand.

use super::ask;

/// Each of the 7,000 reflected rays of `aab`, 6,912 and 88 more at what those hit, is tested against its two objects, and
/// at the 88 hits a shadow ray, too. At 25 of the other hits the lamp is behind the surface. Each ray counts once: so
/// all savings together are what lies between the lesson and all work.
#[test]
fn what_the_switches_save_adds_up_to_all_work() {
    let answer = ask("work a06-shadows-reflection-aab", &[0.0]);
    let lines: Vec<_> = answer.text.lines().collect();
    let kinds = lines[0].split('\t').count();
    let saved: Vec<_> = answer.get("saved").chunks(kinds).collect();
    let of = |words: &str| {
        let switch = lines[1..].iter().position(|line| *line == words);
        saved[switch.expect("a switch")]
    };
    let mirrors = of("reflected rays from surfaces that mirror nothing");
    assert_eq!(mirrors, [0.0, 88.0, 7000.0, 14_176.0, 0.0, 0.0]);
    let behind = of("shadow rays to a light behind the surface");
    assert_eq!(behind, [0.0, 25.0, 0.0, 50.0, 0.0, 0.0]);
    let (done, all) = (answer.get("done"), answer.get("all"));
    for kind in 0..kinds {
        let sum: f64 = saved.iter().map(|counts| counts[kind]).sum();
        assert_eq!(done[kind] + sum, all[kind], "{}", lines[0]);
    }
}

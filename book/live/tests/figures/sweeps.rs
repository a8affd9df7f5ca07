//! Problems from harmless to extreme against values of mpmath at 1,000 digits, rounded to 22.

use super::ask;

/// The exact answers of the cases with these points (`common/corpus/check.py`).
#[test]
fn exact_answers_have_22_digits() {
    let exact = [
        ("distance", 8.0, "99999999.13397459621556"),
        ("distance", 12.0, "999999999999.1339745962"),
        ("tangent", -16.0, "4.999999985098838806152"),
        ("needle", 2.0, "5.000679723915863214793"),
        ("needle", 8.0, "5.000000041389439887028"),
        ("angle", -4.0, "0.00009999999966666667345884"),
        ("angle", -12.0, "9.999999999999999798866e-13"),
        ("spot", -1.0, "0.1003346720854505506651"),
        ("spot", -6.0, "1.000000000000333288081e-6"),
        ("direction", 200.0, "2"),
        ("matrix", 8.0, "0"),
    ];
    for (name, power, digits) in exact {
        let answer = ask(&format!("sweep {name}"), &[power]);
        assert_eq!(answer.text.lines().next(), Some(digits), "{name} {power}");
    }
}

/// 100000000 is 0.87 too much, more than half of its last place. Of 5.000000051875901 the error is 1.05e-8, more than
/// half a unit of the eighth place behind the dot.
#[test]
fn wrong_digits_are_those_below_the_error() {
    let right = |name: &str, power| ask(&format!("sweep {name}"), &[power]).get("right")[0];
    assert_eq!(right("distance", 8.0), "10000000".len() as f64);
    assert_eq!(right("needle", 8.0), "5.0000000".len() as f64);
    assert_eq!(right("direction", 200.0), 0.0, "a ball that is lost");
}

/// The squares of a far ball's distance have lost the square of its radius at 1e8; the cosine of an angle has lost half
/// of its digits near 1e-4; the protocol's least distance is 0.001, and a direction of 1e4 makes `t` less.
#[test]
fn the_protocols_formulas_break_where_theory_says() {
    for (name, from, to) in [
        ("distance", 7.5, 8.5),
        ("angle", -4.5, -3.5),
        ("needle", 7.5, 9.0),
        ("direction", 4.0, 4.0),
        ("matrix", 0.0, 0.0),
    ] {
        let breaks = ask(&format!("sweep {name}"), &[]).get("breaks")[0];
        assert!((from..=to).contains(&breaks), "{name} breaks at {breaks}");
    }
}

/// The lesson stays within the allowance of the problem and a few roundings, but for the cone of a spot light.
#[test]
fn the_lesson_loses_no_more_than_the_problem_allows() {
    for name in ["distance", "tangent", "angle", "matrix", "direction"] {
        let answer = ask(&format!("sweep {name}"), &[]);
        let lists = ["powers", "ours", "allowed"].map(|list| answer.get(list));
        for ((power, ours), allowed) in lists[0].iter().zip(lists[1]).zip(lists[2]) {
            assert!(*ours <= 4.0 * allowed + 4.0, "{name} {power}: {ours}");
        }
    }
}

//! Single and double precision under one name.

use a04_intersections::lab::real::{Real, difference, dot};

fn check<F: Real + std::fmt::Debug>(third: F) {
    let [two, four] = [2.0, 4.0].map(F::from);
    assert_eq!(four.sqrt(), two);
    assert_eq!(two.copysign(-four), -two);
    assert_eq!((-two).copysign(four), two);
    assert_eq!(F::rounded(1.0 / 3.0), third);
    let [a, b] = [[1.0, 2.0, 4.0], [3.0, 5.0, 4.0]].map(|triple| triple.map(F::from));
    assert_eq!(difference(&b, &a), [2.0, 3.0, 0.0].map(F::from));
    assert_eq!(dot(&a, &b), F::from(29.0));
    let next = F::from(1.0) + F::rounded(F::EPSILON);
    assert!(next > F::from(1.0));
    assert_eq!(F::from(1.0) + F::rounded(F::EPSILON / 4.0), F::from(1.0));
}

#[test]
fn singles_and_doubles_do_what_is_asked_of_them() {
    check::<f32>(1.0 / 3.0);
    check::<f64>(1.0 / 3.0);
}

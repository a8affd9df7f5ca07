//! The remark about the corpus of ray failures counts, and names the first case that is not right.

use a02_math::arrays::point;
use a04_intersections::{Geometry, Sphere};
use a04_kinds::corpus::corpus;
use a04_kinds::shape::own;

#[test]
fn the_remark_about_the_corpus_compares_and_names_the_first_failure() {
    let lesson = |x: &[f64]| {
        let sphere = Sphere::new(point([x[0], x[1], x[2]]), x[3])?;
        Ok(Box::new(sphere) as Box<dyn Geometry>)
    };
    let words = corpus("sphere", &lesson).unwrap();
    let start = "The corpus of ray failures: your sphere is right for ";
    let rest = words.strip_prefix(start).unwrap();
    let (count, rest) = rest.split_once(" of ").unwrap();
    assert_eq!(
        rest,
        format!("{count} rays, the lesson for {count} of {count}.")
    );

    let blind = |_: &[f64]| Ok(Box::new(own(|_, _| None)) as Box<dyn Geometry>);
    let words = corpus("sphere", &blind).unwrap();
    // The unit ball under a scale is no sphere of one's own, so the first is another one.
    let first = "The first that is not is public-23: The inner of two balls whose radii differ by 4e-5. \
                 Yours: a miss; exact: t = 999.0. \
                 (https://github.com/mitsuba-renderer/mitsuba3/pull/1871)";
    assert!(words.ends_with(first), "{words}");
}

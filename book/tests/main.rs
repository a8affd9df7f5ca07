//! The book and the crates say the same, as far as neither mdBook nor `links.mjs` sees it.
//!
//! A check returns a complaint with file and line for each mistake.

mod files;
mod forgotten;
mod include;
mod left_over;
mod named;
mod recorded;
mod way_of_a_ray;

use files::Files;

/// Fails with all complaints of a check about this repository.
fn check(complaints: fn(&Files) -> Vec<String>) {
    let complaints = complaints(&Files::read().expect("the repository"));
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

macro_rules! checks {
    ($($name:ident: $complaints:path;)*) => { $(
        #[test]
        fn $name() {
            check($complaints);
        }
    )* };
}

checks! {
    every_page_and_picture_is_reached: left_over::complaints;
    every_listing_shows_something: include::complaints;
    each_function_on_the_way_of_a_ray_calls_the_next: way_of_a_ray::complaints;
    what_a_text_names_exists: named::complaints;
    each_file_of_tests_is_compiled: forgotten::complaints;
    each_exercise_is_in_its_lists: forgotten::exercises;
    each_anchor_has_a_figure: recorded::anchors;
}

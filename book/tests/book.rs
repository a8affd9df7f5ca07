//! The book and the crates say the same.

use book::{Files, caption, changes, chapter, include, link, picture, section};

/// Fails with all complaints of a check about this repository.
fn check(complaints: fn(&Files) -> Vec<String>) {
    let complaints = complaints(&Files::read().unwrap());
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn every_chapter_is_in_the_summary() {
    check(chapter::complaints);
}

#[test]
fn every_link_leads_somewhere() {
    check(link::complaints);
}

#[test]
fn every_picture_is_shown() {
    check(picture::complaints);
}

#[test]
fn every_listing_shows_something() {
    check(include::complaints);
}

#[test]
fn every_picture_and_listing_has_a_caption() {
    check(caption::complaints);
}

#[test]
fn every_section_of_the_protocols_has_its_place() {
    check(section::complaints);
}

#[test]
fn every_stage_says_what_it_adds() {
    check(changes::complaints);
}

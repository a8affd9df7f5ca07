//! The book and the crates say the same.

use std::sync::LazyLock;

use book::{Files, caption, include, left_over};

static FILES: LazyLock<Files> = LazyLock::new(|| Files::read().expect("the repository"));

/// Fails with all complaints of a check about this repository.
fn check(complaints: fn(&Files) -> Vec<String>) {
    let complaints = complaints(&FILES);
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn every_page_picture_and_file_is_reached() {
    check(left_over::complaints);
}

#[test]
fn every_listing_shows_something() {
    check(include::complaints);
}

#[test]
fn every_picture_and_listing_has_a_caption() {
    check(caption::complaints);
}

//! Every target but the command line, with inputs that are the same every time.

use fuzz::inputs::{check_near, check_random};
use fuzz::{images, numbers, scenes};

#[test]
fn picture_files_do_no_harm() {
    check_near("images", 10_000, images::check);
}

#[test]
fn numbers_do_no_harm() {
    check_random(400, 100_000, numbers::check);
}

#[test]
fn scenes_do_no_harm() {
    check_random(1000, 3000, scenes::check);
}

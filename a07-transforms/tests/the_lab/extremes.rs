//! The stiff and extreme cases: every row holds.

use measure::{Effort, extremes};

#[test]
fn every_row_holds() {
    extremes::check(&(a07_transforms::stage().extremes)(Effort::of_build()));
}

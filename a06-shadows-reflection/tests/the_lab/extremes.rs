//! The stiff and extreme cases: every row holds.

use measure::{Effort, extremes};

#[test]
fn every_row_holds() {
    extremes::check(&(a06_shadows_reflection::stage().extremes)(
        Effort::of_build(),
    ));
}

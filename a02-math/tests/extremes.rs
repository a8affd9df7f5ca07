//! The stiff and extreme cases of this stage hold.

use common::Effort;

#[test]
fn extreme_cases_hold() {
    let cases = (a02_math::stage().extremes)(Effort::of_build());
    common::extremes::check(&cases);
}

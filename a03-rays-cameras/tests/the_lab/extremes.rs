//! The stiff and extreme cases of this stage hold.

use measure::Effort;

#[test]
fn extreme_cases_hold() {
    let cases = (a03_rays_cameras::stage().extremes)(Effort::of_build());
    measure::extremes::check(&cases);
}

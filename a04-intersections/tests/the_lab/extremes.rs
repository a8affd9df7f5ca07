//! Every row of the table of extreme cases holds.

use measure::Effort;

#[test]
fn every_case_holds() {
    let cases = (a04_intersections::stage().extremes)(Effort::of_build());
    measure::extremes::check(&cases);
}

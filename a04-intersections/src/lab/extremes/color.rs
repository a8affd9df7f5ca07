//! Conversion of channels to bytes.

use common::{Color, Transfer};
use measure::extremes::{Bound, Case, Fails, Holds, Id, Protocol};

use crate::lab::protocol;

fn case(id: Id, channel: f64, exact: f64, says: Protocol) -> Case {
    let ours = Transfer::Linear.bytes(Color::gray(channel))[0];
    let what = format!("a channel of {channel} as a byte");
    Case::new(id, what, exact, Bound::Equal, f64::from(ours))
        .protocol(says, f64::from(protocol::byte(channel)))
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    vec![
        case("H01", 1.5, 255.0, Fails),
        case("H02", -0.5, 0.0, Fails),
        case("H03", f64::NAN, 0.0, Holds),
        case("H04", f64::INFINITY, 255.0, Fails),
        case("H05", 0.5, 128.0, Fails),
        case("H06", 0.999_999, 255.0, Fails),
        case("H07", 0.5 / 255.0, 1.0, Fails),
        Case::new("H08", "a channel of NaN is black, but not unnoticed: is the colour finite?",
            false, Bound::Equal, Color::gray(f64::NAN).is_finite()),
    ]
}

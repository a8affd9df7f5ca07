//! `AxisAlignedBox`: the lesson's own.

pub use a04_intersections::AxisAlignedBox;

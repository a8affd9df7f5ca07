//! `triple!`: the common code of the three types of three numbers.

/// Implements constructor, coordinates, conversions from and to glam, and
/// comparison within a tolerance for a wrapper of `DVec3`.
macro_rules! triple {
    ($type:ident) => {
        impl $type {
            /// Three coordinates, taken as they are.
            #[must_use]
            pub const fn new(x: f64, y: f64, z: f64) -> Self {
                Self(glam::DVec3::new(x, y, z))
            }

            /// The coordinate to the right.
            #[must_use]
            pub const fn x(self) -> f64 {
                self.0.x
            }

            /// The coordinate upwards.
            #[must_use]
            pub const fn y(self) -> f64 {
                self.0.y
            }

            /// The coordinate towards the reader.
            #[must_use]
            pub const fn z(self) -> f64 {
                self.0.z
            }

            /// The three numbers of glam.
            #[must_use]
            pub const fn from_glam(xyz: glam::DVec3) -> Self {
                Self(xyz)
            }

            /// As three numbers of glam.
            #[must_use]
            pub const fn to_glam(self) -> glam::DVec3 {
                self.0
            }
        }

        impl From<$type> for [f64; 3] {
            fn from(triple: $type) -> Self {
                triple.0.to_array()
            }
        }

        impl approx::AbsDiffEq for $type {
            type Epsilon = f64;

            fn default_epsilon() -> f64 {
                f64::EPSILON
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
                self.0.abs_diff_eq(other.0, epsilon)
            }
        }
    };
}

pub(crate) use triple;

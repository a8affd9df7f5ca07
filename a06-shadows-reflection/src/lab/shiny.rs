//! The Phong materials among the surfaces, for the count of powers.

use std::any::Any;

use a05_lighting::Phong;

use crate::Reflective;

/// The Phong material that a surface is or has, if there is one.
pub fn as_phong(surface: &dyn Any) -> Option<&Phong> {
    match surface.downcast_ref() {
        Some(Reflective { shiny, .. }) => Some(shiny),
        None => surface.downcast_ref(),
    }
}

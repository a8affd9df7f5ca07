//! `as_phong`: the Phong material of a surface, to count powers.

use std::any::Any;

use a05_lighting::Phong;

use crate::Reflective;

/// The Phong material of a surface, if it has one.
pub fn as_phong(surface: &dyn Any) -> Option<&Phong> {
    match surface.downcast_ref() {
        Some(Reflective { shiny, .. }) => Some(shiny),
        None => surface.downcast_ref(),
    }
}

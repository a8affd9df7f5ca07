//! `Drawn`: a function of the place, for tests.

use std::sync::Mutex;

use common::Color;

use super::{Place, View};

/// A function of the place, in units of the smallest cells.
pub struct Drawn<F> {
    light: F,
    /// The tiles that begin in these columns show something so narrow.
    pub hiding: Vec<(u32, f64)>,
    pub stopped: bool,
    /// What was looked at together.
    asked: Mutex<Vec<Vec<Place>>>,
}

impl<F: Fn(Place) -> Color> Drawn<F> {
    pub fn new(light: F) -> Self {
        Self {
            light,
            hiding: Vec::new(),
            stopped: false,
            asked: Mutex::default(),
        }
    }

    /// Where it was looked at, in order, and at how many places at once, at most.
    pub fn asked(&self) -> (Vec<Place>, usize) {
        let asked = self.asked.lock().unwrap();
        let mut places = asked.concat();
        places.sort_unstable();
        (places, asked.iter().map(Vec::len).max().unwrap_or(0))
    }
}

impl<F: Fn(Place) -> Color + Sync> View for Drawn<F> {
    fn light(&self, places: &[Place], light: &mut Vec<Color>) {
        light.clear();
        light.extend(places.iter().map(|place| (self.light)(*place)));
        self.asked.lock().unwrap().push(places.to_vec());
    }

    fn may_hide(&self, (x, _): (u32, u32), _: u32, narrow: f64) -> bool {
        let mut hiding = self.hiding.iter();
        hiding.any(|(tile, width)| *tile == x && *width < narrow)
    }

    fn stopped(&self) -> bool {
        self.stopped
    }
}

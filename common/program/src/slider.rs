//! `Slider`: a number of a scene that a person changes in the window.

use common::{Error, Picture, Sampling, Scene, Settings};

/// The number that a slider changes.
#[derive(Clone, Copy)]
enum Number {
    Samples,
    MaxError,
    Depth,
    /// A coordinate of the place of a light.
    Light(usize, usize),
}

/// A number of a scene, one of some values.
pub struct Slider {
    /// The name for a person.
    pub name: String,
    number: Number,
    values: Vec<f64>,
    pub(crate) start: usize,
    /// The number of the chosen value.
    pub at: usize,
}

impl Slider {
    fn new(name: &str, number: Number, values: &[f64], start: f64) -> Self {
        let mut values = [values, &[start]].concat();
        values.sort_by(f64::total_cmp);
        values.dedup();
        let start = values.partition_point(|value| *value < start);
        let (name, at) = (name.to_owned(), start);
        Self {
            name,
            number,
            values,
            start,
            at,
        }
    }

    /// The sliders of a scene that has these settings at the start.
    pub(crate) fn all(scene: &Scene, settings: &Settings) -> Result<Vec<Self>, Error> {
        let mut sliders = Vec::new();
        let mut add = |name: &str, number, values: &[f64], start| {
            sliders.push(Self::new(name, number, values, start));
        };
        if scene.uses.sampling {
            let samples = [1.0, 4.0, 16.0, 64.0, 256.0, 1024.0, 4096.0];
            let start = settings.samples.into();
            add("Samples", Number::Samples, &samples, start);
            // The first one is no bound.
            let bounds = [f64::INFINITY, 510.0, 255.0, 128.0, 64.0, 32.0].map(f64::recip);
            let start = settings.max_error.unwrap_or(0.0);
            add("Error bound", Number::MaxError, &bounds, start);
        }
        if scene.uses.depth {
            let depths: Vec<_> = (1..=12).map(f64::from).collect();
            add("Depth", Number::Depth, &depths, settings.depth.into());
        }
        let lights = match &scene.picture {
            Picture::Traced(traced) => traced.light_positions(settings)?,
            Picture::Painted(_) => Vec::new(),
        };
        for (light, place) in lights.into_iter().enumerate() {
            for ((axis, start), letter) in place.iter().enumerate().zip(["x", "y", "z"]) {
                let values: Vec<_> = (-32..=32).map(|n| start + 0.25 * f64::from(n)).collect();
                let name = format!("Light {}, {letter}", light + 1);
                add(&name, Number::Light(light, axis), &values, *start);
            }
        }
        Ok(sliders)
    }

    /// The number of the last value.
    #[must_use]
    pub fn last(&self) -> usize {
        self.values.len() - 1
    }

    /// The value as text.
    #[must_use]
    pub fn text(&self) -> String {
        match (self.number, self.values[self.at]) {
            (Number::MaxError, 0.0) => "off".to_owned(),
            (Number::MaxError, error) => format!("1/{:.0}", 1.0 / error),
            (Number::Light(..), place) => format!("{place:.2}"),
            (_, number) => number.to_string(),
        }
    }

    /// Changes the settings to the chosen value.
    pub(crate) fn apply(&self, settings: &mut Settings) {
        let value = self.values[self.at];
        match self.number {
            Number::Samples => settings.samples = value as u32,
            Number::Depth => settings.depth = value as u32,
            Number::MaxError => {
                settings.max_error = (value > 0.0).then_some(value);
                if value > 0.0 {
                    // Few samples would not reach the bound.
                    settings.samples = settings.samples.max(1024);
                }
            }
            Number::Light(light, axis) => {
                let lights = &mut settings.edits.lights;
                lights.resize(lights.len().max(light + 1), [0.0; 3]);
                lights[light][axis] = value - self.values[self.start];
            }
        }
        if settings.samples == 1 {
            settings.sampling = Sampling::Center;
        } else if settings.sampling == Sampling::Center {
            settings.sampling = Sampling::Stratified;
        }
    }
}

#[cfg(test)]
mod tests {
    use common::Image;

    use super::*;

    #[test]
    fn samples_count_again_without_an_error_bound() {
        let scene = Scene::sampled("one", "", |settings, _| Image::black(settings.size));
        let mut settings = Settings {
            max_error: Some(1.0 / 255.0),
            ..Settings::default()
        };
        let mut sliders = Slider::all(&scene, &settings).unwrap();
        // Four samples, and no bound.
        (sliders[0].at, sliders[1].at) = (1, 0);
        for slider in &sliders {
            slider.apply(&mut settings);
        }
        assert_eq!((settings.samples, settings.max_error), (4, None));
    }
}

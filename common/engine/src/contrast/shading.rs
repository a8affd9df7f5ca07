//! The contrast of the light that a surface scatters inside of a footprint.

use std::f64::consts::FRAC_PI_2;

use common::Color;
use glam::DVec3;

use super::footprint::Footprint;
use crate::vector::normalized;
use crate::{Light, LightKind, Phong, Shading};

/// Upper bound of the rounding error of an angle that its cosine gives.
const ANGLE_ERROR: f64 = 1e-7;

/// A light as a footprint sees it.
struct Beam {
    color: Color,
    /// From the point of the footprint to the light, of length 1.
    direction: DVec3,
    /// Upper bound of the angle between the directions to the light from any two of its points.
    angle: f64,
}

/// How much a light can change inside of a footprint.
enum Change {
    /// It does not shine there.
    Dark,
    /// It shines everywhere, and only its direction changes.
    Direction(Beam),
    /// It may shine on one part, and not on another.
    Border(Color),
}

impl Footprint {
    /// The contrast of a material in these lights, per channel; infinite if the engine does not
    /// know it. Where a shape is alone, nothing casts shadows on it.
    pub fn contrast(&self, shading: &Shading, lights: &[Light], is_alone: bool) -> Color {
        match shading {
            Shading::SingleColor(_) => Color::BLACK,
            Shading::Other(_) => Color::gray(f64::INFINITY),
            Shading::Phong(phong) => {
                let mut contrast = Color::BLACK;
                for light in lights {
                    contrast += match self.change(light, is_alone) {
                        Change::Dark => Color::BLACK,
                        Change::Border(color) => (phong.diffuse + phong.specular) * color,
                        Change::Direction(beam) => self.contrast_by(phong, &beam),
                    };
                }
                contrast
            }
        }
    }

    /// How much a light changes. All points are within `length` of the one in the corner.
    fn change(&self, light: &Light, is_alone: bool) -> Change {
        let color = light.max_radiance();
        if light.casts_shadows && !is_alone {
            return Change::Border(color);
        }
        match light.kind {
            LightKind::Directional { direction, .. } => Change::Direction(Beam {
                color,
                direction: -direction,
                angle: 0.0,
            }),
            LightKind::Point { position, .. } => match self.beam(color, position) {
                Some(beam) => Change::Direction(beam),
                None => Change::Border(color),
            },
            LightKind::Spot {
                position,
                direction,
                cos_half_angle,
                ..
            } => {
                let Some(beam) = self.beam(color, position) else {
                    return Change::Border(color);
                };
                let from_axis = angle(-beam.direction.dot(direction));
                let inside = angle(cos_half_angle) - from_axis;
                if inside.abs() <= beam.angle + ANGLE_ERROR {
                    Change::Border(color)
                } else if inside > 0.0 {
                    Change::Direction(beam)
                } else {
                    Change::Dark
                }
            }
            LightKind::Other(_) => Change::Border(color),
        }
    }

    /// The beam of a light at a position, if that is farther away than the footprint is long. On a
    /// path at a distance from the light, its direction turns by at most the length of the path
    /// divided by the distance.
    fn beam(&self, color: Color, position: DVec3) -> Option<Beam> {
        let to_light = position - self.point;
        let nearest = to_light.length() - self.length;
        let direction = normalized(to_light)?;
        (nearest > 0.0).then(|| Beam {
            color,
            direction,
            angle: self.length / nearest,
        })
    }

    /// The contrast by a light that shines on the whole footprint.
    fn contrast_by(&self, phong: &Phong, beam: &Beam) -> Color {
        // The cosine of the angle between normal and light changes by no more than both turn.
        let turn = beam.angle + self.normal_angle;
        let slant = self.normal.dot(beam.direction);
        if slant + turn <= 0.0 {
            return Color::BLACK;
        }
        let diffuse = phong.diffuse * turn.min(1.0);
        // Where the light sets, a highlight ends at once.
        let highlight = if slant > turn {
            self.highlight_contrast(phong.exponent, beam)
        } else {
            1.0
        };
        (diffuse + phong.specular * highlight) * beam.color
    }

    /// The contrast of a highlight, the cosine of an angle to the power of the exponent `p`.
    ///
    /// With the angle, it changes by `p cosᵖ⁻¹ sin`, for exponents from 1 on. That is largest where
    /// the squared cosine is `q = (p - 1)/p`: `√p` times the power `(p - 1)/2` of `q`. Nor does the
    /// highlight change by more than its largest value.
    fn highlight_contrast(&self, exponent: f64, beam: &Beam) -> f64 {
        if exponent < 1.0 {
            return 1.0;
        }
        // A mirrored direction turns twice as far as the normal.
        let turn = beam.angle + 2.0 * self.normal_angle + self.ray_angle;
        let mirrored = self.normal * (2.0 * self.normal.dot(beam.direction)) - beam.direction;
        let smallest = angle(mirrored.dot(-self.direction)) - turn - ANGLE_ERROR;
        let largest = libm::pow(libm::cos(smallest.clamp(0.0, FRAC_PI_2)), exponent);
        let q = (exponent - 1.0) / exponent;
        let slope = exponent.sqrt() * libm::pow(q, (exponent - 1.0) / 2.0);
        (slope * turn).min(largest)
    }
}

/// The angle of a cosine.
fn angle(cosine: f64) -> f64 {
    libm::acos(cosine.clamp(-1.0, 1.0))
}

//! `PhongPacket`: Phong's formula for four hits at once.

use a02_math::vector3x4::mask;
use a02_math::{Lanes, Vector3x4};
use common::Color;
use measure::tally::{self, Work};

use crate::power::powers;
use crate::{ColorPacket, IlluminationPacket, Material, Phong};

/// The materials at four hits.
#[derive(Clone, Copy, Debug)]
pub struct PhongPacket {
    diffuse: ColorPacket,
    specular: ColorPacket,
    exponents: [f64; 4],
    /// A bit for each that answers light, and for each that has a highlight.
    answer_light: u32,
    have_highlight: u32,
}

impl PhongPacket {
    /// The same material four times.
    #[inline]
    #[must_use]
    pub fn splat(material: &Phong) -> Self {
        let bits = |is: bool| if is { 0b1111 } else { 0 };
        Self {
            diffuse: ColorPacket::splat(material.matt.diffuse),
            specular: ColorPacket::splat(material.specular),
            exponents: [material.exponent; 4],
            answer_light: bits(material.answers_light()),
            have_highlight: bits(material.has_highlight()),
        }
    }

    /// These four materials.
    #[inline]
    #[must_use]
    pub fn new(materials: [Phong; 4]) -> Self {
        let bits = |is: fn(&Phong) -> bool| {
            let bits = [0, 1, 2, 3].map(|lane| u32::from(is(&materials[lane])) << lane);
            bits.iter().sum()
        };
        Self {
            diffuse: ColorPacket::new(materials.map(|phong| phong.matt.diffuse)),
            specular: ColorPacket::new(materials.map(|phong| phong.specular)),
            exponents: materials.map(|phong| phong.exponent),
            answer_light: bits(Phong::answers_light),
            have_highlight: bits(Phong::has_highlight),
        }
    }

    /// A bit for each whose colour light can change.
    #[inline]
    #[must_use]
    pub const fn answer_light(&self) -> u32 {
        self.answer_light
    }

    /// The share of the ambient light.
    #[inline]
    #[must_use]
    pub fn ambient(&self, ambient: Color) -> ColorPacket {
        self.diffuse * ColorPacket::splat(ambient)
    }

    /// What the light adds at hits with these normals, seen along rays with
    /// these directions; black in the lanes whose bit in `lit` is not set.
    #[inline]
    #[must_use]
    pub fn shade(
        &self,
        direction: Vector3x4,
        normal: Vector3x4,
        light: &IlluminationPacket,
        lit: u32,
    ) -> ColorPacket {
        let slant = normal.dot(light.direction).max(Lanes::ZERO);
        let share = self.diffuse * light.color * slant;

        let cosine = (-direction).dot(light.direction.reflected_on(normal));
        let is_mirrored = slant.simd_gt(Lanes::ZERO) & cosine.simd_gt(Lanes::ZERO);
        let shining = is_mirrored.to_bitmask() & self.have_highlight & lit;
        if shining == 0 {
            return share.masked(mask(lit));
        }
        tally::count_all(Work::Power, shining.count_ones().into());
        let powers = powers(cosine.fast_min(Lanes::ONE), self.exponents, shining);
        let highlight = self.specular * light.color * powers;
        (share + highlight.masked(mask(shining))).masked(mask(lit))
    }
}

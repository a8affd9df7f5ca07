//! `Phong`: a matt surface with highlights, for four hits at once.
//!
//! (Phong, Illumination for Computer Generated Pictures, 1975.)

use common::Color;
use common::steps::{self, StepKind};
use fearless_simd::prelude::*;

use super::IlluminationPacket;
use super::power::powers;
use crate::lanes::{ColorPacket, Vector3x4, bits_of, greater, lesser, mask, splat};

/// A Phong material; one without highlights is Lambert's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// The reflectance of the diffuse term.
    pub diffuse: Color,
    /// The reflectance of the highlight.
    pub specular: Color,
    /// The exponent of the highlight, at least 0.
    pub exponent: f64,
}

impl Phong {
    fn has_highlight(&self) -> bool {
        self.specular != Color::BLACK
    }

    fn has_power(&self) -> bool {
        self.exponent != 0.0
    }

    /// Upper bound of its colour, per channel, with this ambient light and this sum of
    /// the light of all sources.
    pub(crate) fn max_radiance(&self, ambient: Color, lights: Color) -> Color {
        self.diffuse * (ambient + lights) + self.specular * lights
    }
}

/// The materials at four hits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PhongPacket<S: Simd> {
    diffuse: ColorPacket<S>,
    specular: ColorPacket<S>,
    exponents: [f64; 4],
    has_highlight: u32,
    /// A bit for each that is not Lambert's, which has no power to take.
    has_power: u32,
}

impl<S: Simd> PhongPacket<S> {
    /// The same material four times.
    #[inline(always)]
    pub fn splat(simd: S, material: &Phong) -> Self {
        let bits = |is: bool| if is { 0b1111 } else { 0 };
        Self {
            diffuse: ColorPacket::splat(simd, material.diffuse),
            specular: ColorPacket::splat(simd, material.specular),
            exponents: [material.exponent; 4],
            has_highlight: bits(material.has_highlight()),
            has_power: bits(material.has_power()),
        }
    }

    /// These four materials.
    #[inline(always)]
    pub fn new(simd: S, materials: [&Phong; 4]) -> Self {
        let bits = |is: fn(&Phong) -> bool| {
            let bits = [0, 1, 2, 3].map(|lane| u32::from(is(materials[lane])) << lane);
            bits.iter().sum()
        };
        Self {
            diffuse: ColorPacket::new(simd, materials.map(|phong| phong.diffuse)),
            specular: ColorPacket::new(simd, materials.map(|phong| phong.specular)),
            exponents: materials.map(|phong| phong.exponent),
            has_highlight: bits(Phong::has_highlight),
            has_power: bits(Phong::has_power),
        }
    }

    /// The reflected ambient light.
    #[inline(always)]
    pub fn ambient(&self, ambient: Color) -> ColorPacket<S> {
        self.diffuse * ColorPacket::splat(self.diffuse.r.simd, ambient)
    }

    /// A bit for each that reflects light of its colour. Where this product is 0, those of the diffuse term and of
    /// the highlight are, too.
    #[inline(always)]
    pub fn reflects(&self, light: ColorPacket<S>) -> u32 {
        !((self.diffuse + self.specular) * light).are_black()
    }

    /// The light of one source at hits with these normals, seen along rays with these
    /// directions; black in lanes that are not lit, and where the light is behind the surface. It takes
    /// the power of a highlight that is seen, or of every highlight.
    #[inline(always)]
    pub fn shade(
        &self,
        direction: Vector3x4<S>,
        normal: Vector3x4<S>,
        light: &IlluminationPacket<S>,
        takes_every_power: bool,
    ) -> ColorPacket<S> {
        let simd = direction.x.simd;
        let slant = greater(normal.dot(light.direction), splat(simd, 0.0));
        let diffuse = self.diffuse * light.color * slant;

        let cosine = (-direction).dot(light.direction.reflected_on(normal));
        let is_mirrored = bits_of(slant.simd_gt(0.0) & cosine.simd_gt(0.0));
        let shining = is_mirrored & self.has_highlight & light.lit;
        let computed = if takes_every_power {
            self.has_power & light.lit
        } else {
            shining
        };
        if computed == 0 {
            return diffuse.masked(mask(simd, light.lit));
        }
        steps::count(StepKind::Power, computed.count_ones().into());
        let powers = powers(
            lesser(cosine.abs(), splat(simd, 1.0)),
            self.exponents,
            computed,
        );
        let highlight = self.specular * light.color * powers;
        (diffuse + highlight.masked(mask(simd, shining))).masked(mask(simd, light.lit))
    }
}

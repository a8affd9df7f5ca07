//! `Transfer`: the curve that maps linear light to the 256 levels of a byte.

use crate::Color;

/// The curve between linear light and the values that a file holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Transfer {
    /// None: the value is written as it is, as in the course's pictures.
    #[default]
    Linear,
    /// A plain power with exponent 1/2.2.
    Gamma,
    /// The curve of sRGB (IEC 61966-2-1), which screens expect.
    Srgb,
}

impl Transfer {
    /// The three bytes to write for a colour of linear light.
    #[inline]
    #[must_use]
    pub fn bytes(self, color: Color) -> [u8; 3] {
        if self == Self::Linear {
            return color.to_bytes();
        }
        color.map(|channel| self.encode(channel)).to_bytes()
    }

    /// Writes the red, green and blue bytes of some colours into `rgb`, which has three
    /// bytes for each. All conversions from colours to bytes use this function.
    pub fn write_rgb8(self, colors: &[Color], rgb: &mut [u8]) {
        // A batch of colours, so that one instruction works on many channels.
        const BATCH: usize = 8;
        let (some, rest) = colors.as_chunks::<BATCH>();
        let (bytes, bytes_of_rest) = rgb.split_at_mut(3 * BATCH * some.len());
        for (bytes, colors) in bytes.chunks_exact_mut(3 * BATCH).zip(some) {
            bytes.copy_from_slice(colors.map(|color| self.bytes(color)).as_flattened());
        }
        for (bytes, color) in bytes_of_rest.chunks_exact_mut(3).zip(rest) {
            bytes.copy_from_slice(&self.bytes(*color));
        }
    }

    /// The red, green and blue bytes of these colours.
    pub fn rgb8(self, colors: &mut dyn Iterator<Item = Color>) -> Vec<u8> {
        let colors = colors.collect::<Vec<_>>();
        let mut rgb = vec![0; 3 * colors.len()];
        self.write_rgb8(&colors, &mut rgb);
        rgb
    }

    /// The packed 0xRRGGBB pixel to show for a colour of linear light.
    #[must_use]
    pub fn pack(self, color: Color) -> u32 {
        let [r, g, b] = self.bytes(color);
        u32::from_be_bytes([0, r, g, b])
    }

    /// The value to write for `linear` light; negative light counts as 0.
    #[must_use]
    pub fn encode(self, linear: f64) -> f64 {
        match self {
            Self::Linear => linear,
            Self::Gamma => libm::pow(linear.max(0.0), 1.0 / 2.2),
            Self::Srgb if linear <= 0.003_130_8 => 12.92 * linear,
            Self::Srgb => 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055,
        }
    }

    /// The linear light that [`Transfer::encode`] writes as this value, from 0 to 1.
    ///
    /// (IEC 61966-2-1 has the border at 0.04045.)
    #[must_use]
    pub fn decode(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Gamma => libm::pow(value, 2.2),
            Self::Srgb if value <= 0.040_45 => value / 12.92,
            Self::Srgb => libm::pow((value + 0.055) / 1.055, 2.4),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decoded_byte_is_written_as_the_same_byte() {
        for transfer in [Transfer::Linear, Transfer::Gamma, Transfer::Srgb] {
            for byte in 0..=255 {
                let bytes = [byte, 255 - byte, byte / 2];
                let light = Color::from_bytes(bytes).map(|value| transfer.decode(value));
                assert_eq!(transfer.bytes(light), bytes, "{transfer:?}");
            }
        }
        // The value of linear 1/2 in sRGB.
        let error = Transfer::Srgb.decode(0.735_356_983_052_449_5) - 0.5;
        assert!(error.abs() < 1e-12, "{error}");
    }

    /// Middle grey becomes 2^(-1/2.2), and the sRGB value of linear 1/2. In the standard
    /// the border between the two parts of sRGB belongs to the straight one.
    #[test]
    fn values_follow_the_standards() {
        for (transfer, middle) in [
            (Transfer::Linear, 0.5),
            (Transfer::Gamma, 0.729_740_052_840_723_1),
            (Transfer::Srgb, 0.735_356_983_052_449_5),
        ] {
            for (linear, expected) in [(0.0, 0.0), (0.5, middle), (1.0, 1.0)] {
                let error = transfer.encode(linear) - expected;
                assert!(error.abs() < 1e-12, "{transfer:?} {linear}: {error}");
            }
        }
        let [border, above] = [0.003_130_8, 0.003_130_800_1].map(|x| Transfer::Srgb.encode(x));
        assert_eq!(border, 12.92 * 0.003_130_8);
        assert!((above - border).abs() < 1e-6);
    }
}

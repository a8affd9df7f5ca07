//! `Appearance`: how the window looks.

use crate::options::whole;

/// The colours of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Theme {
    /// Light letters on dark
    Dark,
    /// Dark letters on light
    Light,
}

/// The flags for the look of the window.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub struct Appearance {
    /// Colours of the window [default: the system's]
    #[arg(long)]
    pub theme: Option<Theme>,

    /// Size of letters and bars in the window, in percent [default: the display's]
    #[arg(long, value_name = "PERCENT", allow_negative_numbers = true, value_parser = whole(50..=400_u16))]
    pub ui_scale: Option<u16>,
}

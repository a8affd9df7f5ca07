//! `Colors`: the colours of the window; and the theme of the system.

use std::process::Command;

use program::Theme;

/// Packed 0xRRGGBB colours.
#[derive(Clone, Copy, Default)]
pub struct Colors {
    pub background: u32,
    pub bar: u32,
    pub raised: u32,
    pub text: u32,
    pub muted: u32,
    pub accent: u32,
    pub error: u32,
}

/// Rays over a picture of any colours.
pub const RAY: u32 = 0xFF_C83C;

impl Colors {
    pub const fn of(theme: Theme) -> Self {
        match theme {
            Theme::Dark => Self {
                background: 0x16_181B,
                bar: 0x20_2327,
                raised: 0x3A_3F46,
                text: 0xE4_E6E8,
                muted: 0x9A_A0A8,
                accent: 0x5B_A4F0,
                error: 0xFF_7B72,
            },
            Theme::Light => Self {
                background: 0xE4_E6E9,
                bar: 0xF7_F8F9,
                raised: 0xD5_DAE0,
                text: 0x1D_2126,
                muted: 0x5C_646E,
                accent: 0x1B_6AC9,
                error: 0xC0_1C28,
            },
        }
    }
}

/// The output of a program; none if it is missing.
fn output(program: &str, arguments: &str) -> Option<String> {
    let output = Command::new(program).args(arguments.split(' ')).output();
    Some(String::from_utf8_lossy(&output.ok()?.stdout).into_owned())
}

/// The theme that GNOME and its relatives or KDE are set to; dark elsewhere. `winit` knows that of
/// Windows and macOS.
pub fn theme() -> Theme {
    let styles = [
        ("gsettings", "get org.gnome.desktop.interface color-scheme"),
        ("kreadconfig6", "--group General --key ColorScheme"),
    ];
    let style = styles
        .into_iter()
        .find_map(|(program, arguments)| output(program, arguments));
    match style {
        Some(style) if !style.to_lowercase().contains("dark") => Theme::Light,
        _ => Theme::Dark,
    }
}

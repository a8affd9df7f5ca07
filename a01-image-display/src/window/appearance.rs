//! `Colors`: the colours of the window; and the theme and the scale of the system.

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
            },
            Theme::Light => Self {
                background: 0xE4_E6E9,
                bar: 0xF7_F8F9,
                raised: 0xD5_DAE0,
                text: 0x1D_2126,
                muted: 0x5C_646E,
                accent: 0x1B_6AC9,
            },
        }
    }
}

/// The output of a program; none if it is missing.
fn output(program: &str, arguments: &str) -> Option<String> {
    let output = Command::new(program).args(arguments.split(' ')).output();
    Some(String::from_utf8_lossy(&output.ok()?.stdout).into_owned())
}

/// The theme that GNOME and its relatives, KDE or macOS are set to; dark elsewhere.
pub fn theme() -> Theme {
    let styles = [
        ("gsettings", "get org.gnome.desktop.interface color-scheme"),
        ("kreadconfig6", "--group General --key ColorScheme"),
        ("defaults", "read -g AppleInterfaceStyle"),
    ];
    let style = styles
        .into_iter()
        .find_map(|(program, arguments)| output(program, arguments));
    match style {
        Some(style) if !style.to_lowercase().contains("dark") => Theme::Light,
        _ => Theme::Dark,
    }
}

/// The scale of the display by its dots per inch, which X11 has among its resources. Other
/// systems scale the window themselves.
pub fn scale() -> f64 {
    let resources = output("xrdb", "-query").unwrap_or_default();
    let dots = resources
        .lines()
        .find_map(|line| line.strip_prefix("Xft.dpi:"));
    let dots = dots.and_then(|dots| dots.trim().parse().ok());
    dots.map_or(1.0, |dots: f64| (dots / 96.0).clamp(0.5, 4.0))
}

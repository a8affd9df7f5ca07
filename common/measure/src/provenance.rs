//! Where the figures of a report come from: machine and version.

use std::env::consts::{ARCH, OS};
use std::thread::available_parallelism;

/// The lines of the head of a report, each a name with its value.
pub fn lines() -> [(&'static str, String); 2] {
    let cores = available_parallelism().map_or(1, usize::from);
    let profile = if cfg!(debug_assertions) {
        "dev"
    } else {
        "release"
    };
    let (processor, version) = (processor(), env!("CARGO_PKG_VERSION"));
    [
        ("machine", format!("{processor}, {cores} threads, {OS}")),
        ("version", format!("{version}, profile {profile}")),
    ]
}

/// The model of the processor where the system names it, and otherwise its architecture.
fn processor() -> String {
    let of_linux = || {
        let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
        let mut lines = text.lines().filter_map(|line| line.split_once(':'));
        let (_, model) = lines.find(|(name, _)| name.trim() == "model name")?;
        Some(model.trim().to_owned())
    };
    let of_windows = || std::env::var("PROCESSOR_IDENTIFIER").ok();
    let model = of_linux().or_else(of_windows);
    model.map_or(ARCH.to_owned(), |model| format!("{model} ({ARCH})"))
}

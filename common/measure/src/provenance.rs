//! `Provenance`: where the figures of a report come from.

use std::env::consts::{ARCH, OS};
use std::thread::available_parallelism;

/// The machine and the build that figures were measured on, in words.
pub struct Provenance {
    /// Processor, number of threads and system.
    pub machine: String,
    /// Version and profile of this program.
    pub version: String,
}

impl Provenance {
    /// This program on this machine.
    pub fn here() -> Self {
        let cores = available_parallelism().map_or(1, usize::from);
        let profile = if cfg!(debug_assertions) {
            "dev"
        } else {
            "release"
        };
        let version = env!("CARGO_PKG_VERSION");
        Self {
            machine: format!("{}, {cores} threads, {OS}", processor()),
            version: format!("{version}, profile {profile}"),
        }
    }
}

/// The model of the processor where the system names it, and otherwise its architecture.
fn processor() -> String {
    match model_on_linux().or_else(model_on_windows) {
        Some(model) => format!("{model} ({ARCH})"),
        None => ARCH.to_owned(),
    }
}

fn model_on_linux() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    for line in text.lines() {
        if let Some((name, value)) = line.split_once(':')
            && name.trim() == "model name"
        {
            return Some(value.trim().to_owned());
        }
    }
    None
}

fn model_on_windows() -> Option<String> {
    std::env::var("PROCESSOR_IDENTIFIER").ok()
}

//! Where the figures of a report come from: the machine and the build.

use std::env::consts::{ARCH, OS};
use std::thread::available_parallelism;

/// This machine and this program in words, each with its name.
pub fn here() -> Vec<(&'static str, String)> {
    let cores = available_parallelism().map_or(1, usize::from);
    let (processor, profile) = (processor(), profile());
    let version = env!("CARGO_PKG_VERSION");
    vec![
        ("machine", format!("{processor}, {cores} threads, {OS}")),
        ("version", format!("{version}, profile {profile}")),
    ]
}

/// The profile of Cargo, after which it names the folder of a program.
fn profile() -> String {
    let program = std::env::current_exe().unwrap_or_default();
    let mut folders = program.components().rev().skip(1);
    let folder = folders.find(|folder| folder.as_os_str() != "deps");
    match folder.map(|folder| folder.as_os_str().to_string_lossy()) {
        Some(name) if name == "debug" => "dev".to_owned(),
        Some(name) => name.into_owned(),
        None => "unknown".to_owned(),
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

//! Passes on the compiler and its settings, for the heads of reports.

use std::env::var;
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let of = |name| var(name).unwrap_or_default();
    let version = Command::new(of("RUSTC")).arg("--version").output();
    let version = version.map_or_else(
        |_| "rustc".to_owned(),
        |output| String::from_utf8_lossy(&output.stdout).trim().to_owned(),
    );
    let (target, level) = (of("TARGET"), of("OPT_LEVEL"));
    // The flags are separated by a character that is not printed.
    let flags = of("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ");
    println!("cargo:rustc-env=COMPILER={version}, {target}, opt-level={level} {flags}");
}

//! Says for which instructions the engine is compiled. The code of each level is compiled once more, so a build for
//! development, which is made most often, has one level alone: its profile inherits from `dev`, with whatever
//! assertions and optimisation.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(one_level)");
    let is = |name, value| env::var(name).is_ok_and(|found| found == value);
    if is("PROFILE", "debug") || !is("CARGO_CFG_TARGET_ARCH", "x86_64") {
        println!("cargo::rustc-cfg=one_level");
    }
}

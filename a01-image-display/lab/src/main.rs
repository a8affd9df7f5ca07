//! Reports error against run time of stage 1, and its extreme cases.

fn main() -> std::process::ExitCode {
    measure::run(&a01_lab::laboratory())
}

//! Reports error against run time of stage 7, and its extreme cases.

fn main() -> std::process::ExitCode {
    measure::run(&a07_lab::laboratory())
}

//! Reports error against run time of stage 2, and its extreme cases.

fn main() -> std::process::ExitCode {
    measure::run(&a02_lab::laboratory())
}

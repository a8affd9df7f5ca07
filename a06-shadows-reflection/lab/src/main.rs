//! Reports error against run time of stage 6, and its extreme cases.

fn main() -> std::process::ExitCode {
    measure::run(&a06_lab::laboratory())
}

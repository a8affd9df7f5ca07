//! Reports error against run time of stage 4, and its extreme cases.

fn main() -> std::process::ExitCode {
    measure::run(&a04_lab::laboratory())
}

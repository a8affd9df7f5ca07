//! Reports error against run time of stage 3, and its extreme cases.

fn main() -> std::process::ExitCode {
    measure::run(&a03_lab::laboratory())
}

//! Reports error against run time of stage 5, and its extreme cases.

fn main() -> std::process::ExitCode {
    measure::run(&a05_lab::laboratory())
}

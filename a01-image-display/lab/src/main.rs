//! Reports the error of saved pictures against bytes and run time. Stage 1 has no extreme cases.

fn main() -> std::process::ExitCode {
    measure::run(&a01_lab::laboratory())
}

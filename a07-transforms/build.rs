//! Lists the exercises of this stage for `tests/exercises/main.rs`.

fn main() -> std::io::Result<()> {
    exercise_list::write()
}

//! The memory and time of an open window, and the processes and files left after it.

use std::io::Write;
use std::time::{Duration, Instant};

use testing::display::{Display, Picture, RunningProgram, wait_for};

use super::{folder, program, wait_for_notice, wait_for_picture};

/// Prints a figure; the macros' output is shown for failing tests only.
fn say(figure: &str) {
    let _ = writeln!(std::io::stderr(), "{figure}");
}

/// Waits for the end of all threads but the window's.
fn wait_for_one_thread(window: &RunningProgram) {
    wait_for("the end of the other threads", || {
        (window.threads() == 1).then_some(())
    });
}

/// Moves the mouse over the picture; each place is waited for, so that each is
/// drawn.
fn draw(window: &RunningProgram, times: u32) {
    for time in 0..times {
        let (x, y) = (time % 97, time % 89);
        window.point_at(x, y + Picture::LINE);
        let start = format!("column {x}, row {y}: ");
        window.wait_to_show(&start, |look| {
            let notices = look.notices();
            notices.first().is_some_and(|line| line.starts_with(&start))
        });
    }
}

/// Draws this many times and checks that each costs less than 256 bytes of memory,
/// apart from rounding by the allocator.
fn check_memory(times: u32) {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.press("i");
    draw(&window, 50);
    let before = window.memory();
    draw(&window, times);
    let after = window.memory();
    say(&format!(
        "{times} drawings: {before} KiB before, {after} KiB after"
    ));
    let bound = before + u64::from(times) / 4 + 128;
    assert!(after <= bound, "{before} KiB have become {after}");
}

#[test]
fn drawing_takes_no_more_memory_each_time() {
    check_memory(300);
}

#[test]
#[ignore = "takes minutes"]
fn drawing_ten_thousand_times_takes_no_more_memory() {
    check_memory(10_000);
}

#[test]
fn going_from_scene_to_scene_takes_no_more_memory_each_time() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let mut program = program(folder.path(), "show diagonal");
    // By default the system's allocator keeps a varying share of freed memory.
    program.env("MALLOC_MMAP_THRESHOLD_", "131072");
    let window = display.start(&mut program);
    let go_round = |times| {
        for _ in 0..times {
            for scene in ["painter", "show-image", "diagonal"] {
                window.press("Right");
                wait_for_picture(&window, scene);
            }
        }
    };
    let memory_at_rest = || {
        wait_for_one_thread(&window);
        window.memory()
    };
    go_round(5);
    let before = memory_at_rest();
    go_round(10);
    let after = memory_at_rest();
    say(&format!(
        "30 scenes: {before} KiB before, {after} KiB after"
    ));
    // One picture of 640x480 packed pixels takes 1200 KiB, and 30 were made.
    assert!(after < before + 1200, "{before} KiB have become {after}");
}

#[test]
fn a_finished_window_has_one_thread_and_hardly_computes() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    wait_for_one_thread(&window);
    let (start, before) = (Instant::now(), window.time());
    std::thread::sleep(Duration::from_secs(3));
    let share = window.time().saturating_sub(before).as_secs_f64() / start.elapsed().as_secs_f64();
    let percent = 100.0 * share;
    let _ = writeln!(
        std::io::stderr(),
        "an idle window: {percent:.1} % of a core"
    );
    assert!(percent < 10.0, "{percent:.1} % of a core");
}

#[test]
fn a_closed_window_leaves_nothing_behind() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.press("s");
    wait_for_notice(&window, "saved out/a01-image-display-painter.png");
    window.press("Escape");
    assert_eq!(window.wait_for_end(), (Some(0), String::new()));
    assert_eq!(display.temporary_files(), [""; 0]);
    let names = |path: &std::path::Path| -> Vec<_> {
        let entries = path.read_dir().unwrap();
        entries.map(|entry| entry.unwrap().file_name()).collect()
    };
    assert_eq!(names(folder.path()), ["out"]);
    assert_eq!(
        names(&folder.path().join("out")),
        ["a01-image-display-painter.png"]
    );
}

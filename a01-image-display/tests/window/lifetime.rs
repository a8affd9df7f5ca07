//! The memory and time of an open window.

use std::fs;
use std::time::{Duration, Instant};

use testing::display::{Display, wait_for};

use super::{wait_for_picture, with_window};

/// A number in a file about the program's process, behind this name.
fn number(window: &Display, file: &str, name: &str) -> u64 {
    let path = format!("/proc/{}/{file}", window.process());
    let text = fs::read_to_string(path).expect("a process");
    let mut lines = text.lines();
    let rest = lines.find_map(|line| line.strip_prefix(name)).expect(name);
    let number = rest.split_whitespace().next().expect("a number");
    number.parse().expect("a number")
}

/// Waits for the end of all threads but the window's.
fn wait_for_one_thread(window: &Display) {
    wait_for("the end of other threads", || {
        (number(window, "status", "Threads:") == 1).then_some(())
    });
}

#[test]
fn going_from_scene_to_scene_takes_no_more_memory_each_time() {
    with_window("show diagonal", |window, _| {
        let memory_after_rounds = |rounds| {
            for _ in 0..rounds {
                for scene in ["painter", "show-image", "diagonal"] {
                    window.press("Right");
                    wait_for_picture(&window, scene);
                }
            }
            wait_for_one_thread(&window);
            number(&window, "status", "VmRSS:")
        };
        let (before, after) = (memory_after_rounds(5), memory_after_rounds(10));
        // A picture of 640x480 packed pixels takes 1200 KiB, and 30 were made. The
        // allocator keeps a varying share of freed memory: less than half of that.
        let bound = before + 15 * 1200;
        assert!(after < bound, "{before} KiB have become {after}");
    });
}

#[test]
fn a_finished_window_has_one_thread_and_hardly_computes() {
    with_window("show painter", |window, _| {
        wait_for_picture(&window, "painter");
        wait_for_one_thread(&window);
        // Nanoseconds that the first thread had a processor.
        let time = || Duration::from_nanos(number(&window, "schedstat", ""));
        let (start, before) = (Instant::now(), time());
        std::thread::sleep(Duration::from_secs(3));
        let (time, elapsed) = (time() - before, start.elapsed());
        assert!(time < elapsed / 10, "{time:?} in {elapsed:?}");
    });
}

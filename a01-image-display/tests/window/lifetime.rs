//! The time of an open window.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::display::wait_for;

use super::{wait_for_picture, with_window};

#[test]
fn a_finished_window_has_one_thread_and_hardly_computes() {
    with_window("show painter", |window, _| {
        wait_for_picture(&window, "painter");
        let process = Path::new("/proc").join(window.process().to_string());
        wait_for("the end of other threads", || {
            let threads = process.join("task").read_dir().ok()?;
            (threads.count() == 1).then_some(())
        });
        // Nanoseconds that the thread had a processor.
        let time = || {
            let statistics = fs::read_to_string(process.join("schedstat")).unwrap();
            let nanoseconds = statistics.split(' ').next().unwrap().parse();
            Duration::from_nanos(nanoseconds.unwrap())
        };
        let (start, before) = (Instant::now(), time());
        std::thread::sleep(Duration::from_secs(3));
        let (time, elapsed) = (time().abs_diff(before), start.elapsed());
        assert!(time < elapsed / 10, "{time:?} in {elapsed:?}");
    });
}

//! A program that is killed while it saves.

use std::fs::{self, File};
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

use common::picture_file;

use crate::{assert_success, folder, in_shell, names, program, write_noise};

/// The number of killed programs; the environment variable `SAVING_KILLS` replaces it.
const KILLS: usize = 30;

#[test]
fn killed_at_any_time_it_leaves_the_old_or_the_new_picture() {
    let kills = std::env::var("SAVING_KILLS");
    let kills = kills.map_or(KILLS, |kills| kills.parse().expect("a number"));
    let folder = folder();
    let saved = folder.path().join("saved.png");
    let start = |name: &str| {
        let line = format!("render show-image --open {name} -o saved.png");
        let mut program = program(folder.path(), &line);
        program.stdout(Stdio::null()).stderr(Stdio::null());
        program.spawn().expect("the program runs")
    };
    let pictures = ["a.png", "b.png"];
    let (mut whole, mut total, mut writing) = (Vec::new(), Duration::ZERO, Duration::ZERO);
    for (seed, name) in (0..).zip(pictures) {
        let noise = write_noise(&folder.path().join(name), 1000, seed);
        let (mut child, begun) = (start(name), Instant::now());
        let seen = wait_for_writing(folder.path(), &mut child);
        assert!(child.wait().unwrap().success());
        total = begun.elapsed();
        writing = seen.elapsed();
        assert!(picture_file::open(&saved).unwrap() == noise);
        whole.push(fs::read(&saved).unwrap());
    }

    let mut there = 1;
    let (mut unfinished, mut renamed, mut ended) = (0, 0, 0);
    for kill in 0..kills {
        // Multiples of the golden ratio are spread evenly over all moments.
        let moment = (kill as f64 * 0.618_033_988_749_895).fract();
        let mut child = start(pictures[1 - there]);
        if kill % 2 == 0 {
            sleep(total.mul_f64(moment));
        } else {
            wait_for_writing(folder.path(), &mut child);
            sleep(writing.mul_f64(moment));
        }
        child.kill().unwrap();
        ended += usize::from(child.wait().unwrap().success());

        let left = left_behind(folder.path());
        assert!(left.len() <= 1, "{left:?}");
        unfinished += left.iter().filter(|file| length(file) > 0).count();
        for file in left {
            fs::remove_file(file).unwrap();
        }
        let found = fs::read(&saved).unwrap();
        if found != whole[there] {
            there = 1 - there;
            renamed += 1;
            assert!(found == whole[there], "neither old nor new: kill {kill}");
        }
    }
    println!(
        "a run takes {total:?}, writing {writing:?}; of {kills} kills {unfinished} left an \
         unfinished file, {renamed} a new picture, {ended} came too late"
    );
    assert!(unfinished > 0, "no kill was in time");
}

/// A limit for the length of files kills it when exactly that many bytes are written.
#[test]
fn a_later_program_deletes_the_file_of_a_killed_one() {
    let folder = folder();
    let path = |name| folder.path().join(name);
    write_noise(&path("noise.png"), 300, 1);
    fs::write(path("saved.png"), "old").unwrap();
    let line = "render show-image --open noise.png -o saved.png";
    let script = "ulimit -c 0; ulimit -f 64; exec \"$@\"";
    let killed = in_shell(script, &program(folder.path(), line)).output();
    let status = killed.unwrap().status;
    assert!(status.signal().is_some(), "{status}");
    assert!(fs::read(path("saved.png")).unwrap() == b"old");

    let [left] = &left_behind(folder.path())[..] else {
        panic!("one file should be left: {:?}", names(folder.path()));
    };
    let two_hours_ago = SystemTime::now() - Duration::from_hours(2);
    let file = File::options().write(true).open(left).unwrap();
    file.set_modified(two_hours_ago).unwrap();
    assert_success(&mut program(folder.path(), line));
    assert_eq!(names(folder.path()), ["noise.png", "saved.png"]);
}

/// Waits until the program writes the new file, or has ended.
fn wait_for_writing(folder: &Path, child: &mut Child) -> Instant {
    let is_written = || left_behind(folder).iter().any(|file| length(file) > 0);
    while !is_written() && child.try_wait().unwrap().is_none() {
        sleep(Duration::from_micros(100));
    }
    Instant::now()
}

/// The temporary files.
fn left_behind(folder: &Path) -> Vec<PathBuf> {
    let names = names(folder).into_iter();
    let unnamed = names.filter(|name| name.starts_with(".saving-"));
    unnamed.map(|name| folder.join(name)).collect()
}

/// The length of a file; 0 if it has just been renamed.
fn length(file: &Path) -> u64 {
    fs::metadata(file).map_or(0, |found| found.len())
}

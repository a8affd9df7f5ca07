//! `watch`: shows an exercise, and checks the file whenever it is saved.

use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;
use std::{fs, io, thread};

use crate::exercise::Exercise;
use crate::judgement::judge;
use crate::{files, progress};

/// Time between two looks at the file.
const PAUSE: Duration = Duration::from_millis(100);

const KEYS: &str = "save the file to check it; or h and Enter: hint, n: next, l: list, q: quit";

/// Shows one exercise after the other until the student quits or all are done.
pub fn watch(course: &[Exercise], first: &Exercise) -> Result<(), String> {
    let (sender, typed) = channel();
    thread::spawn(move || {
        let mut lines = io::stdin().lines().map_while(Result::ok);
        lines.try_for_each(|line| sender.send(line))
    });
    let mut exercise = first;
    while work_on(course, exercise, &typed)? {
        let Some(next) = progress::next(course, Some(exercise)) else {
            println!("\n{}\n\nall exercises are done", progress::bars(course));
            break;
        };
        exercise = next;
    }
    Ok(())
}

/// Shows an exercise, and checks the file whenever it is saved. Returns whether the student
/// goes on to the next exercise.
fn work_on(course: &[Exercise], e: &Exercise, typed: &Receiver<String>) -> Result<bool, String> {
    files::begin(e)?;
    let file = files::yours(e);
    println!("\n{}\n", progress::bars(course));
    let (title, minutes, place, task) = (e.title, e.minutes, file.display(), &e.task);
    println!("{title}, {minutes} minutes, in {place}\n\n{task}\n");
    let mut hints = e.hints.iter().cycle();
    let mut checked = None;
    loop {
        // None while an editor replaces the file.
        let saved = fs::metadata(&file).and_then(|file| file.modified()).ok();
        if saved != checked && saved.is_some() {
            let is_done = judge(e, checked.is_none())?;
            checked = saved;
            if is_done {
                println!("solution: {}\nEnter: the next exercise", e.solution);
            } else {
                println!("{KEYS}");
            }
        }
        match typed.recv_timeout(PAUSE).as_deref().map(str::trim) {
            Ok("h") => println!("{}", hints.next().map_or("", |hint| hint)),
            Ok("l") => progress::list(course),
            Ok("n") => return Ok(true),
            Ok("") if progress::is_done(e) => return Ok(true),
            Ok("q") | Err(RecvTimeoutError::Disconnected) => return Ok(false),
            Ok(_) => println!("{KEYS}"),
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

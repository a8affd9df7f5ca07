//! `watch`: shows an exercise, and checks the file whenever it is saved.

use std::fs;
use std::io;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, SystemTime};

use crate::exercise::{Course, Exercise};
use crate::files;
use crate::judgement::{Verdict, judge};
use crate::progress;

/// Time between two looks at the file.
const PAUSE: Duration = Duration::from_millis(100);

const KEYS: &str = "save the file to check it; or h and Enter: hint, n: next, l: list, q: quit";

/// Shows one exercise after the other until the student quits.
pub fn watch(course: &Course, first: Exercise) -> Result<(), String> {
    let typed = typed();
    let mut exercise = first;
    loop {
        files::begin(exercise)?;
        let (title, minutes, task) = (exercise.title, exercise.minutes, exercise.task);
        println!("\n{}\n", progress::bars(course));
        println!(
            "{title}, {minutes} minutes, in {}\n\n{task}\n",
            files::shown(exercise)
        );
        if !work_on(course, exercise, &typed)? {
            return Ok(());
        }
        exercise = following(course, exercise)?;
    }
}

/// The next open exercise after this one, or the first open one.
fn following(course: &Course, exercise: Exercise) -> Result<Exercise, String> {
    let mut later = course
        .exercises
        .iter()
        .copied()
        .skip_while(|e| *e != exercise)
        .skip(1);
    let open = later.find(|e| e.is_core == exercise.is_core && !progress::is_done(*e));
    open.map_or_else(|| progress::next(course), Ok)
}

/// Checks the file whenever it is saved. Returns whether the student goes on to the next
/// exercise.
fn work_on(course: &Course, exercise: Exercise, typed: &Receiver<String>) -> Result<bool, String> {
    let mut hints = exercise.hints.iter().cycle();
    let mut checked = None;
    loop {
        let saved = saved(exercise);
        if saved != checked && saved.is_some() {
            let verdict = judge(exercise, checked.is_none())?;
            checked = saved;
            if verdict == Verdict::Done {
                println!("solution: {}\nEnter: the next exercise", exercise.solution);
            } else {
                println!("{KEYS}");
            }
        }
        match typed.recv_timeout(PAUSE).as_deref().map(str::trim) {
            Ok("h") => println!("{}", hints.next().map_or("", |hint| hint)),
            Ok("l") => progress::list(course),
            Ok("n") => return Ok(true),
            Ok("") if progress::is_done(exercise) => return Ok(true),
            Ok("q") | Err(RecvTimeoutError::Disconnected) => return Ok(false),
            Ok(_) => println!("{KEYS}"),
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

/// Time at which the file was saved last; none while an editor replaces it.
fn saved(exercise: Exercise) -> Option<SystemTime> {
    fs::metadata(files::yours(exercise))
        .and_then(|file| file.modified())
        .ok()
}

/// The lines that the student types.
fn typed() -> Receiver<String> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        for line in io::stdin().lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                return;
            }
        }
    });
    receiver
}

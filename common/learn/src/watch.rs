//! `watch`: shows an exercise, and checks the file whenever it is saved.

use std::sync::mpsc::RecvTimeoutError::{Disconnected, Timeout};
use std::time::Duration;

use console::Term;

use crate::exercise::Exercise;
use crate::judgement::judge;
use crate::{files, keys, progress};

/// Time between two looks at the file.
const PAUSE: Duration = Duration::from_millis(100);

const KEYS: &str = "save the file to check it; keys: h hint, n next, l list, q quit";

/// Shows one exercise after the other until the student quits or all are done.
pub fn watch(course: &[Exercise], first: &Exercise) -> Result<(), String> {
    let mut exercise = first;
    while work_on(course, exercise)? {
        let Some(next) = progress::next(course, Some(exercise)) else {
            println!("\n{}\n\nall exercises are done", progress::bars(course));
            break;
        };
        exercise = next;
    }
    Ok(())
}

/// Checks the file of an exercise whenever it is saved. Returns whether the student goes on to
/// the next exercise.
fn work_on(course: &[Exercise], e: &Exercise) -> Result<bool, String> {
    files::begin(e)?;
    let file = files::yours(e);
    let (mut checked, mut hints, mut typed) = (None, e.hints.iter().cycle(), keys::ask());
    loop {
        let (saved, mut key) = (files::saved(e), None);
        if saved.is_none() && checked.is_some() {
            println!("{} is deleted; Enter begins it anew", file.display());
        } else if saved != checked {
            let terminal = Term::stdout();
            if terminal.is_term() {
                // If it fails, old text remains.
                let _ = terminal.clear_screen();
            }
            let (title, minutes, place) = (e.title, e.minutes, file.display());
            println!(
                "{}\n\n{title}, {minutes} minutes, in {place}",
                progress::bars(course)
            );
            println!("\n{}\n", e.task);
            // A key or the next save stops a program that does not end.
            let judged = judge(e, checked.is_none(), &mut || {
                key = typed.try_recv().ok();
                key.is_some() || files::saved(e) != saved
            });
            // While a key is waited for, no error may end the program.
            let is_done = judged.unwrap_or_else(|problem| {
                println!("{problem}");
                false
            });
            if is_done {
                let solution = files::shortest(e.solution);
                println!("solution: {}\nEnter: the next exercise", solution.display());
            } else {
                println!("{KEYS}");
            }
        }
        checked = saved;
        match key.map_or_else(|| typed.recv_timeout(PAUSE), Ok) {
            Ok('q') | Err(Disconnected) => return Ok(false),
            Err(Timeout) => continue,
            Ok('n') => return Ok(true),
            Ok('\n') if progress::is_done(e) => return Ok(true),
            Ok('\n') => {
                files::begin(e)?;
                checked = None;
            }
            Ok('h') => println!("{}", hints.next().map_or("", |hint| hint)),
            Ok('l') => println!("{}", progress::list(course)),
            Ok(_) => println!("{KEYS}"),
        }
        typed = keys::ask();
    }
}

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
const NEXT: &str = "Enter: the next exercise";

/// Shows one exercise after the other until the student quits or all are done. Returns how many
/// are done.
pub fn watch(course: &[Exercise], first: &Exercise) -> Result<String, String> {
    let mut next = Some(first);
    while let Some(exercise) = next
        && work_on(course, exercise)?
    {
        next = progress::next(course, Some(exercise));
    }
    let end = next.map_or("\n\nall exercises are done", |_| "");
    Ok(progress::bars(course) + end)
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
            println!("{}\n", progress::bars(course));
            println!("{title}, {minutes} minutes, in {place}\n\n{}\n", e.task);
            // A key or the next save stops a program that does not end.
            let judged = judge(e, checked.is_none(), &mut || {
                key = typed.try_recv().ok();
                let stops = key.is_some() || files::saved(e) != saved;
                stops.then(|| "stopped".to_owned())
            });
            let solution = files::shortest(e.solution);
            match judged {
                Ok(done) if solution.is_file() => {
                    println!("{done}\nsolution: {}\n{NEXT}", solution.display());
                }
                Ok(done) => println!("{done}\n{NEXT}"),
                // While a key is waited for, no error may end the program.
                Err(problem) => println!("{problem}\n{KEYS}"),
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

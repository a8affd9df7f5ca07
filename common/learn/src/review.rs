//! `Review`: asks questions about the chapters, and old ones again on later days.
//!
//! The reader answers aloud or on paper, compares, and says whether the answer was known: to recall
//! it is what helps to keep it. See [`crate::schedule`] for the days.

use std::env;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use common::text;
use console::Key;

use crate::exercise::Exercise;
use crate::kept::Kept;
use crate::keys::{Keys, Typed};
use crate::progress::Progress;
use crate::question::{self, Question};
use crate::schedule::{self, Asked};
use crate::screen::Screen;

/// Seconds of a day. A day begins at midnight of UTC.
const DAY: u64 = 24 * 60 * 60;

const ASKS_FOR_ANSWER: &str = "Enter: the answer  q: quit";
const ASKS_FOR_GRADE: &str = "did you know it? y: yes  n: no  q: quit";
const NO_CHAPTER: &str = "no chapter is finished yet: its questions come when you have done the exercises of its core \
    path. `cargo learn review a01` asks those of a chapter that you have read";

/// Asks questions about the chapters, and some of the old ones again on later days
#[derive(clap::Args)]
pub struct Review {
    /// A chapter whose questions are asked now, such as a04 [default: what is due today]
    #[arg(value_name = "CHAPTER")]
    chapter: Option<String>,
}

/// How a question ended.
enum Grade {
    Known,
    NotKnown,
    Quit,
}

impl Review {
    /// Asks, and returns what came of it.
    pub fn run(&self, course: &[Exercise]) -> Result<String, String> {
        let questions = question::read_all(course)?;
        let kept = Kept::read()?;
        if let Some(warning) = kept.warning() {
            eprintln!("{}", text::message(&warning));
        }
        let today = today();
        let asked_now = match &self.chapter {
            Some(chapter) => of_chapter(&questions, chapter)?,
            None => for_today(&questions, course, &kept, today),
        };
        if asked_now.is_empty() {
            return Ok(Screen::new().wrap(&nothing_to_ask(&questions, &kept, today)));
        }
        let mut session = Session {
            screen: Screen::new(),
            keys: Keys::default(),
            today,
        };
        session.ask_all(&asked_now)
    }
}

/// The number of the questions for today, in words; none if there is no such question.
pub fn reminder(course: &[Exercise]) -> Option<String> {
    let questions = question::read_all(course).ok()?;
    let count = for_today(&questions, course, &Kept::read().ok()?, today()).len();
    match count {
        0 => None,
        1 => Some("one question for today: cargo learn review".to_owned()),
        _ => Some(format!("{count} questions for today: cargo learn review")),
    }
}

/// Words behind the last exercise of a chapter's core path, until the questions of the chapter
/// have been asked.
pub fn invitation(course: &[Exercise], exercise: &Exercise, progress: &Progress) -> Option<String> {
    let stage = exercise.stage;
    let mut core = course.iter().filter(|e| e.stage == stage && e.is_core);
    if !exercise.is_core || !core.all(|e| progress.is_done(e)) {
        return None;
    }
    let kept = Kept::read().ok()?;
    let questions = question::read_all(course).ok()?;
    let mut of_chapter = questions.iter().filter(|q| q.stage == stage);
    of_chapter.find(|q| !kept.asked.contains_key(q.id))?;
    let chapter = stage.get(..3)?;
    Some(format!(
        "the core path of this chapter is done; its questions: cargo learn review {chapter}"
    ))
}

/// Days since 1 January 1970, or as many as tests say.
fn today() -> u32 {
    if let Some(day) = env::var("LEARN_DAY").ok().and_then(|day| day.parse().ok()) {
        return day;
    }
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    let days = since.map_or(0, |since| since.as_secs() / DAY);
    u32::try_from(days).unwrap_or(u32::MAX)
}

/// The questions of a chapter; the error names the chapters.
fn of_chapter<'a>(questions: &'a [Question], chapter: &str) -> Result<Vec<&'a Question>, String> {
    let of_chapter: Vec<_> = questions
        .iter()
        .filter(|q| !chapter.is_empty() && q.stage.starts_with(chapter))
        .collect();
    if of_chapter.is_empty() {
        let mut stages: Vec<_> = questions.iter().map(|q| q.stage).collect();
        stages.dedup();
        let chapter = text::name(chapter);
        return Err(format!(
            "no chapter with questions is called {chapter}; they are {}",
            stages.join(", ")
        ));
    }
    Ok(of_chapter)
}

/// The questions that are due, and new ones of the chapters that are finished.
fn for_today<'a>(
    questions: &'a [Question],
    course: &[Exercise],
    kept: &Kept,
    today: u32,
) -> Vec<&'a Question> {
    let finished = finished_stages(course);
    let all: Vec<_> = questions.iter().map(|q| q.id).collect();
    let new = questions.iter().filter(|q| finished.contains(&q.stage));
    let new: Vec<_> = new.map(|q| q.id).collect();
    let ids = schedule::for_today(&all, &new, &kept.asked, today);
    let with_id = |id| questions.iter().find(|q| q.id == id);
    ids.into_iter().filter_map(with_id).collect()
}

/// The stages whose core path is done, and those below one of which an exercise is done.
fn finished_stages(course: &[Exercise]) -> Vec<&'static str> {
    let progress = Progress::read();
    let mut finished = Vec::new();
    let mut reached = Vec::new();
    for of_stage in course.chunk_by(|a, b| a.stage == b.stage) {
        let mut core = of_stage.iter().filter(|e| e.is_core);
        if of_stage.iter().any(|e| progress.is_done(e)) {
            finished.append(&mut reached);
        }
        if core.all(|e| progress.is_done(e)) {
            finished.push(of_stage[0].stage);
        } else {
            reached.push(of_stage[0].stage);
        }
    }
    finished
}

/// Why there is nothing to ask, and when there will be.
fn nothing_to_ask(questions: &[Question], kept: &Kept, today: u32) -> String {
    let asked = questions.iter().filter_map(|q| kept.asked.get(q.id));
    match asked.map(|asked| asked.days_left(today).max(1)).min() {
        None => NO_CHAPTER.to_owned(),
        Some(days) => format!(
            "no question for today; the next one comes {}",
            in_days(days)
        ),
    }
}

fn in_days(days: u32) -> String {
    match days {
        1 => "tomorrow".to_owned(),
        _ => format!("in {days} days"),
    }
}

/// The terminal or pipe, and the day.
struct Session {
    screen: Screen,
    keys: Keys,
    today: u32,
}

impl Session {
    fn ask_all(&mut self, questions: &[&Question]) -> Result<String, String> {
        let (mut known, mut answered) = (0, 0);
        for (number, question) in questions.iter().enumerate() {
            self.say_paragraph(&format!(
                "{} of {}, from \"{}\"",
                number + 1,
                questions.len(),
                question.chapter
            ));
            let is_known = match self.ask(question) {
                Grade::Known => true,
                Grade::NotKnown => false,
                Grade::Quit => break,
            };
            let after = keep(question, is_known, self.today)
                .map_err(|problem| format!("the answer is not kept: {problem}"))?;
            let again = in_days(after.wait());
            answered += 1;
            if is_known {
                known += 1;
                self.say_paragraph(&format!("known; it comes again {again}"));
            } else {
                let page = question.page();
                self.say_paragraph(&format!(
                    "not known; it comes again {again}. Read the chapter: {page}"
                ));
            }
        }
        Ok(match answered {
            0 => "nothing is answered, and nothing is kept".to_owned(),
            _ => format!("{known} of {answered} known"),
        })
    }

    /// Asks one question, shows its answer, and asks whether it was known.
    fn ask(&mut self, question: &Question) -> Grade {
        self.say_paragraph(&self.screen.wrap_markdown(question.words));
        self.screen.say(ASKS_FOR_ANSWER);
        if self.key().is_none() {
            return Grade::Quit;
        }
        self.screen.say("");
        self.say_paragraph(&self.screen.wrap_markdown(question.answer));
        loop {
            self.screen.say(ASKS_FOR_GRADE);
            match self.key() {
                None => return Grade::Quit,
                Some(Key::Char('y' | 'Y')) => return Grade::Known,
                Some(Key::Char('n' | 'N')) => return Grade::NotKnown,
                Some(_) => {}
            }
        }
    }

    /// The next key; none if the reader quits, or nobody types or reads any more.
    fn key(&mut self) -> Option<Key> {
        loop {
            if self.screen.is_closed() {
                return None;
            }
            match self.keys.read(Duration::from_secs(1)) {
                Typed::Nothing => {}
                Typed::End | Typed::Key(Key::Char('q' | 'Q') | Key::CtrlC) => return None,
                Typed::Key(key) => return Some(key),
            }
        }
    }

    /// Prints words and an empty line.
    fn say_paragraph(&self, words: &str) {
        self.screen.say(words);
        self.screen.say("");
    }
}

/// Records an answer. Another `cargo learn` may have recorded something since the question.
fn keep(question: &Question, is_known: bool, today: u32) -> Result<Asked, String> {
    let mut kept = Kept::read()?;
    let before = kept.asked.get(question.id).copied();
    let after = Asked::after(before, is_known, today);
    kept.asked.insert(question.id.to_owned(), after);
    kept.write()?;
    Ok(after)
}

//! `Schedule`: which questions are asked on a day, by the boxes of Sebastian Leitner (*So lernt man
//! lernen*, 1972).
//!
//! A question that was known moves up by one of five boxes, and one that was not goes back to the
//! first. From the first box it is asked again after one day, and from each further box after twice
//! as long: 1, 2, 4, 8, 16 days. A question that was known whenever it was asked has been asked
//! on the days 0, 2, 6, 14 and 30; one that was never known, on every day. If more are due than a
//! day asks, those come first that are late by the most of their own waits, so that a question
//! that went wrong yesterday comes before most others, and none waits for ever.

use std::cmp::Reverse;
use std::collections::BTreeMap;

/// The number of boxes.
pub const BOXES: u32 = 5;

/// The most new questions on a day, and the most old ones.
pub const PER_DAY: usize = 3;

/// When a question was asked, and what was known. Days count from 1 January 1970.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asked {
    /// From 1 to [`BOXES`].
    pub box_number: u32,
    /// The day on which it was asked for the first time.
    pub first: u32,
    /// The day on which it was asked for the last time.
    pub last: u32,
}

impl Asked {
    /// After an answer today. Nothing was `before` if the question is new.
    pub fn after(before: Option<Self>, is_known: bool, today: u32) -> Self {
        let from = before.map_or(1, |before| before.box_number);
        Self {
            box_number: if is_known { (from + 1).min(BOXES) } else { 1 },
            first: before.map_or(today, |before| before.first.min(today)),
            last: today,
        }
    }

    /// Days from one time to the next.
    pub const fn wait(self) -> u32 {
        1 << (self.box_number - 1)
    }

    /// Days until it is due; 0 if it is. A last day that is still to come was a wrong clock, and
    /// the question is due.
    pub fn days_left(self, today: u32) -> u32 {
        match today.checked_sub(self.last) {
            Some(days) => self.wait().saturating_sub(days),
            None => 0,
        }
    }

    /// Days since the last time, in 16ths of its wait.
    fn lateness(self, today: u32) -> u64 {
        let days = today.checked_sub(self.last).unwrap_or(self.wait());
        u64::from(days) * u64::from(1_u32 << (BOXES - self.box_number))
    }

    const fn is_new_on(self, today: u32) -> bool {
        self.last == today && self.first == today
    }

    const fn is_old_on(self, today: u32) -> bool {
        self.last == today && self.first < today
    }
}

/// The ids of the questions for today: first old ones that are due, and then new ones. `ids` are
/// those of the chapters that are finished, in the order of the book. An old question is asked
/// again though its chapter is not finished.
pub fn for_today<'a>(
    all: &[&'a str],
    finished: &[&'a str],
    asked: &BTreeMap<String, Asked>,
    today: u32,
) -> Vec<&'a str> {
    let count = |is_counted: fn(Asked, u32) -> bool| {
        asked.values().filter(|a| is_counted(**a, today)).count()
    };
    let old_left = PER_DAY.saturating_sub(count(Asked::is_old_on));
    let new_left = PER_DAY.saturating_sub(count(Asked::is_new_on));

    let mut due = Vec::new();
    for id in all {
        if let Some(asked) = asked.get(*id)
            && asked.days_left(today) == 0
        {
            due.push((Reverse(asked.lateness(today)), asked.box_number, *id));
        }
    }
    // A stable sort: what is equally late keeps the order of the book.
    due.sort_by_key(|(lateness, box_number, _)| (*lateness, *box_number));
    let old = due.into_iter().map(|(_, _, id)| id).take(old_left);
    let new = finished
        .iter()
        .copied()
        .filter(|id| !asked.contains_key(*id));
    old.chain(new.take(new_left)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A question of this box, asked on this day for the last time and on day 0 for the first.
    fn asked(box_number: u32, last: u32) -> Asked {
        Asked {
            box_number,
            first: 0,
            last,
        }
    }

    /// The days on which one question is asked, of the first 100.
    fn days_of(is_known: fn(u32) -> bool) -> Vec<u32> {
        let mut kept = BTreeMap::new();
        let mut days = Vec::new();
        for today in 0..100 {
            if for_today(&["q"], &["q"], &kept, today) == ["q"] {
                let after = Asked::after(kept.get("q").copied(), is_known(today), today);
                kept.insert("q".to_owned(), after);
                days.push(today);
            }
        }
        days
    }

    /// The waits 2, 4, 8, 16 add up to 2^n - 2 before the n-th time, and then stay 16.
    #[test]
    fn what_is_known_waits_twice_as_long() {
        assert_eq!(days_of(|_| true), [0, 2, 6, 14, 30, 46, 62, 78, 94]);
        assert_eq!(days_of(|_| false), (0..100).collect::<Vec<_>>());
        // Forgotten on day 14: the first box again, 1 day, and then 2, 4, 8.
        assert_eq!(days_of(|day| day != 14)[..7], [0, 2, 6, 14, 15, 17, 21]);
    }

    #[test]
    fn a_day_asks_three_new_questions_in_the_order_of_the_book() {
        let ids = ["a", "b", "c", "d"];
        let mut kept = BTreeMap::new();
        assert_eq!(for_today(&ids, &ids, &kept, 9), ["a", "b", "c"]);
        assert_eq!(for_today(&ids, &ids[..2], &kept, 9), ["a", "b"]);
        for id in ["a", "b", "c"] {
            kept.insert(id.to_owned(), Asked::after(None, true, 9));
        }
        assert!(
            for_today(&ids, &ids, &kept, 9).is_empty(),
            "on the same day"
        );
        assert_eq!(for_today(&ids, &ids, &kept, 10), ["d"]);
    }

    /// 2 days in the box of 1 day are later than 6 in that of 4, and those than 8 in that of 8.
    #[test]
    fn the_three_that_are_latest_come_first() {
        let ids = ["never", "eight", "four", "one", "waiting"];
        let kept = BTreeMap::from([
            ("never".to_owned(), asked(5, 84)),
            ("eight".to_owned(), asked(4, 92)),
            ("four".to_owned(), asked(3, 94)),
            ("one".to_owned(), asked(1, 98)),
            ("waiting".to_owned(), asked(2, 99)),
        ]);
        assert_eq!(for_today(&ids, &[], &kept, 100), ["one", "four", "eight"]);
        let mut later = kept.clone();
        for id in ["one", "four"] {
            later.insert(id.to_owned(), Asked::after(Some(kept[id]), true, 100));
        }
        assert_eq!(
            for_today(&ids, &[], &later, 100),
            ["eight"],
            "one is left of three"
        );
        assert_eq!(kept["waiting"].days_left(100), 1);
    }

    /// Ten questions that are never known, three on a day: four days are enough for all.
    #[test]
    fn none_waits_for_ever() {
        let ids = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"];
        let mut kept: BTreeMap<_, _> = ids.map(|id| (id.to_owned(), asked(1, 0))).into();
        for today in 1..=100 {
            let due = for_today(&ids, &[], &kept, today);
            assert_eq!(due.len(), 3, "on day {today}");
            for id in due {
                let waited = today - kept[id].last;
                assert!(waited <= 4, "{id} waited {waited} days");
                kept.insert(id.to_owned(), Asked::after(Some(kept[id]), false, today));
            }
        }
        assert!(kept.values().all(|asked| asked.last > 96), "{kept:?}");
    }

    #[test]
    fn a_clock_that_goes_back_loses_no_question() {
        let before = asked(5, 70_000);
        let kept = BTreeMap::from([("q".to_owned(), before)]);
        assert_eq!(for_today(&["q"], &[], &kept, 20_000), ["q"]);
        let after = Asked::after(Some(before), true, 20_000);
        assert_eq!((after.last, after.days_left(20_000)), (20_000, 16));
        // A question that was new on a day that is still to come.
        let new = Asked::after(None, true, 70_000);
        assert_eq!(new.days_left(20_000), 0);
        assert_eq!(Asked::after(Some(new), true, 20_000).first, 20_000);
        // Numbers that only an editor writes.
        let late = asked(1, 0);
        assert_eq!(late.days_left(u32::MAX), 0);
        assert!(late.lateness(u32::MAX) > asked(5, 0).lateness(u32::MAX));
    }
}

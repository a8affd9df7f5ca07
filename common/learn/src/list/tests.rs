//! The list without a terminal.

use super::*;

const SIZE: (usize, usize) = (14, 60);

/// The screen after these keys.
fn press(list: &mut List, keys: &[Key]) -> Vec<String> {
    for key in keys {
        assert!(list.obey(key, SIZE.0).is_none(), "{key:?}");
    }
    list.lines(&Progress::default(), SIZE)
}

#[test]
fn the_chosen_exercise_is_always_on_the_screen() {
    let course = crate::exercise::read_all().unwrap();
    let mut list = List::new(course, &course[0]);
    for key in [
        Key::ArrowUp,
        Key::ArrowDown,
        Key::PageDown,
        Key::End,
        Key::PageDown,
    ] {
        let lines = press(&mut list, &[key]);
        let name = course[list.chosen].name;
        let shown = lines.iter().find(|line| line.contains('>')).unwrap();
        assert!(shown.contains(name), "{lines:?}");
        assert!(lines.len() < SIZE.0);
        for line in &lines {
            assert!(console::measure_text_width(line) < SIZE.1, "{line}");
        }
    }
    assert_eq!(list.chosen, course.len() - 1);
}

#[test]
fn words_leave_exercises_out() {
    let course = crate::exercise::read_all().unwrap();
    let mut list = List::new(course, &course[0]);
    let typed = |words: &str| words.chars().map(Key::Char).collect::<Vec<_>>();
    // Letters that are keys elsewhere are words here, and none may be left.
    press(&mut list, &typed("/qxqx"));
    assert!(list.listed().is_empty());
    press(&mut list, &[Key::Escape]);
    assert_eq!(list.listed().len(), course.len());
    press(&mut list, &typed("/SPHERE"));
    press(&mut list, &[Key::Enter]);
    for e in list.listed() {
        assert!(e.name.contains("sphere") || e.title.to_lowercase().contains("sphere"));
    }
    assert!(matches!(
        list.obey(&Key::Enter, SIZE.0),
        Some(Choice::Exercise(e)) if e.name == "sphere"
    ));
}

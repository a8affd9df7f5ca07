//! The list without a terminal.

use super::*;

const SIZE: (usize, usize) = (14, 60);

/// The list of the workbook's exercises, in which none is done.
fn list_of_all() -> List {
    let course = crate::exercise::read_all().unwrap();
    List::new(course, &course[0])
}

/// The screen after these keys.
fn press(list: &mut List, keys: &[Key]) -> Vec<String> {
    for key in keys {
        assert!(list.obey(key, SIZE.0).is_none(), "{key:?}");
    }
    list.lines(&Progress::default(), SIZE)
}

fn type_words(words: &str) -> Vec<Key> {
    words.chars().map(Key::Char).collect()
}

#[test]
fn the_chosen_exercise_is_always_on_the_screen() {
    let mut list = list_of_all();
    let last = list.course.len() - 1;
    for key in [
        Key::ArrowUp,
        Key::ArrowDown,
        Key::PageDown,
        Key::PageDown,
        Key::End,
    ] {
        let lines = press(&mut list, &[key]);
        let name = list.course[list.chosen].name;
        let shown = lines.iter().find(|line| line.contains('>')).unwrap();
        assert!(shown.contains(name), "{lines:?}");
        assert_eq!(lines.len(), SIZE.0);
        for line in &lines {
            assert!(console::measure_text_width(line) < SIZE.1, "{line}");
        }
    }
    assert_eq!(list.chosen, last);
    press(&mut list, &[Key::Home, Key::PageUp]);
    assert_eq!(list.chosen, 0);
}

#[test]
fn words_leave_exercises_out() {
    let mut list = list_of_all();
    let all = list.course.len();
    let lines = press(&mut list, &type_words("/SPHERE"));
    assert!(lines[0].contains("with SPHERE"), "{lines:?}");
    assert!(lines.last().unwrap().starts_with("/SPHERE_"));
    press(&mut list, &[Key::Enter]);
    for e in list.listed() {
        assert!(e.name.contains("sphere") || e.title.to_lowercase().contains("sphere"));
    }
    assert!(matches!(
        list.obey(&Key::Enter, SIZE.0),
        Some(Choice::Exercise(e)) if e.name == "sphere"
    ));
    // Letters that are keys elsewhere are words here, and none may be left.
    let lines = press(&mut list, &type_words("/qxqx"));
    assert!(lines[0].starts_with("exercises 0 to 0 of 0"), "{lines:?}");
    press(&mut list, &[Key::Enter, Key::Enter, Key::PageDown]);
    press(&mut list, &[Key::Char('/'), Key::Escape]);
    assert_eq!(list.listed().len(), all);
    assert!(matches!(
        list.obey(&Key::Escape, SIZE.0),
        Some(Choice::Back)
    ));
}

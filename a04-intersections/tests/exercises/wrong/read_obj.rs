//! Readers that count from 0, skip unknown lines, or lose a triangle.

use a04_intersections::Triangle;
use testing::exercise::Wrong;

use crate::read_obj::check;
use crate::solutions::read_obj::read_obj;

/// The triangles of the text with other words in the lines of this kind, given the
/// number of corners before.
fn reworded(
    text: &str,
    kind: &str,
    reword: impl Fn(usize, &str) -> String,
) -> Result<Vec<Triangle>, String> {
    let (mut corners, mut new) = (0, String::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let first = words.next().unwrap_or_default();
        corners += usize::from(first == "v");
        if first == kind {
            new.push_str(kind);
            for word in words {
                new.push(' ');
                new.push_str(&reword(corners, word));
            }
        } else {
            new.push_str(line);
        }
        new.push('\n');
    }
    read_obj(&new)
}

/// The same number one greater.
fn plus_one(word: &str) -> String {
    word.parse()
        .map_or(word.to_owned(), |n: i64| (n + 1).to_string())
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "corners counted from 0",
        says: r#"the one triangle of "f 1 2 3", after three corners, not "line 4: there is no corner 4": expected yes, got no"#,
        check: |c| check(c, |text| reworded(text, "f", |_, word| plus_one(word))),
    },
    Wrong {
        mistake: "a slash is not read",
        says: r##"the one triangle of "# f 1 1 1\n\nf 1/7 2/8 3/9", after three corners, not "##,
        check: |c| {
            check(c, |text| {
                reworded(text, "f", |_, word| word.replace('/', "x"))
            });
        },
    },
    Wrong {
        mistake: "negative numbers counted from the end of the file",
        says: r#"the one triangle of "f 1/1/1 -2/1/1 3/1/1\nv 9 9 9", after three corners"#,
        check: |c| {
            check(c, |text| {
                let all = text.lines().filter(|line| line.starts_with("v ")).count();
                reworded(text, "f", |_, word| {
                    let number = word.split('/').next().unwrap_or_default().parse::<i64>();
                    match number {
                        Ok(n) if n < 0 => (all as i64 + n + 1).to_string(),
                        _ => word.to_owned(),
                    }
                })
            });
        },
    },
    Wrong {
        mistake: "negative numbers off by one",
        says: r#"the one triangle of "f -3 -2 -1", after three corners, not "line 4: there is no corner 0""#,
        check: |c| {
            check(c, |text| {
                reworded(text, "f", |_, word| {
                    if word.starts_with('-') {
                        plus_one(word)
                    } else {
                        word.to_owned()
                    }
                })
            });
        },
    },
    Wrong {
        mistake: "lines counted from 0",
        says: r#""v 1 2" ends in an error that begins with "line 4: ", not "line 3: "#,
        check: |c| {
            check(c, |text| {
                read_obj(text).map_err(|error| error.replace("line 4", "line 3"))
            });
        },
    },
    Wrong {
        mistake: "broken lines passed over",
        says: r#""v 1 2" ends in an error that begins with "line 4: ": expected yes, got no"#,
        check: |c| check(c, |text| read_obj(text).or(Ok(Vec::new()))),
    },
    Wrong {
        mistake: "only the first triangle of a face",
        says: ", got 1, off by ",
        check: |c| {
            check(c, |text| {
                let first = |line: &str| {
                    let words: Vec<_> = line.split_whitespace().collect();
                    let end = if words.first() == Some(&"f") {
                        4
                    } else {
                        words.len()
                    };
                    words[..end.min(words.len())].join(" ") + "\n"
                };
                read_obj(&text.lines().map(first).collect::<String>())
            });
        },
    },
    Wrong {
        mistake: "a strip instead of a fan",
        says: "]: expected yes, got no",
        check: |c| {
            check(c, |text| {
                // The third corner of a triangle comes first in the next one.
                let Some(face) = text.lines().find(|line| line.starts_with("f ")) else {
                    return read_obj(text);
                };
                let words: Vec<_> = face.split_whitespace().skip(1).collect();
                if words.len() < 4 {
                    return read_obj(text);
                }
                let strip = words.windows(3).map(|w| format!("f {}\n", w.join(" ")));
                read_obj(&text.replace(face, &strip.collect::<String>()))
            });
        },
    },
    Wrong {
        mistake: "every line that begins with v is a corner",
        says: r#"the one triangle of "vt 0 0\nf 1//1 2//1 3//1", after three corners, not "line 4: a corner has three coordinates""#,
        check: |c| {
            check(c, |text| {
                read_obj(&text.replace("vt ", "v ").replace("vn ", "v "))
            });
        },
    },
];

//! `refusal`: why a file does not count, because it uses what it is to write, or reads other files. The grader
//! does not judge it, and `cargo learn` says so.
//!
//! It is found by its words: a macro can hide a use, and nothing finds the lesson's text in another
//! file.

use proc_macro2::{Group, Literal, TokenStream, TokenTree};

use crate::exercise::Exercise;
use crate::tokens;

/// For each exercise, what of the workbook does what it asks for. Behind `*`, words that no file needs, and
/// behind `::` those that lead to the workbook.
const LESSONS: &str = include_str!("lessons.txt");

/// The words before a name that code defines.
const BEFORE_OWN: [&str; 8] = [
    "const", "enum", "fn", "let", "mut", "struct", "trait", "type",
];

/// Why a file does not count, in words for the student; none if it does.
#[must_use]
pub fn refusal(e: &Exercise, text: &str) -> Option<String> {
    // The compiler says what is wrong with other code.
    let tokens = tokens::read(text).ok()?;
    let text = joined(tokens.clone());
    if let Some(word) = words_of("*").find(|word| has(&text, word)) {
        let word = word.replace('~', " ");
        return Some(format!(
            "refused: it contains `{word}`; your code needs nothing but the prelude"
        ));
    }
    let used = words_of(e.name).find(|name| {
        if !name.chars().all(is_of_name) {
            return has(&text, name);
        }
        let search = Search { name, text: &text };
        search.finds_use(tokens.clone(), false, true)
    })?;
    let used = used.trim_end_matches('(');
    Some(format!(
        "refused: it uses `{used}` of the workbook or of a library, which does what the exercise asks for; \
         write your own code. In a course, such a file needs a look"
    ))
}

/// Looks for uses of an item that has a name and is not the file's own.
struct Search<'a> {
    name: &'a str,
    /// The file, as [`joined`] writes it.
    text: &'a str,
}

impl Search<'_> {
    /// Whether tokens have the name by an import, in a path, as a method, or alone where the code does
    /// not define it. `is_own` says that the code around them defines it, and `is_file` that nothing is around them.
    fn finds_use(&self, tokens: TokenStream, is_own: bool, is_file: bool) -> bool {
        let tokens: Vec<_> = tokens.into_iter().collect();
        let words: Vec<_> = tokens.iter().map(word).collect();
        let words: Vec<_> = words.iter().map(String::as_str).collect();
        let mut is_own = is_own;
        let mut defines = false;
        for (at, word) in words.iter().enumerate() {
            defines |= *word == self.name && at > 0 && BEFORE_OWN.contains(&words[at - 1]);
            if *word != "use" {
                continue;
            }
            let rest = tokens[at + 1..].iter().cloned();
            let import = joined(rest.take_while(|token| token.to_string() != ";").collect());
            let has_name = has(&import, self.name);
            if self.is_own(&import) {
                defines |= has_name;
            } else if has_name {
                return true;
            } else if import.contains('*') && words_of("::").any(|root| has(&import, root)) {
                // It gives the name to other code, or hides the file's own.
                if words[..at].ends_with(&["pub"]) || words[..at].ends_with(&["pub", "("]) {
                    return true;
                }
                is_own &= is_file;
            }
        }
        is_own |= defines;
        let is_type = self.name.starts_with(char::is_uppercase);
        for (at, token) in tokens.iter().enumerate() {
            if let TokenTree::Group(bracket) = token
                && self.finds_use(bracket.stream(), is_own, false)
            {
                return true;
            }
            if words[at] != self.name {
                continue;
            }
            let (before, next) = (&words[..at], words.get(at + 1));
            let is_called = matches!(next, Some(&("(" | ":")));
            let is_used = if before.ends_with(&[":", ":"]) {
                !self.is_own(&path_before(before))
            } else if before.ends_with(&["."]) && !before.ends_with(&[".", "."]) {
                is_called
            } else {
                !is_own && (is_type || next == Some(&"("))
            };
            if is_used {
                return true;
            }
        }
        false
    }

    /// Whether a path begins in the file.
    fn is_own(&self, path: &str) -> bool {
        match path.split("::").next().unwrap_or_default() {
            "self" | "super" | "Self" => !path.contains("super::super"),
            first => first.starts_with(is_of_name) && has(self.text, &format!("mod~{first}")),
        }
    }
}

/// The word of a token, or the beginning of a bracket.
fn word(token: &TokenTree) -> String {
    let word = token.to_string();
    match token {
        TokenTree::Group(_) => word.chars().take(1).collect(),
        TokenTree::Literal(_) => String::new(),
        // Any name may be written as a raw one.
        _ => word.trim_start_matches("r#").to_owned(),
    }
}

/// The path at the end of these words.
fn path_before(words: &[&str]) -> String {
    let mut start = words.len();
    while words[..start].ends_with(&[":", ":"]) {
        start -= 2;
        if start > 0 && words[start - 1].starts_with(is_of_name) {
            start -= 1;
        }
    }
    words[start..].concat()
}

/// Whether a letter is part of a name.
fn is_of_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// The tokens, of which the texts are empty.
fn without_texts(tokens: TokenStream) -> TokenStream {
    let without_text = |token| match token {
        TokenTree::Literal(literal) if literal.to_string().contains(['"', '\'']) => {
            Literal::string("").into()
        }
        TokenTree::Group(bracket) => {
            Group::new(bracket.delimiter(), without_texts(bracket.stream())).into()
        }
        other => other,
    };
    tokens.into_iter().map(without_text).collect()
}

/// The code without space and comments, and with `~` between two names.
fn joined(tokens: TokenStream) -> String {
    // Any name may be written as a raw one.
    let code = without_texts(tokens).to_string().replace("r#", "");
    let mut joined = String::new();
    for word in code.split_whitespace() {
        if joined.ends_with(is_of_name) && word.starts_with(is_of_name) {
            joined.push('~');
        }
        joined += word;
    }
    joined
}

/// Whether a text has a word that neither begins nor ends within a longer name; one that ends with `_` is
/// the beginning of names.
fn has(text: &str, word: &str) -> bool {
    text.match_indices(word).any(|(at, _)| {
        let (before, after) = (&text[..at], &text[at + word.len()..]);
        let begins_within = word.starts_with(is_of_name) && before.ends_with(is_of_name);
        let ends_within = word.ends_with(char::is_alphanumeric) && after.starts_with(is_of_name);
        !begins_within && !ends_within
    })
}

/// The words after a name in the list of lessons.
fn words_of(name: &str) -> impl Iterator<Item = &'static str> {
    let after_name = |line: &'static str| line.strip_prefix(name)?.strip_prefix(' ');
    let words = LESSONS.lines().find_map(after_name);
    words.unwrap_or_default().split_whitespace()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files;

    fn is_refused(e: &Exercise, code: &str) -> bool {
        refusal(e, code).is_some()
    }

    #[test]
    fn starters_are_not_refused_nor_imports_that_editors_add() {
        let imports = "use a02_math::Point3;\nuse crate::prelude::Vector3;\nuse common::{Color, Image};\n\
            use a03_rays_cameras::{Ray, Sampler};\nuse super::prelude::Interval;\n";
        for e in crate::exercise::read_all().unwrap() {
            let starter = files::starter(e).unwrap();
            assert_eq!(refusal(e, &starter), None, "{}", e.name);
            let imported = starter.replace("use crate::prelude::*;", imports);
            assert_eq!(refusal(e, &imported), None, "{}", e.name);
            let tested = format!("{starter}\n#[cfg(test)]\nmod tests {{ use super::*; }}");
            assert_eq!(refusal(e, &tested), None, "{}", e.name);
        }
    }

    /// For each exercise of the core path, code that calls the lesson.
    const OF_LESSON: [(&str, &str); 28] = [
        ("set_pixel", "image.set(x, y, color)"),
        ("diagonal", "PaintDiagonal.paint(&mut canvas)"),
        ("products", "Vector3::cross(a, b)"),
        ("angle", "a.angle(b)"),
        ("reflected", "v.reflected_on(n)"),
        ("ray", "ray.t_of(point)"),
        (
            "perspective",
            "crate::prelude::PerspectiveCamera::new(e, g, t, alpha)",
        ),
        (
            "pinhole",
            "use a03_rays_cameras::{Camera, PinholeCamera as Theirs};",
        ),
        ("stripe", "StripedSky::new(camera, 10)"),
        ("picture", "paint(camera, radiance, settings)"),
        ("plane", "type Theirs = a04_intersections::Plane;"),
        ("sphere", "a04_intersections::Sphere::new(self.c, self.r)"),
        (
            "axis_aligned_box",
            "super::super::prelude::AxisAlignedBox::new(a, b)",
        ),
        (
            "triangle",
            "use a04_intersections as lesson; fn f() { lesson::Triangle::new(a, b, c) }",
        ),
        ("nearest", "world.hit(ray, within)"),
        (
            "orthographic",
            "mod lesson { use crate::prelude::*; fn f() { OrthographicCamera::new(e) } }",
        ),
        ("lambert", "Lambert::new(diffuse)"),
        ("phong", "Phong::new(color, color, 8.0)"),
        ("point_light", "PointLight::new(color, lamp)"),
        ("directional_light", "DirectionalLight::new(color, to)"),
        ("spot_light", "SpotLight::new(color, lamp, axis, angle)"),
        (
            "shadowed",
            "a06_shadows_reflection::is_shadowed(world, ray, hit, light)",
        ),
        (
            "leaving",
            "fn f() { use crate::prelude::*; secondary_ray(ray, hit, d) }",
        ),
        ("mirror", "lights.trace(ray, depth)"),
        ("chain", "steps.iter().fold(t, |t, step| step.after(t))"),
        ("under_transform", "transform.ray_to_object(ray)"),
        ("node", "pub use a07_transforms::*;"),
        ("disc", "<a07_transforms::Disc>::new(c, n, r)"),
    ];

    #[test]
    fn files_that_use_the_lesson_are_refused_and_say_so() {
        for e in crate::exercise::read_all().unwrap() {
            let lesson = OF_LESSON.iter().find(|(name, _)| *name == e.name);
            assert_eq!(lesson.is_some(), e.is_core, "{}", e.name);
            let Some((_, code)) = lesson else {
                continue;
            };
            let starter = files::starter(e).unwrap();
            let words = refusal(e, &format!("{starter}\n{code}")).unwrap_or_default();
            assert!(words.contains("does what the exercise asks for"), "{code}");
        }
    }

    #[test]
    fn names_of_the_lesson_are_refused_and_names_of_ones_own_are_not() {
        let e = crate::exercise::find("sphere").unwrap();
        for own in [
            "pub struct Sphere; fn f() -> Sphere { self::Sphere }",
            "pub struct Sphere; mod tests { use super::Sphere; fn f() { Sphere::new() } }",
            "pub struct Sphere; mod tests { use crate::prelude::*; use super::Sphere; type T = Sphere; }",
            "mod mine { pub struct Sphere; } pub use mine::Sphere; type T = Sphere;",
            "pub struct Sphere; fn f() { use std::f64::consts::*; Sphere::new(PI) }",
            "use a04_intersections::*; pub struct Sphere; const A: &str = \"a04_intersections::Sphere\";",
            "pub struct Sphere; fn f(spheres: &[Hemisphere]) { a04_intersections::Sphere2::new() }",
        ] {
            assert_eq!(refusal(e, own), None, "{own}");
        }
        for theirs in [
            "pub type Sphere = crate::prelude::Sphere;",
            "pub use crate::prelude::*;",
            "pub(crate) use a04_intersections::r#Sphere;",
            "use {a02_math::Point3, a04_intersections::{Plane, Sphere as Theirs}};",
            "fn f() { Sphere::new(c, r) }",
            "pub struct Sphere; mod m { use super::super::prelude::*; fn f() { Sphere::new(c, r) } }",
        ] {
            assert!(is_refused(e, theirs), "{theirs}");
        }
        let e = crate::exercise::find("products").unwrap();
        assert!(is_refused(
            e,
            "pub fn dot() { a.to_glam().dot(b.to_glam()) }"
        ));
        assert!(is_refused(
            e,
            "pub fn dot() { let dot = <Vector3 as Direction>::dot; }"
        ));
        assert_eq!(
            refusal(e, "pub fn dot() {} fn f() { dot(a, b); (0..dot(a, b)); }"),
            None
        );
    }

    #[test]
    fn files_that_start_programs_or_read_files_are_refused() {
        let e = crate::exercise::find("sphere").unwrap();
        for line in [
            "std::process::Command::new(\"cat\")",
            "use std::process;",
            "use std::{f64::consts::PI, process as p};",
            "std::fs::read(\"answers\")",
            "std :: fs :: File",
            "use std::{fs as f};",
            "const ANSWERS: &str = include_str!(\"answers\");",
            "let quote = '\"'; std::fs::read(\"a\"); let other = '\\\"';",
            "/* /* */ */ std::net::connect()",
            "let a = r\"\\\"; std::fs::read(b); let c = \"\";",
            "let a = c\"\\\\\"; std::fs::read(b); let c = br#\"\"#;",
            "use std::r#fs as files;",
            "fn f<'a>(c: &'a str) { let q = b'\"'; std::fs::read(c); }",
        ] {
            assert!(is_refused(e, line), "{line}");
        }
        for line in [
            "let processed = 1; let offset = 2;",
            "use std::{f64::consts::PI, mem};",
            "use prefs::path; let external = prefs::path(\"included\");",
            "// It includes what std::fs::read does.",
            "let a = 1.0; // Sphere is in super::x and std::fs.",
            "/* use std::fs; /* std::process */ std::net */ let a = 1;",
            "let a = \"std::fs \\\" std::net\"; let b = r#\"use \"std::fs\"\"#; let r = 1;",
            "mod tests { use super::*; }",
        ] {
            assert_eq!(refusal(e, line), None, "{line}");
        }
    }
}

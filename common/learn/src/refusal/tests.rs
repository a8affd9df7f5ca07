use super::*;
use crate::exercise::{find, read_all};
use crate::starter::starter;

fn is_refused(e: &Exercise, code: &str) -> bool {
    refusal(e, code).is_some()
}

#[test]
fn starters_are_not_refused_nor_imports_that_editors_add() {
    let imports = "use a02_math::Point3;\nuse crate::prelude::Vector3;\nuse common::{Color, Image};\n\
        use a03_rays_cameras::{Ray, Sampler};\nuse super::prelude::Interval;\n";
    for e in read_all().unwrap() {
        let starter = starter(e).unwrap();
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
    for e in read_all().unwrap() {
        let lesson = OF_LESSON.iter().find(|(name, _)| *name == e.name);
        assert_eq!(lesson.is_some(), e.is_core, "{}", e.name);
        let Some((_, code)) = lesson else {
            continue;
        };
        let starter = starter(e).unwrap();
        let words = refusal(e, &format!("{starter}\n{code}")).unwrap_or_default();
        assert!(words.contains("does what the exercise asks for"), "{code}");
    }
}

#[test]
fn names_of_the_lesson_are_refused_and_names_of_ones_own_are_not() {
    let e = find("sphere").unwrap();
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
    let e = find("products").unwrap();
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
    let e = find("sphere").unwrap();
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

//! The work that meshes, uses and groups take, counted by hand.

use common::steps::{Counts, StepKind, counted};
use common::{Image, Omission, Omissions, Renderer, Settings, Size};

use crate::scene_cases::open;

const RAYS: u64 = 16;

/// Looks down at a floor from below the shapes, which are between it and the lamp.
const FLOOR: &str = r#"
[camera]
eye = [0, 1, 0]
gaze = [0, -1, 0]
up = [0, 0, 1]
angle = 20
[material.m]
diffuse = [1, 1, 1]
[[point_light]]
color = [1, 1, 1]
position = [0, 9, 0]
[[plane]]
point = [0, 0, 0]
normal = [0, 1, 0]
material = "m"
"#;

/// The work of a renderer in a scene.
fn work(scene: &str, renderer: Renderer, omissions: Omissions) -> (Image, Counts) {
    let scene = open(scene).unwrap_or_else(|error| panic!("{error}:\n{scene}"));
    let settings = Settings {
        size: Size::new(4, 4).unwrap(),
        depth: 1,
        renderer,
        omissions: Some(omissions),
        ..scene.defaults.clone()
    };
    let (image, counts) = counted(|| scene.render(&settings, &())).unwrap();
    (image.unwrap(), counts)
}

/// A ray from the camera tests the floor and all triangles, and so does a shadow ray that all work
/// sends. That of the lesson ends at the first triangle. The mesh has six, and a node around it.
#[test]
fn a_search_for_shadows_ends_in_a_mesh_and_in_a_use() {
    let triangle = |kind: &str, y: f64| {
        format!("[[{kind}]]\ncorners = [[-9, {y}, -9], [9, {y}, -9], [0, {y}, 9]]\n")
    };
    let of_use = triangle("define.d.triangle", 2.0) + &triangle("define.d.triangle", 3.0);
    let mesh = "[[mesh]]\nfile = \"pyramid.obj\"\nmaterial = \"m\"\n\
        transform = [{ translate = [0, 2, 0] }, { scale = [30, 1, 30] }, { translate = [-2.7, 0, 1.5] }]\n";
    let used = format!("{of_use}[[use]]\nname = \"d\"\nmaterial = \"m\"\n");
    for (shapes, of_lesson, of_all) in [(used.as_str(), 5, 6), (mesh, 11, 16)] {
        let scene = format!("{FLOOR}{shapes}");
        let tests = [Renderer::Lesson, Renderer::NoOmissions].map(|renderer| {
            let (_, counts) = work(&scene, renderer, Omissions::ALL);
            counts[StepKind::Test] / RAYS
        });
        assert_eq!(tests, [of_lesson, of_all], "{shapes}");
    }
}

/// A green floor reflects nothing of red light, so six red lamps cost the engine no ray and no power.
#[test]
fn a_light_of_which_the_surface_reflects_nothing_costs_the_engine_no_ray() {
    let green = "diffuse = [0, 1, 0]\nspecular = [0, 0.5, 0]\nexponent = 20";
    let floor = FLOOR.replace("diffuse = [1, 1, 1]", green);
    let lamp = "[[point_light]]\ncolor = [1, 0, 0]\nposition = [0, 9, 0]\n";
    let lit = floor.clone() + &lamp.repeat(6);
    let (of_floor, counts) = work(&floor, Renderer::Engine, Omissions::ALL);
    assert_eq!(counts[StepKind::ShadowRay], RAYS);
    let (of_engine, with_red) = work(&lit, Renderer::Engine, Omissions::ALL);
    assert_eq!(with_red, counts);
    let without = Omissions::ALL.without(Omission::UnreflectedLight);
    let (put_back, all) = work(&lit, Renderer::Engine, without);
    assert_eq!(all[StepKind::ShadowRay], 7 * RAYS);
    let (of_lesson, _) = work(&lit, Renderer::Lesson, Omissions::ALL);
    assert!(
        [of_engine, put_back, of_lesson]
            .iter()
            .all(|image| *image == of_floor)
    );
}

/// Two groups that move nothing cost the engine no ray, unless this work is put back: then two for
/// each test of the ball.
#[test]
fn groups_that_move_nothing_move_no_rays_of_the_engine() {
    let ball = "sphere]]\ncenter = [0, 0, 0]\nradius = 0.5\nmaterial = \"m\"\n";
    let alone = format!("{FLOOR}[[{ball}");
    let steps = "{ translate = [0, 0, 0] }, { scale = [1, 1, 1] }, { rotate_x = 0 }";
    let grouped =
        format!("{FLOOR}[[group]]\n[[group.group]]\ntransform = [{steps}]\n[[group.group.{ball}");
    let of_alone = work(&alone, Renderer::Engine, Omissions::ALL).1;
    let (image, counts) = work(&grouped, Renderer::Engine, Omissions::ALL);
    assert_eq!(counts, of_alone);
    let without = Omissions::ALL.without(Omission::IdentityTransforms);
    let (same, moved) = work(&grouped, Renderer::Engine, without);
    let (lesson, _) = work(&grouped, Renderer::Lesson, Omissions::ALL);
    assert!(image == same && image == lesson);
    let balls = of_alone[StepKind::Test] / 2;
    assert_eq!(moved[StepKind::ObjectRay], 2 * balls);
}

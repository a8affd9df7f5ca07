//! Random scenes of stages 4 to 7, ordinary and extreme ones.

use a03_rays_cameras::View;
use a03_rays_cameras::registry::Format;
use a06_shadows_reflection::ShadowedWorld;
use a06_shadows_reflection::registry::read_view;
use a07_transforms::registry::{ALL_SHAPES, FORMAT};
use a07_transforms::traced;
use random_scene::{SceneText, Style};
use scene_file::{Error, SceneFile};
use testing::Random;

use crate::compare::compare_scenes;
use crate::own_types::{with_numbers_that_are_none, with_own_types};
use crate::rays::Rays;

/// Every other scene is extreme.
pub const fn style(seed: u64) -> Style {
    [Style::Plain, Style::Extreme][seed as usize % 2]
}

/// The text of the scene of a seed.
pub fn text(seed: u64, style: Style, format: Format) -> SceneText {
    let mut random = Random::new(seed);
    let is_accepted = |text: &SceneText| view(format, text).is_ok();
    SceneText::new(
        &mut |end| random.below(end),
        style,
        format.stage,
        &is_accepted,
    )
}

pub fn file(format: Format, text: &SceneText) -> Result<SceneFile, Error> {
    format.read(&text.scene, &|name| text.mesh(name))
}

pub fn view(format: Format, text: &SceneText) -> Result<View, Error> {
    let (_, view) = format.scene(&file(format, text)?)?;
    Ok(view)
}

/// The camera of the file, or one of bundles.
pub fn seen<W>(seed: u64, view: View<W>) -> View<W> {
    match seed / 2 % 3 {
        0 => view,
        _ => View::new(Rays::new(seed, style(seed)), view.world),
    }
}

fn compare_stage(format: Format, count: u64) {
    compare_scenes(format, 0..count, |seed, file| {
        let (_, view) = format.scene(file).ok()?;
        Some(seen(seed, view))
    });
}

#[test]
fn all_renderers_draw_the_same_pictures_of_stage_4() {
    compare_stage(a04_intersections::registry::FORMAT, 60);
}

#[test]
fn all_renderers_draw_the_same_pictures_of_stage_5() {
    compare_stage(a05_lighting::registry::FORMAT, 40);
}

#[test]
fn all_renderers_draw_the_same_pictures_of_stage_6() {
    compare_stage(a06_shadows_reflection::registry::FORMAT, 40);
}

#[test]
fn all_renderers_draw_the_same_pictures_of_stage_7() {
    compare_stage(FORMAT, 60);
}

/// The view of a file, whose world has something more.
fn view_with(
    seed: u64,
    file: &SceneFile,
    add: impl Fn(ShadowedWorld, u64) -> Option<ShadowedWorld>,
) -> Option<View> {
    let View { camera, world } = seen(seed, read_view(file, ALL_SHAPES).ok()?);
    let world = add(world, seed)?;
    Some(traced(View { camera, world }))
}

#[test]
fn all_renderers_draw_the_same_pictures_of_own_types() {
    compare_scenes(FORMAT, 0..40, |seed, file| {
        view_with(seed, file, with_own_types)
    });
}

/// Rays that leave such a hit have no origin or no direction. They must not take those beside them along.
#[test]
fn numbers_that_are_none_spoil_no_other_ray() {
    compare_scenes(FORMAT, 0..24, |seed, file| {
        view_with(seed, file, with_numbers_that_are_none)
    });
}

//! Steps of a transform; and the scenes of this stage, with the student's code in them.

pub use std::f64::consts::{FRAC_PI_2, TAU};

use a04_intersections::kinds::KINDS as SHAPES;
use a06_shadows_reflection::instruments::recorded::RecordedWorld;

use crate::prelude::*;

/// A step of a transform: the transform alone.
#[derive(Clone, Copy, Debug)]
pub enum Step {
    Translate([f64; 3]),
    Scale([f64; 3]),
    /// About the x, y or z axis, which has this number.
    Rotate(usize, f64),
}

impl Step {
    /// The matrix of the step.
    pub fn matrix(self) -> Mat4x4 {
        self.after(Transform::IDENTITY).matrix()
    }

    /// The matrix that undoes the step.
    pub fn inverse(self) -> Mat4x4 {
        self.after(Transform::IDENTITY).inverse()
    }

    /// A transform with this step chained to it.
    pub fn after(self, t: Transform) -> Transform {
        let chained = match self {
            Self::Translate(to) => t.translate(point(to)),
            Self::Scale([x, y, z]) => t.scale(x, y, z),
            Self::Rotate(0, angle) => t.rotate_x(angle),
            Self::Rotate(1, angle) => t.rotate_y(angle),
            Self::Rotate(_, angle) => t.rotate_z(angle),
        };
        chained.unwrap_or(t)
    }

    /// Up to four steps.
    pub fn random(random: &mut Random) -> Vec<Self> {
        let step = |_| {
            let angle = random.between(-3.0, 3.0);
            match random.below(5) {
                0 => Self::Translate(random.triple(3.0)),
                1 => Self::Scale([(); 3].map(|()| random.between(0.3, 3.0))),
                axis => Self::Rotate(axis as usize - 2, angle),
            }
        };
        (0..4).map(step).collect()
    }
}

impl Input for Step {
    fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
        match self {
            Self::Translate(xyz) | Self::Scale(xyz) => xyz.for_each_number(f),
            Self::Rotate(_, angle) => f(angle),
        }
    }

    fn words(&self) -> Vec<String> {
        vec![format!("{self:?}")]
    }
}

/// The transform of a chain of steps.
pub fn transform(steps: &[Step]) -> Transform {
    let steps = steps.iter();
    steps.fold(Transform::IDENTITY, |t, step| step.after(t))
}

/// Where a lamp is, whether it casts shadows, and the ambient light.
pub type Lamp = ([f64; 3], bool, f64);

/// The lamp of the scenes with transformed objects.
pub const ABOVE: Lamp = ([1.0, 20.0, 20.0], false, 0.25);

/// Compares a scene with its lock: a black world with a lamp, which is filled. Camera and
/// world are from `src/scenes.rs`.
pub fn locked_scene(
    check: &mut Check,
    name: &str,
    eye: f64,
    (light, casts_shadows, ambient): Lamp,
    fill: impl FnOnce(ShadowedWorld) -> Made<ShadowedWorld>,
) {
    check.scene(&a07_transforms::stage(), name, |settings| {
        let light = PointLight::new(Color::WHITE, point(light))?;
        let world = ShadowedWorld::empty(Color::BLACK, Color::gray(ambient))?;
        let world = fill(world.lit_by(LightSource::new(light, casts_shadows)))?;
        let world = RecordedWorld::new(world, SHAPES, false);
        let color = |ray: &Ray| world.radiance(ray, settings.depth);
        paint(&diagonal_camera(eye)?, &color, settings)
    });
}

/// Compares scene `box-transformations`, with the box that is made of an upright one.
pub fn box_scene<G: Geometry>(check: &mut Check, transformed: impl FnOnce(AxisAlignedBox) -> G) {
    locked_scene(check, "box-transformations", 10.0, ABOVE, |world| {
        let upright = AxisAlignedBox::new(point([-0.5; 3]), point([0.5; 3]))?;
        let yellow = Lambert::new(Color::YELLOW)?;
        Ok(world.with(transformed(upright), Box::new(yellow)))
    });
}

/// The steps of scene `box-transformations`.
pub fn steps_of_box() -> [Step; 4] {
    [
        Step::Scale([4.0, 1.0, 8.0]),
        Step::Rotate(2, -20_f64.to_radians()),
        Step::Rotate(1, -5_f64.to_radians()),
        Step::Rotate(0, -30_f64.to_radians()),
    ]
}

/// Shows a world to an eye that looks at the point `at`. Surfaces that face right, up or the
/// eye are brighter than others.
pub fn show_lit(check: &mut Check, world: Made<World<Color>>, eye: [f64; 3], at: [f64; 3]) {
    show_world(check, world, eye, at, &|color, _, n| {
        color * (0.5 + 0.15 * n.x() + 0.3 * n.y() + 0.2 * n.z())
    });
}

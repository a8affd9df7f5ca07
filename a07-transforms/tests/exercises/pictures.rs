//! The scenes of this stage, with the student's code in them; and worlds of students' shapes.

use a03_rays_cameras::instruments::Instruments;
use a04_intersections::registry::ALL_SHAPES;
use a06_shadows_reflection::instruments::instrumented::InstrumentedWorld;

use crate::prelude::*;

/// A scene of this stage without its objects: a black world with a lamp. The same numbers stand
/// in `src/scenes.rs`.
#[derive(Clone, Copy)]
pub struct LitScene {
    pub name: &'static str,
    /// The eye is at this number on each axis, and looks at the origin.
    pub eye: f64,
    pub lamp: [f64; 3],
    pub casts_shadows: bool,
    pub ambient: f64,
}

impl LitScene {
    /// The scene with the objects that code adds to its world.
    pub fn with<C: 'static>(
        self,
        add: fn(&C, ShadowedWorld) -> Made<ShadowedWorld>,
    ) -> StudentPicture<C> {
        StudentPicture::scene(self.name, move |code, settings| {
            let light = PointLight::new(Color::WHITE, point(self.lamp))?;
            let world = ShadowedWorld::empty(Color::BLACK, Color::gray(self.ambient))?;
            let world = world.lit_by(LightSource::new(light, self.casts_shadows));
            let world = InstrumentedWorld::new(add(code, world)?, ALL_SHAPES, Instruments::LESSON);
            let color = |ray: &Ray| world.radiance(ray, settings.depth);
            paint(&diagonal_camera(self.eye)?, &color, settings)
        })
    }
}

/// Scene `box-transformations`.
pub const BOX_SCENE: LitScene = LitScene {
    name: "box-transformations",
    eye: 10.0,
    lamp: [1.0, 20.0, 20.0],
    casts_shadows: false,
    ambient: 0.25,
};

/// The box of scene `box-transformations` before its steps.
pub fn upright_box() -> Made<AxisAlignedBox> {
    AxisAlignedBox::new(point([-0.5; 3]), point([0.5; 3]))
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

/// The surface of the box of scene `box-transformations`.
pub fn yellow() -> Made<Box<Lambert>> {
    Ok(Box::new(Lambert::new(Color::YELLOW)?))
}

/// Shows a world that is made with the student's code. Surfaces that face right, up or the eye
/// are brighter than others.
pub fn lit<C: 'static>(eye: Eye, world: fn(&C) -> Made<World<Color>>) -> StudentPicture<C> {
    StudentPicture::own(move |code, settings| {
        eye.show(&world(code)?, settings, &|color, _, n| {
            color * (0.5 + 0.15 * n.x() + 0.3 * n.y() + 0.2 * n.z())
        })
    })
}

//! Why the picture of a scene of the stage is black: its code may be wrong, too.

use a02_math::Point3;
use a03_rays_cameras::instruments::Instruments;
use a03_rays_cameras::{PinholeCamera, Ray, TracedWorld, View, traced_scene};
use common::{ArgumentError, Color, Settings, Size};

/// A world in which the lesson finds no light, and the engine this background.
struct Dark(Color);

impl TracedWorld for Dark {
    fn radiance(&self, _: &Ray, _: u32) -> Color {
        Color::BLACK
    }

    fn for_engine(&self, depth: u32) -> Option<engine::Scene<'_>> {
        Some(engine::Scene::new(self.0, Color::BLACK, depth))
    }

    fn object_name(&self, _: usize) -> String {
        "object 1: Sphere".to_owned()
    }

    fn instrumented(self: Box<Self>, _: Instruments) -> Box<dyn TracedWorld> {
        self
    }
}

fn view(background: Color) -> Result<View, ArgumentError> {
    let camera = PinholeCamera::new(Point3::new(1.0, 2.0, 5.0), 1.0)?;
    Ok(View::new(camera, Dark(background)).boxed())
}

fn why_black(view: fn(Size) -> Result<View, ArgumentError>) -> Option<String> {
    let settings = Settings {
        size: Size::new(4, 3).unwrap(),
        ..Settings::default()
    };
    let scene = traced_scene("dark", "a black picture", view);
    scene.rays().unwrap().why_black(&settings).unwrap()
}

#[test]
fn a_formula_may_be_wrong() {
    assert_eq!(
        why_black(|_| view(Color::BLACK)).as_deref(),
        Some(
            "no ray meets an object: the camera at (1, 2, 5) looks along (0, 0, -1), or a formula is \
             wrong"
        )
    );
    assert_eq!(
        why_black(|_| view(Color::WHITE)).as_deref(),
        Some("a formula of the lesson is wrong, because --fast draws light")
    );
}

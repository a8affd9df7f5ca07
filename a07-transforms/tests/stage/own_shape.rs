//! A shape of one's own: one row gives it a table in scene files, and all renderers, the
//! explanation and the export take it.

use a02_math::Vector3;
use a03_rays_cameras::kinds::Format;
use a03_rays_cameras::{Ray, View};
use a04_intersections::kinds::{Content, SHAPES as SIMPLE, ShapeKind, ShapeRow, Shapes};
use a04_intersections::{Geometry, Hit, Interval};
use a06_shadows_reflection::kinds::read_view;
use a06_shadows_reflection::traced_with;
use a07_transforms::kinds::SHAPES as TRANSFORMED;
use common::{Image, Renderer, Settings, Size};
use scene_file::{Error, Item, Key};

/// The part of the plane z = 0 between two points of a diagonal.
#[derive(Debug)]
struct Tile {
    corners: [[f64; 2]; 2],
}

impl Geometry for Tile {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let t = -ray.origin().z() / ray.direction().z();
        let p = ray.at(t);
        let [[left, low], [right, high]] = self.corners;
        let is_inside = (left..=right).contains(&p.x()) && (low..=high).contains(&p.y());
        let normal = Vector3::new(0.0, 0.0, 1.0).as_normal();
        (is_inside && within.contains(t)).then(|| Hit::new(t, normal))
    }
}

impl ShapeKind for Tile {
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let corners = item.rows("corners")?;
        Ok(Self { corners })
    }

    fn content(&self) -> Content<'_> {
        Content::Values(vec![("corners", self.corners.as_flattened().to_vec())])
    }
}

const SECTION: &str = "a04-intersections.md#one-question-and-an-interval";
const OWN: &[ShapeRow] = &[ShapeRow::of::<Tile>("tile", SECTION).with_keys(&[Key {
    name: "corners",
    form: "2 x 2 numbers",
    range: "",
    missing: "needed",
    stage: 4,
    about: "its lower left and its upper right corner",
}])];
const KINDS: Shapes = Shapes(&[SIMPLE, TRANSFORMED, OWN]);
const FORMAT: Format = Format {
    stage: 7,
    own_tables: || KINDS.own_tables(),
    view: |file| Ok(traced_with(read_view(file, KINDS)?, KINDS)),
};

/// A tile to the left, and one in a group, moved to the right.
const FILE: &str = "[camera]
eye = [0, 0, 4]
gaze = [0, 0, -1]
angle = 60

[[tile]]
corners = [[-1.5, -0.5], [-0.5, 0.5]]
color = [1, 0, 0]

[[group]]
transform = [{ translate = [1, 0, 0] }]
color = [0, 1, 0]

[[group.tile]]
corners = [[-0.5, -0.5], [0.5, 0.5]]
";

fn view(text: &str) -> Result<View, Error> {
    (FORMAT.view)(&FORMAT.read(text, &|_| Err("no mesh".to_owned()))?)
}

fn settings(renderer: Renderer) -> Settings {
    Settings {
        size: Size::new(64, 48).unwrap(),
        renderer,
        ..Settings::default()
    }
}

fn picture(text: &str, renderer: Renderer) -> Image {
    let view = view(text).unwrap();
    view.render(&settings(renderer), &()).unwrap()
}

#[test]
fn all_renderers_draw_it_and_its_export_is_the_same() {
    let lesson = picture(FILE, Renderer::Lesson);
    let channels = |x| lesson.get(x, 24).unwrap().channels();
    assert_eq!(channels(21), [1.0, 0.0, 0.0]);
    assert_eq!(channels(32), [0.0; 3]);
    assert_eq!(channels(42), [0.0, 1.0, 0.0]);
    let export = view(FILE)
        .unwrap()
        .export("toml", &settings(Renderer::Lesson))
        .unwrap();
    assert!(
        export.contains("[[tile]]\ncolor = [1, 0, 0]\ncorners = [[-1.5, -0.5], [-0.5, 0.5]]\n"),
        "{export}"
    );
    for renderer in Renderer::ALL {
        assert!(picture(FILE, renderer) == lesson, "{renderer:?}");
        assert!(picture(&export, renderer) == lesson, "{renderer:?}");
    }
}

#[test]
fn a_pixel_names_it() {
    let trace = view(FILE)
        .unwrap()
        .trace(&settings(Renderer::Lesson), [21, 24]);
    let mut steps = trace.steps.iter();
    let test = steps.find(|step| step.name == "object 1: Tile").unwrap();
    assert_eq!(test.outcome.to_string(), "hit");
    assert_eq!((test.number, test.section), (Some(1), SECTION));
    // The camera is 4 before the tile: t is 4 divided by the cosine of the ray.
    let [x, y, _] = trace.steps[1].value::<3>("d").unwrap();
    let cosine = (1.0 - x * x - y * y).sqrt();
    let [t] = test.value("t").unwrap();
    assert!((t * cosine - 4.0).abs() < 1e-12, "{t}");
}

#[test]
fn its_mistakes_are_refused_as_those_of_other_shapes() {
    for (right, wrong, expected) in [
        ("[[tile]]", "[[tilt]]", "; the nearest is tile"),
        (
            "corners = [[-1.5",
            "corner = [[-1.5",
            "; the nearest is corners",
        ),
        ("[-0.5, 0.5]]\ncolor", "-0.5]\ncolor", "corners must be"),
    ] {
        let error = view(&FILE.replacen(right, wrong, 1)).err().unwrap();
        assert!(error.text.contains(expected), "{}", error.text);
    }
}

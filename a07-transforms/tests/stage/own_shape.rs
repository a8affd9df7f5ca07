//! A shape that the engine does not know: by its row scene files have it, and all renderers, the
//! explanation and the export take it.

use std::path::Path;

use a02_math::Vector3;
use a03_rays_cameras::Ray;
use a03_rays_cameras::registry::Format;
use a04_intersections::registry::{Content, SHAPES as SIMPLE, ShapeKind, ShapeRow, Shapes};
use a04_intersections::{Geometry, Hit, Interval};
use a06_shadows_reflection::registry::read_view;
use a06_shadows_reflection::traced_with;
use a07_transforms::registry::SHAPES as TRANSFORMED;
use common::Settings;
use scene_file::{Error, Item};

use crate::scene_cases::wrong_scenes;

/// The part of the plane z = 0 between two corners, which stands in the table of a box.
#[derive(Debug)]
struct Tile {
    corners: [[f64; 3]; 2],
}

impl Geometry for Tile {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let t = -ray.origin().z() / ray.direction().z();
        let p = ray.at(t);
        let [[left, low, _], [right, high, _]] = self.corners;
        let is_inside = (left..=right).contains(&p.x()) && (low..=high).contains(&p.y());
        let normal = Vector3::new(0.0, 0.0, 1.0).as_normal();
        (is_inside && within.contains(t)).then(|| Hit::new(t, normal))
    }
}

impl ShapeKind for Tile {
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let [[lbf], [run]] = [item.rows("lbf")?, item.rows("run")?];
        Ok(Self {
            corners: [lbf, run],
        })
    }

    fn content(&self) -> Content<'_> {
        let [lbf, run] = self.corners.map(|corner| corner.to_vec());
        Content::Values(vec![("lbf", lbf), ("run", run)])
    }
}

const SECTION: &str = "a04-intersections.md#one-question-and-an-interval";
const OWN: &[ShapeRow] = &[ShapeRow::of::<Tile>("box", SECTION)];
/// The first row of a table reads it.
const ALL_SHAPES: Shapes = Shapes(&[OWN, SIMPLE, TRANSFORMED]);
const FORMAT: Format = Format {
    stage: 7,
    view: |file| Ok(traced_with(read_view(file, ALL_SHAPES)?, ALL_SHAPES)),
};

#[test]
fn all_renderers_draw_it_and_its_export_is_the_same() {
    let file = Path::new("tests/scenes/own-shape.txt");
    assert_eq!(wrong_scenes(file, |path| FORMAT.open(path)), "");
}

#[test]
fn a_pixel_names_it() {
    let text = "[camera]\neye = [0, 0, 4]\ngaze = [0, 0, -1]\nangle = 60\n[[box]]\n\
        lbf = [-1, -1, 0]\nrun = [1, 1, 0]\ncolor = \"red\"\n";
    let file = FORMAT.read(text, &|_| Err("no mesh".to_owned())).unwrap();
    let trace = (FORMAT.view)(&file)
        .unwrap()
        .trace(&Settings::default(), [320, 240]);
    let mut steps = trace.steps.iter();
    let test = steps.find(|step| step.name == "object 1: Tile").unwrap();
    assert_eq!(test.outcome.to_string(), "hit");
    assert_eq!((test.number, test.section), (Some(1), SECTION));
}

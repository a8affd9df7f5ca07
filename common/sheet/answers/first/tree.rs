//! A tree by the median: nodes that own their children, and a function that descends into the nearer one first.

use std::f64::consts::FRAC_PI_4;

use crate::functions::{self, *};

pub fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    match scene {
        "tree-balls" => balls(samples).picture(&Tree::nearest),
        "tree-list" => balls(samples).picture(&in_list),
        "tree-equal" => equal(samples).picture(&Tree::nearest),
        "tree-lattice" => lattice(samples),
        "tree-count" => balls(samples).counts(),
        "tree-row" => row(samples).counts(),
        "tree-still" => still(samples),
        _ => panic!("there is no scene {scene}"),
    }
}

struct Ball {
    center: Point3,
    radius: f64,
    color: Color,
}

/// The nearest ball that a ray has met, and the number of tests so far.
struct Search<'a> {
    ray: &'a Ray,
    nearest: Option<(f64, usize)>,
    tests: u32,
}

impl Search<'_> {
    /// Where the search ends.
    fn end(&self) -> f64 {
        self.nearest.map_or(f64::INFINITY, |(t, _)| t)
    }

    fn test(&mut self, number: usize, ball: &Ball) {
        self.tests += 1;
        let Some(t) = ball.distance(self.ray) else {
            return;
        };
        let is_nearer = match self.nearest {
            None => true,
            // Of two at the same distance the first in the list counts.
            Some((least, other)) => t < least || (t == least && number < other),
        };
        if is_nearer {
            self.nearest = Some((t, number));
        }
    }
}

impl Ball {
    fn distance(&self, ray: &Ray) -> Option<f64> {
        let f = ray.origin() - self.center;
        let middle = -f.dot(ray.direction());
        let l = f + ray.direction() * middle;
        let squared = self.radius * self.radius - l.dot(l);
        let t = middle - squared.sqrt();
        (squared >= 0.0 && t > 0.0).then_some(t)
    }
}

/// A box with faces along the axes.
#[derive(Clone, Copy)]
struct Bounds {
    low: [f64; 3],
    high: [f64; 3],
}

impl Bounds {
    fn around(balls: &[Ball], numbers: &[usize]) -> Self {
        let mut bounds = Self {
            low: [f64::INFINITY; 3],
            high: [f64::NEG_INFINITY; 3],
        };
        for number in numbers {
            let ball = &balls[*number];
            for (axis, middle) in coordinates(ball.center).into_iter().enumerate() {
                bounds.low[axis] = bounds.low[axis].min(middle - ball.radius);
                bounds.high[axis] = bounds.high[axis].max(middle + ball.radius);
            }
        }
        bounds
    }

    /// Where a ray enters the box; infinity if it does not before the search ends.
    fn entry(&self, search: &mut Search<'_>) -> f64 {
        search.tests += 1;
        let (mut enters, mut leaves) = (0.0_f64, search.end());
        let origin = coordinates(search.ray.origin());
        let direction = search.ray.direction();
        let direction = [direction.x(), direction.y(), direction.z()];
        for axis in 0..3 {
            let a = (self.low[axis] - origin[axis]) / direction[axis];
            let b = (self.high[axis] - origin[axis]) / direction[axis];
            // A ray in a face divides 0 by 0: `max` and `min` pass over what is not a number.
            enters = enters.max(a.min(b));
            leaves = leaves.min(a.max(b));
        }
        // The box is as exact as its faces: rounding must not lose a ball that touches one.
        if enters <= leaves * (1.0 + 1e-12) {
            enters
        } else {
            f64::INFINITY
        }
    }
}

enum Tree {
    Leaf(Bounds, usize),
    Fork(Bounds, Box<[Tree; 2]>),
}

impl Tree {
    /// The tree of these balls, of which there is at least one.
    fn new(balls: &[Ball], numbers: &mut [usize]) -> Self {
        let bounds = Bounds::around(balls, numbers);
        if let [number] = *numbers {
            return Self::Leaf(bounds, number);
        }
        let length = |axis: &usize| bounds.high[*axis] - bounds.low[*axis];
        let lengths = [0, 1, 2].map(|axis| length(&axis));
        let longest = lengths.into_iter().fold(0.0, f64::max);
        let axis = lengths.iter().position(|l| *l == longest).unwrap_or(0);
        let half = numbers.len() / 2;
        let place = |number: &usize| coordinates(balls[*number].center)[axis];
        numbers.select_nth_unstable_by(half, |a, b| place(a).total_cmp(&place(b)));
        let (left, right) = numbers.split_at_mut(half);
        let children = [left, right].map(|part| Self::new(balls, part));
        Self::Fork(bounds, Box::new(children))
    }

    const fn bounds(&self) -> &Bounds {
        match self {
            Self::Leaf(bounds, _) | Self::Fork(bounds, _) => bounds,
        }
    }

    fn nearest(scene: &Scene, search: &mut Search<'_>) {
        if let Some(tree) = &scene.tree
            && tree.bounds().entry(search) < f64::INFINITY
        {
            tree.descend(&scene.balls, search);
        }
    }

    /// Searches a node whose box the ray enters.
    fn descend(&self, balls: &[Ball], search: &mut Search<'_>) {
        let children = match self {
            Self::Leaf(_, number) => return search.test(*number, &balls[*number]),
            Self::Fork(_, children) => children,
        };
        let [left, right] = &**children;
        let [to_left, to_right] = [left, right].map(|child| child.bounds().entry(search));
        let near_first = if to_right < to_left {
            [(to_right, right), (to_left, left)]
        } else {
            [(to_left, left), (to_right, right)]
        };
        for (enters, child) in near_first {
            // The other child is left out if it begins behind the hit.
            if enters <= search.end() && enters < f64::INFINITY {
                child.descend(balls, search);
            }
        }
    }
}

/// How the nearest ball is found.
type Finder<'a> = &'a (dyn Fn(&Scene, &mut Search<'_>) + Sync);

/// Tests every ball.
fn in_list(scene: &Scene, search: &mut Search<'_>) {
    for (number, ball) in scene.balls.iter().enumerate() {
        search.test(number, ball);
    }
}

struct Scene {
    balls: Vec<Ball>,
    tree: Option<Tree>,
    /// Whether the colour of a ball is darker where it turns away.
    shaded: bool,
}

impl Scene {
    fn new(balls: Vec<Ball>, shaded: bool) -> Self {
        let mut numbers: Vec<_> = (0..balls.len()).collect();
        let tree = (!balls.is_empty()).then(|| Tree::new(&balls, &mut numbers));
        Self {
            balls,
            tree,
            shaded,
        }
    }

    fn search<'a>(&self, ray: &'a Ray, finder: Finder<'_>) -> Search<'a> {
        let mut search = Search {
            ray,
            nearest: None,
            tests: 0,
        };
        finder(self, &mut search);
        search
    }

    fn color(&self, ray: &Ray, finder: Finder<'_>) -> Color {
        let Some((t, number)) = self.search(ray, finder).nearest else {
            return Color::gray(0.25);
        };
        let ball = &self.balls[number];
        if !self.shaded {
            return ball.color;
        }
        let cos = (ray.at(t) - ball.center).dot(ray.direction()).abs() / ball.radius;
        ball.color * cos
    }

    fn picture(&self, finder: Finder<'_>) -> Result<Image, Error> {
        let color = |ray: &Ray| self.color(ray, finder);
        functions::render(&camera()?, color, &settings(320, 240)?, &())
    }

    /// The number of tests of each ray with a box or a ball.
    fn counts(&self) -> Result<Image, Error> {
        let tests = |ray: &Ray| {
            let tests = self.search(ray, &Tree::nearest).tests;
            Color::gray(f64::from(tests) / 256.0)
        };
        functions::render(&camera()?, tests, &settings(320, 240)?, &())
    }
}

fn camera() -> Result<PerspectiveCamera, Error> {
    let eye = Point3::new(0.0, 0.0, 2.0);
    let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    Ok(PerspectiveCamera::new(eye, gaze, up, FRAC_PI_4)?)
}

fn settings(width: u32, height: u32) -> Result<Settings, Error> {
    Ok(Settings {
        size: Size::new(width, height)?,
        ..Settings::default()
    })
}

/// Balls by the rule of the sheet, which fill half of a cube.
fn balls(count: u32) -> Scene {
    let radius = 0.5 / libm::cbrt(f64::from(count));
    let mut balls = Vec::new();
    for number in 1..=count {
        let [x, y, z] = [0.819_172_513_4, 0.671_043_606_7, 0.549_700_477_9]
            .map(|step: f64| (step * f64::from(number)).fract());
        balls.push(Ball {
            center: Point3::new(x - 0.5, y - 0.5, z - 0.5),
            radius,
            color: Color::new(x, y, z),
        });
    }
    Scene::new(balls, true)
}

/// Balls that are all at the same place.
fn equal(count: u32) -> Scene {
    let colors = (0..count).map(|number| {
        if number == 0 {
            Color::GREEN
        } else {
            Color::RED
        }
    });
    let balls = colors.map(|color| Ball {
        center: Point3::ORIGIN,
        radius: 0.5,
        color,
    });
    Scene::new(balls.collect(), false)
}

/// A lattice of balls, whose layers become brighter towards the eye.
fn lattice(side: u32) -> Result<Image, Error> {
    let length = f64::from(side);
    let place = |i: u32| (f64::from(i) + 0.5) / length - 0.5;
    let mut balls = Vec::new();
    for i in 0..side.pow(3) {
        let [x, y, z] = [i % side, i / side % side, i / side / side];
        balls.push(Ball {
            center: Point3::new(place(x), place(y), place(z)),
            radius: 0.42 / length,
            color: Color::gray(f64::from(z + 1) / length),
        });
    }
    let scene = Scene::new(balls, false);
    let eye = Point3::new(0.0, 0.0, 2.0);
    let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = OrthographicCamera::new(eye, gaze, up, 1.0)?;
    let color = |ray: &Ray| scene.color(ray, &Tree::nearest);
    functions::render(&camera, color, &settings(501, 501)?, &())
}

/// Balls in a row, one behind the other.
fn row(count: u32) -> Scene {
    let balls = (0..count).map(|number| Ball {
        center: Point3::new(0.0, 0.0, -f64::from(number)),
        radius: 0.4,
        color: Color::WHITE,
    });
    Scene::new(balls.collect(), true)
}

/// The picture of the book: the seeds of a sunflower, as high as the waves of a pond, and their shadows.
fn still(count: u32) -> Result<Image, Error> {
    let seed = |number: u32| {
        let share = f64::from(number) / f64::from(count);
        let (distance, angle) = (10.0 * share.sqrt(), 2.399_963_229_7 * f64::from(number));
        let wave = libm::cos(1.7 * distance) * libm::exp(-0.14 * distance);
        let (sin, cos) = libm::sincos(angle);
        Ball {
            center: Point3::new(distance * cos, 1.3 * wave, distance * sin),
            radius: 8.5 / f64::from(count).sqrt(),
            color: Color::new(0.03, 0.2, 0.32) * (0.5 - 0.5 * wave)
                + Color::new(1.0, 0.6, 0.15) * (0.5 + 0.5 * wave),
        }
    };
    let scene = Scene::new((1..=count).map(seed).collect(), true);
    let sun = Vector3::new(-0.64, 0.48, 0.6);
    let color = |ray: &Ray| {
        let Some((t, number)) = scene.search(ray, &Tree::nearest).nearest else {
            return Color::new(0.01, 0.015, 0.03);
        };
        let ball = &scene.balls[number];
        let normal = (ray.at(t) - ball.center) * (1.0 / ball.radius);
        let above = ball.center + normal * (ball.radius * 1.0001);
        let is_dark = (scene
            .search(&Ray::derived(above, sun), &Tree::nearest)
            .nearest)
            .is_some();
        let light = if is_dark {
            0.0
        } else {
            normal.dot(sun).max(0.0)
        };
        ball.color * (1.1 * light + 0.16 + 0.08 * normal.y())
    };
    let eye = Point3::new(0.0, 6.5, 12.0);
    let gaze = Point3::new(0.0, -1.0, 0.8) - eye;
    let camera = PerspectiveCamera::new(eye, gaze, Vector3::new(0.0, 1.0, 0.0), 0.66)?;
    let settings = Settings {
        samples: 25,
        sampling: Sampling::Stratified,
        ..settings(640, 400)?
    };
    let image = functions::render(&camera, color, &settings, &())?;
    Ok(image.map(|color| color.map(|channel| Transfer::Srgb.encode(channel.min(1.0)))))
}

fn coordinates(p: Point3) -> [f64; 3] {
    [p.x(), p.y(), p.z()]
}

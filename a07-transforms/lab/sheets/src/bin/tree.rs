//! A tree by the median: nodes that own their children, and a function that descends into the nearer one first.

use answers::balls::{self, Ball, Found};
use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    if scene == "tree-still" {
        return still(samples);
    }
    let forest = Forest::new(balls::balls(scene, samples));
    balls::draw(scene, &forest.balls, |ray| match scene {
        "tree-list" => forest.search(ray, Forest::in_list),
        _ => forest.search(ray, Forest::in_tree),
    })
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
        let Some(t) = distance(ball, self.ray) else {
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

/// Where a ray meets a ball.
fn distance(ball: &Ball, ray: &Ray) -> Option<f64> {
    let f = ray.origin() - middle(ball);
    let half = -f.dot(ray.direction());
    let l = f + ray.direction() * half;
    let squared = ball.radius * ball.radius - l.dot(l);
    let t = half - squared.sqrt();
    (squared >= 0.0 && t > 0.0).then_some(t)
}

fn middle(ball: &Ball) -> Point3 {
    let [x, y, z] = ball.center;
    Point3::new(x, y, z)
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
            for (axis, middle) in ball.center.into_iter().enumerate() {
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
        let (o, d) = (search.ray.origin(), search.ray.direction());
        let (origin, direction) = ([o.x(), o.y(), o.z()], [d.x(), d.y(), d.z()]);
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
        let place = |number: &usize| balls[*number].center[axis];
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

struct Forest {
    balls: Vec<Ball>,
    tree: Option<Tree>,
}

impl Forest {
    fn new(balls: Vec<Ball>) -> Self {
        let mut numbers: Vec<_> = (0..balls.len()).collect();
        let tree = (!balls.is_empty()).then(|| Tree::new(&balls, &mut numbers));
        Self { balls, tree }
    }

    fn search(&self, ray: &Ray, finder: fn(&Self, &mut Search<'_>)) -> Found {
        let mut search = Search {
            ray,
            nearest: None,
            tests: 0,
        };
        finder(self, &mut search);
        (search.nearest, search.tests)
    }

    fn in_tree(&self, search: &mut Search<'_>) {
        if let Some(tree) = &self.tree
            && tree.bounds().entry(search) < f64::INFINITY
        {
            tree.descend(&self.balls, search);
        }
    }

    /// Tests every ball.
    fn in_list(&self, search: &mut Search<'_>) {
        for (number, ball) in self.balls.iter().enumerate() {
            search.test(number, ball);
        }
    }
}

/// The picture of the book: the seeds of a sunflower, as high as the waves of a pond, and their shadows.
fn still(count: u32) -> Result<Image, Error> {
    let seed = |number: u32| {
        let share = f64::from(number) / f64::from(count);
        let (distance, angle) = (10.0 * share.sqrt(), 2.399_963_229_7 * f64::from(number));
        let wave = libm::cos(1.7 * distance) * libm::exp(-0.14 * distance);
        let (sin, cos) = libm::sincos(angle);
        Ball {
            center: [distance * cos, 1.3 * wave, distance * sin],
            radius: 8.5 / f64::from(count).sqrt(),
            color: Color::new(0.03, 0.2, 0.32) * (0.5 - 0.5 * wave)
                + Color::new(1.0, 0.6, 0.15) * (0.5 + 0.5 * wave),
        }
    };
    let forest = Forest::new((1..=count).map(seed).collect());
    let sun = Vector3::new(-0.64, 0.48, 0.6);
    let color = |ray: &Ray| {
        let Some((t, number)) = forest.search(ray, Forest::in_tree).0 else {
            return Color::new(0.01, 0.015, 0.03);
        };
        let ball = &forest.balls[number];
        let normal = (ray.at(t) - middle(ball)) * (1.0 / ball.radius);
        let to_sun = Ray::derived(middle(ball) + normal * (ball.radius * 1.0001), sun);
        let light = match forest.search(&to_sun, Forest::in_tree).0 {
            Some(_) => 0.0,
            None => normal.dot(sun).max(0.0),
        };
        ball.color * (1.1 * light + 0.16 + 0.08 * normal.y())
    };
    let eye = Point3::new(0.0, 6.5, 12.0);
    let camera = perspective(eye, Point3::new(0.0, -1.0, 0.8) - eye, 0.66)?;
    let image = sampled_picture(&*camera, [640, 400], 25, color)?;
    Ok(for_screens(image, Transfer::Srgb))
}

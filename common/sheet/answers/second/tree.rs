//! A tree by the surface area: nodes in one list, built from a stack, and searched by a loop with a stack of its
//! own. Leaves hold up to four balls.

use std::f64::consts::FRAC_PI_4;
use std::ops::Range;

use crate::functions::*;

const LEAF: usize = 4;

pub fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    let wide = Size::new(320, 240)?;
    let up = Vector3::new(0.0, 1.0, 0.0);
    let (eye, gaze) = (Point3::new(0.0, 0.0, 2.0), Vector3::new(0.0, 0.0, -1.0));
    let perspective = PerspectiveCamera::new(eye, gaze, up, FRAC_PI_4)?;
    let by_rule = || cloud(samples);
    let at = |search: &dyn Fn(&Ray) -> Color, size| picture_of(&perspective, size, search);
    match scene {
        "tree-balls" => {
            let forest = Forest::new(by_rule());
            at(
                &|ray| shaded(&forest.balls, ray, forest.nearest(ray).0),
                wide,
            )
        }
        "tree-list" => {
            let balls = by_rule();
            at(&|ray| shaded(&balls, ray, in_list(&balls, ray)), wide)
        }
        "tree-count" | "tree-row" => {
            let forest = Forest::new(if scene == "tree-row" {
                file(samples)
            } else {
                by_rule()
            });
            at(
                &|ray| Color::gray(f64::from(forest.nearest(ray).1) / 256.0),
                wide,
            )
        }
        "tree-equal" => {
            let ball = |number| Ball {
                center: [0.0; 3],
                radius: 0.5,
                color: if number == 0 {
                    Color::GREEN
                } else {
                    Color::RED
                },
            };
            let forest = Forest::new((0..samples).map(ball).collect());
            at(&|ray| forest.flat(ray), wide)
        }
        "tree-lattice" => {
            let forest = Forest::new(crystal(samples));
            let camera = OrthographicCamera::new(eye, gaze, up, 1.0)?;
            picture_of(&camera, Size::new(501, 501)?, &|ray| forest.flat(ray))
        }
        _ => panic!("there is no scene {scene}"),
    }
}

fn picture_of(
    camera: &dyn Camera,
    size: Size,
    color: &dyn Fn(&Ray) -> Color,
) -> Result<Image, Error> {
    Image::from_fn(size, |column, row| {
        let (x, y) = camera_coordinates(size, column, row, (0.5, 0.5));
        color(&camera.ray_for(size, x, y))
    })
}

#[derive(Clone, Copy)]
struct Ball {
    center: [f64; 3],
    radius: f64,
    color: Color,
}

impl Ball {
    /// Where a ray meets the ball.
    fn t(&self, o: [f64; 3], d: [f64; 3]) -> Option<f64> {
        let to = [0, 1, 2].map(|axis| self.center[axis] - o[axis]);
        let half = dot(to, d);
        let across = [0, 1, 2].map(|axis| to[axis] - half * d[axis]);
        let squared = self.radius * self.radius - dot(across, across);
        (squared >= 0.0 && half > squared.sqrt()).then(|| half - squared.sqrt())
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn numbers_of(ray: &Ray) -> ([f64; 3], [f64; 3]) {
    let (o, d) = (ray.origin(), ray.direction());
    ([o.x(), o.y(), o.z()], [d.x(), d.y(), d.z()])
}

#[derive(Clone, Copy)]
struct Region {
    low: [f64; 3],
    high: [f64; 3],
}

impl Region {
    const EMPTY: Self = Self {
        low: [f64::INFINITY; 3],
        high: [f64::NEG_INFINITY; 3],
    };

    fn grown(self, ball: &Ball) -> Self {
        // A little larger than the ball, so that rounding loses none.
        let radius = ball.radius * 1.000_000_1;
        let low = [0, 1, 2].map(|axis| self.low[axis].min(ball.center[axis] - radius));
        let high = [0, 1, 2].map(|axis| self.high[axis].max(ball.center[axis] + radius));
        Self { low, high }
    }

    fn area(self) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|axis| (self.high[axis] - self.low[axis]).max(0.0));
        x * y + y * z + z * x
    }

    /// The part of a ray in the region, by the signs of its direction.
    fn is_entered(&self, o: [f64; 3], d: [f64; 3], nearest: f64) -> bool {
        let (mut from, mut to) = (0.0, nearest);
        for axis in 0..3 {
            if d[axis] == 0.0 {
                if o[axis] < self.low[axis] || o[axis] > self.high[axis] {
                    return false;
                }
                continue;
            }
            let is_up = d[axis] > 0.0;
            let (first, last) = if is_up {
                (self.low[axis], self.high[axis])
            } else {
                (self.high[axis], self.low[axis])
            };
            from = f64::max(from, (first - o[axis]) / d[axis]);
            to = f64::min(to, (last - o[axis]) / d[axis]);
        }
        from <= to
    }
}

/// A part of the list of balls, and the two nodes that it is divided into, unless it is a leaf.
struct Node {
    region: Region,
    balls: Range<usize>,
    children: Option<(usize, usize, usize)>,
}

/// The balls in the order of the tree, with their numbers in the list, and the nodes.
struct Forest {
    balls: Vec<Ball>,
    order: Vec<usize>,
    nodes: Vec<Node>,
}

impl Forest {
    fn new(balls: Vec<Ball>) -> Self {
        let order: Vec<_> = (0..balls.len()).collect();
        let mut forest = Self {
            balls,
            order,
            nodes: Vec::new(),
        };
        let all = forest.node(0..forest.order.len());
        let mut open = vec![all];
        while let Some(index) = open.pop() {
            let range = forest.nodes[index].balls.clone();
            let Some((axis, middle)) = forest.divide(&range) else {
                continue;
            };
            let low = forest.node(range.start..middle);
            let high = forest.node(middle..range.end);
            forest.nodes[index].children = Some((axis, low, high));
            open.extend([low, high]);
        }
        forest
    }

    fn node(&mut self, balls: Range<usize>) -> usize {
        let of = |number: &usize| &self.balls[*number];
        let numbers = &self.order[balls.clone()];
        let region = numbers.iter().map(of).fold(Region::EMPTY, Region::grown);
        self.nodes.push(Node {
            region,
            balls,
            children: None,
        });
        self.nodes.len() - 1
    }

    /// Sorts a part of the list so that the sum of area times number of both sides of a place is the least, and
    /// returns axis and place; none if the part stays a leaf.
    fn divide(&mut self, range: &Range<usize>) -> Option<(usize, usize)> {
        if range.len() <= LEAF {
            return None;
        }
        let balls = &self.balls;
        let part = &mut self.order[range.clone()];
        let mut sort = |axis: usize| {
            part.sort_by(|a, b| balls[*a].center[axis].total_cmp(&balls[*b].center[axis]));
            let grow = |region: &mut Region, number: &usize| {
                *region = region.grown(&balls[*number]);
                Some(region.area())
            };
            let left: Vec<_> = part.iter().scan(Region::EMPTY, grow).collect();
            let right: Vec<_> = part.iter().rev().scan(Region::EMPTY, grow).collect();
            let place = |number: usize| balls[number].center[axis];
            (left, right, place(part[0]) < place(part[part.len() - 1]))
        };
        // Where all middles are at one place, any halves will do.
        let mut best = (f64::INFINITY, 0, range.len() / 2);
        for axis in 0..3 {
            let (left, right, differ) = sort(axis);
            for place in 1..if differ { range.len() } else { 1 } {
                let others = range.len() - place;
                let cost = left[place - 1] * place as f64 + right[others - 1] * others as f64;
                if cost < best.0 {
                    best = (cost, axis, place);
                }
            }
        }
        let (_, axis, place) = best;
        sort(axis);
        Some((axis, range.start + place))
    }

    /// The number of the nearest ball, and how many tests found it.
    fn nearest(&self, ray: &Ray) -> (Option<(f64, usize)>, u32) {
        let (o, d) = numbers_of(ray);
        let mut nearest: Option<(f64, usize)> = None;
        let mut tests = 0;
        let mut waiting = if self.balls.is_empty() {
            vec![]
        } else {
            vec![0]
        };
        while let Some(index) = waiting.pop() {
            let node = &self.nodes[index];
            tests += 1;
            let end = nearest.map_or(f64::INFINITY, |(t, _)| t);
            if !node.region.is_entered(o, d, end) {
                continue;
            }
            if let Some((axis, low, high)) = node.children {
                // What lies in front is taken from the end of the list.
                waiting.extend(if d[axis] > 0.0 {
                    [high, low]
                } else {
                    [low, high]
                });
                continue;
            }
            for number in &self.order[node.balls.clone()] {
                tests += 1;
                if let Some(t) = self.balls[*number].t(o, d) {
                    let hit = (t, *number);
                    nearest =
                        Some(nearest.map_or(hit, |other| if hit < other { hit } else { other }));
                }
            }
        }
        (nearest, tests)
    }

    fn flat(&self, ray: &Ray) -> Color {
        let color = |(_, number): (f64, usize)| self.balls[number].color;
        self.nearest(ray).0.map_or(Color::gray(0.25), color)
    }
}

fn in_list(balls: &[Ball], ray: &Ray) -> Option<(f64, usize)> {
    let (o, d) = numbers_of(ray);
    let hits = balls
        .iter()
        .enumerate()
        .filter_map(|(number, ball)| Some((ball.t(o, d)?, number)));
    hits.reduce(|a, b| if b.0 < a.0 { b } else { a })
}

fn shaded(balls: &[Ball], ray: &Ray, nearest: Option<(f64, usize)>) -> Color {
    let Some((t, number)) = nearest else {
        return Color::gray(0.25);
    };
    let ball = &balls[number];
    let p = ray.at(t);
    let out = [p.x(), p.y(), p.z()];
    let out = [0, 1, 2].map(|axis| (out[axis] - ball.center[axis]) / ball.radius);
    ball.color * -dot(out, numbers_of(ray).1)
}

/// Balls by the rule of the sheet.
fn cloud(count: u32) -> Vec<Ball> {
    let of_number = |number: u32| {
        let share = |step: f64| (step * f64::from(number)) % 1.0;
        let place = [
            share(0.819_172_513_4),
            share(0.671_043_606_7),
            share(0.549_700_477_9),
        ];
        Ball {
            center: place.map(|x| x - 0.5),
            radius: 0.5 / libm::cbrt(f64::from(count)),
            color: Color::new(place[0], place[1], place[2]),
        }
    };
    (1..=count).map(of_number).collect()
}

/// Balls one behind the other.
fn file(count: u32) -> Vec<Ball> {
    let ball = |number: u32| Ball {
        center: [0.0, 0.0, -f64::from(number)],
        radius: 0.4,
        color: Color::WHITE,
    };
    (0..count).map(ball).collect()
}

/// Layers of balls, the last of which is white and nearest to the eye.
fn crystal(side: u32) -> Vec<Ball> {
    let mut balls = Vec::new();
    let cell = 1.0 / f64::from(side);
    for layer in 0..side {
        for (row, column) in (0..side).flat_map(|row| (0..side).map(move |column| (row, column))) {
            let center = [column, row, layer].map(|i| (f64::from(i) + 0.5) * cell - 0.5);
            balls.push(Ball {
                center,
                radius: 0.42 * cell,
                color: Color::gray(f64::from(layer + 1) * cell),
            });
        }
    }
    balls
}

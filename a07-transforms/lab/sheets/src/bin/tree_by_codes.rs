//! A tree by Morton's codes: sorted by them, the balls of each cube stand side by side (Lauterbach and others: Fast
//! BVH Construction on GPUs, 2009). Its nodes are a list, searched by a loop with a stack of its own.

use std::ops::Range;

use answers::balls::{self, Ball, Found};
use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

/// The most balls of a node that is not divided.
const LEAF: usize = 2;

fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    let balls = balls::balls(scene, samples);
    let forest = Forest::new(&balls);
    balls::draw(scene, &balls, |ray| match scene {
        "tree-list" => in_list(&balls, ray),
        _ => forest.nearest(&balls, ray),
    })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn numbers_of(ray: &Ray) -> ([f64; 3], [f64; 3]) {
    let (o, d) = (ray.origin(), ray.direction());
    ([o.x(), o.y(), o.z()], [d.x(), d.y(), d.z()])
}

/// Where a ray meets a ball.
fn t(ball: &Ball, o: [f64; 3], d: [f64; 3]) -> Option<f64> {
    let to = [0, 1, 2].map(|axis| ball.center[axis] - o[axis]);
    let half = dot(to, d);
    let across = [0, 1, 2].map(|axis| to[axis] - half * d[axis]);
    let squared = ball.radius * ball.radius - dot(across, across);
    (squared >= 0.0 && half > squared.sqrt()).then(|| half - squared.sqrt())
}

fn in_list(balls: &[Ball], ray: &Ray) -> Found {
    let (o, d) = numbers_of(ray);
    let mut nearest = None;
    for (number, ball) in balls.iter().enumerate() {
        if let Some(t) = t(ball, o, d)
            && nearest.is_none_or(|(least, _)| t < least)
        {
            nearest = Some((t, number));
        }
    }
    (nearest, balls.len() as u32)
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
        Self {
            low: [0, 1, 2].map(|axis| self.low[axis].min(ball.center[axis] - radius)),
            high: [0, 1, 2].map(|axis| self.high[axis].max(ball.center[axis] + radius)),
        }
    }

    /// Whether a ray enters it before the nearest hit.
    fn is_entered(&self, o: [f64; 3], d: [f64; 3], nearest: f64) -> bool {
        let (mut from, mut to) = (0.0, nearest);
        for axis in 0..3 {
            let faces = [self.low[axis], self.high[axis]];
            if d[axis] == 0.0 {
                if o[axis] < faces[0] || o[axis] > faces[1] {
                    return false;
                }
                continue;
            }
            let [a, b] = faces.map(|face| (face - o[axis]) / d[axis]);
            from = f64::max(from, a.min(b));
            to = f64::min(to, a.max(b));
        }
        from <= to
    }

    /// The code of a point: the bits of its coordinates, from 0 to 1023 within the region, take turns.
    fn code(&self, point: [f64; 3]) -> u32 {
        let mut code = 0;
        for (axis, x) in point.into_iter().enumerate() {
            let share = (x - self.low[axis]) / (self.high[axis] - self.low[axis]);
            let place = (share * 1024.0) as u32;
            for bit in 0..10 {
                code |= (place >> bit & 1) << (3 * bit + axis);
            }
        }
        code
    }
}

/// Balls that are side by side in the order of their codes.
struct Node {
    region: Region,
    balls: Range<usize>,
    /// The axis along which it is divided, and the node of its upper half. That of the lower half is the next one.
    fork: Option<(usize, usize)>,
}

struct Forest {
    /// Codes and numbers of the balls, sorted.
    order: Vec<(u32, usize)>,
    /// The node of all balls is the first.
    nodes: Vec<Node>,
}

impl Forest {
    fn new(balls: &[Ball]) -> Self {
        let all = balls.iter().fold(Region::EMPTY, Region::grown);
        let codes = balls.iter().map(|ball| all.code(ball.center));
        let mut order: Vec<_> = codes.zip(0..).collect();
        order.sort_unstable();
        let mut forest = Self {
            order,
            nodes: Vec::new(),
        };
        forest.grow(balls, 0..balls.len());
        forest
    }

    fn grow(&mut self, balls: &[Ball], range: Range<usize>) {
        let part = &self.order[range.clone()];
        let members = part.iter().map(|(_, number)| &balls[*number]);
        let node = self.nodes.len();
        self.nodes.push(Node {
            region: members.fold(Region::EMPTY, Region::grown),
            balls: range.clone(),
            fork: None,
        });
        let &[(first, _), .., (last, _)] = part else {
            return;
        };
        if part.len() <= LEAF || first == last {
            return;
        }
        // The highest bit in which codes differ.
        let bit = (first ^ last).ilog2();
        let lower = part.partition_point(|(code, _)| code >> bit & 1 == 0);
        let middle = range.start + lower;
        self.grow(balls, range.start..middle);
        self.nodes[node].fork = Some((bit as usize % 3, self.nodes.len()));
        self.grow(balls, middle..range.end);
    }

    fn nearest(&self, balls: &[Ball], ray: &Ray) -> Found {
        let (o, d) = numbers_of(ray);
        let mut nearest: Option<(f64, usize)> = None;
        let mut tests = 0;
        let mut waiting = vec![0];
        while let Some(index) = waiting.pop() {
            let node = &self.nodes[index];
            tests += 1;
            let end = nearest.map_or(f64::INFINITY, |(t, _)| t);
            if !node.region.is_entered(o, d, end) {
                continue;
            }
            if let Some((axis, upper)) = node.fork {
                // What lies in front is taken from the end of the list.
                waiting.extend(if d[axis] > 0.0 {
                    [upper, index + 1]
                } else {
                    [index + 1, upper]
                });
                continue;
            }
            for (_, number) in &self.order[node.balls.clone()] {
                tests += 1;
                if let Some(t) = t(&balls[*number], o, d) {
                    let hit = (t, *number);
                    nearest = Some(nearest.map_or(hit, |n| if hit < n { hit } else { n }));
                }
            }
        }
        (nearest, tests)
    }
}

//! Families of questions from a seed: the difficulties that are known, in many sizes.

use corpus::{Question, Shape, Step};

use crate::question::mixed;

/// The families that this file writes.
pub const NAMES: [&str; 10] = [
    "axis", "contact", "far", "grazing", "inside", "needle", "nested", "seam", "size", "zero",
];

/// All questions of these families.
pub fn questions() -> Vec<Question> {
    let mut all = Family::all();
    axis(&mut all);
    contact(&mut all);
    far(&mut all);
    grazing(&mut all);
    inside(&mut all);
    needle(&mut all);
    nested(&mut all);
    seam(&mut all);
    size(&mut all);
    zero(&mut all);
    all.questions
}

type Three = [f64; 3];

/// The questions so far, and random numbers.
struct Family {
    questions: Vec<Question>,
    name: &'static str,
    count: usize,
    state: u64,
}

impl Family {
    fn all() -> Self {
        Self {
            questions: Vec::new(),
            name: "",
            count: 0,
            state: 0,
        }
    }

    /// Starts a family, whose random numbers depend on its seed alone.
    fn start(&mut self, name: &'static str, seed: u64) {
        self.name = name;
        self.count = 0;
        self.state = mixed(seed);
    }

    fn ask(&mut self, says: &str, shape: Shape, ray: Ray) {
        self.ask_under(says, shape, Vec::new(), ray);
    }

    fn ask_under(&mut self, says: &str, shape: Shape, under: Vec<Step>, ray: Ray) {
        self.count += 1;
        self.questions.push(Question {
            id: format!("{}-{:02}", self.name, self.count),
            family: self.name.to_owned(),
            says: says.to_owned(),
            source: "ours".to_owned(),
            shape,
            under,
            origin: ray.origin,
            direction: ray.direction,
            within: ray.within,
        });
    }

    /// A random number, of few digits if the interval is not wide.
    fn between(&mut self, least: f64, most: f64) -> f64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let fraction = (mixed(self.state) >> 11) as f64 / (1_u64 << 53) as f64;
        ((least + (most - least) * fraction) * 1e4).round() / 1e4
    }

    fn three(&mut self, least: f64, most: f64) -> Three {
        [0; 3].map(|_| self.between(least, most))
    }
}

#[derive(Clone, Copy)]
struct Ray {
    origin: Three,
    direction: Three,
    within: [f64; 2],
}

fn ray(origin: Three, direction: Three) -> Ray {
    Ray {
        origin,
        direction,
        within: [0.0, f64::INFINITY],
    }
}

fn towards(origin: Three, target: Three) -> Ray {
    ray(origin, minus(target, origin))
}

fn plus(a: Three, b: Three, factor: f64) -> Three {
    [0, 1, 2].map(|i| a[i] + b[i] * factor)
}

fn minus(a: Three, b: Three) -> Three {
    plus(a, b, -1.0)
}

fn times(a: Three, factor: f64) -> Three {
    a.map(|x| x * factor)
}

fn cross(a: Three, b: Three) -> Three {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn unit(a: Three) -> Three {
    times(a, 1.0 / (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt())
}

/// `β b + γ c + (1 - β - γ) a`.
fn inside_of([a, b, c]: [Three; 3], beta: f64, gamma: f64) -> Three {
    plus(plus(times(a, 1.0 - beta - gamma), b, beta), c, gamma)
}

fn sphere(center: Three, radius: f64) -> Shape {
    Shape::Sphere { center, radius }
}

fn one(corners: [Three; 3]) -> Shape {
    Shape::Triangles(vec![corners])
}

const ORIGIN: Three = [0.0; 3];
const UNIT_BOX: Shape = Shape::Box {
    low: ORIGIN,
    high: [1.0; 3],
};
const HALF: [Three; 3] = [ORIGIN, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
const DOWN: Three = [0.0, 0.0, -1.0];

/// The double nearest to a power of ten.
fn ten_to(power: i32) -> f64 {
    format!("1e{power}").parse().unwrap_or(f64::NAN)
}

/// Rays along the axes, through faces, edges and corners.
fn axis(all: &mut Family) {
    all.start("axis", 1);
    for (x, y, place) in [
        (0.5, 0.25, "through the middle of two faces"),
        (0.0, 0.5, "within the plane of a low face"),
        (1.0, 0.5, "within the plane of a high face"),
        (0.0, 0.0, "along an edge"),
        (1.0, 1.0, "along the opposite edge"),
        (1.0 + 1e-9, 0.5, "1e-9 beside a face"),
        (-1e-12, 0.5, "1e-12 beside a face"),
        (
            1.0_f64.next_up(),
            0.5,
            "one unit in the last place beside a face",
        ),
    ] {
        let says = format!("A box along z, {place}.");
        all.ask(&says, UNIT_BOX, ray([x, y, 5.0], DOWN));
    }
    let flat = Shape::Box {
        low: ORIGIN,
        high: [1.0, 1.0, 0.0],
    };
    all.ask(
        "A flat box, met obliquely.",
        flat.clone(),
        ray([0.3, 0.4, 5.0], [0.1, 0.05, -5.0]),
    );
    all.ask(
        "A flat box, along its sheet.",
        flat,
        ray([-2.0, 0.5, 0.0], [1.0, 0.0, 0.0]),
    );
    for n in 0..4 {
        let low = all.three(-3.0, 0.0);
        let high = plus(low, all.three(0.5, 3.0), 1.0);
        let middle = times(plus(low, high, 1.0), 0.5);
        let axis = n % 3;
        let mut origin = middle;
        origin[axis] = low[axis] - all.between(1.0, 50.0);
        let mut direction = ORIGIN;
        direction[axis] = 1.0;
        let boxed = Shape::Box { low, high };
        all.ask(
            "A box along an axis, through the middle.",
            boxed.clone(),
            ray(origin, direction),
        );
        let side = (axis + 1) % 3;
        origin[side] = high[side];
        all.ask(
            "The same box, within the plane of a side.",
            boxed.clone(),
            ray(origin, direction),
        );
        origin[side] = high[side] + 1e-6;
        all.ask(
            "The same box, 1e-6 beside it.",
            boxed,
            ray(origin, direction),
        );
    }
    for (x, y, place) in [
        (0.25, 0.25, "inside"),
        (0.0, 0.0, "at the corner a"),
        (1.0, 0.0, "at the corner b"),
        (0.5, 0.5, "at the middle of bc"),
        (0.5, 0.0, "at the middle of ab"),
        (0.1, 0.9, "at (0.1, 0.9), which rounding puts beside bc"),
        (0.5, -1e-12, "1e-12 beside ab"),
    ] {
        let says = format!("A triangle in the plane z = 0, along z, {place}.");
        all.ask(&says, one(HALF), ray([x, y, 1.0], DOWN));
    }
    all.ask(
        "A level plane and a parallel ray above it.",
        Shape::Plane {
            point: ORIGIN,
            normal: [0.0, 1.0, 0.0],
        },
        ray([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
    );
    all.ask(
        "A ray within a level plane.",
        Shape::Plane {
            point: ORIGIN,
            normal: [0.0, 1.0, 0.0],
        },
        ray([3.0, 0.0, 0.0], [1.0, 0.0, 2.0]),
    );
}

/// Rays that start on a surface, or close to it.
fn contact(all: &mut Family) {
    all.start("contact", 2);
    let up = [0.0, 0.0, 1.0];
    let unit_sphere = || sphere(ORIGIN, 1.0);
    all.ask("On a ball, outwards.", unit_sphere(), ray(up, up));
    all.ask(
        "On a ball, inwards: the far side is the hit.",
        unit_sphere(),
        ray(up, DOWN),
    );
    all.ask(
        "A ray that touches the ball at its own origin, and nowhere else.",
        unit_sphere(),
        ray([1.0, 0.0, 0.0], up),
    );
    for (height, way, says) in [
        (
            1.0 - 1e-12,
            up,
            "1e-12 below the surface of a ball, outwards.",
        ),
        (
            1.0 + 1e-9,
            DOWN,
            "1e-9 above the surface of a ball, inwards.",
        ),
        (
            1.0 + 1e-6,
            up,
            "1e-6 above the surface of a ball, outwards.",
        ),
    ] {
        all.ask(says, unit_sphere(), ray([0.0, 0.0, height], way));
    }
    all.ask(
        "From a face of a box, outwards.",
        UNIT_BOX,
        ray([0.5, 0.5, 1.0], up),
    );
    all.ask(
        "From a face of a box, within the face.",
        UNIT_BOX,
        ray([0.5, 0.0, 0.25], [1.0, 0.0, 0.0]),
    );
    all.ask(
        "A corner of a box, which is the ray's own origin.",
        UNIT_BOX,
        ray([1.0; 3], [1.0, -1.0, 0.0]),
    );
    all.ask(
        "In a box, 5e-4 before a wall.",
        UNIT_BOX,
        ray([0.5, 0.5, 5e-4], DOWN),
    );
    all.ask(
        "From within a triangle, along its plane.",
        one(HALF),
        ray([0.25, 0.25, 0.0], [1.0, 0.0, 0.0]),
    );
    all.ask(
        "5e-4 above a triangle.",
        one(HALF),
        ray([0.25, 0.25, 5e-4], DOWN),
    );
    for (end, says) in [
        (
            4.0,
            "The interval ends at the hit, which it does not contain.",
        ),
        (4.0 + 1e-9, "The interval ends 1e-9 behind the hit."),
        (4.0 - 1e-9, "The interval ends 1e-9 before the hit."),
    ] {
        let mut short = ray([0.5, 0.5, 5.0], DOWN);
        short.within[1] = end;
        all.ask(says, UNIT_BOX, short);
    }
}

/// Shapes of usual size, seen from far away.
fn far(all: &mut Family) {
    all.start("far", 3);
    let toward = unit([1.0, 2.0, 3.0]);
    for power in [3, 5, 7, 8, 10, 12] {
        let distance = ten_to(power);
        let eye = times(toward, distance);
        let from = |what: &str| format!("{what} from 1e{power} away.");
        let (u, v) = ([2.0, -1.0, 0.0], [3.0, 6.0, -5.0]);
        let off = plus(times(unit(u), 0.3), unit(v), 0.4);
        all.ask(
            &from("A ball of radius 1, half a radius off its middle,"),
            sphere(ORIGIN, 1.0),
            ray(plus(eye, off, 1.0), times(toward, -1.0)),
        );
        all.ask(
            &from("A ball of radius 1, two radii beside it,"),
            sphere(ORIGIN, 1.0),
            ray(plus(eye, unit(u), 2.0), times(toward, -1.0)),
        );
        all.ask(
            &from("A triangle of size 2"),
            one([[1.0, 0.0, -0.5], [-1.0, 1.0, 0.25], [0.0, -1.0, 0.5]]),
            towards(eye, [0.0625, 0.03125, 0.03125]),
        );
        all.ask(
            &from("A box of size 2"),
            Shape::Box {
                low: [-1.0; 3],
                high: [1.0; 3],
            },
            towards(eye, [0.25, -0.125, 0.5]),
        );
    }
    for power in [4, 7, 9] {
        let at = ten_to(power);
        let place = [at, -0.5 * at, 0.75 * at];
        let says = format!("at about 1e{power}, seen from 5 away.");
        all.ask(
            &format!("A ball {says}"),
            sphere(place, 1.0),
            ray(plus(place, [0.5, 0.25, 5.0], 1.0), [0.0, -0.0625, -1.0]),
        );
        let corners = [[1.0, 0.0, 0.5], [-1.0, 1.0, 0.0], [0.0, -1.0, -0.5]];
        all.ask(
            &format!("A triangle {says}"),
            one(corners.map(|corner| plus(place, corner, 1.0))),
            ray(
                plus(place, [0.125, 0.0625, 5.0], 1.0),
                [-0.015_625, 0.0, -1.0],
            ),
        );
        all.ask(
            &format!("A disc {says}"),
            Shape::Disc {
                center: place,
                normal: [1.0, 2.0, 3.0],
                radius: 1.0,
            },
            ray(plus(place, [0.25, 0.125, 5.0], 1.0), [0.0, 0.03125, -1.0]),
        );
    }
}

/// Rays that almost touch a round shape, or are almost parallel to a flat one.
fn grazing(all: &mut Family) {
    all.start("grazing", 4);
    for power in [2, 4, 6, 8, 10, 12, 14] {
        let gap = ten_to(-power);
        for (height, place) in [(1.0 - gap, "inside"), (1.0 + gap, "beside")] {
            let says = format!("A ray 1e-{power} {place} the edge of a ball.");
            all.ask(
                &says,
                sphere(ORIGIN, 1.0),
                ray([-5.0, height, 0.0], [1.0, 0.0, 0.0]),
            );
        }
    }
    all.ask(
        "A ray that touches a ball.",
        sphere(ORIGIN, 1.0),
        ray([-5.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
    );
    all.ask(
        "A ray one unit in the last place inside the edge of a ball.",
        sphere(ORIGIN, 1.0),
        ray([-5.0, 1.0_f64.next_down(), 0.0], [1.0, 0.0, 0.0]),
    );
    all.ask(
        "A ray one unit in the last place beside a ball.",
        sphere(ORIGIN, 1.0),
        ray([-5.0, 1.0_f64.next_up(), 0.0], [1.0, 0.0, 0.0]),
    );
    let normal = [0.36, 0.48, 0.8];
    let along = [0.8, -0.6, 0.0];
    for power in [2, 4, 6, 8, 10, 12] {
        let slope = ten_to(-power);
        let direction = plus(along, normal, -slope);
        let origin = [1.0, -2.0, 3.0];
        all.ask(
            &format!("A plane at an angle of about 1e-{power}."),
            Shape::Plane {
                point: [0.25, 0.5, 0.125],
                normal,
            },
            ray(origin, direction),
        );
        // The ray comes down within the triangle, 3 along it.
        let start = plus([0.5, 0.25, -0.75], normal, 3.0 * slope);
        let side = [0.48, 0.64, -0.6];
        let corners = [
            [0.5, 0.25, -0.75],
            plus(plus([0.5, 0.25, -0.75], along, 6.0), side, 2.0),
            plus(plus([0.5, 0.25, -0.75], along, 6.0), side, -2.0),
        ];
        all.ask(
            &format!("A triangle at an angle of about 1e-{power}."),
            one(corners),
            ray(start, direction),
        );
    }
    for power in [3, 6, 9, 12] {
        let gap = ten_to(-power);
        for (radius, place) in [(5.0 + gap, "inside"), (5.0 - gap, "beside")] {
            all.ask(
                &format!("A disc 1e-{power} {place} its rim."),
                Shape::Disc {
                    center: ORIGIN,
                    normal: [0.0, 0.0, 1.0],
                    radius,
                },
                ray([3.0, 4.0, 2.0], DOWN),
            );
        }
    }
}

/// Rays from inside closed shapes.
fn inside(all: &mut Family) {
    all.start("inside", 5);
    for _ in 0..6 {
        let (center, radius) = (all.three(-2.0, 2.0), all.between(0.5, 4.0));
        let origin = plus(center, all.three(-0.5, 0.5), radius);
        let direction = all.three(-1.0, 1.0);
        all.ask(
            "From inside a ball.",
            sphere(center, radius),
            ray(origin, direction),
        );
    }
    for _ in 0..6 {
        let low = all.three(-3.0, 0.0);
        let high = plus(low, all.three(0.5, 3.0), 1.0);
        let origin = plus(times(low, 0.75), high, 0.25);
        let direction = all.three(-1.0, 1.0);
        all.ask(
            "From inside a box.",
            Shape::Box { low, high },
            ray(origin, direction),
        );
    }
    for radius in [1e3, 1e6, 1e9] {
        all.ask(
            &format!("A ground: from inside a ball of radius {radius:e}, 1.5 above its bottom."),
            sphere([0.0, radius, 0.0], radius),
            ray([0.25, 1.5, 0.5], [0.3, -0.9, 0.2]),
        );
        all.ask(
            &format!("A ground of radius {radius:e}, from 1.5 above it."),
            sphere([0.0, -radius, 0.0], radius),
            ray([0.25, 1.5, 0.5], [0.3, -0.9, 0.2]),
        );
    }
    for from in [[0.3, 1.0, 0.2], [-0.9, 0.5, 0.1]] {
        all.ask(
            "From inside a tube.",
            Shape::Tube {
                from: ORIGIN,
                to: [0.0, 3.0, 0.0],
                radius: 1.0,
            },
            ray(from, [0.25, 0.5, -0.4]),
        );
    }
}

/// Triangles that are almost a line.
fn needle(all: &mut Family) {
    all.start("needle", 6);
    for power in [2, 4, 6, 8, 10] {
        let width = ten_to(-power);
        let along = unit(all.three(-1.0, 1.0));
        let side = unit(cross(along, all.three(-1.0, 1.0)));
        let start = all.three(-1.0, 1.0);
        let corners = [
            start,
            plus(start, along, 1.0),
            plus(plus(start, along, 0.5), side, width),
        ];
        let target = inside_of(corners, 0.25, 0.5);
        let normal = cross(along, side);
        let oblique = plus(plus(normal, along, 0.3), side, 0.2);
        let eye = plus(target, oblique, 5.0);
        let says = |how: &str| format!("A needle of aspect 1e{power}, {how}.");
        all.ask(&says("at its middle"), one(corners), towards(eye, target));
        all.ask(
            &says("at its middle, from 1000 away"),
            one(corners),
            towards(plus(target, oblique, 1000.0), target),
        );
        let at_end = inside_of(corners, 0.9, 0.05);
        all.ask(&says("near its point"), one(corners), towards(eye, at_end));
        all.ask(
            &says("half its width beside it"),
            one(corners),
            towards(eye, plus(target, side, width)),
        );
        let straight = [ORIGIN, [1.0, 0.0, 0.0], [0.5, width, 0.0]];
        all.ask(
            &says("along an axis"),
            one(straight),
            ray([0.4375, 0.5 * width, 3.0], DOWN),
        );
    }
}

/// Shapes under steps.
fn nested(all: &mut Family) {
    all.start("nested", 7);
    for power in [1, 3, 5, 7] {
        let far = ten_to(power);
        let shift = [far, -0.5 * far, 0.25 * far];
        let there_and_back = || {
            vec![
                Step::Translate(shift),
                Step::Scale([2.0, 2.0, 2.0]),
                Step::Translate(times(shift, -0.5)),
            ]
        };
        all.ask_under(
            &format!("A ball that steps move 1e{power} away and back."),
            sphere([0.25, 0.5, -0.125], 1.0),
            there_and_back(),
            ray([0.75, 1.25, 9.0], [0.0625, -0.03125, -1.0]),
        );
        all.ask_under(
            &format!("A triangle that steps move 1e{power} away and back."),
            one([[1.0, 0.0, 0.5], [-1.0, 1.0, 0.0], [0.0, -1.0, -0.5]]),
            there_and_back(),
            ray([0.25, 0.125, 9.0], [-0.015_625, 0.0, -1.0]),
        );
    }
    for power in [1, 2, 4, 6] {
        let flat = ten_to(-power);
        all.ask_under(
            &format!("A ball that is pressed flat to 1e-{power}."),
            sphere(ORIGIN, 1.0),
            vec![Step::Scale([1.0, flat, 1.0])],
            ray([0.3, 2.0, 0.4], [0.05, -1.0, -0.1]),
        );
        all.ask_under(
            &format!("The same, from the side, close above it: 1e-{power} times 0.9."),
            sphere(ORIGIN, 1.0),
            vec![Step::Scale([1.0, flat, 1.0])],
            ray([3.0, 0.9 * flat, 0.0], [-1.0, 0.0, 0.0]),
        );
        all.ask_under(
            &format!("A box whose sides are 1 to 1e-{power}, mirrored."),
            UNIT_BOX,
            vec![
                Step::Translate([0.5, 0.25, 0.0]),
                Step::Scale([-1.0, flat, 1.0]),
            ],
            ray([0.25, 2.0, 0.5], [-0.0625, -1.0, 0.03125]),
        );
    }
    let scales = |n: u32| {
        let mut steps = Vec::new();
        for i in 0..n {
            steps.push(Step::Translate([0.1, -0.2, 0.05 * f64::from(i)]));
            steps.push(Step::Scale([1.1, 0.9, 1.05]));
        }
        steps
    };
    for n in [2, 4, 8] {
        all.ask_under(
            &format!("A ball under {n} pairs of steps."),
            sphere(ORIGIN, 1.0),
            scales(n),
            ray([0.4, -0.9, 8.0], [0.01, 0.02, -1.0]),
        );
        all.ask_under(
            &format!("A disc under {n} pairs of steps."),
            Shape::Disc {
                center: [0.1, 0.2, 0.3],
                normal: [0.2, 0.3, 1.0],
                radius: 1.5,
            },
            scales(n),
            ray([0.4, -0.9, 8.0], [0.01, 0.02, -1.0]),
        );
    }
}

/// Rays at what two triangles or more share. The nearest double to a point of an edge is beside the
/// edge, but the triangles together have no gap.
fn seam(all: &mut Family) {
    all.start("seam", 8);
    for (name, shift) in [
        ("", ORIGIN),
        (" far from the origin", [148_376.0, 1_234.0, -223_423.0]),
        (" at 1e9", [1e9, -1e9, 1e9]),
    ] {
        for n in 0..4 {
            let tetrahedron = [0; 4].map(|_| all.three(0.2, 1.0));
            let signs = [
                [1.0, 1.0, 1.0],
                [1.0, -1.0, -1.0],
                [-1.0, 1.0, -1.0],
                [-1.0, -1.0, 1.0],
            ];
            let corner = |k: usize| {
                let corner: Three = [0, 1, 2].map(|i| tetrahedron[k][i] * signs[k][i] * 4.0);
                plus(shift, corner, 1.0)
            };
            let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
            let triangles = Shape::Triangles(faces.map(|face| face.map(corner)).to_vec());
            let eye = plus(shift, all.three(-0.05, 0.05), 1.0);
            let (from, to) = (corner(n), corner((n + 1) % 4));
            let fraction = all.between(0.1, 0.9);
            let edge = plus(times(from, 1.0 - fraction), to, fraction);
            let says = |at: &str| format!("A closed tetrahedron{name}, from inside, at {at}.");
            all.ask(&says("an edge"), triangles.clone(), towards(eye, edge));
            all.ask(&says("a corner"), triangles, towards(eye, from));
        }
    }
    for corners in 3..=6_u32 {
        let mut rim = Vec::new();
        for k in 0..corners {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(corners) + 0.3;
            let height = all.between(-0.2, 0.2);
            rim.push([libm::cos(angle), libm::sin(angle), height].map(|x| (x * 1e3).round() / 1e3));
        }
        let tip = all.three(-0.1, 0.1);
        let mut fan = Vec::new();
        for k in 0..rim.len() {
            fan.push([tip, rim[k], rim[(k + 1) % rim.len()]]);
        }
        let eye = all.three(3.0, 5.0);
        let says = |at: &str| format!("A fan of {corners} triangles, at {at}.");
        all.ask(
            &says("their common corner"),
            Shape::Triangles(fan.clone()),
            towards(eye, tip),
        );
        let spoke = plus(times(tip, 0.4), rim[1], 0.6);
        all.ask(
            &says("a common edge"),
            Shape::Triangles(fan),
            towards(eye, spoke),
        );
    }
}

/// Huge and tiny scenes.
fn size(all: &mut Family) {
    all.start("size", 9);
    for power in [-99, -30, -12, -6, 6, 12, 18, 30, 99] {
        let size = ten_to(power);
        let says = |what: &str| format!("{what}, all lengths times 1e{power}.");
        all.ask(
            &says("A ball from 3 away"),
            sphere([0.25 * size, 0.5 * size, -size], size),
            ray([0.5 * size, 0.25 * size, 3.0 * size], [0.125, 0.0625, -1.0]),
        );
        all.ask(
            &says("A triangle from 1 away"),
            one([ORIGIN, [size, 0.0, 0.0], [0.0, size, 0.5 * size]]),
            ray([0.25 * size, 0.25 * size, size], [0.0625, -0.125, -1.0]),
        );
        all.ask(
            &says("A box from 2 away"),
            Shape::Box {
                low: [-0.5 * size; 3],
                high: [size; 3],
            },
            ray([0.25 * size, 0.5 * size, 3.0 * size], [0.125, 0.0625, -1.0]),
        );
    }
    for power in [-150, -20, -5, 5, 20, 150] {
        let length = ten_to(power);
        all.ask(
            &format!("A ball, along a direction of length 1e{power}."),
            sphere(ORIGIN, 1.0),
            ray([0.25, 0.5, 3.0], [0.0, 0.0, -length]),
        );
        all.ask(
            &format!("A triangle, along a direction of length 1e{power}."),
            one(HALF),
            ray([0.25, 0.25, 1.0], [0.0625 * length, 0.0, -length]),
        );
    }
}

/// Zeros of both signs, and numbers next to zero.
fn zero(all: &mut Family) {
    all.start("zero", 10);
    for (direction, says) in [
        ([-0.0, 0.0, -1.0], "a negative zero along x"),
        ([0.0, -0.0, -1.0], "a negative zero along y"),
        ([-0.0, -0.0, -1.0], "two negative zeros"),
    ] {
        all.ask(
            &format!("A ball, a direction with {says}."),
            sphere(ORIGIN, 1.0),
            ray([0.0, 0.0, 3.0], direction),
        );
        all.ask(
            &format!("A box, a direction with {says}."),
            UNIT_BOX,
            ray([0.5, 0.25, 5.0], direction),
        );
        all.ask(
            &format!("A box, a direction with {says}, within the planes of two low faces."),
            UNIT_BOX,
            ray([0.0, 0.0, 5.0], direction),
        );
        all.ask(
            &format!("A box, a direction with {says}, within the planes of two high faces."),
            UNIT_BOX,
            ray([1.0, 1.0, 5.0], direction),
        );
        all.ask(
            &format!("A triangle, a direction with {says}."),
            one(HALF),
            ray([0.25, 0.5, 1.0], direction),
        );
        all.ask(
            &format!("A box beside the ray, a direction with {says}."),
            UNIT_BOX,
            ray([2.0, 0.5, 5.0], direction),
        );
    }
    let negative = Shape::Box {
        low: [-1.0; 3],
        high: [-0.0; 3],
    };
    all.ask(
        "A box that ends at negative zeros, from a positive zero.",
        negative.clone(),
        ray([0.0, -0.5, 2.0], [0.0, 0.0, -1.0]),
    );
    all.ask(
        "The same box, through its middle.",
        negative,
        ray([-0.5, -0.25, 2.0], [-0.0, 0.0, -1.0]),
    );
    for tiny in [5e-324, 1e-310, 1e-300, 1e-200] {
        all.ask(
            &format!("A box, within the plane of a face but for a direction of {tiny:e}."),
            UNIT_BOX,
            ray([0.0, 0.5, 5.0], [tiny, 0.0, -1.0]),
        );
        all.ask(
            &format!("A box, through the middle, a direction of {tiny:e} along x."),
            UNIT_BOX,
            ray([0.5, 0.25, 5.0], [tiny, 0.0, -1.0]),
        );
    }
    all.ask(
        "A triangle with corners of negative zeros.",
        one([[-0.0; 3], [1.0, -0.0, 0.0], [-0.0, 1.0, -0.0]]),
        ray([0.25, 0.25, 1.0], DOWN),
    );
}

//! Nodes within nodes flattened: how far that moves what is hit, and what the
//! plan says of it.

use std::sync::{Arc, Mutex};

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, PixelRandom, Ray, render};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere};
use a05_lighting::{Lambert, PointLight};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld};
use a07_transforms::{Flat, Node, Transform, nodes};
use common::{ArgumentError, Bound, Color, Plan, Sampling, Settings, Size};
use measure::experiment::HALF_GREY_LEVEL;
use measure::tally::{Work, counted};

const EYE: Point3 = Point3::new(10.0, 10.0, 10.0);

fn sphere() -> Sphere {
    Sphere::new(Point3::ORIGIN, 1.0).unwrap()
}

fn cube() -> AxisAlignedBox {
    AxisAlignedBox::new(Point3::new(-1.0, -1.0, -1.0), Point3::new(1.0, 1.0, 1.0)).unwrap()
}

fn moved(x: f64) -> Transform {
    let to = Point3::new(x, 0.0, 0.0);
    Transform::IDENTITY.translate(to).unwrap()
}

fn scaled(s: f64) -> Transform {
    Transform::IDENTITY.scale(s, s, s).unwrap()
}

fn turned(angle: f64) -> Transform {
    Transform::IDENTITY.rotate_y(angle).unwrap()
}

/// A movement, turns and an uneven stretching at random.
fn anywhere(random: PixelRandom, level: u64) -> Result<Transform, ArgumentError> {
    let number = |n| 2.0 * random.uniform(10 * level + n) - 1.0;
    let factor = |n| libm::exp2(number(n));
    Transform::IDENTITY
        .translate(Point3::new(number(0), 3.0 * number(1), number(2)))?
        .rotate_x(3.0 * number(3))?
        .scale(factor(4), factor(5), -factor(6))?
        .rotate_z(3.0 * number(7))
}

/// The first transform being the outermost.
fn nested(transforms: &[Transform], leaf: impl Geometry + 'static) -> Node {
    let (innermost, others) = transforms.split_last().unwrap();
    let others = others.iter().rev();
    others.fold(Node::new(*innermost).with(leaf), |node, transform| {
        Node::new(*transform).with(node)
    })
}

/// Keeps the ray that reaches it.
#[derive(Clone, Debug, Default)]
struct Probe(Arc<Mutex<Option<Ray>>>);

impl Geometry for Probe {
    fn hit(&self, ray: &Ray, _: Interval) -> Option<Hit> {
        *self.0.lock().unwrap() = Some(*ray);
        None
    }
}

/// The ray as it reaches the probe in a geometry.
fn arrived(geometry: &impl Geometry, probe: &Probe, ray: &Ray) -> Ray {
    geometry.hit(ray, Interval::AHEAD);
    probe.0.lock().unwrap().take().unwrap()
}

/// A sum of two doubles, the second below the last digit of the first: some 30
/// digits (Dekker, A Floating-Point Technique for Extending the Available
/// Precision, 1971).
#[derive(Clone, Copy)]
struct Exact(f64, f64);

impl Exact {
    fn sum(a: f64, b: f64) -> Self {
        let s = a + b;
        let b_in_s = s - a;
        Self(s, (a - (s - b_in_s)) + (b - b_in_s))
    }

    fn plus(self, other: Self) -> Self {
        let s = Self::sum(self.0, other.0);
        Self::sum(s.0, s.1 + self.1 + other.1)
    }

    fn times(self, b: f64) -> Self {
        let halves = |x: f64| {
            let c = 134_217_729.0 * x;
            let high = c - (c - x);
            (high, x - high)
        };
        let (p, (a1, a2), (b1, b2)) = (self.0 * b, halves(self.0), halves(b));
        let rest = ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2;
        Self::sum(p, rest + self.1 * b)
    }
}

/// What the inverses make of three coordinates, `w` being 1 for a point and 0
/// for a vector.
fn exact(transforms: &[Transform], x: [f64; 3], w: f64) -> [Exact; 3] {
    let start = x.map(|x| Exact(x, 0.0));
    transforms.iter().fold(start, |x, transform| {
        let rows = transform.inverse().rows();
        std::array::from_fn(|i| {
            let row = rows[i];
            let terms = (0..3).map(|j| x[j].times(row[j]));
            terms.fold(Exact(w * row[3], 0.0), Exact::plus)
        })
    })
}

fn array(v: Vector3) -> [f64; 3] {
    v.to_glam().to_array()
}

/// Where a ray is at a place, less where it should be, in the space around all.
fn off(transforms: &[Transform], ray: &Ray, moved: &Ray, t: f64) -> f64 {
    let part = |x: Vector3, exact: [Exact; 3]| {
        let x = array(x);
        std::array::from_fn::<_, 3, _>(|i| Exact(x[i] - exact[i].0, -exact[i].1))
    };
    let from_origin = |r: &Ray| r.origin() - Point3::ORIGIN;
    let o = exact(transforms, array(from_origin(ray)), 1.0);
    let d = exact(transforms, array(ray.direction()), 0.0);
    let o = part(from_origin(moved), o);
    let d = part(moved.direction(), d);
    let x: [f64; 3] = std::array::from_fn(|i| o[i].plus(d[i].times(t)).0);
    let outwards = transforms.iter().rev();
    let x = outwards.fold(Vector3::from_glam(x.into()), |x, transform| {
        transform.matrix() * x
    });
    x.to_glam().length()
}

/// A place at most `reach` from the origin.
fn place(random: PixelRandom, first: u64, reach: f64) -> Point3 {
    let x = [0, 1, 2].map(|i| reach * (2.0 * random.uniform(first + i) - 1.0) / 3_f64.sqrt());
    Point3::new(x[0], x[1], x[2])
}

/// Against exact arithmetic: both ways to move a ray together err by less than
/// the bound, wherever it goes.
#[test]
fn a_flat_tree_is_as_near_as_it_says() {
    let mut worst = 0.0_f64;
    for n in 0..3000 {
        let random = PixelRandom::new(31, n, 0);
        let levels = u64::from(2 + n % 5);
        let mut transforms: Vec<_> = (0..levels)
            .map(|level| anywhere(random, level).unwrap())
            .collect();
        if n % 3 == 0 {
            // Far away, and back.
            transforms.insert(0, moved(1e5 / 3.0));
            transforms.push(moved(-1e5 / 3.0));
        }
        let probe = Probe::default();
        let tree = nested(&transforms, probe.clone());
        let flat = Flat::new(&tree).unwrap();
        let reach = 10.0;
        let (o, x) = (place(random, 100, reach), place(random, 110, reach));
        let ray = Ray::new(o, x - o).unwrap();
        let t = (x - o).to_glam().length();
        let error = |moved: Ray| off(&transforms, &ray, &moved, t);
        let errors = error(arrived(&tree, &probe, &ray)) + error(arrived(&flat, &probe, &ray));
        let bound = flat.shift(reach);
        assert!(errors < bound, "{errors} of {bound}, {levels} levels");
        worst = worst.max(errors / bound);
    }
    // The bound is not so large as to say nothing.
    assert!(worst > 1e-3, "{worst}");
}

/// Hits differ by the shift over the cosine, and by the roundings of the shape's
/// own formula, twice: 4 eps of the distance, in a space that is stretched by up
/// to 4 in each of the nodes.
#[test]
fn a_flat_tree_is_hit_where_the_nodes_are() {
    let mut hits = 0;
    for n in 0..20_000 {
        let random = PixelRandom::new(32, n, 0);
        let levels = 2 + n % 2;
        let transforms: Vec<_> = (0..levels.into())
            .map(|level| anywhere(random, level).unwrap())
            .collect();
        let tree = if n % 2 == 0 {
            nested(&transforms, sphere())
        } else {
            nested(&transforms, cube())
        };
        let flat = Flat::new(&tree).unwrap();
        let (o, x) = (place(random, 100, 20.0), place(random, 110, 3.0));
        let ray = Ray::new(o, x - o).unwrap();
        let [a, b] = [&tree as &dyn Geometry, &flat].map(|g| g.hit(&ray, Interval::AHEAD));
        let (Some(a), Some(b)) = (a, b) else {
            assert_eq!(a.is_some(), b.is_some(), "{ray:?}");
            continue;
        };
        let reach = (ray.at(a.t) - Point3::ORIGIN).to_glam().length().max(20.0);
        let own = 2.0 * 4.0 * f64::EPSILON * 2.0 * reach * f64::from(1 << (2 * levels));
        let cosine = a.face.dot(ray.direction()).abs();
        if cosine < 1e-2 {
            continue;
        }
        let bound = (flat.shift(reach) + own) / cosine;
        assert!((a.t - b.t).abs() < bound, "{} {} {bound}", a.t, b.t);
        hits += 1;
    }
    assert!(hits > 2000, "{hits} hits");
}

/// The digits that are lost a million away come back: flat, the sphere is hit
/// where the sphere without nodes is.
#[test]
fn far_and_back_costs_no_digits_when_it_is_flat() {
    let far = nested(&[moved(1e6), moved(-1e6)], sphere());
    let flat = Flat::new(&far).unwrap();
    let (mut hits, mut worst) = (0, 0.0_f64);
    for n in 0..2000 {
        let random = PixelRandom::new(33, n, 0);
        let (o, x) = (place(random, 0, 10.0), place(random, 10, 1.0));
        let ray = Ray::new(o, x - o).unwrap();
        let hit = |g: &dyn Geometry| g.hit(&ray, Interval::AHEAD).map(|hit| hit.t);
        let (true_t, nested_t) = (hit(&sphere()), hit(&far));
        assert_eq!(hit(&flat), true_t);
        if let (Some(a), Some(b)) = (true_t, nested_t) {
            worst = worst.max((a - b).abs());
            hits += 1;
        }
    }
    assert!(hits > 500, "{hits} hits");
    // Half a unit of 1e6 is 6e-11.
    assert!(worst > 1e-11, "{worst}");
}

/// A sun with planets that have moons, on a floor that shows their shadows.
fn orbits() -> Result<ShadowedWorld, ArgumentError> {
    let mut suns = Node::new(moved(-0.5).rotate_x(0.2)?).with(sphere());
    for planet in 0..5 {
        let angle = 1.3 * f64::from(planet);
        let place = turned(angle).translate(Point3::new(3.0, 0.0, 0.0))?;
        let mut node = Node::new(place).with(Node::new(scaled(0.5)).with(sphere()));
        for moon in 0..3 {
            let orbit = turned(2.0 * f64::from(moon)).translate(Point3::new(1.0, 0.3, 0.0))?;
            node = node.with(Node::new(orbit.scale(0.2, 0.3, 0.2)?).with(cube()));
        }
        suns = suns.with(node);
    }
    let up = Vector3::new(0.0, 1.0, 0.0).as_normal();
    let floor = Plane::new(Point3::new(0.0, -1.5, 0.0), up)?;
    let lamp = PointLight::new(Color::WHITE, Point3::new(3.0, 12.0, 5.0))?;
    Ok(ShadowedWorld::empty(Color::BLACK, Color::gray(0.1))?
        .with(suns, Box::new(Lambert::new(Color::YELLOW)?))
        .with(floor, Box::new(Lambert::new(Color::WHITE)?))
        .lit_by(LightSource::new(lamp, true)))
}

/// Within the error asked for, the picture is the same, for fewer moved rays.
#[test]
fn a_flat_world_looks_as_before() {
    let settings = Settings {
        size: Size::new(96, 72).unwrap(),
        samples: 4,
        sampling: Sampling::Regular,
        ..Settings::default()
    };
    let gaze = Point3::ORIGIN - EYE;
    let camera = PerspectiveCamera::new(EYE, gaze, Vector3::new(0.0, 1.0, 0.0), 0.7).unwrap();
    let picture = |world: ShadowedWorld| {
        let world = world.prepared([]);
        let tracer = RecursiveTracer::new(&world, true);
        let radiance = |ray: &Ray| tracer.trace(ray, 1);
        let (image, tally) = counted(|| render(&camera, radiance, &settings, &())).unwrap();
        (image.unwrap(), tally[Work::MovedRay])
    };
    let (nested, all) = picture(orbits().unwrap());
    let flat = nodes::flattened(orbits().unwrap(), EYE, HALF_GREY_LEVEL);
    let (flat, fewer) = picture(flat);
    let channels = nested.pixels().iter().zip(flat.pixels());
    let squares = channels.flat_map(|(a, b)| (*a - *b).channels().map(|c| c * c));
    let mean = squares.sum::<f64>() / (3.0 * nested.pixels().len() as f64);
    assert!(mean.sqrt() < HALF_GREY_LEVEL, "{mean}");
    // Planets lie in two nodes or three, and only the sun in one.
    assert!(2 * fewer < all, "{fewer} of {all}");
}

fn white() -> Lambert {
    Lambert::new(Color::WHITE).unwrap()
}

fn told(world: &ShadowedWorld) -> String {
    nodes::plan(Plan::default(), world, EYE).to_string()
}

#[test]
fn the_plan_tells_of_nodes() {
    let world = || {
        let inner = Node::new(turned(0.3)).with(Node::new(scaled(0.5)).with(sphere()));
        let tree = Node::new(moved(2.0))
            .with(sphere())
            .with(Node::new(scaled(2.0)).with(cube()))
            .with(inner);
        ShadowedWorld::empty(Color::BLACK, Color::WHITE)
            .unwrap()
            .with(tree, Box::new(white()))
            .with(Node::new(turned(1.0)).with(sphere()), Box::new(white()))
            .with(sphere(), Box::new(white()))
    };
    let plan = told(&world());
    for part in [
        "nodes: 5, 3 of them within others",
        "the matrix of 3 of 5 nodes: they turn nothing (same bits)",
    ] {
        assert!(plan.contains(part), "{part}: {plan}");
    }
    assert!(!plan.contains("nested"), "{plan}");

    // Flat there are one for each that has shapes, of which that in the turned
    // one turns, too.
    let plan = told(&nodes::flattened(world(), EYE, HALF_GREY_LEVEL));
    for part in [
        "nodes: 5, 3 of them within others",
        "3 nested nodes: ",
        "the matrix of 2 of 4 nodes: they turn nothing (same bits)",
        "(shapes move by less than ",
    ] {
        assert!(plan.contains(part), "{part}: {plan}");
    }

    let world = ShadowedWorld::empty(Color::BLACK, Color::WHITE).unwrap();
    let turning = Node::new(turned(1.0)).with(sphere());
    let plan = told(&world.with(turning, Box::new(white())));
    assert!(
        plan.contains("nodes: 1") && !plan.contains("the matrix of"),
        "{plan}"
    );
}

/// Two nodes: inwards they make an eighth of a length, and 1.5 / 4 + 2 of none;
/// outwards eight times as much. The plane has no end, so the eye reaches farthest.
#[test]
fn the_shift_is_what_two_roundings_make_of_both_ways() {
    let node = |x: f64, s: f64| {
        let moved = Transform::IDENTITY.translate(Point3::new(0.0, x, 0.0));
        moved.unwrap().scale(s, s, s).unwrap()
    };
    let floor = || Plane::new(Point3::ORIGIN, Vector3::new(0.0, 1.0, 0.0).as_normal()).unwrap();
    let tree = || nested(&[node(3.0, 2.0), node(8.0, 4.0)], floor());
    let flat = Flat::new(&tree()).unwrap();
    let rounding = 16.0 * f64::EPSILON * 2.0 * 8.0;
    for reach in [0.0, 1.0, 8.0] {
        assert_eq!(flat.shift(reach), rounding * (3.0 * reach / 8.0 + 2.375));
    }

    let (eye, reach) = (Point3::new(0.0, 0.0, 8.0), 8.0);
    let shift = flat.shift(reach) / reach;
    let as_much = shift * 4096.0;
    for (max_error, expected) in [
        (as_much, vec![]),
        (as_much.next_up(), vec![Bound::Shift(shift)]),
    ] {
        let world = ShadowedWorld::empty(Color::BLACK, Color::WHITE).unwrap();
        let world = nodes::flattened(world.with(tree(), Box::new(white())), eye, max_error);
        let plan = nodes::plan(Plan::default(), &world, eye);
        let bounds = plan.omissions.iter().map(|omission| omission.bound);
        let bounds: Vec<_> = bounds.filter(|bound| *bound != Bound::SameBits).collect();
        assert_eq!(bounds, expected);
    }
}

/// Nodes that move too far for the bound stay as they are, and so do trees whose
/// products would be no transform.
#[test]
fn what_flattening_would_change_too_much_stays() {
    let lit = |node| {
        let world = ShadowedWorld::empty(Color::BLACK, Color::WHITE).unwrap();
        nodes::flattened(world.with(node, Box::new(white())), EYE, HALF_GREY_LEVEL)
    };
    for (far, flat) in [(1e6, true), (1e12, false)] {
        let tree = nested(&[moved(far), moved(-far)], sphere());
        assert_eq!(told(&lit(tree)).contains("nested nodes"), flat, "{far}");
    }
    let huge = nested(&[scaled(1e-100), scaled(1e-100)], sphere());
    assert!(Flat::new(&huge).is_none());
    assert!(Flat::new(&Node::new(moved(1.0)).with(sphere())).is_none());
}

/// What the scenes of the course say; none nests nodes.
#[test]
fn the_scenes_tell_of_their_nodes() {
    for (name, straight) in [
        ("sphere-transformation", Some(true)),
        ("box-transformations", Some(false)),
        ("disc", None),
    ] {
        let stage = a07_transforms::stage();
        let scene = stage.scene(name).unwrap();
        let plan = scene.plan(&scene.defaults).unwrap().to_string();
        let matrix = "the matrix of 1 of 1 nodes: they turn nothing";
        assert_eq!(plan.contains("nodes: 1"), straight.is_some(), "{plan}");
        assert_eq!(plan.contains(matrix), straight == Some(true), "{plan}");
    }
}

//! A prepared world answers every ray as its plain list does, to the last bit.

use a02_math::{Lanes, Normal3, Point3, Vector3, Vector3x4};
use a03_rays_cameras::{Focus, PixelRandom, Ray, RayPacket};
use a04_intersections::{
    AxisAlignedBox, Bounds, Geometry, Hit, Interval, Plane, Sphere, Triangle, World,
};
use common::{Color, Plan};

/// Random numbers in a row, each from -1 to 1.
struct Numbers(PixelRandom, u64);

impl Numbers {
    fn new(seed: u64) -> Self {
        Self(PixelRandom::new(seed, 0, 0), 0)
    }

    fn next(&mut self) -> f64 {
        self.1 += 1;
        2.0 * self.0.uniform(self.1) - 1.0
    }

    fn vector(&mut self) -> Vector3 {
        Vector3::new(self.next(), self.next(), self.next())
    }
}

/// A scene of some size somewhere.
#[derive(Clone, Copy)]
struct Place {
    middle: Vector3,
    size: f64,
}

impl Place {
    fn point(self, at: Vector3) -> Point3 {
        Point3::ORIGIN + self.middle + at * self.size
    }
}

/// A world of `count` random shapes of all kinds, some of them twice and some
/// of them needles; the surface of each is its number.
fn world(seed: u64, count: usize, place: Place) -> World<usize> {
    let mut numbers = Numbers::new(seed);
    let mut world = World::new(Color::BLACK).unwrap();
    let small = 2.0 / libm::cbrt(count as f64);
    for i in 0..count {
        let at = numbers.vector();
        let (a, b) = (numbers.vector() * small, numbers.vector() * small);
        let corners = [at, at + a, at + b].map(|corner| place.point(corner));
        let [p, q, r] = corners;
        let length = place.size * small * (1.1 + numbers.next()) / 2.0;
        world = match i % 8 {
            0..3 => world.with(Sphere::new(p, length).unwrap(), i),
            3 => world.with(AxisAlignedBox::new(p, q).unwrap(), i),
            4 => world.with(Triangle::new(p, q, r).unwrap(), i),
            5 => {
                let normals = [numbers.vector(), numbers.vector(), numbers.vector()];
                let smooth = Triangle::new(p, q, r).unwrap();
                world.with(
                    smooth
                        .with_normals(normals.map(Vector3::as_normal))
                        .unwrap(),
                    i,
                )
            }
            6 => {
                // The same sphere twice: the first one counts.
                let sphere = Sphere::new(p, length).unwrap();
                world.with(sphere, i).with(sphere, count + i)
            }
            _ => {
                let near_the_line = place.point(at + a * 0.5 + b * 1e-9);
                match Triangle::new(p, q, near_the_line) {
                    Ok(needle) => world.with(needle, i),
                    Err(_) => world,
                }
            }
        };
    }
    let down = place.point(Vector3::new(0.0, -1.2, 0.0));
    world.with(
        Plane::new(down, Normal3::new(0.0, 1.0, 0.1)).unwrap(),
        2 * count,
    )
}

/// What was met: all numbers of the hit, bit by bit, and the surface.
type Met = Option<([u64; 7], usize)>;

fn met(world: &World<usize>, ray: &Ray, within: Interval) -> Met {
    world
        .hit(ray, within)
        .map(|(Hit { t, normal, face }, surface)| {
            let numbers = [
                t,
                normal.x(),
                normal.y(),
                normal.z(),
                face.x(),
                face.y(),
                face.z(),
            ];
            (numbers.map(f64::to_bits), *surface)
        })
}

/// Asks four rays together for what they meet, and for whether they meet anything:
/// as many as are in `lanes`.
fn compare_together(world: &World<usize>, rays: [&(Ray, Interval); 4], lanes: u32) {
    let search = world.search().expect("a prepared world");
    let packet = RayPacket::new(rays.map(|(ray, _)| ray));
    let hits = search.hit_together(&packet, lanes);
    let max = Lanes::new(rays.map(|(_, within)| within.max));
    let is_hit = search.is_hit_together(&packet, max, lanes);
    let t = hits.hit.t.to_array();
    let [normals, faces] = [hits.hit.normal, hits.hit.face].map(Vector3x4::to_lanes);
    for (lane, (ray, within)) in rays.into_iter().enumerate() {
        if lanes >> lane & 1 == 0 {
            continue;
        }
        let together = (hits.met >> lane & 1 != 0).then(|| {
            let ([nx, ny, nz], [fx, fy, fz]) = (normals[lane].into(), faces[lane].into());
            let numbers: [f64; 7] = [t[lane], nx, ny, nz, fx, fy, fz];
            (
                numbers.map(f64::to_bits),
                *world.surface(hits.objects[lane] as usize),
            )
        });
        assert_eq!(together, met(world, ray, Interval::AHEAD), "{ray:?}");
        let before = Interval::before(within.max);
        assert_eq!(
            is_hit >> lane & 1 != 0,
            world.is_hit(ray, before),
            "{ray:?}"
        );
    }
}

/// Asks both worlds, and returns how many rays met something.
fn compare(plain: &World<usize>, prepared: &World<usize>, rays: &[(Ray, Interval)]) -> usize {
    let mut hits = 0;
    for (ray, within) in rays {
        let expected = met(plain, ray, *within);
        assert_eq!(met(prepared, ray, *within), expected, "{ray:?}");
        assert_eq!(
            prepared.is_hit(ray, *within),
            plain.is_hit(ray, *within),
            "{ray:?}"
        );
        hits += usize::from(expected.is_some());
    }
    // Four in a row go different ways; of ten kinds, those ten apart are alike.
    for (i, forty) in rays.chunks_exact(40).enumerate() {
        let lanes = 1 + i as u32 % 15;
        for k in 0..10 {
            let four = [0, 10, 20, 30].map(|further| &forty[k + further]);
            compare_together(prepared, four, lanes);
            compare_together(prepared, four, 0b1111);
            let four = [0, 1, 2, 3].map(|further| &forty[4 * k + further]);
            compare_together(prepared, four, 0b1111);
        }
    }
    hits
}

/// Rays of all pencils, aimed at random places and at the rims of shapes, and
/// rays of none.
fn rays(
    seed: u64,
    count: usize,
    place: Place,
    eye: Point3,
    lamp: Point3,
    sun: Vector3,
) -> Vec<(Ray, Interval)> {
    let mut numbers = Numbers::new(seed);
    let mut rays = Vec::new();
    for _ in 0..count {
        let (a, b) = (
            place.point(numbers.vector()),
            place.point(numbers.vector() * 3.0),
        );
        let reach = place.size * (1.0 + numbers.next());
        let seen = Ray::new(eye, a - eye).unwrap();
        let to_lamp = lamp - a;
        let way = to_lamp.magnitude();
        rays.extend([
            (seen, Interval::AHEAD),
            (
                seen,
                Interval {
                    min: reach / 2.0,
                    max: 3.0 * reach,
                },
            ),
            (
                Ray::new(a, to_lamp).unwrap(),
                Interval::before(way * (1.0 - 1e-7)),
            ),
            (Ray::new(a, to_lamp).unwrap(), Interval::before(way / 2.0)),
            (Ray::new(b, -sun).unwrap(), Interval::AHEAD),
            (Ray::new(a, sun).unwrap(), Interval::AHEAD),
            (Ray::new(b, a - b).unwrap(), Interval::AHEAD),
            (
                Ray::new(a, numbers.vector()).unwrap(),
                Interval::before(reach),
            ),
            (
                Ray::new(a, Vector3::new(0.0, 0.0, 1.0)).unwrap(),
                Interval::AHEAD,
            ),
            (
                Ray::new(a, Vector3::new(-1.0, -0.0, -0.0)).unwrap(),
                Interval::AHEAD,
            ),
        ]);
    }
    rays
}

fn check(seed: u64, shapes: usize, count: usize, place: Place) {
    let (eye, lamp) = (
        place.point(Vector3::new(3.0, 2.0, 4.0)),
        place.point(Vector3::new(-1.0, 5.0, 2.0)),
    );
    let inside = place.point(Vector3::new(0.1, 0.2, -0.1));
    let sun = Vector3::new(-1.0, -2.0, 0.5).unit("sun").unwrap();
    let foci = [
        Focus::Point(eye),
        Focus::Point(lamp),
        Focus::Point(inside),
        Focus::Direction(sun),
    ];
    let plain = world(seed, shapes, place);
    let prepared = world(seed, shapes, place).prepared(foci);
    let hits = [(eye, lamp), (lamp, eye), (inside, inside)].map(|(eye, lamp)| {
        compare(
            &plain,
            &prepared,
            &rays(seed + 1, count, place, eye, lamp, sun),
        )
    });
    assert!(hits.iter().all(|hits| *hits > count), "{hits:?}");
}

const HERE: Place = Place {
    middle: Vector3::new(0.0, 0.0, 0.0),
    size: 1.0,
};

#[test]
fn few_and_many_shapes_are_met_as_in_the_list() {
    for (seed, shapes) in [(10, 1), (20, 5), (30, 9), (40, 60), (50, 2_000)] {
        check(seed, shapes, 20_000 / shapes.max(10), HERE);
    }
}

#[test]
fn the_size_of_a_scene_does_not_matter_nor_its_place() {
    for (seed, size) in [1e-95, 1e-40, 1e-6, 1e6, 1e40, 1e95]
        .into_iter()
        .enumerate()
    {
        check(seed as u64, 100, 300, Place { size, ..HERE });
    }
    for (seed, far) in [1e3, 1e6, 1e9, 1e13].into_iter().enumerate() {
        let middle = Vector3::new(far, -far, far);
        check(seed as u64, 100, 300, Place { middle, ..HERE });
    }
}

#[test]
fn rays_that_just_touch_are_decided_as_in_the_list() {
    let mut numbers = Numbers::new(7);
    let spheres: Vec<_> = (0..200)
        .map(|_| {
            (
                Point3::ORIGIN + numbers.vector(),
                0.05 * (1.1 + numbers.next()),
            )
        })
        .collect();
    let eye = Point3::new(4.0, 3.0, 5.0);
    let world = || {
        let empty = World::new(Color::BLACK).unwrap();
        spheres
            .iter()
            .enumerate()
            .fold(empty, |world, (i, (c, r))| {
                world.with(Sphere::new(*c, *r).unwrap(), i)
            })
    };
    let (plain, prepared) = (world(), world().prepared([Focus::Point(eye)]));
    let mut rays = Vec::new();
    for (c, r) in &spheres {
        for _ in 0..40 {
            // To a point of the sphere where the ray is at a right angle to the
            // radius, up to rounding, from the eye and from elsewhere.
            for from in [eye, Point3::ORIGIN + numbers.vector() * 3.0] {
                let way = *c - from;
                let Some(aside) = way.cross(numbers.vector()).normalized() else {
                    continue;
                };
                let nearer = r * r / way.magnitude();
                let Some(along) = way.normalized() else {
                    continue;
                };
                let aside = aside * (r * r - nearer * nearer).sqrt();
                let tangent = way - along * nearer + aside;
                rays.push((Ray::new(from, tangent).unwrap(), Interval::AHEAD));
            }
        }
    }
    let hits = compare(&plain, &prepared, &rays);
    // About half of the rays pass on the inner side.
    assert!(
        (rays.len() / 4..rays.len()).contains(&hits),
        "{hits} of {}",
        rays.len()
    );
}

#[test]
fn an_object_that_is_added_is_met() {
    let sphere = |x| Sphere::new(Point3::new(x, 0.0, 0.0), 0.5).unwrap();
    let world = World::new(Color::BLACK).unwrap().with(sphere(3.0), 0);
    let world = world
        .prepared([Focus::Point(Point3::ORIGIN)])
        .with(sphere(1.0), 1);
    let ray = Ray::new(Point3::ORIGIN, Vector3::new(1.0, 0.0, 0.0)).unwrap();
    let (_, surface) = world.hit(&ray, Interval::AHEAD).unwrap();
    assert_eq!(*surface, 1);
}

/// Two shapes under one name.
#[derive(Debug)]
struct Pair([Sphere; 2]);

impl Geometry for Pair {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let [a, b] = self.0.each_ref().map(|sphere| sphere.hit(ray, within));
        match (a, b) {
            (Some(a), Some(b)) => Some(if b.t < a.t { b } else { a }),
            (a, b) => a.or(b),
        }
    }

    fn bounds(&self) -> Bounds {
        self.0[0].bounds().union(self.0[1].bounds())
    }

    fn parts(&self) -> Option<Vec<std::sync::Arc<dyn Geometry>>> {
        let [a, b] = self.0;
        Some(vec![std::sync::Arc::new(a), std::sync::Arc::new(b)])
    }
}

#[test]
fn the_parts_of_an_object_have_its_surface() {
    let world = || {
        let empty = World::new(Color::BLACK).unwrap();
        (0..50).fold(empty, |world, i| {
            let sphere = |z: f64| Sphere::new(Point3::new(f64::from(i), 0.0, z), 0.3).unwrap();
            world.with(Pair([sphere(0.0), sphere(1.0)]), i as usize)
        })
    };
    let eye = Point3::new(25.0, 5.0, 30.0);
    let (plain, prepared) = (world(), world().prepared([Focus::Point(eye)]));
    let mut numbers = Numbers::new(3);
    let rays: Vec<_> = (0..20_000)
        .map(|_| {
            let aim = Point3::new(
                25.0 + 26.0 * numbers.next(),
                0.4 * numbers.next(),
                numbers.next(),
            );
            (Ray::new(eye, aim - eye).unwrap(), Interval::AHEAD)
        })
        .collect();
    assert!(compare(&plain, &prepared, &rays) > 1000);
}

#[test]
fn in_a_box_a_shape_has_the_same_bounds_and_parts() {
    let sphere = |x| Sphere::new(Point3::new(x, 0.0, 0.0), 0.5).unwrap();
    let pair = || Pair([sphere(0.0), sphere(3.0)]);
    let boxed: Box<dyn Geometry> = Box::new(pair());
    assert_eq!(boxed.bounds(), pair().bounds());
    assert_eq!(boxed.parts().unwrap().len(), 2);
    assert!(Box::new(sphere(0.0)).parts().is_none());
}

/// Of few shapes all are asked; more are searched, and a tree needs bounds.
#[test]
fn the_plan_tells_how_shapes_are_found() {
    let floor = || Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0)).unwrap();
    let sphere = || Sphere::new(Point3::new(0.0, 0.0, -5.0), 0.5).unwrap();
    let what = |planes: usize, spheres: usize, foci: Vec<Focus>| -> Vec<String> {
        let mut world = World::new(Color::BLACK).unwrap();
        for _ in 0..planes {
            world = world.with(floor(), ());
        }
        for _ in 0..spheres {
            world = world.with(sphere(), ());
        }
        let world = world.prepared(foci);
        let plan = world.plan(Plan::default());
        assert_eq!(plan.needs, [format!("objects: {}", planes + spheres)]);
        let plan = world.search().unwrap().plan_together(plan);
        plan.omissions.into_iter().map(|o| o.what).collect()
    };
    let eye = vec![Focus::Point(Point3::ORIGIN)];
    let beside = "questions to objects beside a ray of the eye or to a light";
    let far = "questions to objects far from any other ray";
    let tree = "a tree of bounds";
    let alone = "a search for a ray alone";
    let together = "questions to objects beside four rays of the eye or to a light";
    assert_eq!(what(0, 4, vec![]), [alone]);
    assert_eq!(what(0, 4, eye.clone()), [alone, together]);
    assert_eq!(what(0, 5, vec![]), [far]);
    assert_eq!(what(0, 5, eye.clone()), [beside, far]);
    assert_eq!(what(3, 3, eye), [beside, tree]);
    assert_eq!(what(3, 4, vec![]), [far]);

    let pair = Pair([sphere(), sphere()]);
    let world = World::new(Color::BLACK).unwrap().with(pair, ());
    let plan = world.prepared([]).plan(Plan::default());
    assert_eq!(plan.omissions[0].what, tree, "parts are searched");
}

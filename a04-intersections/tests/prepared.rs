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

/// Four rays together are told that they pass a sphere sooner than one alone is.
#[test]
fn four_rays_pass_a_sphere_by_next_to_nothing_as_one_does() {
    let mut numbers = Numbers::new(8);
    let (mut met, mut all) = (0, 0);
    for size in [1e-95, 1e-6, 1.0, 1e95] {
        for i in 0..2_400 {
            let (c, r) = (numbers.vector(), 0.55 + 0.5 * numbers.next());
            let from = c + numbers.vector() * 4.0;
            let Some(aside) = (c - from).cross(numbers.vector()).normalized() else {
                continue;
            };
            // Beside the sphere by so much of the radius; or from its surface outwards,
            // inwards or along it.
            let off = [0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-3][i / 3 % 8];
            let (from, to) = match i % 3 {
                0 => (from, c + aside * (r * (1.0 + off * numbers.next())) - from),
                1 => (c + aside * (r * (1.0 + off)), numbers.vector()),
                _ => (c + aside * r, aside.cross(numbers.vector())),
            };
            let at = |v: Vector3| Point3::ORIGIN + v * size;
            let sphere = Sphere::new(at(c), r * size).unwrap();
            let [_, prepared] = both(&[sphere], Point3::ORIGIN);
            let ray = Ray::new(at(from), to).unwrap();
            let other = Ray::derived(ray.origin(), ray.direction() * (1.0 + numbers.next()));
            for ray in [ray, other] {
                let ray = (ray, Interval::before(2.0 * size));
                compare_together(&prepared, [&ray; 4], 0b1111);
                met += usize::from(prepared.is_hit(&ray.0, Interval::AHEAD));
                all += 1;
            }
        }
    }
    assert!((all / 4..3 * all / 4).contains(&met), "{met} of {all}");
}

/// A world of these shapes, as a list and prepared for rays from the eye.
fn both<G: Geometry + Clone + 'static>(shapes: &[G], eye: Point3) -> [World<usize>; 2] {
    let world = || {
        let empty = World::new(Color::BLACK).unwrap();
        let shapes = shapes.iter().cloned().enumerate();
        shapes.fold(empty, |world, (i, shape)| world.with(shape, i))
    };
    [world(), world().prepared([Focus::Point(eye)])]
}

/// From a point to a point.
fn towards(from: Point3, to: Point3) -> (Ray, Interval) {
    (Ray::new(from, to - from).unwrap(), Interval::AHEAD)
}

/// Rounding has such a ray leave a box before it enters it.
#[test]
fn rays_through_edges_are_decided_as_in_the_list() {
    let mut numbers = Numbers::new(8);
    let corners = [(); 5].map(|()| Point3::ORIGIN + numbers.vector());
    let size = Vector3::new(0.3, 0.2, 0.1);
    let shapes = corners.map(|corner| AxisAlignedBox::new(corner, corner + size).unwrap());
    let eye = Point3::new(4.0, 3.0, 5.0);
    let [plain, prepared] = both(&shapes, eye);
    let mut rays = Vec::new();
    for i in 0..4000 {
        // An edge that can be seen from where all rays come from.
        let along = 0.5 + 0.4 * numbers.next();
        let (x, y) = [(0.3, along * 0.2), (along * 0.3, 0.2)][i % 2];
        let edge = corners[i % 5] + Vector3::new(x, y, [0.1, 0.0][i / 2 % 2]);
        let aside = numbers.vector();
        let from = Point3::new(aside.x() + 3.0, aside.y() + 3.0, aside.z());
        rays.extend([towards(eye, edge), towards(from, edge)]);
    }
    assert!(compare(&plain, &prepared, &rays) > 1000);
}

/// From so far away its corners are one point but for rounding, in any unit.
#[test]
fn triangles_far_beside_rays_are_met_by_none() {
    let mut numbers = Numbers::new(9);
    for scale in [1.0, 1.0 / (1_u64 << 60) as f64] {
        let corner = |x, y, z| Point3::ORIGIN + Vector3::new(x, y, z) * scale;
        let corners = [
            corner(0.0, 1.5, 3.0),
            corner(10.0, 0.0, 8.5),
            corner(1.0, 0.0, 0.0),
        ];
        let [a, b, c] = corners;
        let far = 9_007_199_254_740_992.0 * scale;
        let eye = Point3::ORIGIN + numbers.vector() * far;
        let [plain, prepared] = both(&[Triangle::new(a, b, c).unwrap()], eye);
        let rays: Vec<_> = (0..40_000)
            .map(|_| {
                let from = Point3::ORIGIN + numbers.vector() * far;
                let ray = Ray::new(from, numbers.vector()).unwrap();
                (ray, Interval::AHEAD)
            })
            .collect();
        compare(&plain, &prepared, &rays);
    }
}

/// From so far away that the radius is below rounding, a sphere has no normal.
#[test]
fn a_sphere_that_is_a_point_by_rounding_is_decided_as_in_the_list() {
    let centre = Point3::new(0.5, 0.25, 0.75);
    let eye = Point3::new(0.5, 0.25, 1e20);
    let [plain, prepared] = both(&[Sphere::new(centre, 1.0).unwrap()], eye);
    let mut numbers = Numbers::new(11);
    let mut rays = vec![towards(eye, centre); 40];
    for far in [1e14, 1e15, 1e16, 1e17, 1e18, 1e20] {
        rays.extend((0..200).map(|_| towards(centre + numbers.vector() * far, centre)));
    }
    let hits = compare(&plain, &prepared, &rays);
    assert!((200..rays.len()).contains(&hits), "{hits}");
}

/// The normals of two corners are opposite: half way between them is none.
#[test]
fn normals_that_cancel_are_decided_as_in_the_list() {
    let corner = |x, y| Point3::new(x, y, 0.0);
    let [up, down] = [1.0, -1.0].map(|z| Normal3::new(0.0, 0.0, z));
    let flat = Triangle::new(corner(0.0, 0.0), corner(4.0, 0.0), corner(0.0, 4.0)).unwrap();
    let smooth = flat.with_normals([up, down, up]).unwrap();
    let eye = Point3::new(2.0, 1.0, 8.0);
    let [plain, prepared] = both(&[smooth], eye);
    let rays: Vec<_> = (0..400)
        .map(|i| {
            let y = f64::from(i % 8) / 4.0;
            let x = [2.0, f64::from(i) / 200.0][usize::from(i % 4 == 1)];
            let above = Point3::new(x, y, 8.0);
            towards(above, corner(x, y))
        })
        .collect();
    assert_eq!(compare(&plain, &prepared, &rays), 400);
}

/// Cuts by area alone take only a few of them off at each level.
#[test]
fn spheres_of_all_sizes_are_met_as_in_the_list() {
    let sphere = |exponent: i32| {
        let size = libm::ldexp(1.0, exponent);
        Sphere::new(Point3::new(size, 0.0, 0.0), size / 4.0).unwrap()
    };
    let spheres: Vec<_> = (-300..=300).map(sphere).collect();
    let eye = Point3::new(-1.0, 0.0, 0.0);
    let [plain, prepared] = both(&spheres, eye);
    let ray = |exponent: i32| {
        let (from, to) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        let before = libm::ldexp(1.0, exponent);
        match exponent % 3 {
            0 => towards(Point3::new(-before, 0.0, 0.0), from),
            1 => towards(Point3::new(2.0 * before, before, 0.0), to),
            _ => towards(Point3::new(before * 1.5, 0.0, 0.0), from),
        }
    };
    let rays: Vec<_> = (-300..=300).map(ray).collect();
    assert!(compare(&plain, &prepared, &rays) > 400);
}

/// The upper faces of both boxes lie in one plane. The larger one comes nearer to the
/// eye and is asked first, wherever it stands in the list.
#[test]
fn of_two_at_the_same_place_the_first_of_the_list_counts() {
    let aab = |half: f64| {
        let low = Point3::new(-half, -half, -1.0);
        AxisAlignedBox::new(low, Point3::new(half, half, 0.0)).unwrap()
    };
    let eye = Point3::new(5.0, 0.5, 3.0);
    let mut numbers = Numbers::new(13);
    let rays: Vec<_> = (0..400)
        .map(|_| towards(eye, Point3::new(numbers.next(), numbers.next(), 0.0)))
        .collect();
    for shapes in [[aab(1.0), aab(2.0)], [aab(2.0), aab(1.0)]] {
        let [plain, prepared] = both(&shapes, eye);
        assert_eq!(compare(&plain, &prepared, &rays), 400);
        let first = |(ray, _): &_| *plain.hit(ray, Interval::AHEAD).unwrap().1 == 0;
        assert!(rays.iter().all(first));
    }
}

/// No cut parts what has its middle in one place.
#[test]
fn spheres_in_one_place_are_met_as_in_the_list() {
    let centre = Point3::new(1.0, 2.0, 3.0);
    let sphere = |i: u32| Sphere::new(centre, 1.0 + f64::from(i % 50) / 50.0).unwrap();
    let spheres: Vec<_> = (0..100).map(sphere).collect();
    let eye = Point3::new(9.0, 8.0, 7.0);
    let [plain, prepared] = both(&spheres, eye);
    let mut numbers = Numbers::new(12);
    let rays: Vec<_> = (0..1000)
        .map(|_| {
            let aim = centre + numbers.vector() * 2.0;
            towards(centre + numbers.vector() * 5.0, aim)
        })
        .collect();
    assert!(compare(&plain, &prepared, &rays) > 400);
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

/// A shape of a kind that no search knows.
#[derive(Debug)]
struct Unknown(Sphere);

impl Geometry for Unknown {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.hit(ray, within)
    }

    fn bounds(&self) -> Bounds {
        self.0.bounds()
    }
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

    let empty = World::new(Color::BLACK).unwrap();
    let world = (0..5).fold(empty, |world, _| world.with(Unknown(sphere()), ()));
    let plan = world.prepared([]).plan(Plan::default());
    assert_eq!(plan.omissions[0].what, far, "of any kind");
}

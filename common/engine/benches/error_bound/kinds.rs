//! Kinds of pictures, with variants by random numbers.

use common::{Color, Settings};
use engine::{Camera, Hit, Ray, Renderer, Shading, Shape, Surface};
use glam::{DVec3, dvec3};

use crate::support::Numbers;
use crate::support::scene::SCENES;

/// The name of a kind, an upper bound of its light, and a function that makes the variant of
/// these numbers.
pub type Kind<M = Make> = (&'static str, f64, M);
type Make = Box<dyn Fn(&mut Numbers, &Settings) -> Renderer<'static>>;
type MakePicture = fn(&mut Numbers, &Settings) -> Renderer<'static>;

/// The width of a pixel where 160 lie side by side.
const PIXEL: f64 = 1.0 / 160.0;
const SMALL: [f64; 2] = [0.1 * PIXEL, 0.8 * PIXEL];

const PICTURES: [Kind<MakePicture>; 14] = [
    ("needles", 1.0, |numbers, settings| {
        let ranges = [[3.0, 15.0], [0.2, 1.0], [0.001, 0.01]];
        let needle = |u: f64, v: f64| when(u > 0.0 && v.abs() < 1.0 - u);
        things(numbers, settings, ranges, needle)
    }),
    ("rims of spot lights", 1.0, |numbers, settings| {
        let ranges = [[1.0, 6.0], [0.005, 0.06], [0.3, 1.0]];
        let spot = |u, v| disc(u, v).map(|light| light - 0.5 * (u * u + v * v));
        things(numbers, settings, ranges, spot)
    }),
    ("flat ellipsoids", 2.0, |numbers, settings| {
        let ranges = [[2.0, 20.0], [0.02, 0.3], [0.002, 0.03]];
        things(numbers, settings, ranges, ball)
    }),
    ("foliage", 1.0, |numbers, settings| {
        let ranges = [[30.0, 90.0], [0.003, 0.08], [0.05, 0.5]];
        let leaf = |u: f64, v: f64| when(u.abs() + v.abs() < 1.0);
        things(numbers, settings, ranges, leaf)
    }),
    ("crossing wires", 1.0, |numbers, settings| {
        let ranges = [[2.0, 10.0], [1.0; 2], [0.0003, 0.0025]];
        things(numbers, settings, ranges, |_, v| when(v.abs() < 1.0))
    }),
    ("glaring highlights", 6.0, |numbers, settings| {
        let ranges = [[1.0, 30.0], [0.01, 0.2], [1.0; 2]];
        let glaring = |u, v| lit(u, v).map(|lit| lit + 5.0 * libm::pow(lit, 1000.0));
        things(numbers, settings, ranges, glaring)
    }),
    ("glints", 8.0, |numbers, settings| {
        let glint = |u, v| disc(u, v).map(|light| 8.0 * light);
        things(numbers, settings, [[1.0, 25.0], SMALL, [1.0; 2]], glint)
    }),
    ("a lone box", 1.0, |numbers, settings| {
        let square = |u: f64, v: f64| when(u.abs().max(v.abs()) < 1.0);
        things(numbers, settings, [[1.0; 2], SMALL, [1.0; 2]], square)
    }),
    ("stars and far spheres", 2.0, |numbers, settings| {
        things(numbers, settings, [[1.0, 120.0], SMALL, [1.0; 2]], ball)
    }),
    (
        "checkered floor to the horizon",
        1.0,
        |numbers, settings| {
            let (height, near) = (numbers.between(0.2, 0.5), numbers.between(0.05, 0.5));
            let ((sin, cos), colors) = (numbers.turn(), [numbers.color(), numbers.color()]);
            picture(settings, move |x, y| {
                if y >= height {
                    return Color::new(0.5, 0.6, 0.9);
                }
                let far = near / (height - y);
                let u = 4.0 * far * (x - 0.5);
                let square = (u * cos - far * sin).floor() + (u * sin + far * cos).floor();
                colors[square.rem_euclid(2.0) as usize]
            })
        },
    ),
    ("fence thinner than a pixel", 1.0, |numbers, settings| {
        let (pitch, share) = (numbers.between(0.8, 6.0), numbers.between(0.05, 0.4));
        let (slant, color) = (numbers.between(-0.2, 0.2), numbers.color());
        let (top, bottom) = (numbers.between(0.4, 0.7), numbers.between(0.05, 0.3));
        picture(settings, move |x, y| {
            let post = ((x + slant * y) / (pitch * PIXEL)).rem_euclid(1.0) < share;
            let fence = when(post && y < top && y > bottom).map(|_| color);
            fence.unwrap_or(Color::gray(0.3 + 0.4 * y))
        })
    }),
    ("almost level edges", 1.0, |numbers, settings| {
        let mut edges = numbers.list([1.0, 4.0], |numbers| {
            let slope = libm::pow(numbers.between(-0.1, 0.1), 3.0);
            (numbers.between(0.0, 0.75), slope, numbers.color())
        });
        edges.sort_by(|a, b| a.0.total_cmp(&b.0));
        picture(settings, move |x, y| {
            let above = edges.iter().find(|(low, slope, _)| y < low + slope * x);
            above.map_or(Color::gray(0.9), |(_, _, color)| *color)
        })
    }),
    ("narrowing rings", 1.0, |numbers, settings| {
        let ((left, low), rate) = (numbers.place(), numbers.between(50.0, 3000.0));
        picture(settings, move |x, y| {
            let squared = (x - left) * (x - left) + (y - low) * (y - low);
            Color::gray(0.5 + 0.5 * libm::cos(rate * squared))
        })
    }),
    ("specks in a glaring light", 40.0, |numbers, settings| {
        let speck = |u: f64, v: f64| when(u.abs().max(v.abs()) < 1.0).map(|lit| 40.0 * lit);
        let ranges = [[12.0; 2], [0.05 * PIXEL, 0.09 * PIXEL], [1.0; 2]];
        things(numbers, settings, ranges, speck)
    }),
];

/// Scenes of the benchmark `peers`, whose bounds follow from their lights and materials.
const SEEN: [&str; 11] = [
    "mirrors", "objects", "spheres", "torus", "swarm", "boxes", "discs", "nodes", "lamps", "hills",
    "hairs",
];

/// All kinds.
pub fn kinds() -> Vec<Kind> {
    let scenes = SCENES.iter().filter(|scene| SEEN.contains(&scene.name));
    // From a random place.
    let scenes = scenes.map(|scene| {
        let make: Make = Box::new(|numbers, settings| {
            let mut scene = *scene;
            scene.view[0] += numbers.in_cube(0.3);
            scene.prepare(settings)
        });
        (scene.name, f64::INFINITY, make)
    });
    let pictures = PICTURES.into_iter();
    let pictures = pictures.map(|(name, bound, make)| (name, bound, Box::new(make) as Make));
    pictures.chain(scenes).collect()
}

/// Things at random places, turned by random angles, before light that changes evenly. The
/// ranges are those of their number, their extent in one direction, and that in the other as
/// a multiple of it. The function is their brightness in units of extents, or none.
fn things(
    numbers: &mut Numbers,
    settings: &Settings,
    [count, long, flat]: [[f64; 2]; 3],
    brightness: fn(f64, f64) -> Option<f64>,
) -> Renderer<'static> {
    let [low, high] = [numbers.color() * 0.3, numbers.color()];
    let things = numbers.list(count, |numbers| {
        let extent = numbers.between(long[0], long[1]);
        let extents = [extent, extent * numbers.between(flat[0], flat[1])];
        (numbers.place(), numbers.turn(), extents, numbers.color())
    });
    picture(settings, move |x, y| {
        let mut lit = things
            .iter()
            .filter_map(|((left, bottom), (sin, cos), extents, color)| {
                let (dx, dy) = (x - left, y - bottom);
                let (along, across) = (dx * cos + dy * sin, dy * cos - dx * sin);
                Some(*color * brightness(along / extents[0], across / extents[1])?)
            });
        lit.next().unwrap_or(low * (1.0 - y) + high * (y * y))
    })
}

fn when(is_covered: bool) -> Option<f64> {
    is_covered.then_some(1.0)
}

fn disc(u: f64, v: f64) -> Option<f64> {
    when(u * u + v * v < 1.0)
}

/// The light on a ball.
fn lit(u: f64, v: f64) -> Option<f64> {
    let height = (1.0 - u * u - v * v).sqrt();
    when(height > 0.0).map(|_| (0.5 * u + 0.6 * v + 0.62 * height).max(0.0))
}

fn ball(u: f64, v: f64) -> Option<f64> {
    lit(u, v).map(|lit| 0.1 + 0.8 * lit + libm::pow(lit, 60.0))
}

impl Numbers {
    fn place(&mut self) -> (f64, f64) {
        (self.between(0.0, 1.0), self.between(0.0, 0.75))
    }

    /// Sine and cosine of any angle.
    fn turn(&mut self) -> (f64, f64) {
        libm::sincos(self.between(0.0, std::f64::consts::TAU))
    }

    fn color(&mut self) -> Color {
        let [r, g, b] = [(); 3].map(|()| self.between(0.05, 1.0));
        Color::new(r, g, b)
    }

    /// A number of things, from `least` to `most`.
    fn list<T>(&mut self, [least, most]: [f64; 2], make: impl Fn(&mut Self) -> T) -> Vec<T> {
        let count = self.between(least, most + 1.0) as u32;
        (0..count).map(|_| make(self)).collect()
    }
}

/// A scene that shows the light at each place: `x` is from 0 to 1 over the width of the
/// picture, and `y` upwards from 0 to its height, 0.75. The rays start at their places.
fn picture(
    settings: &Settings,
    light: impl Fn(f64, f64) -> Color + Send + Sync + 'static,
) -> Renderer<'static> {
    let mut scene = engine::Scene::new(Color::BLACK, Color::BLACK, 1);
    let shading = Shading::Other(Box::new(move |ray, _| light(ray.origin.x, ray.origin.y)));
    let surface = scene.add_surface(Surface::matt(shading));
    scene.add_shape(Shape::other(|_| Some(Hit::new(1.0, DVec3::Z))), surface);
    let camera = Camera::Other(Box::new(|size, x, y| {
        let [x, y] = [x, y].map(|place| (place + 0.5) / f64::from(size.width()));
        let (origin, direction) = (dvec3(x, y, 0.0), DVec3::NEG_Z);
        Ray { origin, direction }
    }));
    Renderer::new(scene, camera, settings)
}

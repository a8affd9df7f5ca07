//! Kinds of pictures, with variants by random numbers.

use common::{Color, Settings};
use engine::{Camera, Hit, Ray, Renderer, Shading, Shape, Surface};
use glam::{DVec3, dvec3};

use crate::rooms::room;
use crate::support::scene::SCENES;
use crate::support::{Numbers, numbers_in};

/// The name of a kind, an upper bound of its light, and a function that makes the variant of
/// these numbers.
pub type Kind<M = Make> = (&'static str, f64, M);
type Make = Box<dyn Fn(&mut Numbers, &Settings) -> Renderer<'static>>;
type MakePicture = fn(&mut Numbers, &Settings) -> Renderer<'static>;

/// The width of a pixel where 160 lie side by side.
const PIXEL: f64 = 1.0 / 160.0;

/// The brightness of a thing in units of its extents, or none outside of it.
fn brightness(kind: &str) -> fn(f64, f64) -> Option<f64> {
    match kind {
        "needles" => |u, v| when(u > 0.0 && v.abs() < 1.0 - u),
        "rims of spot lights" => |u, v| disc(u, v).map(|light| light - 0.5 * (u * u + v * v)),
        "foliage" => |u, v| when(u.abs() + v.abs() < 1.0),
        "crossing wires" => |_, v| when(v.abs() < 1.0),
        "glaring highlights" => |u, v| lit(u, v).map(|lit| lit + 5.0 * libm::pow(lit, 1000.0)),
        "glints" => |u, v| disc(u, v).map(|light| 8.0 * light),
        "a lone box" => square,
        "specks in a glaring light" => |u, v| square(u, v).map(|light| 40.0 * light),
        _ => ball,
    }
}

const PICTURES: [Kind<MakePicture>; 7] = [
    ("a lone shape", f64::INFINITY, |numbers, settings| {
        room(numbers, settings, [1.0, 1.0], true)
    }),
    ("few shapes", f64::INFINITY, |numbers, settings| {
        room(numbers, settings, [1.0, 4.0], false)
    }),
    (
        "few shapes and shadows",
        f64::INFINITY,
        |numbers, settings| room(numbers, settings, [2.0, 4.0], true),
    ),
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
        let (pitch, fraction) = (numbers.between(0.8, 6.0), numbers.between(0.05, 0.4));
        let (slant, color) = (numbers.between(-0.2, 0.2), numbers.color());
        let (top, bottom) = (numbers.between(0.4, 0.7), numbers.between(0.05, 0.3));
        picture(settings, move |x, y| {
            let post = ((x + slant * y) / (pitch * PIXEL)).rem_euclid(1.0) < fraction;
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
    let things = include_str!("things.md").lines().skip(2).map(|row| {
        let name = row.split(" | ").next().unwrap_or_default();
        let name = name.trim_start_matches("| ");
        let [bound, a, b, c, d, e, f] = numbers_in(row)[..].try_into().expect("7 numbers");
        let make: Make = Box::new(move |numbers, settings| {
            things(
                numbers,
                settings,
                [[a, b], [c, d], [e, f]],
                brightness(name),
            )
        });
        (name, bound, make)
    });
    let pictures = PICTURES.map(|(name, bound, make)| (name, bound, Box::new(make) as Make));
    things.chain(pictures).chain(scenes).collect()
}

/// Things at random places, turned by random angles, before light that changes evenly. The ranges
/// are those of their number, their extent in one direction, and that in the other as a multiple
/// of it.
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

fn square(u: f64, v: f64) -> Option<f64> {
    when(u.abs().max(v.abs()) < 1.0)
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

    pub fn color(&mut self) -> Color {
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

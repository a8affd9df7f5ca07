//! All cores: each thread takes the next row, and random numbers belong to a pixel.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::Duration;

use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

/// A row that a thread begins to draw.
struct Row {
    number: u32,
    /// The number of the thread, from 1.
    thread: u32,
    /// How many threads are drawing a row, this one included.
    drawing: u32,
}

/// A picture whose rows are drawn by as many threads.
fn draw(
    size: Size,
    threads: u32,
    paint: impl Fn(&Row, &mut [Color]) + Sync,
) -> Result<Image, Error> {
    let mut image = Image::black(size)?;
    let width = size.width() as usize;
    // The rows that a thread takes at a time.
    let taken = 1;
    let parts = image.pixels_mut().chunks_mut(taken * width).enumerate();
    let parts = Mutex::new(parts);
    let drawing = AtomicU32::new(0);
    thread::scope(|scope| {
        for thread in 1..=threads {
            let (parts, drawing, paint) = (&parts, &drawing, &paint);
            scope.spawn(move || {
                // The lock is open again at the end of this expression, before the row is drawn.
                let take = || parts.lock().expect("no thread panics").next();
                while let Some((part, pixels)) = take() {
                    for (row, pixels) in pixels.chunks_mut(width).enumerate() {
                        let others = drawing.fetch_add(1, Ordering::Relaxed);
                        let row = Row {
                            number: (part * taken + row) as u32,
                            thread,
                            drawing: others + 1,
                        };
                        paint(&row, pixels);
                        drawing.fetch_sub(1, Ordering::Relaxed);
                    }
                }
            });
        }
    });
    Ok(image)
}

/// Each pixel is the mean of 64 random numbers.
fn noise(threads: u32) -> Result<Image, Error> {
    let size = Size::new(300, 200)?;
    draw(size, threads, |row, pixels| {
        for (column, pixel) in (0..).zip(pixels) {
            let random = PixelRandom::new(seed(), column, row.number);
            let sum: f64 = (0..64).map(|i| random.uniform(i)).sum();
            *pixel = Color::gray(sum / 64.0);
        }
    })
}

/// Row y from below takes y milliseconds. Red says which thread has drawn it, and green how many were drawing.
fn load(threads: u32) -> Result<Image, Error> {
    let size = Size::new(100, 100)?;
    draw(size, threads, |row, pixels| {
        thread::sleep(Duration::from_millis((size.height() - row.number).into()));
        let of_all = |count: u32| f64::from(count) / f64::from(threads);
        pixels.fill(Color::new(of_all(row.thread), of_all(row.drawing), 0.0));
    })
}

/// A planet with a ring of dust, before stars.
struct Night {
    planet: Sphere,
    ring: Plane,
    sun: Vector3,
}

impl Night {
    /// The light along a ray, if it meets anything; `dust` is a random number.
    fn light_along(&self, ray: &Ray, dust: f64) -> Option<Color> {
        let planet = self.planet.hit(ray, Interval::AHEAD);
        let ring = self.ring.hit(ray, Interval::AHEAD);
        let t = |hit: &Option<Hit>| hit.as_ref().map_or(f64::INFINITY, |hit| hit.t);
        if t(&ring) < t(&planet) {
            let place = ray.at(t(&ring));
            let distance = (place - Point3::ORIGIN).magnitude();
            let density = 0.55 + 0.35 * libm::sin(21.0 * distance);
            if (1.3..2.2).contains(&distance) && dust < density {
                let to_sun = Ray::derived(place, self.sun);
                let is_lit = self.planet.hit(&to_sun, Interval::AHEAD).is_none();
                return Some(Color::new(0.75, 0.66, 0.55) * if is_lit { 1.0 } else { 0.03 });
            }
        }
        planet.map(|hit| {
            let n = Vector3::from(hit.geometric_normal);
            let bands = 0.8 + 0.2 * libm::sin(9.0 * n.y());
            Color::new(0.9, 0.62, 0.36) * (bands * n.dot(self.sun).max(0.0))
        })
    }
}

/// The picture of a tracer, with random rays and stars at random.
fn night(size: Size, samples: u32, threads: u32) -> Result<Image, Error> {
    let axis = Vector3::new(0.3, 1.0, 0.15);
    let sun = Vector3::new(-0.75, 0.3, 0.6);
    let night = Night {
        planet: Sphere::new(Point3::ORIGIN, 1.0)?,
        ring: Plane::new(Point3::ORIGIN, axis.as_normal())?,
        sun: sun * (1.0 / sun.magnitude()),
    };
    let eye = Point3::new(0.0, 1.0, 6.0);
    let camera = perspective(eye, Point3::ORIGIN - eye, 0.62)?;
    draw(size, threads, |row, pixels| {
        for (column, pixel) in (0..).zip(pixels) {
            // A star may be in the middle of 5 by 5 pixels.
            let star = PixelRandom::new(seed(), column / 5, row.number / 5).uniform(1000);
            let [right, down] = [column, row.number].map(|at| f64::from(at % 5) - 2.0);
            let glow = libm::exp(-0.7 * (right * right + down * down));
            let background = 4.0 * libm::pow(star, 400.0) * glow;
            let random = PixelRandom::new(seed(), column, row.number);
            let mut sum = Color::BLACK;
            for i in 0..u64::from(samples) {
                let [x, y, dust] = [0, 1, 2].map(|k| random.uniform(3 * i + k));
                let (x, y) = camera_coordinates(size, column, row.number, (x, y));
                let ray = camera.ray_for(size, x, y);
                sum += night
                    .light_along(&ray, dust)
                    .unwrap_or(Color::gray(background));
            }
            *pixel = sum * (1.0 / f64::from(samples));
        }
    })
}

fn render(name: &str, threads: u32) -> Result<Image, Error> {
    match name {
        "cores-load" => load(threads),
        "cores-picture" => night(Size::new(300, 200)?, 64, threads),
        "cores-still" => {
            let image = night(Size::new(640, 400)?, 16, threads)?;
            Ok(for_screens(image, Transfer::Gamma))
        }
        _ => noise(threads),
    }
}

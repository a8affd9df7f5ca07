//! Glass by a list of rays that wait: the refractive index is a function of the place, asked a little before
//! and behind each surface, and both laws are those of angles.

use std::f64::consts::FRAC_PI_2;

use crate::functions::*;
use crate::workbench::*;

const STEP: f64 = 1e-7;

/// A surface that a ray may cross.
#[derive(Clone, Copy)]
enum Border {
    /// The plane of this z.
    Level(f64),
    /// The ball of this radius around the origin.
    Round(f64),
}

/// Glass in front of a wall, which shines.
struct Room {
    borders: &'static [Border],
    index: fn(Point3) -> f64,
    /// The light of the wall at z = -3, if there is one.
    wall: Option<fn(Point3) -> Color>,
    sky: fn(Vector3) -> Color,
}

/// A ray that waits, its share of the pixel, and how many rays its path may still have.
struct Waiting {
    ray: Ray,
    share: f64,
    left: u32,
}

const PLATE: Room = Room {
    borders: &[Border::Level(0.0), Border::Level(-1.0)],
    index: |p| {
        if p.z() < 0.0 && p.z() > -1.0 {
            1.5
        } else {
            1.0
        }
    },
    wall: Some(|p| white_if(p.x() < 0.0) * Color::RED + Color::BLUE * 0.4),
    sky: |_| Color::new(0.0, 1.0, 0.4),
};

const BRIGHT_PLATE: Room = Room {
    wall: Some(|p| white_if(p.x() < 0.0) * Color::RED * 5000.0),
    ..PLATE
};

const POOL: Room = Room {
    borders: &[Border::Level(0.0)],
    index: |p| if p.z() < 0.0 { 1.5 } else { 1.0 },
    wall: Some(|_| Color::RED),
    sky: |_| Color::GREEN,
};

const BALL: Room = Room {
    borders: &[Border::Round(1.0)],
    index: |p| if distance(p) < 1.0 { 1.5 } else { 1.0 },
    wall: None,
    sky: |d| white_if(d.y() > -0.5),
};

const BUBBLE: Room = Room {
    borders: &[Border::Round(1.0), Border::Round(0.5)],
    index: |p| {
        if distance(p) < 1.0 && distance(p) > 0.5 {
            1.5
        } else {
            1.0
        }
    },
    ..BALL
};

fn distance(p: Point3) -> f64 {
    (p - Point3::ORIGIN).magnitude()
}

pub fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    let side = if matches!(scene, "glass-ball" | "glass-bubble") {
        251
    } else {
        301
    };
    let eye = Point3::new(0.0, 0.0, 5.0);
    let below = Point3::new(0.0, 0.0, -1.0);
    let (room, camera) = match scene {
        "glass-plate-0" | "glass-count" => (PLATE, aslant(0.0)?),
        "glass-plate-45" => (PLATE, aslant(45.0)?),
        "glass-plate-80" => (PLATE, aslant(80.0)?),
        "glass-grazing" => (BRIGHT_PLATE, aslant(89.9)?),
        "glass-ball" => (BALL, parallel(eye, AHEAD, 2.5)?),
        "glass-bubble" => (BUBBLE, parallel(eye, AHEAD, 2.5)?),
        "glass-window" => (POOL, perspective(below, -AHEAD, FRAC_PI_2)?),
        _ => panic!("there is no scene {scene}"),
    };
    picture(&*camera, [side, side], |ray| {
        let (light, rays) = follow(&room, *ray, samples);
        match scene {
            "glass-count" => Color::gray(f64::from(rays) / 64.0),
            _ => light,
        }
    })
}

fn aslant(degrees: f64) -> Result<Box<dyn Camera>, Error> {
    let angle = degrees.to_radians();
    let eye = Point3::new(-6.0 * libm::tan(angle), 0.0, 3.0);
    let gaze = Vector3::new(libm::sin(angle), 0.0, -libm::cos(angle));
    parallel(eye, gaze, 3.0)
}

/// The light along a ray, and the number of rays that were followed.
fn follow(room: &Room, ray: Ray, depth: u32) -> (Color, u32) {
    let (mut light, mut rays) = (Color::BLACK, 0);
    let mut waiting = vec![Waiting {
        ray,
        share: 1.0,
        left: depth,
    }];
    while let Some(Waiting { ray, share, left }) = waiting.pop() {
        rays += 1;
        let border = room.nearest(&ray);
        let (origin, d) = (ray.origin(), ray.direction());
        let to_wall = (-3.0 - origin.z()) / d.z();
        if let Some(wall) = room.wall
            && to_wall > 0.0
            && border.is_none_or(|(t, _)| to_wall < t)
        {
            light += wall(ray.at(to_wall)) * share;
            continue;
        }
        let Some((t, border)) = border else {
            light += (room.sky)(d) * share;
            continue;
        };
        let p = ray.at(t);
        let normal = border.normal(p, d);
        let before = (room.index)(p + normal * STEP);
        let behind = (room.index)(p - normal * STEP);
        for (direction, part) in divide(d, normal, before, behind) {
            if share * part >= 1e-6 && left > 1 {
                waiting.push(Waiting {
                    ray: Ray::derived(p, direction),
                    share: share * part,
                    left: left - 1,
                });
            }
        }
    }
    (light, rays)
}

/// The mirrored and the refracted direction, and the share of each.
fn divide(d: Vector3, normal: Vector3, before: f64, behind: f64) -> [(Vector3, f64); 2] {
    let cos = -d.dot(normal);
    let along = d + normal * cos;
    let mirrored = along + normal * cos;
    let sin = along.magnitude();
    let sin_behind = sin * before / behind;
    if sin_behind >= 1.0 {
        return [(mirrored, 1.0), (d, 0.0)];
    }
    if sin < 1e-6 {
        let amplitude = (before - behind) / (before + behind);
        let share = amplitude * amplitude;
        return [(mirrored, share), (d, 1.0 - share)];
    }
    let (a, b) = (libm::atan2(sin, cos), libm::asin(sin_behind));
    let across = libm::sin(a - b) / libm::sin(a + b);
    let in_plane = libm::tan(a - b) / libm::tan(a + b);
    let share = f64::midpoint(across * across, in_plane * in_plane);
    let refracted = along * (sin_behind / sin) - normal * libm::cos(b);
    [(mirrored, share), (refracted, 1.0 - share)]
}

impl Room {
    /// The nearest border ahead.
    fn nearest(&self, ray: &Ray) -> Option<(f64, Border)> {
        let mut nearest: Option<(f64, Border)> = None;
        for border in self.borders {
            for t in border.crossings(ray) {
                if t > STEP && nearest.is_none_or(|(least, _)| t < least) {
                    nearest = Some((t, *border));
                }
            }
        }
        nearest
    }
}

impl Border {
    /// Where a ray crosses it; not a number where it does not.
    fn crossings(self, ray: &Ray) -> [f64; 2] {
        match self {
            Self::Level(z) => [(z - ray.origin().z()) / ray.direction().z(); 2],
            Self::Round(radius) => {
                let from_middle = ray.origin() - Point3::ORIGIN;
                let half = from_middle.dot(ray.direction());
                let root = (half * half - from_middle.dot(from_middle) + radius * radius).sqrt();
                [-half - root, -half + root]
            }
        }
    }

    /// The normal on the side that the ray comes from.
    fn normal(self, p: Point3, d: Vector3) -> Vector3 {
        let normal = match self {
            Self::Level(_) => Vector3::new(0.0, 0.0, 1.0),
            Self::Round(radius) => (p - Point3::ORIGIN) * (1.0 / radius),
        };
        if normal.dot(d) > 0.0 { -normal } else { normal }
    }
}

//! The balls of the sheet of the tree, by its rules, and their pictures by any search for the nearest one.

use crate::*;

pub struct Ball {
    pub center: [f64; 3],
    pub radius: f64,
    pub color: Color,
}

/// The distance and the number of the nearest ball, and the number of tests that found it.
pub type Found = (Option<(f64, usize)>, u32);

/// The balls of a scene, of which there are `count`; of a lattice along each side.
pub fn balls(scene: &str, count: u32) -> Vec<Ball> {
    match scene {
        "tree-lattice" => (0..count.pow(3)).map(|i| of_lattice(i, count)).collect(),
        "tree-row" => (0..count).map(of_row).collect(),
        "tree-equal" => (0..count).map(equal).collect(),
        _ => (1..=count).map(|i| of_cloud(i, count)).collect(),
    }
}

/// Balls fill half of a cube.
fn of_cloud(number: u32, count: u32) -> Ball {
    let steps = [0.819_172_513_4, 0.671_043_606_7, 0.549_700_477_9];
    let [x, y, z] = steps.map(|step: f64| (step * f64::from(number)).fract());
    Ball {
        center: [x - 0.5, y - 0.5, z - 0.5],
        radius: 0.5 / libm::cbrt(f64::from(count)),
        color: Color::new(x, y, z),
    }
}

/// Layers become brighter towards the eye.
fn of_lattice(number: u32, side: u32) -> Ball {
    let place = [number % side, number / side % side, number / side / side];
    let length = f64::from(side);
    Ball {
        center: place.map(|i| (f64::from(i) + 0.5) / length - 0.5),
        radius: 0.42 / length,
        color: Color::gray(f64::from(place[2] + 1) / length),
    }
}

/// One behind the other.
fn of_row(number: u32) -> Ball {
    Ball {
        center: [0.0, 0.0, -f64::from(number)],
        radius: 0.4,
        color: Color::WHITE,
    }
}

/// All at the same place, and the first one green.
fn equal(number: u32) -> Ball {
    Ball {
        center: [0.0; 3],
        radius: 0.5,
        color: if number == 0 {
            Color::GREEN
        } else {
            Color::RED
        },
    }
}

/// The picture of a scene: its balls, or how many tests each ray takes.
pub fn draw(
    scene: &str,
    balls: &[Ball],
    search: impl Fn(&Ray) -> Found + Sync,
) -> Result<Image, Error> {
    let eye = Point3::new(0.0, 0.0, 2.0);
    let (camera, size) = match scene {
        "tree-lattice" => (parallel(eye, AHEAD, 1.0)?, [501, 501]),
        _ => (perspective(eye, AHEAD, FRAC_PI_4)?, [320, 240]),
    };
    picture(&*camera, size, |ray| {
        let (nearest, tests) = search(ray);
        if let "tree-count" | "tree-row" = scene {
            return Color::gray(f64::from(tests) / 256.0);
        }
        let Some((t, number)) = nearest else {
            return Color::gray(0.25);
        };
        let ball = &balls[number];
        match scene {
            "tree-balls" | "tree-list" => {
                // Darker where it turns away.
                let [x, y, z] = ball.center;
                let out = ray.at(t) - Point3::new(x, y, z);
                ball.color * (out.dot(ray.direction()).abs() / ball.radius)
            }
            _ => ball.color,
        }
    })
}

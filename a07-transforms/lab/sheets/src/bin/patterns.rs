//! Patterns by many rays through each pixel: a pattern is a function from two numbers to a colour.

use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

const SKY: Color = Color::new(0.3, 0.5, 0.9);

/// The colour at two coordinates on a surface.
type Pattern = fn(f64, f64) -> Color;

fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    match scene {
        "patterns-floor" => floor(0.0, samples),
        "patterns-far" => floor(-3e9, samples),
        "patterns-ball" => ball(5.0, samples, chessboard_on_ball),
        "patterns-picture" => ball(-5.0, samples, picture_on_ball),
        "patterns-count" => count(samples),
        "patterns-still" => still(samples),
        _ => panic!("there is no scene {scene}"),
    }
}

/// Black and white by turns, in fields of length 1: the first to the right of 0 is black.
fn stripes(x: f64) -> bool {
    x.floor().rem_euclid(2.0) == 1.0
}

fn chessboard(x: f64, y: f64) -> Color {
    white_if(stripes(x) != stripes(y))
}

fn chessboard_on_ball(longitude: f64, latitude: f64) -> Color {
    let field = TAU / 10.0;
    chessboard(longitude / field, latitude / field)
}

/// The picture of the sheet, 8 by 4 pixels, around the ball: its left edge is at the back.
fn picture_on_ball(longitude: f64, latitude: f64) -> Color {
    let (columns, rows) = (8_u8, 4_u8);
    let across = (longitude / TAU + 0.5) * f64::from(columns);
    let down = (0.5 - latitude / PI) * f64::from(rows);
    // The last column ends at 8, which is no column.
    let column = (across.floor() as u8).min(columns - 1);
    let row = (down.floor() as u8).min(rows - 1);
    Color::new(f64::from(column + 1) / 8.0, f64::from(row + 1) / 4.0, 0.0)
}

fn floor(x: f64, samples: u32) -> Result<Image, Error> {
    sampled_picture(&*floor_camera(x)?, [320, 240], samples, floor_color)
}

fn floor_camera(x: f64) -> Result<Box<dyn Camera>, Error> {
    perspective(Point3::new(x, 8.0, 0.0), AHEAD, FRAC_PI_2)
}

/// The chessboard on the plane y = 0, or the sky.
fn floor_color(ray: &Ray) -> Color {
    let t = -ray.origin().y() / ray.direction().y();
    if t > 0.0 {
        let p = ray.at(t);
        chessboard(p.x(), p.z())
    } else {
        SKY
    }
}

/// How many rays are sent for each pixel: one, if the pixel is more than ten fields long.
fn count(samples: u32) -> Result<Image, Error> {
    let size = Size::new(320, 240)?;
    let camera = floor_camera(0.0)?;
    Image::from_fn(size, |column, row| {
        // The lengths at which the upper and the lower edge of the pixel meet the floor.
        let [upper, lower] = [0.0, 1.0].map(|down| {
            let (x, y) = camera_coordinates(size, column, row, (0.5, down));
            let ray = camera.ray_for(size, x, y);
            let t = -ray.origin().y() / ray.direction().y();
            ray.at(t).z()
        });
        let is_floor = lower < 0.0;
        let is_one = is_floor && (upper - lower).abs() > 10.0;
        Color::gray(f64::from(if is_one { 1 } else { samples }) / 64.0)
    })
}

/// A ball around the origin, seen by parallel rays from this z.
fn ball(z: f64, samples: u32, pattern: Pattern) -> Result<Image, Error> {
    let ball = Sphere::new(Point3::ORIGIN, 1.0)?;
    let color = |ray: &Ray| {
        let Some(hit) = ball.hit(ray, Interval::AHEAD) else {
            return SKY;
        };
        let n = hit.normal;
        pattern(
            libm::atan2(n.x(), n.z()),
            libm::asin(n.y().clamp(-1.0, 1.0)),
        )
    };
    let camera = parallel(Point3::new(0.0, 0.0, z), AHEAD * z, 2.4)?;
    if samples == 1 {
        picture(&*camera, [241, 241], color)
    } else {
        sampled_picture(&*camera, [241, 241], samples, color)
    }
}

/// The picture of the book: stripes, board and picture on three balls, on a board, in the sun.
fn still(samples: u32) -> Result<Image, Error> {
    let striped: Pattern = |_, latitude| {
        if stripes(latitude / TAU * 14.0) {
            Color::new(0.85, 0.8, 0.7)
        } else {
            Color::new(0.65, 0.08, 0.05)
        }
    };
    let bodies: [(Point3, f64, Pattern); 3] = [
        (Point3::new(-2.3, 1.0, -0.6), 1.0, striped),
        (Point3::new(0.1, 1.3, -1.4), 1.3, chessboard_on_ball),
        (Point3::new(2.1, 0.8, 0.3), 0.8, picture_on_ball),
    ];
    let mut balls = Vec::new();
    for (center, radius, pattern) in bodies {
        balls.push((Sphere::new(center, radius)?, pattern));
    }
    let sun = Vector3::new(-0.48, 0.64, 0.6);
    let lit = |color: Color, p: Point3, n: Vector3| {
        let to_sun = Ray::derived(p + n * 1e-9, sun);
        let is_dark = (balls.iter()).any(|(ball, _)| ball.hit(&to_sun, Interval::AHEAD).is_some());
        let light = if is_dark { 0.0 } else { n.dot(sun).max(0.0) };
        color * (0.15 + 0.95 * light)
    };
    let color = |ray: &Ray| {
        let mut within = Interval::AHEAD;
        let mut seen = None;
        for (ball, pattern) in &balls {
            if let Some(hit) = ball.hit(ray, within) {
                within = Interval::before(hit.t);
                seen = Some((hit, pattern));
            }
        }
        if let Some((hit, pattern)) = seen {
            let n = hit.normal;
            // A little turned, so that the fields of the poles are seen.
            let (y, z) = (0.9 * n.y() + 0.436 * n.z(), 0.9 * n.z() - 0.436 * n.y());
            let (longitude, latitude) = (libm::atan2(n.x(), z), libm::asin(y.clamp(-1.0, 1.0)));
            return lit(pattern(longitude, latitude), ray.at(hit.t), n.into());
        }
        let sky = Color::new(0.4, 0.55, 0.8);
        let t = -ray.origin().y() / ray.direction().y();
        if t < 0.0 {
            return sky;
        }
        let p = ray.at(t);
        let field = floor_color(ray) * 0.7 + Color::new(0.05, 0.07, 0.1);
        let far = 1.0 - libm::exp(-t / 60.0);
        lit(field, p, UP) * (1.0 - far) + sky * far
    };
    let eye = Point3::new(0.4, 2.4, 8.0);
    let gaze = Point3::new(0.0, 0.9, 0.0) - eye;
    let camera = perspective(eye, gaze, 0.55)?;
    let image = sampled_picture(&*camera, [640, 400], samples, color)?;
    Ok(for_screens(image, Transfer::Srgb))
}

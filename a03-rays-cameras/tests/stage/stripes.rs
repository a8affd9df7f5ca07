//! The striped sky: the number, the colours and the borders of its stripes. The extreme
//! cases Q05, Q14 and Q15 count the stripes of whole pictures.

use a02_math::Point3;
use a03_rays_cameras::{PinholeCamera, StripeRule, StripedSky};
use common::Size;
use testing::assert_refused;

#[test]
fn stripes_alternate_and_have_the_given_number() {
    let size = Size::SECOND_COURSE;
    for alpha in [0.5, std::f64::consts::FRAC_PI_2, 2.5] {
        let camera = PinholeCamera::new(Point3::ORIGIN, alpha).unwrap();
        for rule in [StripeRule::Direction, StripeRule::Wall] {
            for stripes in [1, 2, 3, 10, 11] {
                let sky = StripedSky::new(&camera, size, stripes, rule).unwrap();
                let column = (0..size.height()).map(|y| {
                    let ray = camera.generate_ray(size, 240.0, f64::from(y) + 0.5);
                    (sky.stripe(&ray), sky.color_for(&ray))
                });
                let mut seen: Vec<_> = column.collect();
                seen.dedup();
                let numbers: Vec<_> = seen.iter().map(|(stripe, _)| *stripe).collect();
                assert_eq!(numbers, (0..stripes).rev().collect::<Vec<_>>());
                assert!(seen.windows(2).all(|pair| pair[0].1 != pair[1].1));
            }
        }
    }
}

/// On the boundary between two stripes, `d.y = c` and so the height on the
/// picture is `c / sqrt(1 - c²)` times the distance from the eye.
#[test]
fn the_stripes_of_directions_bend_along_a_hyperbola() {
    let size = Size::new(400, 300).unwrap();
    let camera = PinholeCamera::new(Point3::ORIGIN, std::f64::consts::FRAC_PI_2).unwrap();
    let sky = StripedSky::new(&camera, size, 10, StripeRule::Direction).unwrap();
    let top = 0.5_f64.sqrt();
    let c = 0.6 * top; // between stripes 7 and 8
    for x in [-200.0, -120.0, 0.0, 77.0, 200.0_f64] {
        let height = c / (1.0 - c * c).sqrt() * (x * x + 150.0 * 150.0).sqrt();
        for (beside, stripe) in [(-1e-6, 7), (1e-6, 8)] {
            let ray = camera.generate_ray(size, 200.0 + x, 150.0 - height - beside);
            assert_eq!(sky.stripe(&ray), stripe);
        }
    }
}

#[test]
fn a_sky_of_no_stripes_is_refused() {
    let camera = PinholeCamera::new(Point3::ORIGIN, 1.0).unwrap();
    let sky = StripedSky::new(&camera, Size::COURSE, 0, StripeRule::Wall);
    assert_refused(sky, "stripes is", "at least 1");
}

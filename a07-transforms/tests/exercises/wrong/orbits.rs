//! Moons that leave the earth, and planets that turn on the spot.

use a02_math::Point3;
use a07_transforms::Transform;
use common::ArgumentError;
use testing::exercise::Wrong;

use crate::orbits::check;
use crate::solutions::orbits::orbits;

fn along_x(x: f64) -> Point3 {
    Point3::new(x, 0.0, 0.0)
}

fn turned(angle: f64) -> Result<Transform, ArgumentError> {
    Transform::IDENTITY.rotate_y(angle)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "moved first and turned on the spot",
        says: "place of the moon, year 0.000, month 1.571: expected (5, 0, -1), got (6, 0, 0)",
        check: |c| {
            check(c, |year, month| {
                let earth = Transform::IDENTITY
                    .translate(along_x(5.0))?
                    .rotate_y(year)?;
                Ok([earth, earth.translate(along_x(1.0))?.rotate_y(month)?])
            });
        },
    },
    Wrong {
        mistake: "a moon that does not turn with the earth",
        says: "place of the moon, year 1.571, month 0.000: expected (0, 0, -6), got (1",
        check: |c| {
            check(c, |year, month| {
                let [earth, _] = orbits(year, month)?;
                let place = earth.matrix() * Point3::ORIGIN;
                let moon = Transform::IDENTITY.translate(place)?.rotate_y(month)?;
                Ok([earth, moon.translate(along_x(1.0))?])
            });
        },
    },
    Wrong {
        mistake: "a moon of the sun",
        says: "place of the moon, year 0.000, month 0.000: expected (6, 0, 0), got (1, 0, 0)",
        check: |c| {
            check(c, |year, month| {
                let [earth, _] = orbits(year, month)?;
                Ok([earth, turned(month)?.translate(along_x(1.0))?])
            });
        },
    },
    Wrong {
        mistake: "turned the other way",
        says: "place of the moon, year 0.000, month 1.571: expected (5, 0, -1), got (5, 0, 1)",
        check: |c| check(c, |year, month| orbits(-year, -month)),
    },
    Wrong {
        mistake: "year and month exchanged",
        says: "place of the moon, year 0.000, month 1.571: expected (5, 0, -1), got",
        check: |c| check(c, |year, month| orbits(month, year)),
    },
    Wrong {
        mistake: "a moon that always shows the earth the same side of the sky",
        says: "direction into which the moon turns its back, year 0.000, month 1.571: expected (-1, 0, 0), got",
        check: |c| {
            check(c, |year, month| {
                let [earth, moon] = orbits(year, month)?;
                Ok([earth, moon.rotate_y(-month)?])
            });
        },
    },
    Wrong {
        mistake: "the earth 1 away and the moon 5",
        says: "place of the earth, year 0.000, month 0.000: expected (5, 0, 0), got (1, 0, 0)",
        check: |c| {
            check(c, |year, month| {
                let earth = turned(year)?.translate(along_x(1.0))?;
                Ok([earth, earth.rotate_y(month)?.translate(along_x(5.0))?])
            });
        },
    },
    Wrong {
        mistake: "about the z axis",
        says: "place of the moon, year 0.000, month 1.571: expected (5, 0, -1), got (5, 1, 0)",
        check: |c| {
            check(c, |year, month| {
                let earth = Transform::IDENTITY
                    .rotate_z(year)?
                    .translate(along_x(5.0))?;
                Ok([earth, earth.rotate_z(month)?.translate(along_x(1.0))?])
            });
        },
    },
];

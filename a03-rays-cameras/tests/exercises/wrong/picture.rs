//! Wrong solutions.

use a03_rays_cameras::{Sampler, camera_coordinates};
use common::{Color, Image, Settings, Size};
use testing::exercise::{Check, Wrong};

use crate::picture;

type Place = (f64, f64);

/// The loop, with the coordinates of a sample and the number that a sum is divided by.
fn check(
    check: &mut Check,
    coordinates: fn(Size, u32, u32, Place) -> Place,
    divisor: fn(&Settings, Sampler) -> u32,
) {
    picture::check(check, |camera, radiance, settings| {
        let (size, sampler) = (settings.size, Sampler::new(settings));
        Image::from_fn(size, |column, row| {
            let mut sum = Color::BLACK;
            for place in sampler.places(column, row) {
                let (x, y) = coordinates(size, column, row, place);
                sum += radiance(&camera.ray_for(size, x, y));
            }
            sum.map(|sum| sum / f64::from(divisor(settings, sampler)))
        })
    });
}

const fn samples(_: &Settings, sampler: Sampler) -> u32 {
    sampler.samples()
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "upside down",
        says: "column 0, row 0 of 3x2, Center sampling",
        check: |c| {
            check(
                c,
                |_, column, row, (x, y)| (f64::from(column) + x - 0.5, f64::from(row) + y - 0.5),
                samples,
            );
        },
    },
    Wrong {
        mistake: "the sum instead of the mean",
        says: "Regular sampling, 4 samples: expected",
        check: |c| check(c, camera_coordinates, |_, _| 1),
    },
    Wrong {
        mistake: "the samples asked for instead of those taken",
        says: "Regular sampling, 5 samples: expected",
        check: |c| check(c, camera_coordinates, |settings, _| settings.samples),
    },
    Wrong {
        mistake: "one ray through the middle",
        says: "Regular sampling, 4 samples: expected",
        check: |c| {
            check(
                c,
                |size, column, row, _| camera_coordinates(size, column, row, (0.5, 0.5)),
                samples,
            );
        },
    },
    Wrong {
        mistake: "columns and rows swapped",
        says: "column 1, row 0 of 3x2, Center sampling",
        check: |c| {
            check(
                c,
                |size, column, row, place| {
                    camera_coordinates(size, row, column.min(size.height() - 1), place)
                },
                samples,
            );
        },
    },
];

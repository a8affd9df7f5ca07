//! Errors over many rays, compared with 30 digits; and translated and scaled scenes, whose
//! hits must not change.

use measure::extremes::{AgainstProtocol, Case};

use crate::compared_shape::{BOX, ComparedShape, PLANE, SPHERE, TRIANGLE};
use crate::experiments::far_sphere::{Formula, is_wrong, ours, queries};
use crate::formula::sphere::SphereQuery;
use crate::line::line;
use crate::protocol;
use crate::support::{Numbers, Triple};

/// Number of rays from a distance with a wrong decision between hit and miss of a unit sphere.
pub fn wrong_hits(distance: f64, rays: usize) -> Case {
    let queries = queries(distance, rays);
    let count = |formula: Formula| {
        let is_wrong = |query: &&SphereQuery| is_wrong(query, formula(query));
        queries.iter().filter(is_wrong).count()
    };
    Case::of(count(ours), count(protocol::sphere))
}

/// Coordinates are multiples of this: they are exact after a translation by 2^30.
const GRID: f64 = 1.0 / 1_048_576.0;

/// Where a scene is, and how large.
#[derive(Clone, Copy)]
struct Place {
    scale: f64,
    /// The translation along all axes.
    shift: f64,
}

const HERE: Place = Place {
    scale: 1.0,
    shift: 0.0,
};

impl Place {
    fn at(self, position: Triple) -> Triple {
        position.map(|x| x * self.scale + self.shift)
    }

    /// Four shapes with their numbers at this place.
    fn shapes(self) -> [(ComparedShape, Vec<f64>); 4] {
        let opposite = [[-0.75, -0.5, -1.0], [0.5, 1.25, 0.75]];
        let corners = [[-1.5, 0.25, 0.0], [1.0, -1.25, 0.5], [0.5, 1.5, -0.75]];
        let center = self.at([0.25, 0.125, -0.5]);
        [
            (
                PLANE,
                [self.at([0.25, -0.5, 1.0]), [1.0, 2.0, -3.0]].concat(),
            ),
            (BOX, opposite.map(|corner| self.at(corner)).concat()),
            (TRIANGLE, corners.map(|corner| self.at(corner)).concat()),
            (SPHERE, [&center[..], &[1.25 * self.scale]].concat()),
        ]
    }

    /// The distances of the shapes along the `n`-th ray. The ray's direction does not depend on the
    /// place.
    fn distances(self, n: usize) -> [AgainstProtocol<Option<f64>>; 4] {
        let mut numbers = Numbers::new(41, n);
        let mut on_grid = |reach: f64| (numbers.between(-reach, reach) / GRID).round() * GRID;
        let from = [(); 3].map(|()| on_grid(4.0));
        let direction = from.map(|x| on_grid(1.0) - x);
        let ray = line(self.at(from), direction).any_ray();
        self.shapes().map(|(shape, numbers)| AgainstProtocol {
            ours: shape.lesson(&numbers, &ray),
            theirs: (shape.protocol)(&numbers, &ray),
        })
    }
}

/// Number of distances that differ in any bit, except for the scale, at some places.
fn differing(places: &[Place], rays: usize) -> Case {
    let (mut ours, mut theirs) = (0, 0);
    for n in 0..rays {
        let here = HERE.distances(n);
        for place in places {
            for (here, there) in here.iter().zip(place.distances(n)) {
                ours += usize::from(differs(here.ours, there.ours, place.scale));
                theirs += usize::from(differs(here.theirs, there.theirs, place.scale));
            }
        }
    }
    Case::of(ours, theirs)
}

fn differs(here: Option<f64>, there: Option<f64>, scale: f64) -> bool {
    here.map(|t| (t * scale).to_bits()) != there.map(f64::to_bits)
}

/// Four shapes moved by 2^30.
pub fn moved(rays: usize) -> Case {
    let moved = Place {
        shift: libm::scalbn(1.0, 30),
        ..HERE
    };
    differing(&[moved], rays)
}

/// Four shapes in scales from 2^-300 to 2^300.
pub fn scaled(rays: usize) -> Case {
    let mut scaled = Vec::new();
    for power in (-300..=300).step_by(50) {
        scaled.push(Place {
            scale: libm::scalbn(1.0, power),
            ..HERE
        });
    }
    differing(&scaled, rays)
}

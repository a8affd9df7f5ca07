//! Answers for the whole line, for the centre alone, or in wrong units.

use a02_math::Direction;
use testing::exercise::Wrong;

use crate::may_meet::check;
use crate::solutions::may_meet::may_meet;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the whole line, also behind the origin",
        says: "from 1.1 radii along the ray, 0 beside, radius 1, direction of length 1: expected no, got yes",
        check: |c| {
            check(c, |centre, r, ray| {
                (ray.at(ray.t_of(centre)) - centre).magnitude() <= r
            });
        },
    },
    Wrong {
        mistake: "no sphere whose centre is behind",
        says: "from 0.8 radii along the ray, 0.5 beside, radius 1, direction of length 1: expected yes, got no",
        check: |c| {
            check(c, |centre, r, ray| {
                ray.t_of(centre) >= 0.0 && may_meet(centre, r, ray)
            });
        },
    },
    Wrong {
        mistake: "a direction taken for one of length 1",
        says: "direction of length 0.001: expected yes, got no",
        check: |c| {
            check(c, |centre, r, ray| {
                let t = (centre - ray.origin()).dot(ray.direction());
                (ray.at(t.max(0.0)) - centre).magnitude() <= r
            });
        },
    },
    Wrong {
        mistake: "a squared distance compared with the radius",
        says: "beside, radius 2, direction of length 1: expected yes, got no",
        check: |c| {
            check(c, |centre, r, ray| {
                let way = ray.at(ray.t_of(centre).max(0.0)) - centre;
                way.dot(way) <= r
            });
        },
    },
    Wrong {
        mistake: "< instead of <= at the border",
        says: "along the border, which counts as within: expected yes, got no",
        check: |c| {
            check(c, |centre, r, ray| {
                (ray.at(ray.t_of(centre).max(0.0)) - centre).magnitude() < r
            });
        },
    },
    Wrong {
        mistake: "the distance of the origin from the centre",
        says: "from -5 radii along the ray, 0 beside, radius 1, direction of length 1: expected yes, got no",
        check: |c| check(c, |centre, r, ray| (ray.origin() - centre).magnitude() <= r),
    },
    Wrong {
        mistake: "only from outside",
        says: "from 0.8 radii along the ray, 0.5 beside, radius 1, direction of length 1: expected yes, got no",
        check: |c| {
            check(c, |centre, r, ray| {
                (ray.origin() - centre).magnitude() > r && may_meet(centre, r, ray)
            });
        },
    },
];

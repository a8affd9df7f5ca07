//! The lesson's test of triangles with Kahan's difference of products.

use corpus::{CASES, Found, Question, Shape};

use crate::{Adapter, nearest, within};

pub const ADAPTER: Adapter = Adapter {
    name: "woop-compensated",
    title: "Woop, Benthin and Wald in doubles, with Kahan's difference of products",
    cases: CASES,
    ask,
};

fn ask(question: &Question) -> Option<Found> {
    let Shape::Triangles(all) = &question.shape else {
        return None;
    };
    let of_triangle = |corners: &_| within(question, woop(question, corners));
    question
        .under
        .is_empty()
        .then(|| nearest(all.iter().map(of_triangle)))
}

fn woop(question: &Question, corners: &[[f64; 3]; 3]) -> Found {
    let (o, d) = (question.origin, question.direction);
    let mut z = 0;
    for axis in 1..3 {
        if d[axis].abs() > d[z].abs() {
            z = axis;
        }
    }
    let (x, y) = ((z + 1) % 3, (z + 2) % 3);
    let [a, b, c] = corners.map(|p| {
        let depth = p[z] - o[z];
        [
            (p[x] - o[x]) - d[x] / d[z] * depth,
            (p[y] - o[y]) - d[y] / d[z] * depth,
            depth / d[z],
        ]
    });
    let area = |p: [f64; 3], q: [f64; 3]| difference_of_products(p[0], q[1], p[1], q[0]);
    let [u, v, w] = [area(c, b), area(a, c), area(b, a)];
    let is_inside = u.min(v).min(w) >= 0.0 || u.max(v).max(w) <= 0.0;
    let determinant = u + v + w;
    let t = (u * a[2] + v * b[2] + w * c[2]) / determinant;
    (is_inside && determinant != 0.0).then_some(t)
}

/// `a b - c d`, where the rounding error of `c d` is added again.
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = c * d;
    a.mul_add(b, -product) + (-c).mul_add(d, product)
}

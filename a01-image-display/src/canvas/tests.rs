//! Tests of `canvas`.

use super::*;
use std::f64::consts::PI;

fn canvas(width: u32, height: u32) -> Canvas {
    Canvas::new(Size::new(width, height).unwrap(), Color::BLACK).unwrap()
}

/// The area that is painted, pixels counting as much as they are covered.
fn area(canvas: &Canvas) -> f64 {
    canvas.image.pixels().iter().map(|color| color.r).sum()
}

fn red_at(canvas: &Canvas, x: u32, y: u32) -> f64 {
    canvas.image.get(x, y).unwrap().r
}

/// The integral of 2 pi r c(r) dr with c(r) the coverage at a distance r
/// from the middle of a disc: clamp(h + 1/2 - r, 0, min(2h, 1)), h = w/2.
fn soft_disc(width: f64) -> f64 {
    let (outer, inner) = (width / 2.0 + 0.5, (width / 2.0 - 0.5).abs());
    PI * (outer * outer * outer - inner * inner * inner) / 3.0
}

#[test]
fn a_line_is_blended_in_proportion_to_its_coverage() {
    let (below, quarter) = (Color::new(0.5, 1.0, 0.25), Color::new(0.625, 0.75, 0.1875));
    let mut canvas = Canvas::new(Size::new(20, 9).unwrap(), below).unwrap();
    // From row 2.75 to row 5.25.
    canvas.line((-9.0, 4.0), (29.0, 4.0), 2.5, Color::RED);
    for x in 0..20 {
        let column: Vec<_> = (2..7).map(|y| canvas.image.get(x, y).unwrap()).collect();
        assert_eq!(column, [quarter, Color::RED, Color::RED, quarter, below]);
    }
}

/// A sum over pixels stands for the integral.
fn assert_area(canvas: &Canvas, exact: f64, tolerance: f64) {
    let error = (area(canvas) / exact - 1.0).abs();
    assert!(error < tolerance, "{} and {exact}", area(canvas));
}

#[test]
fn the_area_of_a_line_is_length_times_width_and_round_ends() {
    for (to, widths) in [
        ((180.0, 50.0), [0.2, 1.0, 1.7, 8.0]),
        ((91.7, 190.2), [0.2, 1.0, 1.7, 8.0]),
        // A dot.
        ((50.0, 50.0), [5.0, 8.0, 17.0, 31.0]),
    ] {
        for width in widths {
            let mut canvas = canvas(240, 240);
            canvas.line((50.0, 50.0), to, width, Color::WHITE);
            let (x, y) = (to.0 - 50.0, to.1 - 50.0);
            let length = f64::sqrt(x * x + y * y);
            assert_area(&canvas, length * width + soft_disc(width), 0.02);
        }
    }
}

#[test]
fn an_arrow_is_a_line_and_a_triangle_in_every_direction() {
    for (to, length) in [
        ((260.0, 100.0), 160.0),
        ((100.0, 260.0), 160.0),
        ((4.0, 28.0), 120.0),
        // Shorter than its head: all head, 6 long and 5 wide.
        ((106.0, 100.0), 6.0),
    ] {
        let mut canvas = canvas(280, 280);
        canvas.arrow((100.0, 100.0), to, 4.0, Color::WHITE);
        // The head is 24 long and 20 wide, the line's beginning half a disc.
        let exact = match length {
            6.0 => 15.0,
            _ => (length - 24.0) * 4.0 + 24.0 * 20.0 / 2.0 + soft_disc(4.0) / 2.0,
        };
        assert_area(&canvas, exact, if length == 6.0 { 0.1 } else { 0.01 });
    }
}

#[test]
fn bad_coordinates_draw_nothing_and_far_ones_are_clipped() {
    let (good, empty) = ((10.0, 10.0), canvas(20, 20));
    for bad in [f64::NAN, -f64::INFINITY, 1e300, -2e9] {
        let mut canvas = empty.clone();
        for at in [(bad, 5.0), (5.0, bad)] {
            canvas.line(at, good, 3.0, Color::RED);
            canvas.arrow(good, at, 3.0, Color::RED);
            canvas.text(at, 1, Color::RED, "A");
        }
        for width in [bad, 0.0, -1.0] {
            canvas.line(good, (15.0, 15.0), width, Color::RED);
            canvas.arrow(good, (15.0, 15.0), width, Color::RED);
        }
        assert_eq!(canvas, empty, "{bad}");
    }
    let mut far = empty;
    far.line((-1e9, 10.0), (1e9, 10.0), 2.0, Color::RED);
    for x in 0..20 {
        assert!((red_at(&far, x, 9) - 1.0).abs() < 0.01);
        assert!(red_at(&far, x, 7).abs() < 0.01);
    }
}

#[test]
fn every_dot_of_a_letter_is_a_square() {
    let mut canvas = canvas(20, 20);
    canvas.text((2.3, 3.6), 2, Color::WHITE, "-");
    // Six dots in the fourth row.
    for (x, y) in (0..20).flat_map(|x| (0..20).map(move |y| (x, y))) {
        let is_dot = (2..14).contains(&x) && (10..12).contains(&y);
        assert_eq!(
            red_at(&canvas, x, y),
            f64::from(u8::from(is_dot)),
            "{x} {y}"
        );
    }
}

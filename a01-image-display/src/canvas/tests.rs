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

#[test]
fn the_area_of_a_line_is_length_times_width_and_round_ends() {
    for (to, widths, tolerance) in [
        ((180.0, 50.0), &[0.2, 1.0, 1.7, 3.0, 8.0][..], 0.01),
        ((170.3, 93.1), &[0.2, 1.0, 1.7, 3.0, 8.0], 0.01),
        ((91.7, 190.2), &[0.2, 1.0, 1.7, 3.0, 8.0], 0.01),
        ((50.0, 187.0), &[0.2, 1.0, 1.7, 3.0, 8.0], 0.01),
        // Without length, a dot.
        ((50.0, 50.0), &[5.0, 31.0], 0.02),
    ] {
        for &width in widths {
            let from = (50.0, 50.0);
            let mut canvas = canvas(240, 240);
            canvas.line(from, to, width, Color::WHITE);
            let (x, y) = (to.0 - from.0, to.1 - from.1);
            let length = (x * x + y * y).sqrt();
            let exact = length * width + soft_disc(width);
            // A sum over pixels stands for the integral.
            let error = (area(&canvas) / exact - 1.0).abs();
            assert!(error < tolerance, "to {to:?}, width {width}: {error}");
        }
    }
}

#[test]
fn an_arrow_is_a_line_and_a_triangle_in_every_direction() {
    for (to, x, y) in [
        ((260.0, 100.0), 1.0, 0.0),
        ((100.0, 260.0), 0.0, 1.0),
        ((4.0, 28.0), -0.8, -0.6),
    ] {
        let mut canvas = canvas(280, 280);
        canvas.arrow((100.0, 100.0), to, 4.0, Color::WHITE);
        // The head is 24 long and 20 wide, the line's beginning half a disc.
        let length = (to.0 - 100.0) * x + (to.1 - 100.0) * y;
        let exact = (length - 24.0) * 4.0 + 24.0 * 20.0 / 2.0 + soft_disc(4.0) / 2.0;
        let error = (area(&canvas) / exact - 1.0).abs();
        assert!(error < 0.01, "{to:?}: {error}");
        // Beside the tip, in the head and before it.
        let at = |back: f64, aside: f64| {
            let (x, y) = (to.0 - back * x - aside * y, to.1 - back * y + aside * x);
            red_at(&canvas, x as u32, y as u32)
        };
        assert_eq!(
            [at(2.0, 4.0), at(22.0, 7.0), at(30.0, 7.0)],
            [0.0, 1.0, 0.0]
        );
    }
}

#[test]
fn the_tip_is_where_the_arrow_ends() {
    let mut canvas = canvas(20, 20);
    canvas.arrow((2.0, 9.5), (15.0, 9.5), 2.0, Color::RED);
    // The head's edges rise 2.5 over 6, so half a pixel behind or before
    // the tip is 0.5 * 2.5 / 6.5 from them.
    let part = 0.5 * 2.5 / 6.5;
    assert!((red_at(&canvas, 14, 9) - (0.5 + part)).abs() < 1e-12);
    assert!((red_at(&canvas, 15, 9) - (0.5 - part)).abs() < 1e-12);
    assert_eq!(red_at(&canvas, 17, 9), 0.0);
}

#[test]
fn a_short_arrow_is_all_head_and_one_without_length_a_dot() {
    let mut short = canvas(40, 40);
    short.arrow((10.0, 20.0), (16.0, 20.0), 4.0, Color::WHITE);
    // 6 long and 5 wide.
    assert!((area(&short) - 15.0).abs() < 1.5, "{}", area(&short));

    for (length, width) in [(0.0, 4.0), (1e-300, 4.0), (1e-9, 4.0), (10.0, 1e-9)] {
        let to = (20.0 + length, 20.0);
        let (mut arrow, mut line) = (canvas(40, 40), canvas(40, 40));
        arrow.arrow((20.0, 20.0), to, width, Color::RED);
        line.line((20.0, 20.0), to, width, Color::RED);
        assert_eq!(arrow, line, "{length} {width}");
        assert!(area(&line) > 0.0);
    }
}

#[test]
fn shapes_are_clipped_at_the_border() {
    let draw = |canvas: &mut Canvas, shift: f64| {
        let at = |x: f64, y: f64| (x + shift, y + shift);
        canvas.line(at(-30.0, 5.0), at(50.0, 35.0), 3.0, Color::RED);
        canvas.arrow(at(10.0, 60.0), at(12.0, -20.0), 2.0, Color::GREEN);
        canvas.text(at(-5.0, 14.0), 2, Color::BLUE, "outside?");
    };
    let (mut cut, mut whole) = (canvas(40, 30), canvas(240, 230));
    draw(&mut cut, 0.0);
    draw(&mut whole, 100.0);
    for y in 0..30 {
        for x in 0..40 {
            let (cut, whole) = (cut.image.get(x, y), whole.image.get(x + 100, y + 100));
            let apart = cut.unwrap() - whole.unwrap();
            assert!(apart.channels().iter().all(|c| c.abs() < 1e-12));
        }
    }
    assert!(area(&cut) > 50.0);
}

#[test]
fn bad_coordinates_draw_nothing_and_far_ones_are_clipped() {
    let empty = canvas(20, 20);
    let good = (10.0, 10.0);
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, -2e9] {
        let mut canvas = empty.clone();
        for at in [(bad, 5.0), (5.0, bad), (bad, bad)] {
            canvas.line(at, good, 3.0, Color::RED);
            canvas.line(good, at, 3.0, Color::RED);
            canvas.arrow(at, good, 3.0, Color::RED);
            canvas.arrow(good, at, 3.0, Color::RED);
            canvas.text(at, 1, Color::RED, "A");
        }
        canvas.line(good, (15.0, 15.0), bad, Color::RED);
        canvas.arrow(good, (15.0, 15.0), bad, Color::RED);
        canvas.arrow(good, good, bad, Color::RED);
        assert_eq!(canvas, empty, "{bad}");
    }
    for width in [0.0, -1.0] {
        let mut canvas = empty.clone();
        canvas.line(good, (15.0, 15.0), width, Color::RED);
        canvas.arrow(good, (15.0, 15.0), width, Color::RED);
        assert_eq!(canvas, empty, "width {width}");
    }
    let mut far = empty.clone();
    far.line((-1e9, 10.0), (1e9, 10.0), 2.0, Color::RED);
    far.arrow((1e9, 1e9), (-1e9, 1e9), 1e9, Color::RED);
    for x in 0..20 {
        assert!((red_at(&far, x, 9) - 1.0).abs() < 0.01);
        assert!(red_at(&far, x, 7).abs() < 0.01);
    }
    far.text((0.0, 0.0), u32::MAX, Color::RED, "wide");
    far.text((-1e9, 0.0), 1, Color::RED, "far");
}

#[test]
fn characters_differ_and_unknown_ones_are_question_marks() {
    let mut shapes = std::collections::HashSet::from([glyph('?'), glyph(' ')]);
    for character in "AZaz09+-*/=<>()[]{}|^~äöüßÄÖÜéñ±×÷°²³½Ωαγδθλμπρστφω≤≥".chars()
    {
        assert!(shapes.insert(glyph(character)), "{character}");
    }
    for character in "\u{7}\n\u{85}\u{3a2}→中𝛼".chars() {
        assert_eq!(glyph(character), glyph('?'), "{character:?}");
    }
    assert_eq!(glyph(' '), [0; 8]);
}

#[test]
fn every_dot_of_a_letter_is_a_square_at_its_place() {
    for (scale, at) in [(1, (2.3, 1.6)), (3, (4.0, 5.0))] {
        let mut canvas = canvas(60, 32);
        canvas.text(at, scale, Color::WHITE, "gR");
        let (left, top) = (at.0.round() as u32, at.1.round() as u32);
        for y in 0..32 {
            for x in 0..60 {
                let dot = |start: u32, at: u32| Some(at.checked_sub(start)? / scale);
                let place = dot(left, x).zip(dot(top, y));
                let is_dot = place.is_some_and(|(column, row)| {
                    let letter = "gR".chars().nth(column as usize / 8);
                    row < 8
                        && letter.is_some_and(|c| glyph(c)[row as usize] >> (column % 8) & 1 == 1)
                });
                assert_eq!(
                    red_at(&canvas, x, y),
                    f64::from(u8::from(is_dot)),
                    "{x} {y}"
                );
            }
        }
    }
    let mut none = canvas(20, 20);
    none.text((0.0, 0.0), 0, Color::WHITE, "none");
    none.text((0.0, 0.0), 1, Color::WHITE, "");
    assert_eq!(area(&none), 0.0);
}

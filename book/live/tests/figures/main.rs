//! The numbers of figures against closed forms, and pictures against their locks.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, PI};

use live::{Reply, call};

mod arithmetic;
mod measuring;
mod omissions;
mod sensitivity;
mod sweeps;

fn ask(request: &str, numbers: &[f64]) -> Reply {
    call(request, numbers).unwrap()
}

#[track_caller]
fn assert_near(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
}

/// A ray at half the radius meets the sphere half a chord, √(3/4), before and behind
/// its middle, wherever both are moved together.
#[test]
fn a_sphere_is_hit_half_a_chord_around_the_middle() {
    let half = 0.75_f64.sqrt();
    for [cx, cy] in [[0.0, 0.0], [0.5, -0.25], [-1.0, 1.0]] {
        let answer = ask("sphere", &[cx, cy + 0.5, 0.0, 1.0, cx, cy]);
        for name in ["ours", "protocol", "exact"] {
            assert_near(answer.get(name), &[10.0 - half, 10.0 + half]);
        }
        for name in ["our", "protocol", "exact"].map(|by| format!("{by}_discriminant")) {
            assert_near(answer.get(&name), &[4.0 * 0.75]);
        }
    }
}

/// From 10^8 radii the squares agree in all digits: the protocol's error is as large as
/// the sphere, and ours one rounding of the distance. Our discriminant errs by a few
/// roundings of the distance, theirs by some of its square.
#[test]
fn from_far_away_only_the_protocols_formula_fails() {
    for (power, distance) in [(2.0, 1e2), (4.0, 1e4), (6.0, 1e6), (7.0, 1e7), (8.0, 1e8)] {
        let answer = ask("sphere", &[0.0, 0.5, 0.1, power, 0.0, 0.0]);
        assert!(answer.get("our_error")[0] <= 2.0 * distance * f64::EPSILON);
        let [exact, ours, protocol] =
            ["exact", "our", "protocol"].map(|by| answer.get(&format!("{by}_discriminant"))[0]);
        assert!((ours - exact).abs() <= 32.0 * distance * f64::EPSILON);
        assert!((protocol - exact).abs() <= 32.0 * distance * distance * f64::EPSILON);
        if distance == 1e8 {
            assert!((protocol - exact).abs() > 1.0);
            assert!(answer.get("protocol_error")[0] > 0.1);
        }
    }
    assert!(
        ask("sphere", &[0.0, 1.5, 0.0, 1.0, 0.0, 0.0])
            .get("ours")
            .is_empty()
    );
}

/// The discriminant that the figure shows is the one from which the lesson's far root
/// is computed.
#[test]
fn our_discriminant_is_that_of_the_lesson() {
    for power in [0.0, 1.0, 3.0, 6.0, 8.0] {
        let answer = ask("sphere", &[0.25, 0.5, 0.0, power, 0.0, 0.125]);
        // Along x, the ray is nearest to the centre, at 0, when it has undone its origin.
        let middle = -answer.get("origin")[0];
        let half = (answer.get("our_discriminant")[0] / 4.0).sqrt();
        assert_eq!(answer.get("ours")[1], middle + half);
    }
}

/// From (-2, 0, 0) along x: into the slab in x after 1, out after 3. From (-3, 0, -4)
/// towards the middle, 5 away, a quarter of the way in z is 5/4 of `t`.
#[test]
fn slabs_are_entered_and_left() {
    let answer = ask("slabs", &[-2.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert_near(answer.get("x_slab"), &[1.0, 3.0]);
    assert_near(answer.get("both"), &[1.0, 3.0]);
    assert_near(answer.get("normal"), &[-1.0, 0.0, 0.0]);
    let beside = ask("slabs", &[-2.0, 1.0, 0.0, 1.0, 0.0, 0.0]);
    assert!(beside.get("hit").is_empty());
    let slanted = ask("slabs", &[-3.0, 0.0, 0.0, 0.0, -4.0, 0.0]);
    assert_near(slanted.get("x_slab"), &[5.0 - 5.0 / 3.0, 5.0 + 5.0 / 3.0]);
    assert_near(slanted.get("z_slab"), &[3.75, 6.25]);
    assert_near(slanted.get("both"), &[3.75, 6.25]);
    assert_near(slanted.get("normal"), &[0.0, 0.0, -1.0]);
}

#[test]
fn weights_of_corners_are_shares_of_the_area() {
    let at = |x, y| ask("barycentric", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, x, y]);
    assert_near(at(0.25, 0.25).get("weights"), &[0.5, 0.25, 0.25]);
    assert_near(at(0.5, 0.0).get("weights"), &[0.5, 0.5, 0.0]);
    assert!(at(0.7, 0.7).get("weights").is_empty());
    // At a corner the normal is the corner's: (-1/3, -1/3, 1), normalised.
    let length = 11.0_f64.sqrt();
    let corner = [-1.0, -1.0, 3.0].map(|x| x / length);
    assert_near(at(0.0, 0.0).get("normal"), &corner);
}

/// Lambert's cosine, and Phong's power of the cosine between eye and reflected light.
#[test]
fn light_from_45_degrees_is_seen_matt_and_mirrored() {
    let answer = ask("shading", &[3.0 * FRAC_PI_4, FRAC_PI_2, 2.0]);
    let cosine = FRAC_1_SQRT_2;
    assert_near(answer.get("cosine"), &[cosine]);
    assert_near(answer.get("reflected"), &[cosine, cosine]);
    assert_near(answer.get("diffuse"), &[0.5 * cosine]);
    assert_near(answer.get("highlight"), &[0.5 * 0.5]);
}

/// From 60 degrees off the normal, a beam lights twice its width, half as brightly.
#[test]
fn a_slanted_beam_is_spread() {
    for (light, cosine) in [(FRAC_PI_2, 1.0), (PI / 6.0, 0.5), (5.0 * PI / 6.0, 0.5)] {
        let answer = ask("lambert", &[light]);
        assert_near(answer.get("cosine"), &[cosine]);
        assert_near(answer.get("lit"), &[1.0 / cosine]);
        assert_near(answer.get("diffuse"), &[cosine]);
    }
    assert_near(ask("lambert", &[-0.5]).get("diffuse"), &[0.0]);
}

/// A vertical edge through the middle; of four regular samples two are left of it. The exact
/// area beside an edge through the centre is one half, and at 45 degrees an edge cuts off a
/// right isosceles triangle, whose area is the square of its height.
#[test]
fn samples_estimate_a_covered_area() {
    let at = |angle, offset| ask("samples", &[angle, offset, 4.0, 1.0, 0.0]);
    assert_near(at(0.0, 0.0).get("x"), &[0.25, 0.75, 0.25, 0.75]);
    assert_near(at(0.0, 0.0).get("estimate"), &[0.5]);
    assert_near(at(0.0, 0.0).get("error"), &[0.0]);
    for angle in [0.0, 30.0, 45.0, 90.0, 200.0] {
        assert_near(at(angle, 0.0).get("area"), &[0.5]);
    }
    assert_near(at(0.0, 0.25).get("area"), &[0.75]);
    assert_near(at(45.0, FRAC_1_SQRT_2 - 0.3).get("area"), &[1.0 - 0.09]);
}

/// Independent samples err by 1/√n: 1024 by a 32nd of one. The error of a sum of squares
/// over 400 pixels is itself uncertain by a few percent.
#[test]
fn the_error_of_random_samples_falls_with_the_root_of_their_number() {
    let answer = ask("sample-errors", &[2.0]);
    let errors = answer.get("errors");
    let ratio = errors[0] / errors[5];
    assert!((ratio / 32.0 - 1.0).abs() < 0.2, "{ratio}");
}

/// A direction of a white sky brings 2u when u = cos θ is even on [0, 1], of variance 1/3; of half a sky it brings
/// 2u or 0, of variance 2/3 - 1/4. By the cosine each brings 1, or of half a sky 1 or 0. The error measured in 1,000
/// pixels is itself uncertain by 1/√2000, of which 5 are allowed.
#[test]
fn the_noise_of_directions_is_that_of_the_closed_form() {
    for (sky, even, cosine) in [(0.0, 1.0 / 3.0, 0.0), (1.0, 5.0 / 12.0, 0.25)] {
        for (samples, seed) in [(1.0, 0.0), (16.0, 1.0), (64.0, 2.0)] {
            let answer = ask("hemisphere", &[samples, sky, seed]);
            for (density, variance) in [("even", even), ("cosine", cosine)] {
                let exact = (variance / samples).sqrt();
                assert_near(answer.get(&format!("{density}_exact")), &[exact]);
                let [measured] = answer.get(&format!("{density}_noise")) else {
                    panic!("one noise for each density");
                };
                let uncertain = 5.0 * exact / 2000.0_f64.sqrt();
                assert!((measured - exact).abs() <= uncertain, "{measured} {exact}");
            }
        }
    }
}

/// Seen from above, even directions have a mean square radius of 1 - 1/3, with the variance 4/45, and those by the
/// cosine, which are even on the disc, 1/2, with the variance 1/12. Of 256 directions five standard errors are allowed.
#[test]
fn directions_by_the_cosine_are_even_on_the_disc_below() {
    let answer = ask("hemisphere", &[256.0, 0.0, 0.0]);
    for (density, mean, variance) in [("even", 2.0 / 3.0, 4.0 / 45.0), ("cosine", 0.5, 1.0 / 12.0)]
    {
        let places = answer.get(density);
        assert_eq!(places.len(), 512);
        let square = places.iter().map(|x| x * x).sum::<f64>() / 256.0;
        let uncertain = 5.0 * f64::sqrt(variance / 256.0);
        assert!((square - mean).abs() < uncertain, "{density}: {square}");
    }
}

#[test]
fn a_spot_lights_its_cone() {
    let at = |x, y| ask("spot", &[0.0, 45.0, x, y]);
    assert_near(at(1.0, 0.99).get("lit"), &[1.0]);
    assert_near(at(1.0, 1.01).get("lit"), &[0.0]);
    assert_near(at(0.0, 1.0).get("angle"), &[90.0]);
}

/// From (0, 1.4, 4.4) through (0, 1.05, 3.2), 1.25 away: four times as far is the floor.
/// The lamp is at (-0.6, 3, 2.4), and from step 11 on mirrors pass on three tenths.
#[test]
fn a_ray_through_the_scene_meets_its_floor() {
    let flat = ask("scene", &[0.0, 1.05, 6.0, 1.0, 0.8, 0.35, 0.0]);
    assert_near(flat.get("t"), &[5.0]);
    assert_near(flat.get("path"), &[0.0, 1.4, 4.4, 0.0, 0.0, -0.4]);
    let way = (0.36_f64 + 9.0 + 2.8 * 2.8).sqrt();
    assert_near(flat.get("cosine"), &[3.0 / way]);
    let mirrored = ask("scene", &[0.0, 1.05, 2.0, 2.0, 0.8, 0.35, 11.0]);
    assert_near(mirrored.get("left"), &[0.3 * 0.3]);
}

/// Scaled by 2 in x: at 45 degrees of the sphere the right normal leans towards y, by
/// the inverse factor, and the wrong one towards x.
#[test]
fn normals_lean_by_the_inverse_factor() {
    let half = FRAC_1_SQRT_2;
    let answer = ask(
        "normals",
        &[2.0, 1.0, 0.0, 0.0, 0.0, 2.0 * half, 5.0, 2.0 * half, 0.0],
    );
    let five = 5.0_f64.sqrt();
    assert_near(answer.get("normal"), &[1.0 / five, 2.0 / five]);
    assert_near(answer.get("wrong_normal"), &[2.0 / five, 1.0 / five]);
    // The cosine between both is 4/5.
    assert_near(&[libm::cos(answer.get("apart")[0].to_radians())], &[0.8]);
    // Along y the space is as it was; along x, half as long.
    assert_near(answer.get("length"), &[1.0]);
    let along_x = ask("spaces", &[2.0, 1.0, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0]);
    assert_near(along_x.get("length"), &[0.5]);
    assert_near(along_x.get("t_world"), &[3.0]);
    assert_near(along_x.get("t_object"), &[3.0]);
    assert_near(answer.get("t_world"), &[5.0 - half]);
    assert_eq!(answer.get("t_world"), answer.get("t_object"));
}

#[test]
fn the_order_of_a_chain_matters() {
    let answer = ask("chain", &[90.0, 2.0, 0.0]);
    assert_near(&answer.get("turned_first")[..2], &[2.0, 0.0]);
    assert_near(&answer.get("moved_first")[..2], &[0.0, 2.0]);
}

/// An opening of 90 degrees in a picture of 4 to 3: the upper edge is as far up as
/// ahead.
#[test]
fn the_corners_of_a_picture_span_its_opening() {
    let answer = ask("camera", &[0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 90.0, 3.0]);
    assert_near(answer.get("u"), &[1.0, 0.0, 0.0]);
    assert_near(answer.get("w"), &[0.0, 0.0, 1.0]);
    let [x, y, z] = answer.get("corners")[6..9] else {
        panic!("four corners of three coordinates")
    };
    assert_near(&[x / -z, y / -z], &[4.0 / 3.0, 1.0]);
}

#[test]
fn too_little_lift_and_too_much_are_wrong() {
    let wrong = |power| ask("offset", &[power]).get("wrong_pixels")[0];
    assert_eq!(wrong(-13.0), 0.0);
    assert!(wrong(-18.0) > 10_000.0);
    assert!(wrong(-0.5) > 100.0);
}

/// The camera of `phong` looks from (4, 4, 4) at the sphere around (1, 1, 1).
#[test]
fn a_pixel_is_traced_to_the_surface_of_the_sphere() {
    let picture = [641.0, 481.0, 1.0, 0.0, 0.0, 6.0, 0.0, 0.0, 0.0, 1.0];
    let numbers = [&picture[..], &[320.0, 240.0]].concat();
    let text = ask("trace a05-lighting-phong", &numbers).text;
    let hit = text.lines().find(|line| line.contains("\"kind\": \"hit\""));
    let (_, t) = hit.unwrap().split_once("\"t\": [").unwrap();
    let (t, _) = t.split_once(']').unwrap();
    assert_near(&[t.parse().unwrap()], &[3.0 * 3.0_f64.sqrt() - 0.5]);
    let svg = ask("drawing a05-lighting-phong", &numbers).text;
    assert!(
        svg.contains(r#"class="curve ray1""#) && svg.contains("Sphere"),
        "{svg}"
    );
    let below = [&picture[..], &[320.0, 481.0]].concat();
    let error = call("trace a05-lighting-phong", &below).unwrap_err();
    assert_eq!(error, "the pixel is not in 641x481 pixels");
}

/// The balls of `sphere` mirror, and are of a Phong material otherwise.
#[test]
fn a_step_says_by_which_type_the_page_finds_its_formula() {
    let picture = [640.0, 480.0, 1.0, 0.0, 0.0, 6.0, 0.0, 0.0, 0.0, 1.0];
    let numbers = [&picture[..], &[320.0, 240.0]].concat();
    let text = ask("trace a06-shadows-reflection-sphere", &numbers).text;
    for fields in [
        r#"Sphere", "about": "Sphere""#,
        r#""name": "colour of Reflective", "about": "Phong""#,
    ] {
        assert!(text.contains(fields), "no {fields} in {text}");
    }
}

/// From (0, 0, 3) along -z to the sphere: 2 away. The second line is wrong.
#[test]
fn a_scene_file_is_a_picture() {
    let scene = |key| {
        let camera = "[camera]\neye = [0, 0, 3]\ngaze = [0, 0, -1]\nangle = 40";
        format!("file\n{camera}\n[[sphere]]\ncenter = [0, 0, 0]\n{key} = 1\ncolor = [1, 0, 0]")
    };
    let image = ask(&format!("render {}", scene("radius")), &[]);
    assert_eq!(image.pixels[4 * (240 * 640 + 320)..][..4], [255, 0, 0, 255]);
    let error = call(&format!("about {}", scene("radios")), &[]).unwrap_err();
    assert_eq!(
        error,
        "7:1: sphere has no \"radios\"; the nearest is radius"
    );
    let picture = |line: &str| {
        format!(
            "about file\n[picture]\n{line}\n[camera]\neye = [0, 0, 3]\ngaze = [0, 0, -1]\nangle = 40"
        )
    };
    let large = call(&picture("size = [1000, 5000]"), &[]).unwrap_err();
    assert!(large.starts_with("2:8: this page takes at most"), "{large}");
    let deep = call(&picture("depth = 51"), &[]).unwrap_err();
    assert_eq!(deep, "2:9: this page takes a depth of at most 50");
}

#[test]
fn a_wrong_request_is_answered_by_a_sentence() {
    let error = |request| call(request, &[]).unwrap_err();
    assert_eq!(error("torus"), "there is no figure \"torus\"");
    assert_eq!(error("spot"), "the figure spot takes 4 numbers, not 0");
    assert_eq!(error("render nothing"), "there is no picture \"nothing\"");
    let flat = call("slabs", &[0.0; 6]).unwrap_err();
    assert!(flat.contains("direction"), "{flat}");
}

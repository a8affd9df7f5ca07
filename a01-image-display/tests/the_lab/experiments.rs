//! The report on saved pictures. Bytes and errors of JPEG files are not locked:
//! encoder and decoder may round in other ways on other machines.

use measure::Effort;
use measure::experiment::Curve;

fn curves() -> Vec<(&'static str, Curve<'static>)> {
    let experiments = (a01_image_display::stage().experiments)();
    let curves = |e: measure::experiment::Experiment<'static>| {
        let name = e.name;
        (e.curves)(Effort::Quick)
            .into_iter()
            .map(move |c| (name, c))
    };
    experiments.into_iter().flat_map(curves).collect()
}

#[test]
fn png_keeps_every_byte_and_jpeg_at_no_quality() {
    let curves = curves();
    assert_eq!(curves.len(), 6);
    for (name, curve) in curves {
        let exact = curve.method == "PNG";
        assert_eq!(curve.points.len(), if exact { 1 } else { 9 }, "{name}");
        for point in &curve.points {
            assert_eq!(point.max == 0.0, exact, "{name}, quality {}", point.knob);
        }
    }
}

#[test]
fn more_quality_is_more_bytes_and_less_error() {
    for (name, curve) in curves() {
        let at = |quality: f64| curve.points.iter().find(|point| point.knob == quality);
        let marks: Vec<_> = [10.0, 50.0, 90.0, 100.0]
            .into_iter()
            .filter_map(at)
            .collect();
        for pair in marks.windows(2) {
            let [low, high] = [pair[0], pair[1]];
            assert!(low.work < high.work, "{name}, quality {}", high.knob);
            assert!(low.rms > high.rms, "{name}, quality {}", high.knob);
        }
    }
}

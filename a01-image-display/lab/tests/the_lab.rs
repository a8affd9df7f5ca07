//! The report on saved pictures. Bytes and errors of JPEG files are not locked: encoder and decoder
//! may round in other ways on other machines.

use measure::Effort;

#[test]
fn png_keeps_every_byte_and_jpeg_at_no_quality() {
    for experiment in (a01_lab::laboratory().experiments)() {
        let curves = (experiment.curves)(Effort::Quick);
        let [jpeg, png] = &curves[..] else {
            panic!("JPEG and PNG");
        };
        assert_eq!((jpeg.points.len(), png.points.len()), (9, 1));
        assert_eq!(png.points[0].max, 0.0, "{}", experiment.name);
        assert!(jpeg.points.iter().all(|point| point.max > 0.0));
        // More quality is more bytes and less error.
        let at = |quality: &f64| jpeg.points.iter().find(|point| point.parameter == *quality);
        let marks: Vec<_> = [10.0, 50.0, 90.0, 100.0].iter().filter_map(at).collect();
        for pair in marks.windows(2) {
            assert!(pair[0].work < pair[1].work && pair[0].rms > pair[1].rms);
        }
    }
}

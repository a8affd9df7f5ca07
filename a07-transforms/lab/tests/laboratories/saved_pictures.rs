//! The report of stage 1 on saved pictures. Bytes and errors of JPEG files are not locked: encoder and decoder
//! may round in other ways on other machines.

use measure::experiment::Point;

#[test]
fn png_keeps_every_byte_and_jpeg_at_no_quality() {
    for experiment in (a01_lab::laboratory().experiments)() {
        let curves = (experiment.curves)();
        let [jpeg, png] = &curves[..] else {
            panic!("JPEG and PNG");
        };
        assert_eq!((jpeg.points.len(), png.points.len()), (9, 1));
        assert_eq!(png.points[0].errors.max, Some(0.0), "{}", experiment.name);
        assert!(jpeg.points.iter().all(|point| point.errors.max > Some(0.0)));
        // More quality is more bytes and less error.
        let mut marks = Vec::new();
        for quality in [10.0, 50.0, 90.0, 100.0] {
            let of_quality = |point: &&Point| point.parameter == quality;
            marks.extend(jpeg.points.iter().find(of_quality));
        }
        for pair in marks.windows(2) {
            let [coarse, fine] = [pair[0], pair[1]];
            assert!(coarse.work < fine.work && coarse.errors.rms > fine.errors.rms);
        }
    }
}

//! The locked pictures of the errata, and of mistakes in general. Their hashes stand beside those of the stage.

use a07_lab::{errata, go_wrong};
use testing::picture_lock::TestPaths;

const TEST_PATHS: TestPaths = TestPaths {
    stage: concat!(env!("CARGO_MANIFEST_DIR"), "/.."),
    scratch: env!("CARGO_TARGET_TMPDIR"),
    program: "",
};

testing::lock_scenes! {
    every_mistake_is_locked: errata::stage();
    tangent half_pixel stripes box_faces far_sphere highlight point_light point_light_slope spot_light
    directional_light mirror transform normal node
}

testing::lock_scenes! {
    everything_that_goes_wrong_is_locked: go_wrong::stage();
    offset gamma cracks terminator rim coincident
}

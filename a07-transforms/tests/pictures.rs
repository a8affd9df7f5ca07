//! The locked pictures of this stage, of the errata, and of mistakes in general.

use a07_lab::{errata, go_wrong};

testing::lock_pictures! {
    a07_transforms::stage();
    sphere_transformation box_transformations disc
}

testing::lock_scenes! {
    every_mistake_is_locked: errata::stage();
    tangent half_pixel stripes box_faces far_sphere highlight point_light point_light_slope spot_light
    directional_light mirror transform normal node
}

testing::lock_scenes! {
    everything_that_goes_wrong_is_locked: go_wrong::stage();
    offset gamma cracks terminator rim coincident
}

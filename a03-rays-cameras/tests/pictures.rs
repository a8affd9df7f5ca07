//! The locked pictures of this stage.

testing::lock_pictures! { a03_rays_cameras::stage(); striped_sky striped_sky_straight }

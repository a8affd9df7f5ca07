//! The locked pictures of this stage.

testing::lock_pictures! {
    a07_transforms::stage();
    sphere_transformation box_transformations disc
}

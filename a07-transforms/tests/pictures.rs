//! The locked pictures of this stage.

common::lock_pictures! {
    a07_transforms::stage();
    sphere_transformation box_transformations disc
}

//! The locked pictures of this stage.

testing::lock_pictures! {
    a05_lighting::stage();
    lighting_1 lambert phong phong_directional phong_spot phong_spot_ambient
}

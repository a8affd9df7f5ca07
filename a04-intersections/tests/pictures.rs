//! The locked pictures of this stage.

testing::lock_pictures! {
    a04_intersections::stage();
    scene_1 scene_2 scene_3 scene_4 scene_5 scene_6
}

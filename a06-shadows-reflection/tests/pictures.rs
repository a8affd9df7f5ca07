//! The locked pictures of this stage.

testing::lock_pictures! { a06_shadows_reflection::stage(); sphere aab }

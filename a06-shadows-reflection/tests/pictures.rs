//! The locked pictures of this stage.

common::lock_pictures! { a06_shadows_reflection::stage(); sphere aab }

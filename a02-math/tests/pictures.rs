//! The locked picture of this stage.

testing::lock_pictures! { a02_math::stage(); vectors }

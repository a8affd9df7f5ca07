//! The locked picture of this stage.

common::lock_pictures! { a02_math::stage(); vectors }

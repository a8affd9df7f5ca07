//! The pictures of the stage, locked byte for byte.

testing::lock_pictures! { a01_image_display::stage(); diagonal painter show_image }

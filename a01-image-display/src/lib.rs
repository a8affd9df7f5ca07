//! Pixels, pictures and the window that shows them.

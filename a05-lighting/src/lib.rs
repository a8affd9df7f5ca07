//! Lights and materials: Lambert and Phong.

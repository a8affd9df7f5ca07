//! Vectors, points, normals and 3x3 matrices.

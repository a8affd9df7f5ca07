//! Planes, boxes, triangles and spheres, and the world that holds them.

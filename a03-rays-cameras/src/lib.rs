//! Rays, cameras, sampling and the striped sky.

//! Proves the exercises of this stage, which the book sets.

#![allow(unexpected_cfgs, reason = "names of exercises")]

#[cfg(not(learn))]
#[path = "wrong/own.rs"]
mod own;
mod shape;
mod steps;

testing::exercises! {
    chain => |check| chain::check(check, chain);
    under_transform => |check| under_transform::check(check, ray_to_object, normal_from_object);
    node => |check| node::check(check, |t, children| children.into_iter().fold(Node::new(t), Node::with));
    disc => |check| disc::check(check, Disc::new);
    ring => |check| ring::check(check, Ring::new);
    orbits => |check| orbits::check(check, orbits);
    sheared => |check| sheared::check(check, Sheared::new, Sheared::new);
    rotation => |check| rotation::check(check, rotation);
}

//! `Scene`: a scene as a list of items, which belongs to none of the programs that render it.
//!
//! The background is black, because Tachyon paints it, unweakened, where the last mirror
//! that a ray may meet would show something. All lights cast shadows: Tachyon has no other.

use common::Size;
use engine::Basis;
use glam::{DVec3, dvec3};

/// A scene in numbers.
pub struct Scene {
    pub name: &'static str,
    pub about: &'static str,
    /// The place of the camera, and the direction in which it looks.
    pub view: [DVec3; 2],
    pub lights: fn() -> Vec<Item>,
    /// How many surfaces a ray may meet.
    pub depth: u32,
    /// The shares of light in highlights and mirrors, the same for all materials.
    pub shares: [f64; 2],
    /// Makes the objects one after the other: a list of them would count among
    /// the memory of the program that we measure.
    pub objects: fn() -> Items,
}

pub type Items = Box<dyn Iterator<Item = Item>>;

/// A part of a scene: its kind, and the vectors that belong to it.
#[derive(Clone, Copy)]
pub struct Item {
    pub kind: Kind,
    pub vectors: [DVec3; 7],
    /// The index of its colour, of an object or a material.
    pub color: usize,
}

#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Eye, right, up and forward for a picture of height 1; its sides, bottom and top at
    /// distance 1 and half a pixel aside; width, height and depth.
    Camera,
    /// Colour; highlight, its exponent and mirrored light; ambient light.
    Material,
    /// Colour and position.
    Point,
    /// Colour, position, direction, a point on the axis and half the angle in degrees.
    Spot,
    /// Colour, a far position and direction.
    Directional,
    /// Normal of a plane through the origin: Tachyon misplaces others.
    Plane,
    /// Centre and radius.
    Sphere,
    /// Corners of a cube: Tachyon turns the faces of other boxes.
    Cube,
    /// Centre, normal and radius.
    Disc,
    /// Three corners.
    Triangle,
    /// Three corners and their normals.
    Smooth,
    /// Smooth triangles of one material follow, and end.
    Mesh,
    EndOfMesh,
    /// The images of the axes and of the origin, for the next object.
    Transform,
    End,
}

/// An item with these vectors.
pub fn item(kind: Kind, vectors: &[DVec3], color: usize) -> Item {
    let vectors = std::array::from_fn(|i| vectors.get(i).copied().unwrap_or_default());
    Item {
        kind,
        vectors,
        color,
    }
}

/// Six colours and a dark grey.
const COLORS: [DVec3; 7] = [
    dvec3(0.8, 0.1, 0.1),
    dvec3(0.1, 0.7, 0.2),
    dvec3(0.1, 0.2, 0.8),
    dvec3(0.8, 0.7, 0.1),
    dvec3(0.7, 0.1, 0.7),
    dvec3(0.1, 0.7, 0.7),
    dvec3(0.2, 0.2, 0.2),
];

/// The index of the grey, which is also the number of colours before it.
pub const GREY: usize = 6;
/// The share of each colour that is seen without any light.
pub const AMBIENT: f64 = 0.1;
/// Half the vertical opening angle of all cameras, in radians.
pub const HALF_ANGLE: f64 = std::f64::consts::FRAC_PI_8;

impl Scene {
    /// All items: the camera, the materials, the lights and the objects.
    pub fn items(&self, size: Size) -> impl Iterator<Item = Item> {
        let shares = dvec3(self.shares[0], 32.0, self.shares[1]);
        let material = move |(i, color): (usize, &DVec3)| {
            item(Kind::Material, &[*color, shares, DVec3::splat(AMBIENT)], i)
        };
        let materials = COLORS.iter().enumerate().map(material);
        let start = std::iter::once(self.camera(size)).chain(materials);
        start
            .chain((self.lights)())
            .chain((self.objects)())
            .chain([item(Kind::End, &[], 0)])
    }

    /// The axes of the camera, which is held upright.
    pub fn basis(&self) -> Basis {
        let [e, gaze] = self.view;
        let w = -gaze.normalize();
        let u = DVec3::Y.cross(w).normalize();
        let v = w.cross(u);
        Basis { e, u, v, w }
    }

    fn camera(&self, size: Size) -> Item {
        let (Basis { e, u, v, w }, top) = (self.basis(), libm::tan(HALF_ANGLE));
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let (left, half) = (top * width / height, top / height);
        let vectors = [
            e,
            u * (width / height),
            v,
            w * (-0.5 / top),
            dvec3(left + half, half - left, 0.0),
            dvec3(-top - half, top - half, 0.0),
            dvec3(width, height, self.depth.into()),
        ];
        item(Kind::Camera, &vectors, 0)
    }
}

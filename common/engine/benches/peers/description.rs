//! `Description`: a scene that belongs to none of the programs that render it.

use glam::DMat4;

/// A point, a direction or a colour.
pub type Triple = [f64; 3];

/// A scene. The background is black, because Tachyon paints it, unweakened, where the
/// last mirror that a ray may meet would show something.
pub struct Description {
    pub name: &'static str,
    /// For the reader of the table.
    pub about: &'static str,
    /// Whether most rays start at mirrors, or in the middle of the objects.
    pub is_incoherent: bool,
    pub camera: Camera,
    pub lights: Vec<Light>,
    /// The share of each colour that is seen without any light.
    pub ambient: f64,
    /// How many surfaces a ray may meet.
    pub depth: u32,
    pub materials: Vec<Material>,
    /// Makes the objects one after the other: a list of them would count among
    /// the memory of the program that we measure.
    pub objects: fn() -> Objects,
}

pub type Objects = Box<dyn Iterator<Item = Object>>;

/// A perspective camera, with its full vertical opening angle in radians.
pub struct Camera {
    pub eye: Triple,
    pub gaze: Triple,
    pub up: Triple,
    pub angle: f64,
}

/// A light that does not grow weaker with the distance. It casts shadows, as Tachyon
/// knows no other.
pub struct Light {
    pub color: Triple,
    pub kind: LightKind,
}

pub enum LightKind {
    /// At a place.
    Point(Triple),
    /// At a place, around a direction, up to an angle in degrees.
    Spot(Triple, Triple, f64),
    /// Travels in a direction.
    Directional(Triple),
}

/// Phong's model as all programs have it: highlights take the colour of the
/// light, and mirrors show all channels alike.
pub struct Material {
    pub color: Triple,
    pub specular: f64,
    pub exponent: f64,
    pub reflection: f64,
}

/// A shape, and which of the materials it is made of.
pub struct Object {
    pub shape: Shape,
    pub material: usize,
}

pub enum Shape {
    /// The normal of a plane through the origin: Tachyon misplaces others.
    Plane(Triple),
    /// Centre and radius.
    Sphere(Triple, f64),
    /// Centre and half the edge: the normals of Tachyon's other boxes are wrong.
    Cube(Triple, f64),
    /// Centre, normal and radius.
    Disc(Triple, Triple, f64),
    Triangle([Triple; 3]),
    Mesh(Mesh),
    /// A shape under transforms, from the innermost to the outermost.
    Node(Box<Shape>, Vec<DMat4>),
}

/// Smooth triangles: corners, the normal at each, and three corners a triangle.
pub struct Mesh {
    pub corners: Vec<Triple>,
    pub normals: Vec<Triple>,
    pub triangles: Vec<[u32; 3]>,
}

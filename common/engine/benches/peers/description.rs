//! `Description`: a scene that belongs to none of the programs that render it.

/// A point, a direction or a colour.
pub type Triple = [f64; 3];

/// A scene. The background is black, because Tachyon paints it, unweakened, where the
/// last mirror that a ray may meet would show something.
pub struct Description {
    pub name: &'static str,
    pub camera: Camera,
    pub light: Light,
    /// The share of each colour that is seen without any light.
    pub ambient: f64,
    /// How many surfaces a ray may meet.
    pub depth: u32,
    pub materials: Vec<Material>,
    /// Makes the objects one after the other: a list of them would count among
    /// the memory of the program that we measure.
    pub objects: fn() -> Box<dyn Iterator<Item = Object>>,
}

/// A perspective camera, with its full vertical opening angle in radians.
pub struct Camera {
    pub eye: Triple,
    pub gaze: Triple,
    pub up: Triple,
    pub angle: f64,
}

/// A white light that does not grow weaker. It casts shadows, as Tachyon knows
/// no other.
pub enum Light {
    /// At a place.
    Point(Triple),
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
    /// Point and normal.
    Plane(Triple, Triple),
    /// Centre and radius.
    Sphere(Triple, f64),
    /// Opposite corners, the smaller numbers first.
    Box(Triple, Triple),
    Triangle([Triple; 3]),
    Mesh(Mesh),
}

/// Smooth triangles: corners, the normal at each, and three corners a triangle.
pub struct Mesh {
    pub corners: Vec<Triple>,
    pub normals: Vec<Triple>,
    pub triangles: Vec<[usize; 3]>,
}

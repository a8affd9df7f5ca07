//! `synonyms`: names of other programs for tables and keys of a scene file.

/// Names, and the names that a scene file has for them.
const SYNONYMS: &[(&str, &str)] = &[
    ("aabb", "box"),
    ("ball", "sphere"),
    ("block", "box"),
    ("bottom", "lbf"),
    ("brightness", "color"),
    ("brick", "box"),
    ("center_point", "center"),
    ("circle", "disc"),
    ("colour", "color"),
    ("copies", "count"),
    ("cube", "box"),
    ("cuboid", "box"),
    ("def", "define"),
    ("definition", "define"),
    ("directional", "directional_light"),
    ("disk", "disc"),
    ("facing", "gaze"),
    ("field_of_view", "angle"),
    ("filename", "file"),
    ("floor", "plane"),
    ("forward", "gaze"),
    ("fov", "angle"),
    ("fovy", "angle"),
    ("from", "eye"),
    ("ground", "plane"),
    ("instance", "use"),
    ("intensity", "color"),
    ("kd", "diffuse"),
    ("ks", "specular"),
    ("lamp", "point_light"),
    ("light", "point_light"),
    ("lookat", "look_at"),
    ("location", "eye"),
    ("loop", "repeat"),
    ("max", "run"),
    ("min", "lbf"),
    ("model", "mesh"),
    ("move", "translate"),
    ("n", "exponent"),
    ("number", "count"),
    ("obj", "mesh"),
    ("object", "group"),
    ("offset", "translate"),
    ("parallel_light", "directional_light"),
    ("path", "file"),
    ("phong_size", "exponent"),
    ("position", "eye"),
    ("pos", "eye"),
    ("r", "radius"),
    ("reflectance", "reflection"),
    ("reflective", "reflection"),
    ("reflectivity", "reflection"),
    ("resize", "scale"),
    ("resolution", "size"),
    ("rotate_x", "rotate"),
    ("rotate_y", "rotate"),
    ("rotate_z", "rotate"),
    ("rotation", "rotate"),
    ("shininess", "exponent"),
    ("sky", "background"),
    ("source", "file"),
    ("spot", "spot_light"),
    ("step", "translate"),
    ("spotlight", "spot_light"),
    ("sun", "directional_light"),
    ("target", "look_at"),
    ("times", "count"),
    ("to", "look_at"),
    ("top", "run"),
    ("transformation", "transform"),
    ("transforms", "transform"),
    ("translation", "translate"),
    ("upwards", "up"),
    ("vertices", "corners"),
];

/// Those of lights and spheres for "position".
const OTHER_PLACES: [(&str, &str); 8] = [
    ("pos", "position"),
    ("location", "position"),
    ("eye", "position"),
    ("pos", "center"),
    ("position", "center"),
    ("location", "center"),
    ("position", "point"),
    ("angle", "half_angle"),
];

/// Shapes that a scene file has no table for, and what has their form.
const OTHER_SHAPES: &[(&str, &str)] = &[
    ("capsule", "a mesh"),
    ("cone", "a mesh"),
    ("cylinder", "a mesh"),
    ("ellipsoid", "a sphere with a scale in its transform"),
    ("pyramid", "a mesh, or triangles"),
    ("quad", "two triangles, or a box that is flat"),
    ("rectangle", "two triangles, or a box that is flat"),
    ("square", "two triangles, or a box that is flat"),
    ("torus", "a mesh"),
    ("tube", "a mesh"),
];

/// What has the form of another program's shape, if it is one.
pub fn form_of(name: &str) -> Option<&'static str> {
    let name = name.to_lowercase();
    let found = OTHER_SHAPES.iter().find(|(shape, _)| *shape == name);
    found.map(|(_, form)| *form)
}

/// The known name for another program's, if there is one.
pub fn known_for<'a>(known: &[&'a str], name: &str) -> Option<&'a str> {
    let name = name.to_lowercase();
    let mut pairs = SYNONYMS.iter().chain(&OTHER_PLACES);
    pairs.find_map(|(foreign, own)| {
        let found = known.iter().find(|known| *known == own);
        found.copied().filter(|_| *foreign == name)
    })
}

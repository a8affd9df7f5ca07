//! Reads PLY files (Turk, *The PLY Polygon File Format*, 1994): vertices with their normals, faces,
//! and strips of triangles.

use common::text::number;

use super::NONE;
use super::ply_header::{self, Element, Header, Property};
use super::ply_numbers::{NoNumber, Numbers};
use super::polygons::{Format, Polygons};

/// The properties of a vertex: its place and its normal.
const COORDINATES: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// The vertices with their normals, and the faces. The error is a clause.
pub fn read(bytes: &[u8]) -> Result<Polygons, String> {
    let (Header { encoding, elements }, rest) = ply_header::read(bytes)?;
    let mut numbers = Numbers { encoding, rest };
    let mut reader = Reader::default();
    reader.polygons.format = Format::Ply { element: "face" };
    // Faces may stand before the vertices, whose normals have the indices of their corners.
    reader.has_normals = elements.iter().any(|element| {
        let mut properties = element.properties.iter();
        element.name == "vertex" && properties.any(|property| property.is_number("nx"))
    });
    for element in &elements {
        check(element)?;
        // Things without properties take no bytes, so that any number of them may be promised.
        if element.properties.is_empty() {
            continue;
        }
        for i in 0..element.count {
            let added = reader.add(element, i as usize, &mut numbers);
            added.map_err(|mistake| {
                let Element { name, count, .. } = element;
                match mistake {
                    Mistake::Number(NoNumber::End) => {
                        format!("it ends within {name} {i} of {count}, from 0: it is cut off")
                    }
                    Mistake::Number(NoNumber::Word(word)) => {
                        format!("{name} {i} has \"{word}\" where a number should be")
                    }
                    Mistake::Length(length) => {
                        format!("{name} {i} has a list of {} numbers", number(length))
                    }
                    Mistake::Vertex(index) => format!(
                        "{name} {i} has the vertex {}, but vertices are numbered from 0",
                        number(index)
                    ),
                }
            })?;
        }
    }
    Ok(reader.polygons)
}

/// What is wrong in a vertex or a face.
enum Mistake {
    /// A number that is not there.
    Number(NoNumber),
    /// A length of a list that is none.
    Length(f64),
    /// An index that is none.
    Vertex(f64),
}

/// Checks that the things of an element have the properties that are needed.
fn check(element: &Element) -> Result<(), String> {
    let has = |name: &str| {
        let mut properties = element.properties.iter();
        properties.any(|property| property.is_number(name))
    };
    match element.name.as_str() {
        "vertex" if element.count > 0 => {
            let missing: Vec<_> = ["x", "y", "z"].into_iter().filter(|x| !has(x)).collect();
            if !missing.is_empty() {
                let missing = missing.join(" and ");
                return Err(format!("its vertices lack the property {missing}"));
            }
        }
        name @ ("face" | "tristrips") if element.count > 0 => {
            let mut properties = element.properties.iter();
            if !properties.any(Property::is_corners) {
                return Err(format!("its element {name} lacks the list vertex_indices"));
            }
        }
        _ => (),
    }
    Ok(())
}

#[derive(Default)]
struct Reader {
    polygons: Polygons,
    /// Whether vertices have normals, so that the normal has the index of its corner.
    has_normals: bool,
    /// The numbers of the property that was read last.
    list: Vec<f64>,
}

impl Reader {
    /// Adds the next thing of an element.
    fn add(
        &mut self,
        element: &Element,
        place: usize,
        numbers: &mut Numbers,
    ) -> Result<(), Mistake> {
        let mut vertex = [f64::NAN; 6];
        for property in &element.properties {
            let Some(length) = property.length else {
                let number = numbers.next(property.kind).map_err(Mistake::Number)?;
                if element.name == "vertex"
                    && let Some(i) = COORDINATES.iter().position(|name| *name == property.name)
                {
                    vertex[i] = number;
                }
                continue;
            };
            let length = numbers.next(length).map_err(Mistake::Number)?;
            if length.fract() != 0.0 || !(0.0..=f64::from(u32::MAX)).contains(&length) {
                return Err(Mistake::Length(length));
            }
            self.list.clear();
            for _ in 0..length as u64 {
                let number = numbers.next(property.kind).map_err(Mistake::Number)?;
                self.list.push(number);
            }
            if property.is_corners() {
                match element.name.as_str() {
                    "face" => self.add_face(place)?,
                    "tristrips" => self.add_strips(place)?,
                    _ => {}
                }
            }
        }
        if element.name == "vertex" {
            let [x, y, z, normal @ ..] = vertex;
            let place = format_args!("vertex {place}");
            self.polygons.add_position([x, y, z], place);
            if self.has_normals {
                self.polygons.normals.push(normal);
            }
        }
        Ok(())
    }

    /// Adds a face whose corners are the list.
    fn add_face(&mut self, place: usize) -> Result<(), Mistake> {
        for index in &self.list {
            let corner = corner(*index, self.has_normals)?;
            self.polygons.corners.push(corner);
        }
        self.polygons.end_face(place);
        Ok(())
    }

    /// Adds the strips of a list, between which stands -1. Each three neighbours in a strip are a triangle, and
    /// every second one goes round the other way.
    fn add_strips(&mut self, place: usize) -> Result<(), Mistake> {
        self.polygons.format = Format::Ply {
            element: "tristrips",
        };
        // An unsigned type has no -1.
        let is_between = |index: &f64| *index == -1.0 || *index == f64::from(u32::MAX);
        for strip in self.list.split(is_between) {
            for (i, triangle) in strip.windows(3).enumerate() {
                let order = if i % 2 == 0 { [0, 1, 2] } else { [1, 0, 2] };
                for index in order.map(|k| triangle[k]) {
                    let corner = corner(index, self.has_normals)?;
                    self.polygons.corners.push(corner);
                }
                self.polygons.end_face(place);
            }
            if let 1 | 2 = strip.len() {
                self.polygons.end_face(place);
            }
        }
        Ok(())
    }
}

impl Property {
    /// Whether it is a number of this name.
    fn is_number(&self, name: &str) -> bool {
        self.length.is_none() && self.name == name
    }

    /// Whether it is the list of a face's corners.
    fn is_corners(&self) -> bool {
        self.length.is_some() && self.name.starts_with("vertex_ind")
    }
}

/// The indices of a corner and of its normal.
fn corner(index: f64, has_normals: bool) -> Result<[u32; 2], Mistake> {
    if index.fract() != 0.0 || !(0.0..f64::from(NONE - 1)).contains(&index) {
        return Err(Mistake::Vertex(index));
    }
    let index = index as u32;
    Ok([index, if has_normals { index } else { NONE }])
}

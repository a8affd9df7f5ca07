//! The introduction maps every section of both protocols to its place.

use crate::Files;
use crate::page::complaint;

/// The page with the map: a table for each protocol, with the columns number,
/// name, place in the book and place in the code.
const MAP: &str = "book/src/introduction.md";

/// Numbers and names of the first protocol's sections.
const FIRST: [(&str, &str); 53] = [
    ("1", "Preparation"),
    ("2", "World"),
    ("2.1", "Changes to World"),
    ("3", "Raytracer"),
    ("3.1", "Test methods"),
    ("4", "Painter"),
    ("4.1", "Variables"),
    ("4.2", "Constructor"),
    ("4.3", "setupPanel()"),
    ("4.4", "Further methods"),
    ("5", "PaintDiagonal"),
    ("6", "ShowImage"),
    ("7", "Mat3x3, Vector3, Point3 and Normal3"),
    ("8", "Ray"),
    ("9", "The cameras"),
    ("9.1", "OrthographicCamera"),
    ("9.2", "PerspectiveCamera"),
    ("10", "Color"),
    ("11", "The geometry"),
    ("11.1", "Plane"),
    ("11.2", "AxisAlignedBox"),
    ("11.3", "Triangle"),
    ("11.4", "Sphere"),
    ("11.5", "Hit"),
    ("12", "Lights"),
    ("12.1", "PointLight"),
    ("12.2", "Spotlight"),
    ("12.3", "DirectionalLight"),
    ("13", "Material"),
    ("13.1", "SingleColorMaterial"),
    ("13.2", "PhongMaterial"),
    ("13.3", "LambertMaterial"),
    ("14", "Shadows"),
    ("14.1", "Changes to illuminates()"),
    ("14.1.1", "PointLight"),
    ("14.1.2", "SpotLight"),
    ("14.1.3", "DirectionalLight"),
    ("15", "Reflection"),
    ("15.1", "RecursiveTracer"),
    ("15.2", "ReflectiveMaterial"),
    ("16", "Transformations"),
    ("16.1", "Mat4x4"),
    ("16.2", "Transform"),
    ("16.2.1", "translation()"),
    ("16.2.2", "rescale()"),
    ("16.2.3", "rotationOnX(), rotationOnY(), rotationOnZ()"),
    ("16.2.4", "multiply()"),
    ("17", "Scene graph"),
    ("17.1", "Node"),
    ("17.1.1", "hit()"),
    ("18", "Disc"),
    ("18.1", "hit()"),
    ("19", "Progress bar"),
];

/// The sections of the second protocol.
const SECOND: [(&str, &str); 4] = [
    ("3.1", "Vectors"),
    ("3.2", "Ray"),
    ("3.3", "Pinhole camera"),
    ("3.4", "Background"),
];

/// The sections that the map lacks, and its links that point to nothing.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = map("first protocol", &FIRST, files);
    complaints.extend(map("second protocol", &SECOND, files));
    complaints
}

fn map(protocol: &str, sections: &[(&str, &str)], files: &Files) -> Vec<String> {
    let text = files.text(MAP).unwrap_or_default();
    let lines = text.lines().enumerate();
    let mut table = lines
        .skip_while(|(_, line)| !line.starts_with(&format!("| {protocol} |")))
        .take_while(|(_, line)| line.starts_with('|'))
        .map(|(index, line)| (index + 1, cells(line)));
    let Some((head, _)) = table.next() else {
        return vec![complaint(
            MAP,
            1,
            &format!("there is no table of the {protocol}"),
        )];
    };
    let rows: Vec<_> = table.skip(1).collect();
    let mut complaints = Vec::new();
    for (number, name) in sections {
        let found = rows.iter().any(|(_, row)| row[..2] == [*number, *name]);
        if !found {
            let wrong = format!("the {protocol}'s section {number}, {name}, is missing");
            complaints.push(complaint(MAP, head, &wrong));
        }
    }
    for (line, row) in &rows {
        let wrong = |what: String| complaint(MAP, *line, &what);
        if !sections
            .iter()
            .any(|(number, name)| row[..2] == [*number, *name])
        {
            complaints.push(wrong(format!(
                "the {protocol} has no section {}, {}",
                row[0], row[1]
            )));
        }
        if !row[2].contains("](") {
            complaints.push(wrong(format!(
                "section {} has no place in the book",
                row[0]
            )));
        }
        let places: Vec<_> = row[3].split('`').skip(1).step_by(2).collect();
        if places.is_empty() {
            complaints.push(wrong(format!(
                "section {} has no place in the code",
                row[0]
            )));
        }
        for place in places
            .into_iter()
            .filter(|place| files.text(place).is_none())
        {
            complaints.push(wrong(format!("{place} does not exist")));
        }
    }
    complaints
}

/// The four columns of a row; a missing one is empty.
fn cells(line: &str) -> [&str; 4] {
    let mut cells = line.trim_matches('|').split('|').map(str::trim);
    std::array::from_fn(|_| cells.next().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECTIONS: [(&str, &str); 2] = [("1", "One"), ("1.1", "Two")];
    const HEAD: &str = "# Map\n\n| protocol | | book | code |\n|---|---|---|---|\n";
    const ONE: &str = "| 1 | One | [a](a.md) | `a.rs` |\n";
    const TWO: &str = "| 1.1 | Two | [a](a.md) | `a.rs`, `b.rs` |\n";

    fn complaints_about(rows: &str) -> Vec<String> {
        let text = format!("{HEAD}{rows}\n\n| another | table |\n");
        let files = Files::of([(MAP, &text), ("a.rs", ""), ("b.rs", "")]);
        map("protocol", &SECTIONS, &files)
    }

    #[test]
    fn a_map_of_all_sections_is_right() {
        assert_eq!(complaints_about(&format!("{ONE}{TWO}")), [""; 0]);
    }

    #[test]
    fn a_missing_section_is_found() {
        assert_eq!(
            complaints_about(ONE),
            [format!(
                "{MAP}:3: the protocol's section 1.1, Two, is missing"
            )]
        );
    }

    #[test]
    fn a_missing_table_is_found() {
        let files = Files::of([(MAP, "# Map")]);
        assert_eq!(
            map("protocol", &SECTIONS, &files),
            [format!("{MAP}:1: there is no table of the protocol")]
        );
    }

    #[test]
    fn an_invented_section_is_found() {
        let three = "| 1.2 | Three | [a](a.md) | `a.rs` |\n";
        assert_eq!(
            complaints_about(&format!("{ONE}{TWO}{three}")),
            [format!("{MAP}:7: the protocol has no section 1.2, Three")]
        );
    }

    #[test]
    fn a_place_that_is_none_is_found() {
        let nowhere = "| 1.1 | Two | somewhere | a.rs |\n";
        assert_eq!(
            complaints_about(&format!("{ONE}{nowhere}")),
            [
                format!("{MAP}:6: section 1.1 has no place in the book"),
                format!("{MAP}:6: section 1.1 has no place in the code")
            ]
        );
        let gone = TWO.replace("b.rs", "c.rs");
        assert_eq!(
            complaints_about(&format!("{ONE}{gone}")),
            [format!("{MAP}:6: c.rs does not exist")]
        );
    }

    #[test]
    fn both_protocols_have_their_map() {
        let expected = ["first", "second"]
            .map(|protocol| format!("{MAP}:1: there is no table of the {protocol} protocol"));
        assert_eq!(complaints(&Files::of([(MAP, "# Map")])), expected);
    }
}

//! `Header`: the elements of a PLY file with their properties, and the format of the numbers behind
//! it.

use common::text;

/// The elements of a file, and the format of their numbers.
#[derive(Debug, Default)]
pub struct Header {
    /// How the numbers are written.
    pub encoding: Encoding,
    /// What stands in the file, in its order.
    pub elements: Vec<Element>,
}

/// How numbers are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// As words.
    #[default]
    Ascii,
    /// As bytes, the least significant one first.
    LittleEndian,
    /// As bytes, the most significant one first.
    BigEndian,
}

/// Things of one kind, such as vertices.
#[derive(Debug)]
pub struct Element {
    /// The name of the kind.
    pub name: String,
    /// How many there are, as the header promises.
    pub count: u64,
    /// The numbers of each thing.
    pub properties: Vec<Property>,
}

/// A number or a list of numbers.
#[derive(Debug)]
pub struct Property {
    /// Its name, such as `x`.
    pub name: String,
    /// The type of the number of numbers; none for a single number.
    pub length: Option<Type>,
    /// The type of the number, or of those in the list.
    pub kind: Type,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    Int8,
    Uint8,
    Int16,
    Uint16,
    Int32,
    Uint32,
    Float32,
    Float64,
}

impl Type {
    /// The type of a name, in the spelling of 1994 or with its size.
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::Int8,
            "uchar" | "uint8" => Self::Uint8,
            "short" | "int16" => Self::Int16,
            "ushort" | "uint16" => Self::Uint16,
            "int" | "int32" => Self::Int32,
            "uint" | "uint32" => Self::Uint32,
            "float" | "float32" => Self::Float32,
            "double" | "float64" => Self::Float64,
            _ => return None,
        })
    }
}

/// Whether the first line is `ply`.
pub fn is_ply(bytes: &[u8]) -> bool {
    let after = bytes.strip_prefix(b"ply");
    after.is_some_and(|rest| rest.first().is_none_or(u8::is_ascii_whitespace))
}

/// The header, and the bytes behind it. The error is a clause.
pub fn read(bytes: &[u8]) -> Result<(Header, &[u8]), String> {
    let mut header = Header::default();
    let mut rest = bytes;
    // Where each line ends with CR alone, an LF behind the header is the first byte of a number.
    let mut has_cr_alone = true;
    loop {
        let end = rest.iter().position(|byte| matches!(byte, b'\r' | b'\n'));
        let (line, below) = rest.split_at(end.ok_or("it has no line end_header")?);
        let is_end = line.trim_ascii() == b"end_header";
        let is_cr_lf = below.starts_with(b"\r\n") && !(is_end && has_cr_alone);
        has_cr_alone &= below.starts_with(b"\r") && !is_cr_lf;
        rest = &below[if is_cr_lf { 2 } else { 1 }..];
        if is_end {
            return Ok((header, rest));
        }
        header.add(line)?;
    }
}

impl Header {
    fn add(&mut self, line: &[u8]) -> Result<(), String> {
        let text = String::from_utf8_lossy(line);
        let words: Vec<_> = text.split_ascii_whitespace().collect();
        match words[..] {
            // Comments may have bytes of any encoding.
            [] | ["ply" | "comment" | "obj_info", ..] => (),
            ["format", name, ..] => {
                self.encoding = match name {
                    "ascii" => Encoding::Ascii,
                    "binary_little_endian" => Encoding::LittleEndian,
                    "binary_big_endian" => Encoding::BigEndian,
                    _ => {
                        let name = text::name(name);
                        return Err(format!(
                            "its format is \"{name}\", but there is ascii, binary_little_endian \
                             and binary_big_endian"
                        ));
                    }
                };
            }
            ["element", name, count] => {
                let Ok(count) = count.parse() else {
                    let line = text::name(&text);
                    return Err(format!("its header has \"{line}\", without a count"));
                };
                self.elements.push(Element {
                    name: name.to_owned(),
                    count,
                    properties: Vec::new(),
                });
            }
            ["property", "list", length, kind, name] => {
                let (length, kind) = (named(length, name)?, named(kind, name)?);
                self.add_property(name, Some(length), kind)?;
            }
            ["property", kind, name] => self.add_property(name, None, named(kind, name)?)?,
            _ => {
                let line = text::name(&text);
                return Err(format!("its header has the unknown line \"{line}\""));
            }
        }
        Ok(())
    }

    fn add_property(&mut self, name: &str, length: Option<Type>, kind: Type) -> Result<(), String> {
        let name = name.to_owned();
        let Some(element) = self.elements.last_mut() else {
            let name = text::name(&name);
            return Err(format!(
                "its property {name} stands before the first element"
            ));
        };
        element.properties.push(Property { name, length, kind });
        Ok(())
    }
}

/// The type of a property.
fn named(kind: &str, property: &str) -> Result<Type, String> {
    Type::named(kind).ok_or_else(|| {
        let (kind, property) = (text::name(kind), text::name(property));
        format!(
            "its property {property} has the unknown type {kind}; there is char, uchar, short, \
             ushort, int, uint, float and double"
        )
    })
}

//! `Svg`: a picture of lines, marks and text in colours for light and dark pages.

use std::fmt::Write;

/// Colours that colour-blind people can distinguish, too (Okabe and Ito, Color Universal
/// Design, 2008). Without variables, which only browsers know.
const STYLE: &str = "\
svg{font:13px system-ui,sans-serif}.small{font-size:11.5px}.bold{font-weight:600}
.middle{text-anchor:middle}.end{text-anchor:end}path{fill:none}
.curve{stroke-width:2}.object{stroke-width:3;opacity:.45}.key{stroke-width:12;opacity:.45}
.estimate{stroke-dasharray:6 4}.mark{stroke-width:1.8}
rect,.mark{fill:#fff}text{fill:#282828}.small{fill:#6b6b6b}path{stroke:#282828}.grid{stroke:#e4e4e4}
.c0{stroke:#0072b2}.c1{stroke:#d55e00}.c2{stroke:#009e73}.c3{stroke:#b4558c}
.c4{stroke:#3a94cf}.c5{stroke:#8a6100}.c6{stroke:#3c3c3c}.c7{stroke:#5e3c99}
@media(prefers-color-scheme:dark){
rect,.mark{fill:#181a1b}text{fill:#e1e1e1}.small{fill:#a0a0a0}path{stroke:#e1e1e1}.grid{stroke:#393c3e}
.c0{stroke:#56b4e9}.c1{stroke:#e69f00}.c2{stroke:#00be8c}.c3{stroke:#e696c3}
.c4{stroke:#8c9cff}.c5{stroke:#f0e442}.c6{stroke:#c8c8c8}.c7{stroke:#ff9d8a}}
";

/// The marks of the curves, around (0, 0): open, so that equal points of several curves
/// are all seen.
const MARKS: [&str; 8] = [
    "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0z",
    "M-3.6-3.6h7.2v7.2h-7.2z",
    "M0-5L4.6 3.4H-4.6z",
    "M0-5.4L4 0L0 5.4L-4 0z",
    "M0 5L4.6-3.4H-4.6z",
    "M-2.4 0a2.4 2.4 0 1 0 4.8 0a2.4 2.4 0 1 0-4.8 0z",
    "M-2-2h4v4h-4z",
    "M-4-4L4 4M-4 4L4-4",
];

/// A picture.
pub struct Svg(String);

impl Svg {
    /// An empty picture with a title for readers that do not see it.
    #[must_use]
    pub fn new([width, height]: [f64; 2], title: &str) -> Self {
        let title = escaped(title);
        let size = format!(r#"width="{width}" height="{height}""#);
        Self(format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" {size} role="img">
<title>{title}</title>
<style>{STYLE}</style>
<rect {size}/>
"#
        ))
    }

    /// Text at a position. An empty text is left out.
    pub fn text(&mut self, class: &str, [x, y]: [f64; 2], text: &str) {
        if !text.is_empty() {
            let text = escaped(text);
            let place = format_args!(r#"x="{x:.1}" y="{y:.1}""#);
            let _ = writeln!(self.0, r#"<text class="{class}" {place}>{text}</text>"#);
        }
    }

    /// A line through points.
    pub fn line(&mut self, class: &str, points: &[[f64; 2]]) {
        let points = points.iter().map(|[x, y]| format!("{x:.1} {y:.1}"));
        self.path(class, &format!("M{}", points.collect::<Vec<_>>().join("L")));
    }

    /// A path in the notation of SVG.
    pub fn path(&mut self, class: &str, path: &str) {
        let _ = writeln!(self.0, r#"<path class="{class}" d="{path}"/>"#);
    }

    /// The mark of a curve.
    pub fn mark(&mut self, curve: usize, [x, y]: [f64; 2]) {
        let (color, mark) = (color(curve), MARKS[curve % MARKS.len()]);
        let place = format_args!(r#"transform="translate({x:.1} {y:.1})""#);
        let _ = writeln!(self.0, r#"<path class="mark {color}" {place} d="{mark}"/>"#);
    }

    /// The finished file.
    #[must_use]
    pub fn finish(self) -> String {
        self.0 + "</svg>\n"
    }
}

/// The class of the colour of a curve.
#[must_use]
pub fn color(curve: usize) -> String {
    format!("c{}", curve % MARKS.len())
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

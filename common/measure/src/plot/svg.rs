//! `Svg`: a picture of lines, marks and text in colours for light and dark pages.

use std::fmt::Write;

/// Colours that colour-blind people can distinguish, too (Okabe and Ito, Color Universal
/// Design, 2008); the book's diagrams choose between light and dark in the same way.
const STYLE: &str = "\
svg{--paper:#fff;--ink:#282828;--pale:#6b6b6b;--grid:#e4e4e4;--c0:#0072b2;--c1:#d55e00;
--c2:#009e73;--c3:#b4558c;--c4:#3a94cf;--c5:#8a6100;--c6:#3c3c3c;font:13px system-ui,sans-serif}
@media(prefers-color-scheme:dark){
svg{--paper:#181a1b;--ink:#e1e1e1;--pale:#a0a0a0;--grid:#393c3e;--c0:#56b4e9;--c1:#e69f00;
--c2:#00be8c;--c3:#e696c3;--c4:#8c9cff;--c5:#f0e442;--c6:#c8c8c8}}
rect{fill:var(--paper)}text{fill:var(--ink)}.title{font-weight:600;font-size:16px}
.small{font-size:11.5px;fill:var(--pale)}.middle{text-anchor:middle}.end{text-anchor:end}
path{fill:none;stroke:var(--ink)}.grid{stroke:var(--grid)}.level{stroke-dasharray:2 3}
.c0{stroke:var(--c0)}.c1{stroke:var(--c1)}.c2{stroke:var(--c2)}.c3{stroke:var(--c3)}
.c4{stroke:var(--c4)}.c5{stroke:var(--c5)}.c6{stroke:var(--c6)}.curve{stroke-width:2}
.estimate{stroke-dasharray:6 4}.mark{fill:var(--paper);stroke-width:1.8}
";

/// The marks of the curves, around (0, 0): open, so that equal points of several curves
/// are all seen.
const MARKS: [&str; 7] = [
    "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0z",
    "M-3.6-3.6h7.2v7.2h-7.2z",
    "M0-5L4.6 3.4H-4.6z",
    "M0-5.4L4 0L0 5.4L-4 0z",
    "M0 5L4.6-3.4H-4.6z",
    "M-2.4 0a2.4 2.4 0 1 0 4.8 0a2.4 2.4 0 1 0-4.8 0z",
    "M-2-2h4v4h-4z",
];

/// A picture.
pub struct Svg(String);

impl Svg {
    /// An empty picture with a title for readers that do not see it.
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
        let path = points.collect::<Vec<_>>().join("L");
        let _ = writeln!(self.0, r#"<path class="{class}" d="M{path}"/>"#);
    }

    /// The mark of a curve.
    pub fn mark(&mut self, curve: usize, [x, y]: [f64; 2]) {
        let (color, mark) = (color(curve), MARKS[curve % MARKS.len()]);
        let place = format_args!(r#"transform="translate({x:.1} {y:.1})""#);
        let _ = writeln!(self.0, r#"<path class="mark {color}" {place} d="{mark}"/>"#);
    }

    /// The finished file.
    pub fn finish(self) -> String {
        self.0 + "</svg>\n"
    }
}

/// The class of the colour of a curve.
pub fn color(curve: usize) -> String {
    format!("c{}", curve % MARKS.len())
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

//! The book can be read without a network: no page asks for a file from outside.

use std::path::Path;

use crate::{file, pages};

/// Tags of HTML that load a file, with their attribute for its address.
const LOADING: [(&str, &str); 5] = [
    ("<link", "href=\""),
    ("<script", "src=\""),
    ("<img", "src=\""),
    ("<iframe", "src=\""),
    ("<source", "src=\""),
];

/// Checks all pages and style sheets.
pub fn check() -> Result<(), String> {
    let mut found = Vec::new();
    for path in file::files_below(Path::new(pages::FOLDER))? {
        let addresses = if file::has_extension(&path, "html") {
            loaded_by_page(&file::read(&path)?)
        } else if file::has_extension(&path, "css") {
            loaded_by_style(&file::read(&path)?)
        } else {
            continue;
        };
        for address in addresses {
            found.push(format!("\n  {}: {address}", path.display()));
        }
    }
    if found.is_empty() {
        return Ok(());
    }
    let found = found.concat();
    Err(format!("the book needs files from the network:{found}"))
}

/// The addresses in the network that a page loads.
fn loaded_by_page(page: &str) -> Vec<String> {
    let mut addresses = Vec::new();
    for (tag, attribute) in LOADING {
        for after in page.split(tag).skip(1) {
            let inside = after.split('>').next().unwrap_or_default();
            for value in inside.split(attribute).skip(1) {
                let address = value.split('"').next().unwrap_or_default();
                if is_in_network(address) {
                    addresses.push(address.to_owned());
                }
            }
        }
    }
    addresses.extend(loaded_by_style(page));
    addresses
}

/// The addresses in the network that a style sheet loads.
fn loaded_by_style(style: &str) -> Vec<String> {
    let mut addresses = Vec::new();
    for after in style.split("url(").skip(1) {
        let inside = after.split(')').next().unwrap_or_default();
        let address = inside.trim_matches(['"', '\'', ' ']);
        if is_in_network(address) {
            addresses.push(address.to_owned());
        }
    }
    addresses
}

fn is_in_network(address: &str) -> bool {
    let without_protocol = address
        .trim_start_matches("https:")
        .trim_start_matches("http:");
    without_protocol.starts_with("//")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_from_outside_are_found_and_links_of_the_text_are_not() {
        let page = r#"<a href="https://example.org">a link</a><img alt="" src="near.png">
            <script async src="//example.org/a.js"></script><link rel="x" href="http://b.org/c.css">
            <style>a { background: url('https://example.org/d.png') }</style>"#;
        let expected = [
            "http://b.org/c.css",
            "//example.org/a.js",
            "https://example.org/d.png",
        ];
        assert_eq!(loaded_by_page(page), expected);
        assert!(loaded_by_style("a { src: url(katex/font.woff2) }").is_empty());
    }
}

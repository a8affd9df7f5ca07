//! `Packages`: which packages of the workbook others are built of, as Cargo knows it.

use learn::files;
use serde_json::Value;

/// The packages of the workbook.
pub struct Packages {
    pub needed: Vec<Package>,
    pub others: Vec<Package>,
}

pub struct Package {
    pub name: String,
    /// Its folder in the workbook.
    pub folder: String,
    /// The names of the packages that it is built of.
    needs: Vec<String>,
}

impl Packages {
    /// Asks Cargo which packages these are built of, and their tests.
    pub fn read(built: &[&str]) -> Result<Self, String> {
        let metadata = learn::metadata(&files::workspace())?;
        let root = metadata["workspace_root"].as_str().unwrap_or_default();
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        let mut others = Vec::new();
        for package in metadata["packages"].as_array().into_iter().flatten() {
            let name = text(&package["name"]);
            let manifest = text(&package["manifest_path"]);
            let folder = manifest.strip_prefix(root).unwrap_or(&manifest);
            let folder = folder.trim_end_matches("Cargo.toml").trim_matches('/');
            let mut needs = Vec::new();
            for dependency in package["dependencies"].as_array().into_iter().flatten() {
                let is_of_tests = dependency["kind"] == "dev" && !built.contains(&&*name);
                let is_of_browsers = dependency["target"] == "cfg(target_family = \"wasm\")";
                if !is_of_tests && !is_of_browsers {
                    needs.push(text(&dependency["name"]));
                }
            }
            others.push(Package {
                folder: folder.to_owned(),
                name,
                needs,
            });
        }
        let mut needed: Vec<Package> = Vec::new();
        let mut open: Vec<_> = built.iter().map(|&name| name.to_owned()).collect();
        while let Some(name) = open.pop() {
            // A name that is not found is that of a library from outside, or is needed already.
            if let Some(place) = others.iter().position(|other| other.name == name) {
                let package = others.swap_remove(place);
                open.extend_from_slice(&package.needs);
                needed.push(package);
            }
        }
        Ok(Self { needed, others })
    }
}

//! `Packages`: the packages of the workbook and what each is built of, as Cargo knows it.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use learn::exercise::Exercise;
use learn::files;
use serde_json::Value;

use crate::grading_folder::output_of;

/// The packages of the workbook by their names.
pub struct Packages(BTreeMap<String, Package>);

struct Package {
    /// Its folder in the workbook.
    folder: String,
    /// The names of the packages that it is built of.
    needs: Vec<String>,
}

impl Packages {
    /// Asks Cargo. The checks of the exercises are tests of their stages, which therefore need the packages of
    /// their tests, too.
    pub fn read(course: &[Exercise]) -> Result<Self, String> {
        let mut cargo = Command::new("cargo");
        cargo.args([
            "metadata",
            "--no-deps",
            "--offline",
            "--format-version",
            "1",
        ]);
        let output = output_of(cargo.current_dir(files::workspace()))?;
        let metadata: Value = serde_json::from_slice(&output).map_err(|error| error.to_string())?;
        let root = metadata["workspace_root"].as_str().unwrap_or_default();
        let mut packages = BTreeMap::new();
        for package in metadata["packages"].as_array().into_iter().flatten() {
            let name = package["name"].as_str().unwrap_or_default();
            let manifest = package["manifest_path"].as_str().unwrap_or_default();
            let folder = manifest.strip_prefix(root).unwrap_or(manifest);
            let folder = folder.trim_end_matches("Cargo.toml").trim_matches('/');
            let is_stage = course.iter().any(|e| e.stage == name);
            let mut needs = Vec::new();
            for dependency in package["dependencies"].as_array().into_iter().flatten() {
                let is_of_tests = dependency["kind"] == "dev" && !is_stage;
                let is_of_browsers = dependency["target"] == "cfg(target_family = \"wasm\")";
                if !is_of_tests && !is_of_browsers {
                    needs.extend(dependency["name"].as_str().map(str::to_owned));
                }
            }
            let folder = folder.to_owned();
            packages.insert(name.to_owned(), Package { folder, needs });
        }
        Ok(Self(packages))
    }

    /// The names of these packages and of all that they are built of.
    pub fn built_of<'a>(&'a self, names: impl IntoIterator<Item = &'a str>) -> BTreeSet<&'a str> {
        let mut open: Vec<_> = names.into_iter().collect();
        let mut found = BTreeSet::new();
        while let Some(name) = open.pop() {
            // Others are libraries from outside.
            if let Some(package) = self.0.get(name)
                && found.insert(name)
            {
                open.extend(package.needs.iter().map(String::as_str));
            }
        }
        found
    }

    /// The names and folders of all packages.
    pub fn folders(&self) -> impl Iterator<Item = (&str, &str)> {
        let packages = self.0.iter();
        packages.map(|(name, package)| (&**name, &*package.folder))
    }

    /// The package that a file belongs to, and its path in the folder of the package.
    pub fn of_file<'p>(&self, path: &'p str) -> Option<(&str, &'p str)> {
        let within =
            |(name, folder): (_, &str)| Some((name, path.strip_prefix(folder)?.strip_prefix('/')?));
        self.folders()
            .filter_map(within)
            .min_by_key(|(_, inner)| inner.len())
    }
}

//! Checks the direction of uses between crates, and between the modules of two large crates.
//!
//! To add, move or rename a crate, change [`FLOORS_OF_CRATES`]; a crate that is missing there fails the test, and so does a name without a crate.
//! [`FLOORS_INSIDE_CRATES`] does the same for modules.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::circles::uses;
use crate::source::Tree;

/// The crates from the lowest floor to the highest. Each crate depends only on crates of lower floors, not of its own floor.
pub const FLOORS_OF_CRATES: &[&[&str]] = &[
    &["contact-plots", "contact-scaling"],
    &["osim-model"],
    &["osim-requests"],
    &["osim-inspect", "osim-motion", "osim-patch"],
    &["osim-planning"],
    &["osim-view"],
    &["osim-library"],
    // The front ends.
    &["osim-contact-scale", "osim-python", "osim-web"],
];

/// Crates whose modules have floors: each module uses only modules on lower floors. The root of the crate may use all modules.
pub const FLOORS_INSIDE_CRATES: &[(&str, &[&[&str]])] = &[
    ("osim-model", &[&["messages", "xml"], &["model"], &["compare", "feet"]]),
    ("osim-view", &[&["figures", "report"], &["html"]]),
];

/// The crates of a workspace, each with the crates that it depends on.
pub type Crates = BTreeMap<String, Vec<String>>;

/// Reads the manifests of all crates in a folder.
///
/// # Errors
/// A manifest cannot be read.
pub fn crates(folder: &Path) -> Result<Crates, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut crates = Crates::new();
    for entry in entries.flatten().filter(|entry| entry.path().join("Cargo.toml").is_file()) {
        let manifest = entry.path().join("Cargo.toml");
        let text =
            fs::read_to_string(&manifest).map_err(|error| format!("{}: {error}", manifest.display()))?;
        let table: toml::Table = text.parse().map_err(|error| format!("{}: {error}", manifest.display()))?;
        crates.insert(entry.file_name().to_string_lossy().into_owned(), dependencies(&table));
    }
    Ok(crates)
}

/// The crates that a manifest, or its part about one system, depends on. Dependencies of tests count only if they have a version:
/// Cargo publishes these, and cannot find an order for publishing if such a dependency is on a higher floor.
fn dependencies(table: &toml::Table) -> Vec<String> {
    let inner = |name: &str| table.get(name).and_then(toml::Value::as_table);
    let is_published = |value: &toml::Value| value.get("path").is_none() || value.get("version").is_some();
    let mut names = Vec::new();
    let kinds = ["dependencies", "build-dependencies", "dev-dependencies"];
    for (name, value) in
        kinds.into_iter().filter_map(inner).flatten().filter(|(_, value)| is_published(value))
    {
        names.push(value.get("package").and_then(toml::Value::as_str).unwrap_or(name).to_owned());
    }
    let systems = inner("target").into_iter().flatten().filter_map(|(_, value)| value.as_table());
    names.extend(systems.flat_map(dependencies));
    names
}

/// Dependencies on a crate that is not on a lower floor, crates without a floor, and names in `floors` without a crate.
#[must_use]
pub fn faults(floors: &[&[&str]], crates: &Crates) -> Vec<String> {
    let floor = |name: &str| floors.iter().position(|floor| floor.contains(&name));
    let mut faults: Vec<String> = floors
        .iter()
        .copied()
        .flatten()
        .filter(|name| !crates.contains_key(**name))
        .map(|name| format!("the table of floors names {name}, which is not a crate"))
        .collect();
    for (from, dependencies) in crates {
        let Some(own_floor) = floor(from) else {
            faults.push(format!("{from} is missing from the table of floors"));
            continue;
        };
        let upwards = dependencies.iter().filter(|to| floor(to).is_some_and(|other| other >= own_floor));
        faults.extend(upwards.map(|to| format!("{from} depends on {to}, which is not on a lower floor")));
    }
    faults
}

/// Uses of a module that is not on a lower floor, and modules without a floor.
#[must_use]
pub fn faults_inside(floors: &[&[&str]], tree: &Tree) -> Vec<String> {
    let floor = |path: &[String]| floors.iter().position(|floor| floor.contains(&path[0].as_str()));
    let modules = tree.keys().filter(|path| path.len() == 1 && floor(path).is_none());
    let mut faults: Vec<String> =
        modules.map(|path| format!("{} is missing from the table of floors", path[0])).collect();
    for ((from, to), place) in uses(tree).iter().filter(|((from, to), _)| !from.is_empty() && !to.is_empty())
    {
        if from[0] != to[0] && floor(to) >= floor(from) {
            faults.push(format!("{} uses {}, which is not on a lower floor: {place}", from[0], to[0]));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crates(of: &[(&str, &[&str])]) -> Crates {
        of.iter()
            .map(|(name, on)| ((*name).to_owned(), on.iter().map(|on| (*on).to_owned()).collect()))
            .collect()
    }

    #[test]
    fn upward_arrows_and_missing_crates_are_faults() {
        let floors: &[&[&str]] = &[&["a"], &["b", "c"], &["gone"]];
        let found_faults =
            faults(floors, &crates(&[("a", &["c"]), ("b", &["a", "c"]), ("c", &["a"]), ("new", &[])]));
        let expected = [
            "the table of floors names gone, which is not a crate",
            "a depends on c, which is not on a lower floor",
            "b depends on c, which is not on a lower floor",
            "new is missing from the table of floors",
        ];
        assert_eq!(found_faults, expected);
    }

    #[test]
    fn dependencies_of_a_manifest_are_read() -> Result<(), toml::de::Error> {
        let manifest: toml::Table = "[dependencies]\na.workspace = true\nrenamed = { package = 'b' }\n\
            [target.'cfg(unix)'.dependencies]\nc = '1'\n[dev-dependencies]\nd = '1'\n\
            own = { path = '.' }\n"
            .parse()?;
        assert_eq!(dependencies(&manifest), ["a", "b", "d", "c"]);
        Ok(())
    }
}

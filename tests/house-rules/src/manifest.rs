//! What a `Cargo.toml` says about crates and what they depend on.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::Error;

/// A crate that another one depends on.
#[derive(Debug, Clone)]
pub(crate) struct Dependency {
    /// What the source calls it.
    pub(crate) key: String,
    /// What it is called.
    pub(crate) package: String,
    pub(crate) line: usize,
    /// Tests and benchmarks alone use it.
    pub(crate) for_tests: bool,
}

/// One `Cargo.toml`.
#[derive(Debug, Default)]
pub(crate) struct Manifest {
    /// The name of its crate, if it has one.
    pub(crate) name: Option<String>,
    pub(crate) dependencies: Vec<Dependency>,
    /// Paths of its library and its programs that are not in the usual places.
    pub(crate) roots: Vec<PathBuf>,
    /// Of its workspace, if it has one.
    pub(crate) members: Vec<String>,
    pub(crate) excluded: Vec<String>,
}

impl Manifest {
    /// Reads one.
    pub(crate) fn read(path: &Path) -> Result<Self, Error> {
        let text =
            fs::read_to_string(path).map_err(|source| Error::Read { path: path.to_owned(), source })?;
        let table = DeTable::parse(&text).map_err(|error| Error::Manifest {
            path: path.to_owned(),
            message: error.message().to_owned(),
        })?;
        let table = table.get_ref();
        let workspace = child(table, "workspace");
        Ok(Self {
            name: child(table, "package").and_then(|package| text_of(package, "name")),
            dependencies: dependencies(table, &text),
            roots: roots(table),
            members: workspace.map_or_else(Vec::new, |workspace| texts_of(workspace, "members")),
            excluded: workspace.map_or_else(Vec::new, |workspace| texts_of(workspace, "exclude")),
        })
    }

    /// Gives dependencies that the workspace names otherwise (`package = …`) their real names.
    pub(crate) fn inherit(&mut self, names: &BTreeMap<String, String>) {
        for dependency in &mut self.dependencies {
            if let Some(package) = names.get(&dependency.key) {
                dependency.package.clone_from(package);
            }
        }
    }
}

/// Dependencies that a workspace names otherwise than they are called.
pub(crate) fn renamed(path: &Path) -> Result<BTreeMap<String, String>, Error> {
    let text = fs::read_to_string(path).map_err(|source| Error::Read { path: path.to_owned(), source })?;
    let table = DeTable::parse(&text)
        .map_err(|error| Error::Manifest { path: path.to_owned(), message: error.message().to_owned() })?;
    let mut found = Vec::new();
    if let Some(workspace) = child(table.get_ref(), "workspace") {
        of_table(workspace, "dependencies", &text, false, &mut found);
    }
    let renamed = found.into_iter().filter(|dependency| dependency.key != dependency.package);
    Ok(renamed.map(|dependency| (dependency.key, dependency.package)).collect())
}

fn dependencies(table: &DeTable<'_>, text: &str) -> Vec<Dependency> {
    let mut found = Vec::new();
    let systems = child(table, "target");
    let by_system =
        systems.into_iter().flat_map(|systems| systems.values()).filter_map(|value| table_of(value));
    for table in std::iter::once(table).chain(by_system) {
        of_table(table, "dependencies", text, false, &mut found);
        of_table(table, "build-dependencies", text, false, &mut found);
        of_table(table, "dev-dependencies", text, true, &mut found);
    }
    found
}

fn of_table(table: &DeTable<'_>, name: &str, text: &str, for_tests: bool, found: &mut Vec<Dependency>) {
    for (key, value) in child(table, name).into_iter().flatten() {
        let line = text.get(..key.span().start).unwrap_or(text).matches('\n').count() + 1;
        let key = key.get_ref().to_string();
        let package = table_of(value).and_then(|value| text_of(value, "package"));
        found.push(Dependency { package: package.unwrap_or_else(|| key.clone()), key, line, for_tests });
    }
}

fn roots(table: &DeTable<'_>) -> Vec<PathBuf> {
    let library = child(table, "lib").and_then(|library| text_of(library, "path"));
    let programs = table.get("bin").and_then(|programs| programs.get_ref().as_array());
    let programs = programs.into_iter().flatten().filter_map(table_of);
    let programs = programs.filter_map(|program| text_of(program, "path"));
    library.into_iter().chain(programs).map(PathBuf::from).collect()
}

fn table_of<'t, 'i>(value: &'t Spanned<DeValue<'i>>) -> Option<&'t DeTable<'i>> {
    value.get_ref().as_table()
}

fn child<'t, 'i>(table: &'t DeTable<'i>, name: &str) -> Option<&'t DeTable<'i>> {
    table.get(name).and_then(table_of)
}

fn text_of(table: &DeTable<'_>, name: &str) -> Option<String> {
    table.get(name).and_then(|value| value.get_ref().as_str()).map(str::to_owned)
}

fn texts_of(table: &DeTable<'_>, name: &str) -> Vec<String> {
    let values = table.get(name).and_then(|value| value.get_ref().as_array()).into_iter().flatten();
    values.filter_map(|value| value.get_ref().as_str()).map(str::to_owned).collect()
}

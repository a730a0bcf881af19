//! A workspace that was read, and the rules to ask it about.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::manifest::{self, Manifest};
use crate::package::Package;
use crate::rules::{
    Arrow, Ban, Banned, Circle, Forbidden, LayerFault, Limits, OptionNamed, Size, TooLarge, Words, arrows_of,
    banned, circles, layer_faults, options_named, sizes, too_large,
};

/// All crates of a workspace, with their sources.
#[derive(Debug)]
pub struct Workspace {
    packages: Vec<Package>,
}

impl Workspace {
    /// Reads the workspace whose `Cargo.toml` is in the folder `root`: its members, and the crate in `root` itself if
    /// there is one. In `members`, `*` stands for any part of a name.
    ///
    /// # Errors
    /// A file that cannot be read or is not Rust, or a module without a file.
    pub fn read(root: &Path) -> Result<Self, Error> {
        let path = root.join("Cargo.toml");
        let mut manifest = Manifest::read(&path)?;
        let renamed = manifest::renamed(&path)?;
        let mut packages = Vec::new();
        for dir in members(root, &manifest)? {
            let path = dir.join("Cargo.toml");
            let mut manifest = Manifest::read(&path)?;
            manifest.inherit(&renamed);
            let name = manifest.name.clone().ok_or_else(|| Error::Manifest {
                path,
                message: "this member has no [package]".to_owned(),
            })?;
            packages.push(Package::read(name, &dir, root, manifest)?);
        }
        if let Some(name) = manifest.name.clone() {
            manifest.inherit(&renamed);
            packages.push(Package::read(name, root, root, manifest)?);
        }
        Ok(Self { packages })
    }

    /// Reads one crate that has no `Cargo.toml`, only a folder `src` in `dir`.
    ///
    /// # Errors
    /// As [`Workspace::read`].
    pub fn of_sources(name: &str, dir: &Path) -> Result<Self, Error> {
        let package = Package::read(name.to_owned(), dir, dir, Manifest::default())?;
        Ok(Self { packages: vec![package] })
    }

    /// The names of its crates.
    pub fn crates(&self) -> impl Iterator<Item = &str> {
        self.packages.iter().map(|package| package.name.as_str())
    }

    /// Modules that use each other in a circle, in every crate.
    #[must_use]
    pub fn circles(&self) -> Vec<Circle> {
        self.packages.iter().flat_map(circles).collect()
    }

    /// Every place where a module names what another module of its crate defines, in a circle or not.
    #[must_use]
    pub fn uses(&self) -> Vec<Arrow> {
        self.packages.iter().flat_map(arrows_of).collect()
    }

    /// Dependencies that do not point downwards. `layers` are names of crates, from the lowest layer to the highest;
    /// crates of one layer must not depend on each other. Every crate must stand in a layer.
    #[must_use]
    pub fn arrows(&self, layers: &[&[&str]]) -> Vec<LayerFault> {
        layer_faults(&self.packages, layers)
    }

    /// What crates depend on or name though they must not.
    ///
    /// # Errors
    /// A ban on a crate that the workspace does not have.
    pub fn banned(&self, bans: &[Ban<'_>]) -> Result<Vec<Banned>, Error> {
        let mut found = Vec::new();
        for ban in bans {
            found.extend(banned(self.package(ban.in_crate)?, ban));
        }
        Ok(found)
    }

    /// How large every crate, every folder of modules and every file is.
    #[must_use]
    pub fn sizes(&self) -> Vec<Size> {
        self.packages.iter().flat_map(sizes).collect()
    }

    /// Crates, folders and files above their limit.
    #[must_use]
    pub fn too_large(&self, limits: &Limits) -> Vec<TooLarge> {
        too_large(self.sizes(), limits)
    }

    /// Options of the command line that these crates name in their texts.
    ///
    /// # Errors
    /// A name of a crate that the workspace does not have.
    pub fn options_named(&self, in_crates: &[&str]) -> Result<Vec<OptionNamed>, Error> {
        let mut found = Vec::new();
        for name in in_crates {
            found.extend(options_named(self.package(name)?));
        }
        Ok(found)
    }

    /// Words in the texts and doc comments of all crates that must not be used there.
    #[must_use]
    pub fn forbidden(&self, words: &Words) -> Vec<Forbidden> {
        self.packages.iter().flat_map(|package| words.in_package(package)).collect()
    }

    fn package(&self, name: &str) -> Result<&Package, Error> {
        let found = self.packages.iter().find(|package| package.name == name);
        found.ok_or_else(|| Error::NoCrate(name.to_owned()))
    }
}

/// The folders of all members.
fn members(root: &Path, manifest: &Manifest) -> Result<Vec<PathBuf>, Error> {
    let mut found = Vec::new();
    for pattern in &manifest.members {
        let mut dirs = vec![root.to_owned()];
        for name in pattern.split('/').filter(|name| !name.is_empty() && *name != ".") {
            let next: Result<Vec<_>, Error> = dirs.iter().map(|dir| below(dir, name)).collect();
            dirs = next?.into_iter().flatten().collect();
        }
        // What a `*` finds may be something else; what is named must be there, and reading it says so.
        found.extend(
            dirs.into_iter().filter(|dir| !pattern.contains('*') || dir.join("Cargo.toml").is_file()),
        );
    }
    let excluded =
        |dir: &PathBuf| manifest.excluded.iter().any(|excluded| dir.starts_with(root.join(excluded)));
    found.retain(|dir| dir != root && !excluded(dir));
    found.sort();
    found.dedup();
    Ok(found)
}

/// The folders in `dir` that a part of a pattern stands for.
fn below(dir: &Path, pattern: &str) -> Result<Vec<PathBuf>, Error> {
    let Some((start, end)) = pattern.split_once('*') else { return Ok(vec![dir.join(pattern)]) };
    let wrong = |source| Error::Read { path: dir.to_owned(), source };
    let mut found = Vec::new();
    for entry in fs::read_dir(dir).map_err(wrong)? {
        let entry = entry.map_err(wrong)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let fits = name.len() >= start.len() + end.len() && name.starts_with(start) && name.ends_with(end);
        if fits && entry.path().is_dir() {
            found.push(entry.path());
        }
    }
    Ok(found)
}

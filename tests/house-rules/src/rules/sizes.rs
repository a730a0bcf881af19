//! Sizes: what nobody can hold in mind is too large.

use std::collections::BTreeMap;
use std::fmt;

use crate::package::Package;

/// What has a size.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measured {
    /// A crate, without test code.
    Crate,
    /// A folder below `src` with all below it, without test code.
    Folder,
    /// A file, with its test code.
    File,
}

/// The largest sizes that are allowed, in lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Of a crate.
    pub of_crate: usize,
    /// Of a folder.
    pub of_folder: usize,
    /// Of a file.
    pub of_file: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { of_crate: 9000, of_folder: 3000, of_file: 400 }
    }
}

/// How large something is.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Size {
    /// What it is.
    pub of: Measured,
    /// Its name if it is a crate, else its path.
    pub name: String,
    /// Its lines, blank ones and comments too.
    pub lines: usize,
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let without = if self.of == Measured::File { "" } else { " without tests" };
        write!(f, "{}: {} lines{without}", self.name, self.lines)
    }
}

/// Something above its limit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TooLarge {
    /// What, and how large it is.
    pub size: Size,
    /// How large it may be.
    pub limit: usize,
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, allowed are {}", self.size, self.limit)
    }
}

/// The sizes of a crate, its folders and its files.
pub(crate) fn sizes(package: &Package) -> Vec<Size> {
    let mut folders: BTreeMap<&str, usize> = BTreeMap::new();
    let mut files = Vec::new();
    let mut total = 0;
    for file in &package.files {
        let lines = file.lines - file.lines_of_tests.min(file.lines);
        total += lines;
        for (end, _) in file.path.match_indices('/').filter(|(end, _)| *end > package.sources.len()) {
            *folders.entry(&file.path[..end]).or_default() += lines;
        }
        files.push(Size { of: Measured::File, name: file.path.clone(), lines: file.lines });
    }
    let folders =
        folders.into_iter().map(|(name, lines)| Size { of: Measured::Folder, name: name.to_owned(), lines });
    let whole = Size { of: Measured::Crate, name: package.name.clone(), lines: total };
    std::iter::once(whole).chain(folders).chain(files).collect()
}

/// Those above their limit.
pub(crate) fn too_large(sizes: Vec<Size>, limits: &Limits) -> Vec<TooLarge> {
    let limit = |of: Measured| match of {
        Measured::Crate => limits.of_crate,
        Measured::Folder => limits.of_folder,
        Measured::File => limits.of_file,
    };
    let sizes = sizes.into_iter().map(|size| TooLarge { limit: limit(size.of), size });
    sizes.filter(|found| found.size.lines > found.limit).collect()
}

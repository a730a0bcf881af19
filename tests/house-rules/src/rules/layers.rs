//! No arrow upwards between crates.

use std::fmt;

use crate::package::Package;

/// What is wrong with the layers of crates.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LayerFault {
    /// A crate depends on one that does not stand below it.
    Upwards {
        /// The crate that depends.
        from: String,
        /// What it depends on.
        to: String,
        /// The `Cargo.toml` that says so.
        file: String,
        /// Where in it.
        line: usize,
    },
    /// A crate of the workspace stands in no layer, so nothing would hold for it.
    NoLayer {
        /// The crate.
        in_crate: String,
    },
    /// A layer names a crate that the workspace does not have.
    NoCrate {
        /// The name.
        name: String,
    },
}

impl fmt::Display for LayerFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Upwards { from, to, file, line } => {
                write!(f, "{file}:{line}: {from} depends on {to}, which does not stand below it")
            }
            Self::NoLayer { in_crate } => write!(f, "{in_crate} stands in no layer"),
            Self::NoCrate { name } => write!(f, "a layer names {name}, which is no crate of the workspace"),
        }
    }
}

/// All faults. Dependencies of tests may point anywhere.
pub(crate) fn layer_faults(packages: &[Package], layers: &[&[&str]]) -> Vec<LayerFault> {
    let layer = |name: &str| layers.iter().position(|layer| layer.contains(&name));
    let is_crate = |name: &str| packages.iter().any(|package| package.name == name);
    let mut faults = Vec::new();
    for name in layers.iter().copied().flatten().filter(|name| !is_crate(name)) {
        faults.push(LayerFault::NoCrate { name: (*name).to_owned() });
    }
    for package in packages {
        let own = layer(&package.name);
        if own.is_none() {
            faults.push(LayerFault::NoLayer { in_crate: package.name.clone() });
        }
        let dependencies = package.dependencies.iter().filter(|dependency| !dependency.for_tests);
        for dependency in dependencies.filter(|dependency| is_crate(&dependency.package)) {
            if let (Some(own), Some(other)) = (own, layer(&dependency.package))
                && other >= own
            {
                faults.push(LayerFault::Upwards {
                    from: package.name.clone(),
                    to: dependency.package.clone(),
                    file: package.manifest.clone(),
                    line: dependency.line,
                });
            }
        }
    }
    faults
}

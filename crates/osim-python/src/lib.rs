//! The Rust part of the Python package `osim_contact_scale`: the package's module `_native`.
//!
//! The module only calls the other crates and computes nothing itself. Requests come in as dictionaries. Results go out as
//! dictionaries with the same numbers as the command's JSON. While Rust works, other threads of Python run.
//!
//! # What it will not do
//!
//! The module does not use pandas, notebooks or opensim: the Python code in `python/osim_contact_scale/` does.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
#![allow(clippy::needless_pass_by_value, reason = "arguments from Python come by value")]

mod calls;
mod calls_into_rust;
mod equations;
mod figure;
mod files;
mod many_models;
mod planned_change;
mod problem;
mod scaling;

use pyo3::prelude::*;

/// The Rust half of `osim_contact_scale`.
#[pymodule(gil_used = false)]
mod _native {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::calls::{calculate, drop_test, explain, fit, motion, presets, reproduce, units};
    #[pymodule_export]
    use crate::calls_into_rust::defect;
    #[pymodule_export]
    use crate::equations::{equation, equation_of_list, equations, mixing_rules, steps};
    #[pymodule_export]
    use crate::figure::write_file;
    #[pymodule_export]
    use crate::figure::{Figure, plot};
    #[pymodule_export]
    use crate::many_models::{change_many, rescale_many, survey, sweep};
    #[pymodule_export]
    use crate::planned_change::{Planned, plan};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("VERSION", env!("CARGO_PKG_VERSION"))
    }
}

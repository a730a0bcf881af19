//! Links the module without a Python: the missing symbols are those of the Python that loads the module later.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}

//! How the module is linked: Python, which loads it, has the names that are missing in it. So no Python is needed to compile it.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}

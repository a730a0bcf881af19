//! The command `osim-contact-scale`.
fn main() {}

//! Prints what the rules find in a workspace: `cargo run --example report -- ROOT [CRATE…]`.
//!
//! Options are looked for in the crates named. With `-v` before the root, every arrow of a circle is shown.

use std::error::Error;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use house_rules::{Limits, Measured, Workspace};

fn main() -> ExitCode {
    match report() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(io::stderr(), "{error}");
            ExitCode::FAILURE
        }
    }
}

fn report() -> Result<(), Box<dyn Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let all = arguments.first().is_some_and(|first| first == "-v");
    if all {
        arguments.remove(0);
    }
    let (root, below) = arguments.split_first().ok_or("say which workspace: report ROOT [CRATE…]")?;
    let workspace = Workspace::read(Path::new(root))?;
    let mut out = io::stdout().lock();
    for circle in workspace.circles() {
        if all { writeln!(out, "{circle:#}\n")? } else { writeln!(out, "{circle}\n")? }
    }
    for size in workspace.sizes().into_iter().filter(|size| size.of != Measured::File) {
        writeln!(out, "{size}")?;
    }
    writeln!(out)?;
    for found in workspace.too_large(&Limits::default()) {
        writeln!(out, "too large: {found}")?;
    }
    let below: Vec<&str> = below.iter().map(String::as_str).collect();
    for found in workspace.options_named(&below)? {
        writeln!(out, "{found}")?;
    }
    Ok(())
}

//! What a crate must do without.

use house_rules::{Ban, Error};

use crate::support::{shown, workspace};

const BAN: Ban<'_> = Ban {
    in_crate: "strict",
    dependencies: &["clap", "tempfile"],
    paths: &[
        "std::fs",
        "std::env",
        "std::process",
        "std::io::stdin",
        "std::io::stdout",
        "std::io::stderr",
        "println!",
        "eprintln!",
        "terminal",
    ],
};

/// By `use` with groups, names and globs, by paths that go on from an import, through a re-export, and in macros.
#[test]
fn refused() {
    let expected = [
        "Cargo.toml:7: strict must do without clap, written as terminal",
        "src/lib.rs:4: strict must do without std::fs",
        "src/lib.rs:4: strict must do without std::io::stdout",
        "src/lib.rs:6: strict must do without std::env, written as std::env::*",
        "src/lib.rs:7: strict must do without std::io::stderr, written as std::io::*",
        "src/lib.rs:7: strict must do without std::io::stdin, written as std::io::*",
        "src/lib.rs:7: strict must do without std::io::stdout, written as std::io::*",
        "src/lib.rs:10: strict must do without println!",
        "src/lib.rs:12: strict must do without std::fs, written as fs::File::open",
        "src/lib.rs:13: strict must do without std::io::stdout, written as out",
        "src/lib.rs:14: strict must do without std::io::stderr, written as io::stderr",
        "src/lib.rs:14: strict must do without std::process, written as std::process::id",
        "src/lib.rs:15: strict must do without eprintln!",
        "src/shown/mod.rs:1: strict must do without terminal",
        "src/shown/mod.rs:2: strict must do without terminal",
        "src/shown/mod.rs:5: strict must do without terminal, written as shown::width",
        "src/shown/mod.rs:5: strict must do without terminal, written as terminal::width",
        "src/shown/mod.rs:11: strict must do without std::fs, written as standard::fs::copy",
        "src/system.rs:1: strict must do without std::fs",
        "src/system.rs:4: strict must do without std::fs, written as files::read",
        "src/system.rs:8: strict must do without std::fs, written as crate::system::files::read",
    ];
    assert_eq!(shown(&workspace("bans/refused").banned(&[BAN]).unwrap()), expected);
}

/// Other parts of `std::io`, a module of that name, documentation, texts, and tests.
#[test]
fn passes() {
    assert_eq!(shown(&workspace("bans/passes").banned(&[BAN]).unwrap()), [""; 0]);
}

#[test]
fn of_a_crate_that_is_not_there() {
    let ban = Ban { in_crate: "strickt", ..BAN };
    let error = workspace("bans/passes").banned(&[ban]).unwrap_err();
    assert!(matches!(&error, Error::NoCrate(name) if name == "strickt"), "{error}");
}

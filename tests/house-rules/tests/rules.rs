//! Tests each rule with small crates that break or keep it. A crate is one string, with a file after each `// name` line.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use house_rules::floors::faults_inside;
use house_rules::source::{Sources, Tree, trees};
use house_rules::{circles, texts, words::Words};

/// The tree of modules of a library whose files are in the string `files`.
fn library(files: &str) -> Tree {
    let mut sources = Sources::new();
    for file in files.split("\n// ").skip(1) {
        let (name, code) = file.split_once('\n').unwrap();
        sources.insert(format!("src/{name}"), code.to_owned());
    }
    trees(&sources).unwrap().remove(0)
}

#[track_caller]
fn assert_circle(files: &str) {
    assert_eq!(circles::circles(&library(files)).len(), 1, "{files}");
}

#[track_caller]
fn assert_no_circle(files: &str) {
    assert_eq!(circles::circles(&library(files)), Vec::<String>::new(), "{files}");
}

/// Asserts a circle between modules `a` and `b`, where `b` uses `a`, and `a` has this code.
#[track_caller]
fn assert_circle_with(code: &str) {
    assert_circle(&format!(
        "\n// lib.rs\nmod a; mod b; mod facade;\n// a.rs\n{code}\npub struct A;\n// b.rs\nuse crate::a::A; pub struct B(pub A); pub fn f() {{}}\n// facade.rs\npub use crate::b::{{B, f}};\npub use crate::b as other;\n"
    ));
}

#[track_caller]
fn assert_no_circle_with(code: &str) {
    assert_no_circle(&format!(
        "\n// lib.rs\nmod a; mod b; mod facade;\n// a.rs\n{code}\npub struct A;\n// b.rs\nuse crate::a::A; pub struct B(pub A); pub fn f() {{}}\n// facade.rs\npub use crate::b::{{B, f}};\n"
    ));
}

#[test]
fn circles_are_found_however_they_are_written() {
    assert_circle_with("use crate::b::B;");
    assert_circle_with("use super::b::{self, B as C};");
    assert_circle_with("use crate::{b::{B}, other};");
    assert_circle_with("fn g() { use crate::b::B; }");
    assert_circle_with("fn g() { crate::b::f() }");
    assert_circle_with("fn g(x: Option<Box<crate::b::B>>) {}");
    assert_circle_with("impl From<super::b::B> for A {}");
    assert_circle_with("use crate::b; fn g() { b::f() }");
    assert_circle_with("use super::b as c; fn g() { c::f() }");
    assert_circle_with("use crate::b::*;");
    assert_circle_with("#[serde(with = \"super::b\")] struct C;");
    assert_circle_with("fn g() { write!(x, \"{}\", crate::b::f()) }");
    assert_circle_with("macro_rules! m { () => { $crate::b::f() } }");
    assert_circle_with(
        "#[cfg(windows)] use crate::b as system; #[cfg(unix)] use std::fs as system; fn g() { system::f() }",
    );
}

#[test]
fn circles_through_facades_are_found() {
    assert_circle_with("use crate::facade::B;");
    assert_circle_with("fn g() { crate::facade::f() }");
    assert_circle_with("use crate::facade::other; fn g() { other::f() }");
    assert_circle_with("use crate::facade::*;");
    // What the parent defines, and its child uses.
    assert_circle(
        "\n// lib.rs\nmod a;\n// a/mod.rs\nmod b; pub use b::B; pub struct A;\n// a/b.rs\nuse super::A; pub struct B;\n",
    );
    assert_circle("\n// lib.rs\nmod b; pub use b::B; pub struct A;\n// b.rs\nuse crate::A; pub struct B;\n");
    // The facade passes on what the child has from elsewhere, and so uses the child.
    assert_circle(
        "\n// lib.rs\nmod a; mod c;\n// a/mod.rs\nmod b; pub use b::C; pub struct A;\n// a/b.rs\npub use crate::c::C; use super::A;\n// c.rs\npub struct C;\n",
    );
}

#[test]
fn circles_of_three_modules_and_of_macros_are_found() {
    assert_circle(
        "\n// lib.rs\nmod a; mod b; mod c;\n// a.rs\nuse crate::b::f; pub fn a() {}\n// b.rs\nuse crate::c::g; pub fn f() {}\n// c.rs\nuse crate::a::a; pub fn g() {}\n",
    );
    assert_circle(
        "\n// lib.rs\nmod a; mod b;\n// a.rs\nuse crate::b::B; #[macro_export] macro_rules! four { () => { 4 } }\n// b.rs\npub struct B; fn f() { crate::four!() }\n",
    );
    // A function and a module of one name.
    assert_circle(
        "\n// lib.rs\nmod a; mod run;\n// a.rs\nuse super::run; pub fn run() { run::run() }\n// run.rs\npub fn run() { crate::a::run() }\n",
    );
}

#[test]
fn upward_arrows_between_modules_are_found() {
    let tree = library(
        "\n// lib.rs\nmod a; mod b; mod c; mod new; use c::C;\n// a.rs\nuse crate::b::B; pub struct A;\n// b.rs\npub struct B; fn f() { crate::c::C; }\n// c.rs\nuse crate::a::A; pub struct C;\n// new.rs\n",
    );
    let faults = faults_inside(&[&["a", "b"], &["c"]], &tree);
    let expected = [
        "new is missing from the table of floors",
        "a uses b, which is not on a lower floor: crate::b::B (src/a.rs:1)",
        "b uses c, which is not on a lower floor: crate::c::C (src/b.rs:1)",
    ];
    assert_eq!(faults, expected);
}

#[test]
fn code_without_circles_passes() {
    assert_no_circle_with("");
    assert_no_circle_with("use b::B; fn g() { b::f() }");
    assert_no_circle_with("/// [`crate::b::B`]\n// crate::b::B\nconst T: &str = \"crate::b::B\";");
    assert_no_circle_with("#[cfg(test)] mod tests { use crate::b::B; }");
    assert_no_circle_with("#[test] fn g() { crate::b::f() }");
    assert_no_circle_with("pub(in crate::b) fn g() { x.b(); $b::f(); ::b::f(); <T as U>::b::f() }");
    assert_no_circle_with("use std::b; fn g() { b::f() }");
    // Children that use each other by way of a `mod.rs` that only passes on.
    assert_no_circle(
        "\n// lib.rs\nmod plan;\n// plan/mod.rs\nmod draft; mod set; pub use draft::Draft; use set::Set;\n// plan/draft.rs\npub struct Draft;\n// plan/set.rs\nuse super::Draft; pub struct Set;\n",
    );
    assert_no_circle(
        "\n// lib.rs\nmod p;\n// p/mod.rs\nmod a; mod b; pub fn f() { a::f() }\n// p/a.rs\nuse super::b; pub fn f() { b::f() }\n// p/b.rs\npub fn f() {}\n",
    );
    assert_no_circle(
        "\n// lib.rs\nmod a; mod words;\n// a.rs\nuse crate::words::Words;\n// words.rs\npub use outside::Words;\n",
    );
    assert_no_circle(
        "\n// lib.rs\nmod a; mod b; pub use a::A;\n// a.rs\nuse crate::b::{B, Made}; pub struct A;\n// b.rs\nmake! { Made } pub struct B;\n",
    );
}

#[test]
fn a_circle_is_reported_with_its_places() {
    let circles = circles::circles(&library(
        "\n// lib.rs\nmod a; mod b;\n// a.rs\n\nuse crate::b::B;\n// b.rs\nuse super::a::A;\n",
    ));
    let expected = "2 modules use each other in a circle:\n  crate::a -> crate::b: crate::b::B (src/a.rs:2)\n  crate::b -> crate::a: super::a::A (src/b.rs:1)";
    assert_eq!(circles, [expected]);
}

#[test]
fn a_module_without_a_file_is_an_error() {
    let sources = Sources::from([("src/lib.rs".to_owned(), "mod a;".to_owned())]);
    assert_eq!(trees(&sources).unwrap_err(), "src/lib.rs: no file for `mod a`");
}

#[test]
fn comments_strings_and_tests_are_not_code() {
    let code = r####"
// lib.rs
/// one::two
/// three
fn f<'a>(x: &'a str) { g('"', '\'', b'\x00', b"b\n", r#"r"#, "x\
  y", a::b) } // not "this::that" /* nor */
/* nor "that::this" */ const Z: &str = r##"a"#b"##;
#[cfg(test)]
#[rustfmt::skip]
mod tests { fn f() -> [u8; 2] { c::d("e") } }
#[cfg(not(test))] h::i; #[cfg(all(test, unix))] use j::{k, l}; #[test] fn m(x: [u8; 3]) { n::o() } #[cfg(any(test, unix))] p::q;
"####;
    let tree = library(code);
    let module = &tree[&Vec::new()];
    let texts: Vec<(&str, usize)> = module.texts.iter().map(|text| (text.text.as_str(), text.line)).collect();
    let strings = [("b\"b  \"", 3), ("r#\"r\"#", 3), ("\"x\\\n  y\"", 3), ("r##\"a\"#b\"##", 5)];
    assert_eq!(texts, [&[(" one::two\n three", 1)], &strings[..]].concat());
    let mentions: Vec<String> =
        module.mentions.iter().map(|(path, line)| format!("{}:{line}", path.join("::"))).collect();
    assert_eq!(mentions, ["a::b:4", "h::i:9", "p::q:9"]);
    assert!(module.imports.is_empty(), "{:?}", module.imports);
}

#[test]
fn options_in_strings_are_found() {
    let code = "\n// lib.rs\n/// --docs\nfn f() { g(\"give\n --target-mass KG, or '--radius-'\", \"a--b <!-- c --> -- ---d\", r#\"[--raw]\"#); } // --comment\n\
                #[cfg(test)] mod tests { const A: &str = \"--test\"; }\n";
    assert_eq!(
        texts::options(&library(code)),
        ["src/lib.rs:3: --target-mass", "src/lib.rs:3: --radius", "src/lib.rs:3: --raw"]
    );
}

#[test]
fn uses_of_the_system_are_found() {
    let code = "\n// lib.rs\nuse std::{fs, io, fmt};\nuse std::process::Command;\nfn f() { fs::read(x); io::stdout(); io::Error::last(); fmt::Error }\n\
                fn g() { std::env::args(); other::fs::read() }\n#[cfg(test)] use std::net;\n";
    let expected = [
        "src/lib.rs:1: std::fs",
        "src/lib.rs:2: std::process::Command",
        "src/lib.rs:3: std::fs::read",
        "src/lib.rs:3: std::io::stdout",
        "src/lib.rs:4: std::env::args",
    ];
    assert_eq!(texts::outside(&library(code)), expected);
}

#[test]
fn forbidden_words_in_code_are_found() {
    let words: Words = toml::from_str(
        "[[word]]\nnot = 'told of'\nsay = 'reported'\nunless = 'told of (all|none)'\nwrong = ['told of']",
    )
    .unwrap();
    let code = "\n// lib.rs\n/// It is Told\n/// of. Not `told of`.\nfn told_of() { f(\"{told_of} it is told of\", \"told of all\"); } // told of\n";
    let expected = ["src/lib.rs:1: not 'Told of', but reported", "src/lib.rs:3: not 'told of', but reported"];
    let mut forbidden = words.in_code(&library(code));
    forbidden.sort();
    assert_eq!(forbidden, expected.map(|forbidden| forbidden.replace("Told /// of", "Told of")));
}

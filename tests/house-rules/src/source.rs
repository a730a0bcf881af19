//! Reads the modules of all crates: definitions, imports, paths and texts of each, without code that only tests compile.
//!
//! A module is a file; the code in `mod a { … }` is ignored. The text is searched, not parsed: no macro is expanded, and a method
//! call on a value names no module.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use regex::{Captures, Regex};

/// The text of each file of a crate, by its path from the root of the crate: `src/lib.rs`.
pub type Sources = BTreeMap<String, String>;

/// One name that a `use` imports.
#[derive(Debug)]
pub struct Import {
    /// The path of the import, as the code spells it.
    pub path: Vec<String>,
    /// Name of the import in this module; `*` if all names are imported.
    pub name: String,
    /// Whether the import is a `pub use`.
    pub is_passed_on: bool,
    /// The line of the import; 0 for an exported macro, which is in the root of the crate without a `use`.
    pub line: usize,
}

/// A string, or a group of doc comments on consecutive lines.
#[derive(Debug)]
pub struct Text {
    /// The text, with blanks in place of escapes.
    pub text: String,
    /// The line on which the text begins, from 1.
    pub line: usize,
    /// Whether the text is a doc comment.
    pub is_doc: bool,
}

/// A module of Rust.
#[derive(Debug, Default)]
pub struct Module {
    /// The path of the module, such as `crate::a::b`, as a list of names without `crate`.
    pub path: Vec<String>,
    pub file: String,
    /// Names of the child modules that have files of their own.
    pub children: Vec<String>,
    /// Names that the module defines.
    pub items: BTreeSet<String>,
    /// Paths of macros among the paths in the module.
    pub macros: Vec<String>,
    /// Imports of the module.
    pub imports: Vec<Import>,
    /// Paths of two or more names in the module's code, with their lines.
    pub mentions: Vec<(Vec<String>, usize)>,
    /// Strings and doc comments of the module.
    pub texts: Vec<Text>,
}

/// A tree of modules by their paths: a library, or a program.
pub type Tree = BTreeMap<Vec<String>, Module>;

/// Keys in attributes of serde whose text is a path in the code.
const SERDE_KEYS_WITH_PATHS: &[&str] = &["with", "default", "skip_serializing_if", "from"];

#[expect(clippy::expect_used, reason = "constants, which each test of this crate uses")]
pub(crate) fn pattern(parts: &[&str]) -> Regex {
    Regex::new(&format!("(?s){}", parts.join("|"))).expect("a regular expression")
}

/// Matches comments, strings and characters. Lifetimes match, too, so that their mark does not begin a character.
static COMMENT_OR_STRING: LazyLock<Regex> = LazyLock::new(|| {
    pattern(&[
        r"//[^\n]*|/\*.*?\*/",
        r####"[bc]?r"[^"]*"|[bc]?r#".*?"#|[bc]?r##".*?"##|[bc]?r###".*?"###"####,
        r#"[bc]?"(?:[^"\\]|\\.)*""#,
        r"b?'(?:[^'\\]|\\[^u]|\\x..|\\u\{\w+\})'|'\w+",
    ])
});
static ESCAPE_IN_STRING: LazyLock<Regex> = LazyLock::new(|| pattern(&[r"\\[^\n]"]));
static TEST_ATTRIBUTE: LazyLock<Regex> =
    LazyLock::new(|| pattern(&[r"#\[(?:test|cfg\([^\]]*\btest\b[^\]]*\))\]"]));
static MODULE_ITEM: LazyLock<Regex> = LazyLock::new(|| pattern(&[r"\bmod\s+(\w+)\s*([;{])"]));
static USE_ITEM: LazyLock<Regex> = LazyLock::new(|| pattern(&[r"\b(pub(?:\([^)]*\))?\s+)?use\s([^;]+);"]));
static DEFINED_ITEM: LazyLock<Regex> = LazyLock::new(|| {
    pattern(&[
        r"\b((?:const\s+)?fn|struct|enum|union|trait|type|const|static|macro_rules!)\s+(?:mut\s+)?(\w+)",
    ])
});
/// Matches a path, or `pub(in …)`, which uses no module.
static PATH_IN_CODE: LazyLock<Regex> =
    LazyLock::new(|| pattern(&[r"pub\([^)]*\)|(?:\$crate|\b[[:alpha:]_]\w*)(?:::[[:alpha:]_]\w*)+"]));

/// The trees of modules of each crate of a project: of its library and of its program.
///
/// # Errors
/// A file cannot be read, or a module has no file.
pub fn project(root: &Path) -> Result<BTreeMap<String, Vec<Tree>>, String> {
    let entries = fs::read_dir(root.join("crates")).map_err(|error| error.to_string())?;
    let mut project = BTreeMap::new();
    for folder in entries.flatten().map(|entry| entry.path()).filter(|folder| folder.join("src").is_dir()) {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut sources = Sources::new();
        for entry in walkdir::WalkDir::new(folder.join("src")) {
            let path = entry.map_err(|error| error.to_string())?.into_path();
            if path.extension().is_some_and(|ending| ending == "rs") {
                let file = path.strip_prefix(&folder).unwrap_or(&path).to_string_lossy().replace('\\', "/");
                let text =
                    fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
                sources.insert(file, text);
            }
        }
        let mut trees = trees(&sources).map_err(|error| format!("crates/{name}/{error}"))?;
        for module in trees.iter_mut().flat_map(BTreeMap::values_mut) {
            module.file = format!("crates/{name}/{}", module.file);
        }
        project.insert(name, trees);
    }
    Ok(project)
}

/// The trees of modules in a crate: of its library and of its program.
///
/// # Errors
/// A module has no file.
pub fn trees(sources: &Sources) -> Result<Vec<Tree>, String> {
    let mut trees = Vec::new();
    for root in ["src/lib.rs", "src/main.rs"].into_iter().filter(|root| sources.contains_key(*root)) {
        let mut tree = Tree::new();
        let mut pending = vec![(Vec::new(), root.to_owned(), "src".to_owned())];
        let mut macros = Vec::new();
        while let Some((path, file, folder)) = pending.pop() {
            let module = module(path, &file, &sources[&file]);
            for name in &module.macros {
                let path =
                    [&["crate".to_owned()], module.path.as_slice(), std::slice::from_ref(name)].concat();
                macros.push(Import { path, name: name.clone(), is_passed_on: false, line: 0 });
            }
            for child in &module.children {
                let inside = format!("{folder}/{child}");
                let mut files = [format!("{inside}.rs"), format!("{inside}/mod.rs")].into_iter();
                let file = files.find(|file| sources.contains_key(file));
                let file = file.ok_or_else(|| format!("{}: no file for `mod {child}`", module.file))?;
                pending.push(([module.path.as_slice(), std::slice::from_ref(child)].concat(), file, inside));
            }
            tree.insert(module.path.clone(), module);
        }
        tree.entry(Vec::new()).or_default().imports.append(&mut macros);
        trees.push(tree);
    }
    Ok(trees)
}

/// Reads a module from the text of its file.
fn module(path: Vec<String>, file: &str, source: &str) -> Module {
    let breaks: Vec<usize> = source.match_indices('\n').map(|(at, _)| at).collect();
    let line = |at: usize| 1 + breaks.partition_point(|end| *end < at);
    let mut module = Module { path, file: file.to_owned(), ..Module::default() };
    let mut code = COMMENT_OR_STRING.replace_all(source, |part: &Captures<'_>| blank(&part[0])).into_owned();
    let mut tests = Vec::new();
    for test in TEST_ATTRIBUTE.find_iter(&code.clone()) {
        let is_for_more = ["not", "any"].iter().any(|word| test.as_str().contains(word));
        if !is_for_more && code[test.range()].starts_with('#') {
            tests.push(test.start()..blank_item(&mut code, test.start(), test.end()));
        }
    }
    for part in COMMENT_OR_STRING
        .find_iter(source)
        .filter(|part| !tests.iter().any(|test| test.contains(&part.start())))
    {
        module.add_text(part.as_str(), line(part.start()), &code[..part.start()]);
    }
    for (whole, name, sign) in MODULE_ITEM
        .captures_iter(&code.clone())
        .map(|captures| (captures.get_match().range(), captures[1].to_owned(), captures[2].to_owned()))
    {
        if sign == "{" {
            blank_item(&mut code, whole.start, whole.end - 1);
        } else if code[whole].starts_with('m') {
            module.children.push(name);
        }
    }
    for captures in USE_ITEM.captures_iter(&code) {
        let (is_passed_on, line) = (captures.get(1).is_some(), line(captures.get_match().start()));
        let add = &mut |path, name| module.imports.push(Import { path, name, is_passed_on, line });
        import_leaves(&captures[2], &[], add);
    }
    let code = USE_ITEM.replace_all(&code, |captures: &Captures<'_>| blank(&captures[0]));
    for captures in DEFINED_ITEM.captures_iter(&code) {
        module.items.insert(captures[2].to_owned());
        module.macros.extend((&captures[1] == "macro_rules!").then(|| captures[2].to_owned()));
    }
    for captures in PATH_IN_CODE.find_iter(&code).filter(|captures| !captures.as_str().starts_with("pub(")) {
        // A path after a value, a variable of a macro or a type does not begin here.
        let before = code[..captures.start()].trim_end();
        if !["::", ".", "$"].iter().any(|sign| before.ends_with(sign)) {
            module.mentions.push((path_names(captures.as_str()), line(captures.start())));
        }
    }
    module
}

impl Module {
    /// Adds the text of a string or a doc comment. `before` is the code before it.
    fn add_text(&mut self, part: &str, line: usize, before: &str) {
        let is_doc = part.starts_with("///") && !part.starts_with("////") || part.starts_with("//!");
        match self.texts.last_mut() {
            Some(last)
                if is_doc && last.is_doc && last.line + last.text.matches('\n').count() + 1 == line =>
            {
                last.text.push('\n');
                last.text.push_str(&part[3..]);
            }
            _ if is_doc => self.texts.push(Text { text: part[3..].to_owned(), line, is_doc }),
            _ if part.ends_with(['"', '#']) && !part.starts_with('/') => {
                let text = ESCAPE_IN_STRING.replace_all(part, "  ").into_owned();
                let key = before.trim_end().trim_end_matches('=').trim_end();
                if text.contains("::")
                    && SERDE_KEYS_WITH_PATHS.iter().any(|key_of_path| key.ends_with(key_of_path))
                {
                    self.mentions.push((path_names(text.trim_matches('"')), line));
                }
                self.texts.push(Text { text, line, is_doc });
            }
            _ => {}
        }
    }
}

/// The text with a blank in place of each byte; line ends stay.
pub(crate) fn blank(text: &str) -> String {
    text.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect()
}

/// Replaces an item that begins at `begin` by blanks; `at` is the position after its attribute or its name. Returns its end.
fn blank_item(code: &mut String, begin: usize, at: usize) -> usize {
    let (mut depth, mut end) = (0_usize, code.len());
    for (place, sign) in code[at..].char_indices() {
        depth += usize::from("([{".contains(sign));
        if ")]}".contains(sign) && depth == 0 {
            end = at + place;
            break;
        }
        depth -= usize::from(")]}".contains(sign));
        if depth == 0 && (sign == ';' || sign == '}') {
            end = at + place + 1;
            break;
        }
    }
    code.replace_range(begin..end, &blank(&code[begin..end]));
    end
}

fn path_names(path: &str) -> Vec<String> {
    let names = path.trim_start_matches('$').split("::").map(str::trim);
    names.filter(|name| !name.is_empty()).map(str::to_owned).collect()
}

/// Adds each import in a tree of imports, such as `a::{b, c}`, by its path and its name.
fn import_leaves(tree: &str, before: &[String], add: &mut impl FnMut(Vec<String>, String)) {
    if let Some((begin, inside)) = tree.split_once('{') {
        let path = [before, &path_names(begin)].concat();
        let mut depth = 0_usize;
        let parts = inside[..inside.rfind('}').unwrap_or(inside.len())].split(|sign| {
            depth += usize::from(sign == '{');
            depth -= usize::from(sign == '}').min(depth);
            depth == 0 && sign == ','
        });
        return parts.for_each(|part| import_leaves(part, &path, add));
    }
    let (written, name) =
        tree.split_once(" as ").map_or((tree, None), |(path, name)| (path, Some(name.trim())));
    let mut path = [before, &path_names(written)].concat();
    let last = path.last().cloned().unwrap_or_default();
    if last == "*" || last == "self" && path.len() > 1 {
        path.pop();
    }
    let name =
        name.map(str::to_owned).or_else(|| if last == "*" { Some(last) } else { path.last().cloned() });
    if let Some(name) = name.filter(|_| !written.trim().is_empty()) {
        add(path, name);
    }
}

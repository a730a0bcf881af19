//! The modules of a crate: what each defines, imports and names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::tokens::{Token, are, group_end, tokens, without_tests};

/// The tokens of some sources, by the path of the file from the root of the crate: `src/lib.rs`.
pub type Sources = BTreeMap<String, Vec<Token>>;

/// The lines of each file, in all and without tests.
pub type Lines = BTreeMap<String, (usize, usize)>;

/// One leaf of a `use`.
#[derive(Debug, Clone)]
pub struct Import {
    /// The path as it is written.
    pub path: Vec<String>,
    /// The name by which it is known here; `*` if that is all names.
    pub name: String,
    /// Whether other modules see it.
    pub is_passed_on: bool,
    /// Where it is; 0 if nobody wrote it, but the root knows an exported macro so.
    pub line: usize,
}

/// A module.
#[derive(Debug, Default)]
pub struct Module {
    /// `crate::a::b`, as names without `crate`.
    pub path: Vec<String>,
    /// Its file.
    pub file: String,
    /// Names that it defines.
    pub items: BTreeSet<String>,
    /// What it imports.
    pub imports: Vec<Import>,
    /// Paths of two names or more in its code, with their lines.
    pub mentions: Vec<(Vec<String>, usize)>,
    /// Its strings and doc comments.
    pub texts: Vec<Token>,
}

/// A tree of modules by their paths: a library, or a program.
pub type Tree = BTreeMap<Vec<String>, Module>;

/// Keywords before the name of an item.
const KEYWORDS: &[&str] =
    &["fn", "struct", "enum", "union", "trait", "type", "const", "static", "macro_rules"];

/// Keys of serde's attributes whose text is a path.
const KEYS: &[&str] =
    &["with", "serialize_with", "deserialize_with", "default", "skip_serializing_if", "from", "try_from"];

/// Reads the sources of a crate, without what only tests compile, and counts their lines.
///
/// # Errors
/// A file that cannot be read.
pub fn sources(folder: &Path) -> Result<(Sources, Lines), String> {
    let (mut found, mut lines) = (Sources::new(), Lines::new());
    for entry in walkdir::WalkDir::new(folder.join("src")).sort_by_file_name() {
        let path = entry.map_err(|error| error.to_string())?.into_path();
        if path.extension().is_some_and(|ending| ending == "rs") {
            let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            let name = path.strip_prefix(folder).unwrap_or(&path).to_string_lossy().replace('\\', "/");
            let (code, tests) = without_tests(&tokens(&text));
            let all = text.lines().count();
            lines.insert(name.clone(), (all, all - tests.min(all)));
            found.insert(name, code);
        }
    }
    Ok((found, lines))
}

/// The trees of modules in a crate: that of its library and that of its program.
///
/// # Errors
/// A module without a file.
pub fn trees(sources: &Sources) -> Result<Vec<Tree>, String> {
    let mut found = Vec::new();
    for file in ["src/lib.rs", "src/main.rs"] {
        if let Some(tokens) = sources.get(file) {
            let mut reader = Reader { sources, tree: Tree::new(), macros: Vec::new() };
            reader.module(Module { file: file.to_owned(), ..Module::default() }, "src", tokens)?;
            let root = reader.tree.entry(Vec::new()).or_default();
            root.imports.append(&mut reader.macros);
            found.push(reader.tree);
        }
    }
    Ok(found)
}

struct Reader<'s> {
    sources: &'s Sources,
    tree: Tree,
    /// As if the root imported each.
    macros: Vec<Import>,
}

impl Reader<'_> {
    /// Reads the tokens of a module; `folder` is where the files of modules in it are.
    fn module(&mut self, mut module: Module, folder: &str, tokens: &[Token]) -> Result<(), String> {
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            at = match token.text.as_str() {
                // `pub(in crate::a)` uses nothing.
                "pub" if are(tokens, at + 1, &["("]) => {
                    let end = group_end(tokens, at + 1);
                    if are(tokens, end, &["use"]) { imports(tokens, end, true, &mut module) } else { end }
                }
                "use" => imports(tokens, at, at > 0 && tokens[at - 1].text == "pub", &mut module),
                "mod" => self.child(&module, folder, tokens, at)?,
                _ if token.word().is_some() => self.word(&mut module, tokens, at),
                _ => {
                    if token.is_string() || token.is_doc() {
                        module.texts.push(token.clone());
                    }
                    if at > 1
                        && token.is_string()
                        && tokens[at - 1].text == "="
                        && KEYS.contains(&tokens[at - 2].text.as_str())
                    {
                        let path: Vec<String> =
                            token.text.trim_matches('"').split("::").map(str::to_owned).collect();
                        module.mentions.extend((path.len() > 1).then_some((path, token.line)));
                    }
                    at + 1
                }
            };
        }
        self.tree.insert(module.path.clone(), module);
        Ok(())
    }

    /// Takes the word at `at`: the keyword of an item, also in functions and in the calls of macros, or the begin of a path.
    fn word(&mut self, module: &mut Module, tokens: &[Token], at: usize) -> usize {
        let next = at + 1 + usize::from(are(tokens, at + 1, &["!"]) || are(tokens, at + 1, &["mut"]));
        let name =
            tokens.get(next).and_then(Token::word).filter(|_| KEYWORDS.contains(&tokens[at].text.as_str()));
        if let Some(name) = name {
            module.items.insert(name.to_owned());
            if tokens[at].text == "macro_rules" && !module.path.is_empty() {
                let path = [&["crate".to_owned()], module.path.as_slice(), &[name.to_owned()]].concat();
                self.macros.push(Import { path, name: name.to_owned(), is_passed_on: false, line: 0 });
            }
        }
        let mut end = at + 1;
        while are(tokens, end, &["::"]) && tokens.get(end + 1).is_some_and(|next| next.word().is_some()) {
            end += 2;
        }
        // A path that goes on from a value, a variable of a macro or a type begins elsewhere.
        let before = at.checked_sub(1).map_or("", |before| tokens[before].text.as_str());
        if end > at + 1 && !(["::", "."].contains(&before) || before == "$" && tokens[at].text != "crate") {
            let path = tokens[at..end].iter().step_by(2).map(|token| token.text.clone());
            module.mentions.push((path.collect(), tokens[at].line));
        }
        end
    }

    /// Reads the module that is declared at `at`; gives the place after it.
    fn child(&mut self, parent: &Module, folder: &str, tokens: &[Token], at: usize) -> Result<usize, String> {
        let Some(name) = tokens.get(at + 1).and_then(Token::word) else { return Ok(at + 1) };
        let path = [parent.path.as_slice(), &[name.to_owned()]].concat();
        let inside = format!("{folder}/{name}");
        if are(tokens, at + 2, &["{"]) {
            let end = group_end(tokens, at + 2);
            let module = Module { path, file: parent.file.clone(), ..Module::default() };
            self.module(module, &inside, &tokens[at + 3..end - 1])?;
            return Ok(end);
        }
        if are(tokens, at + 2, &[";"]) {
            let files = [format!("{inside}.rs"), format!("{inside}/mod.rs")];
            let found = files.into_iter().find_map(|file| Some((self.sources.get(&file)?, file)));
            let (code, file) = found.ok_or_else(|| format!("{}: no file for `mod {name}`", parent.file))?;
            self.module(Module { path, file, ..Module::default() }, &inside, code)?;
        }
        Ok(at + 2)
    }
}

/// Reads the `use` at `at`; gives the place after its `;`.
fn imports(tokens: &[Token], at: usize, is_passed_on: bool, module: &mut Module) -> usize {
    let end = tokens[at..].iter().position(|token| token.text == ";").map_or(tokens.len(), |end| at + end);
    let mut leaves = Vec::new();
    leaves_of(&tokens[at + 1..end], &[], &mut leaves);
    module.imports.extend(leaves.into_iter().map(|(path, name, line)| Import {
        path,
        name,
        is_passed_on,
        line,
    }));
    end + 1
}

/// The leaves of a tree of imports: path, name and line of each.
fn leaves_of(tokens: &[Token], before: &[String], found: &mut Vec<(Vec<String>, String, usize)>) {
    let mut path = before.to_vec();
    let mut name = None;
    for (at, token) in tokens.iter().enumerate() {
        match token.text.as_str() {
            "{" => {
                let mut depth = 0_usize;
                let leaves = tokens[at + 1..group_end(tokens, at) - 1].split(|token| {
                    depth += usize::from(token.text == "{");
                    depth -= usize::from(token.text == "}").min(depth);
                    depth == 0 && token.text == ","
                });
                return leaves.for_each(|leaf| leaves_of(leaf, &path, found));
            }
            "as" => {
                name = tokens.get(at + 1).map(|token| token.text.clone());
                break;
            }
            "*" => name = Some("*".to_owned()),
            "self" if !path.is_empty() => {}
            text => path.extend(token.word().map(|_| text.to_owned())),
        }
    }
    if let (Some(token), Some(last)) = (tokens.first(), path.last().cloned()) {
        found.push((path, name.unwrap_or(last), token.line));
    }
}

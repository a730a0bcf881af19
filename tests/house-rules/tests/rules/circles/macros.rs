//! Circles in the tokens of macros, which nothing expands.

use super::super::support::refused;

#[test]
fn macro_call() {
    refused(
        "macro-call",
        &[
            "crate::a -> crate::b: crate::b::four (src/a.rs:4)",
            "crate::a -> crate::b: super::b::four (src/a.rs:8)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// Paths in a call that begin with an imported module. `self::six` is in the same module, and no field
/// or variable is taken for a path.
#[test]
fn macro_call_by_module() {
    refused(
        "macro-call-by-module",
        &[
            "crate::a -> crate::c::b: b::four (src/a.rs:6)",
            "crate::c::b -> crate::a: super::super::a::five (src/c/b.rs:2)",
        ],
    );
}

#[test]
fn dollar_crate() {
    refused(
        "dollar-crate",
        &[
            "crate::a -> crate::b: $crate::b::four (src/a.rs:3)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// Groups in a macro: one that holds a `$name`, and one over several lines.
#[test]
fn use_in_macro() {
    refused(
        "use-in-macro",
        &[
            "crate::a -> crate::b: $crate::b (src/a.rs:3)",
            "crate::a -> crate::b: crate::b::B (src/a.rs:5)",
            "crate::a -> crate::b: crate::b::four (src/a.rs:6)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// A macro that is in scope because it stands before.
#[test]
fn macro_by_name() {
    refused(
        "macro-by-name",
        &["crate::a -> crate::b: crate::b::FOUR (src/a.rs:8)", "crate::b -> crate::a: four! (src/b.rs:1)"],
    );
}

/// An exported macro has its path at the root, and is defined elsewhere.
#[test]
fn exported_macro() {
    refused(
        "exported-macro",
        &[
            "crate::a -> crate::b: crate::b::four (src/a.rs:9)",
            "crate::b -> crate::a: crate::four! (src/b.rs:2)",
        ],
    );
}

/// The name of the item stands in the call.
#[test]
fn item_of_macro_call() {
    refused(
        "item-of-macro-call",
        &[
            "crate::a -> crate::b: crate::facade::Made (src/a.rs:1)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:9)",
        ],
    );
}

/// The name of the item stands in the `macro_rules!` that is called.
#[test]
fn item_of_macro_rules() {
    refused(
        "item-of-macro-rules",
        &[
            "crate::a -> crate::b: crate::facade::Made (src/a.rs:1)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:4)",
        ],
    );
}

/// A macro of another crate makes the item: whoever names it uses the module it is looked for in.
#[test]
fn generated_name() {
    refused(
        "generated-name",
        &[
            "crate::a -> crate::b: crate::b::Made (src/a.rs:1)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// The same where a facade passes the name on.
#[test]
fn generated_name_through_facade() {
    refused(
        "generated-name-through-facade",
        &[
            "crate::a -> crate::b: crate::facade::Made (src/a.rs:1)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// Names behind `trait`, `fn`, `const`, `static` and `type`, and in what a `macro_rules!` repeats.
#[test]
fn items_of_macro_calls() {
    refused(
        "items-of-macro-calls",
        &[
            "crate::a -> crate::b: crate::facade::First (src/a.rs:1)",
            "crate::a -> crate::b: crate::facade::second (src/a.rs:2)",
            "crate::a -> crate::b: crate::facade::THIRD (src/a.rs:3)",
            "crate::a -> crate::b: crate::facade::FOURTH (src/a.rs:4)",
            "crate::a -> crate::b: crate::facade::Fifth (src/a.rs:5)",
            "crate::a -> crate::b: crate::facade::SIXTH (src/a.rs:6)",
            "crate::a -> crate::b: crate::facade::Seventh (src/a.rs:7)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:6)",
        ],
    );
}

/// After ranges, colons, keywords and marks; groups of `use`; calls and names that a glob has brought in; attributes. A
/// text is a path behind a key of serde, or if it begins with `crate::`.
#[test]
fn paths_in_macros() {
    refused(
        "paths-in-macros",
        &[
            "crate::a -> crate::b: b::FIRST (src/a.rs:7)",
            "crate::a -> crate::b: b::Second (src/a.rs:8)",
            "crate::a -> crate::b: b::third (src/a.rs:9)",
            "crate::a -> crate::b: b::Fourth (src/a.rs:10)",
            "crate::a -> crate::b: b::fifth (src/a.rs:11)",
            "crate::a -> crate::b: four (src/a.rs:12)",
            "crate::a -> crate::b: Thing (src/a.rs:13)",
            "crate::a -> crate::b: b (src/a.rs:14)",
            "crate::a -> crate::b: b (src/a.rs:15)",
            "crate::a -> crate::b: four (src/a.rs:16)",
            "crate::a -> crate::b: b::Eleventh (src/a.rs:17)",
            "crate::a -> crate::b: b::Inside (src/a.rs:18)",
            "crate::a -> crate::b: b::twelfth! (src/a.rs:18)",
            "crate::a -> crate::b: $crate::b::Last (src/a.rs:19)",
            "crate::a -> crate::b: four (src/a.rs:25)",
            "crate::a -> crate::b: b::four (src/a.rs:27)",
            "crate::a -> crate::b: crate::b::four (src/a.rs:27)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:3)",
        ],
    );
}

//! Circles by paths in the code.

use super::super::support::refused;

#[test]
fn path_in_expression() {
    refused(
        "path-in-expression",
        &[
            "crate::a -> crate::b: crate::b::four (src/a.rs:4)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

#[test]
fn path_in_type() {
    refused(
        "path-in-type",
        &["crate::a -> crate::b: crate::b::B (src/a.rs:2)", "crate::b -> crate::a: crate::a::A (src/b.rs:1)"],
    );
}

#[test]
fn path_in_pattern() {
    refused(
        "path-in-pattern",
        &[
            "crate::a -> crate::b: crate::b::FOUR (src/a.rs:5)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// The module of the enum is used, once in a macro and once outside.
#[test]
fn enum_variant() {
    refused(
        "enum-variant",
        &[
            "crate::a -> crate::b: crate::b::Kind::Hard (src/a.rs:4)",
            "crate::a -> crate::b: crate::b::Kind::Hard (src/a.rs:8)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:2)",
        ],
    );
}

/// The module of the type is used, not one further.
#[test]
fn associated_function() {
    refused(
        "associated-function",
        &[
            "crate::a -> crate::b: crate::b::B (src/a.rs:4)",
            "crate::a -> crate::b: crate::b::B::made (src/a.rs:4)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:6)",
        ],
    );
}

#[test]
fn trait_bound() {
    refused(
        "trait-bound",
        &[
            "crate::a -> crate::b: crate::b::Named (src/a.rs:3)",
            "crate::a -> crate::b: super::b::Named (src/a.rs:5)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:5)",
        ],
    );
}

/// The trait that is implemented is a path too.
#[test]
fn trait_of_impl() {
    refused(
        "trait-of-impl",
        &[
            "crate::a -> crate::b: super::b::Named (src/a.rs:3)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:2)",
        ],
    );
}

/// A module and a function of one name: what is re-exported is the function.
#[test]
fn same_name() {
    refused(
        "same-name",
        &[
            "crate::plan::rescale -> crate::plan::set: super::set (src/plan/rescale.rs:1)",
            "crate::plan::set -> crate::plan::rescale: super::rescale (src/plan/set.rs:2)",
        ],
    );
}

/// `r#match`.
#[test]
fn raw_name() {
    refused(
        "raw-name",
        &[
            "crate::b -> crate::match: crate::match::A (src/b.rs:1)",
            "crate::match -> crate::b: crate::b::B (src/match.rs:1)",
        ],
    );
}

/// serde's `with` names a module or a function in a text; the line is that of the text.
#[test]
fn attribute_text() {
    refused(
        "attribute-text",
        &[
            "crate::model -> crate::number: crate::number (src/model.rs:7)",
            "crate::model -> crate::text: super::text::write (src/model.rs:9)",
            "crate::model -> crate::text: text::read (src/model.rs:9)",
            "crate::model -> crate::text: text (src/model.rs:11)",
            "crate::number -> crate::model: crate::model::Model (src/number.rs:1)",
            "crate::text -> crate::model: crate::model::Model (src/text.rs:1)",
        ],
    );
}

/// clap's `value_parser`, also behind a condition.
#[test]
fn attribute_tokens() {
    refused(
        "attribute-tokens",
        &[
            "crate::args -> crate::values: crate::values::mass (src/args.rs:3)",
            "crate::args -> crate::values: super::values::FOUR (src/args.rs:5)",
            "crate::values -> crate::args: crate::args::Args (src/values.rs:1)",
        ],
    );
}

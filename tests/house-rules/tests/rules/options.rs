//! No option of the command line is named below the command.

use crate::support::{shown, sources};

/// In texts of functions, macros, attributes and registers; behind escapes; in raw texts, bytes and texts of several
/// lines.
#[test]
fn refused() {
    let expected = [
        "src/lib.rs:5: refused names the option --mass",
        "src/lib.rs:10: refused names the option --target-mass",
        "src/lib.rs:11: refused names the option --radius",
        "src/lib.rs:11: refused names the option --select",
        "src/lib.rs:12: refused names the option --after-escape",
        "src/lib.rs:13: refused names the option --raw",
        "src/lib.rs:15: refused names the option --second-line",
        "src/lib.rs:19: refused names the option --third-line",
        "src/lib.rs:21: refused names the option --bytes",
        "src/lib.rs:25: refused names the option --plain",
        "src/lib.rs:27: refused names the option --plain-bytes",
        "src/lib.rs:29: refused names the option --plain-c",
        "src/register.rs:9: refused names the option --exclude",
        "src/register.rs:9: refused names the option --skip-disabled",
    ];
    let found = sources("options", "refused").options_named(&["refused"]).unwrap();
    assert_eq!(shown(&found), expected);
}

/// Marks of comments in XML, dashes in sentences and in words; documentation, and tests.
#[test]
fn passes() {
    let found = sources("options", "passes").options_named(&["passes"]).unwrap();
    assert_eq!(shown(&found), [""; 0]);
}

#[test]
fn of_a_crate_that_is_not_there() {
    let error = sources("options", "passes").options_named(&["other"]).unwrap_err();
    assert_eq!(error.to_string(), "no crate other in the workspace, though a rule speaks of it");
}

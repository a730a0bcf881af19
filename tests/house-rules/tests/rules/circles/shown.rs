//! How a circle is shown, so that a reader can open it.

use super::super::support::circles;

/// The shortest way round where there are others, then one place for each arrow.
#[test]
fn in_a_few_lines() {
    let [circle] = circles("four-modules").try_into().unwrap();
    assert_eq!(circle.modules, ["crate::a", "crate::b", "crate::c", "crate::d"]);
    assert_eq!(circle.shortest, ["crate::c", "crate::d"]);
    let expected = "\
four-modules: 4 modules use each other in a circle: crate::a, crate::b, crate::c, crate::d
  shortest way round: crate::c -> crate::d -> crate::c
  crate::a -> crate::b: crate::b::B (src/a.rs:1)
  crate::b -> crate::c: crate::c::C (src/b.rs:1)
  crate::c -> crate::a: crate::a::A (src/c.rs:1)
  crate::c -> crate::d: crate::d::D (src/c.rs:2)
  crate::d -> crate::c: crate::c::C (src/d.rs:1) and 1 more";
    assert_eq!(circle.to_string(), expected);
}

/// `{:#}` shows every place.
#[test]
fn in_full() {
    let [circle] = circles("four-modules").try_into().unwrap();
    let shown = format!("{circle:#}");
    assert!(shown.ends_with(
        "
  crate::d -> crate::c: crate::c::C (src/d.rs:1)
  crate::d -> crate::c: crate::c::C (src/d.rs:3)"
    ));
}

/// The whole circle is the shortest way round: no need to say it twice.
#[test]
fn of_two() {
    let [circle] = circles("plain-use").try_into().unwrap();
    assert!(!circle.to_string().contains("shortest"), "{circle}");
}

/// Each circle has modules of its own.
#[test]
fn one_by_one() {
    let modules: Vec<Vec<String>> = circles("two-circles").into_iter().map(|circle| circle.modules).collect();
    assert_eq!(modules, [["crate::a", "crate::b"], ["crate::c", "crate::d"]]);
}

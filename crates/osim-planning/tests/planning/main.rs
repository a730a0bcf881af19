//! Tests of findings and of remedies with trial plans. Remedies are run as they are proposed.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    unreachable_pub,
    reason = "a test fails by panicking"
)]

mod add_and_remove;
mod checks;
mod compose;
#[allow(dead_code, reason = "the tests of osim-inspect have these feet, too")]
#[path = "../../../osim-inspect/tests/inspect/feet/mod.rs"]
mod feet;
mod findings;
mod fixed_to_ground;
mod judged_in_memory;
mod kinds;
mod known_contacts;
mod left_like_right;
mod level_feet;
mod many_limbs;
mod masses;
mod odd_side;
mod one_cause;
mod placement;
mod random;
mod remedies;
mod result_in_memory;
mod rules;
mod similar_copies;
mod sizes;
mod sizes_by_chance;
mod spheres_left_behind;
mod tables_by_chance;
mod view_in_space;

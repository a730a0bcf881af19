//! Restitution and dissipation: (13), its exact form, and the speed of the paper's drop.

use contact_scaling::equations::symbols::{ALPHA, C_EXACT, C_R, IMPACT};
use contact_scaling::restitution;

use super::define::function;
use super::function::Function;
use super::parameter::Returns::Value;

pub(super) const ALL: &[Function] = &[
    function!(approximate_restitution(dissipation: ALPHA, impact_speed: IMPACT)
        -> Value(C_R), "restitution::approximate",
        restitution::approximate(dissipation, impact_speed)?),
    function!(dissipation_for_restitution(restitution: C_R, impact_speed: IMPACT)
        -> Value(ALPHA), "restitution::dissipation",
        restitution::dissipation(restitution, impact_speed)?),
    function!(exact_restitution(dissipation: ALPHA, impact_speed: IMPACT)
        -> Value(C_EXACT), "restitution::exact",
        restitution::exact(dissipation, impact_speed)?),
    function!(dissipation_for_exact_restitution(restitution: C_EXACT, impact_speed: IMPACT)
        -> Value(ALPHA), "restitution::exact_dissipation",
        restitution::exact_dissipation(restitution, impact_speed)?),
    function!(drop_speed(gravity: G, radius: R)
        -> Value(IMPACT), "restitution::drop_speed",
        restitution::drop_speed(gravity, radius)?),
];

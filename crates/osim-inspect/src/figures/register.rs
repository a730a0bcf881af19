//! The one register of figures. A new figure is a new entry here, and a test.

use contact_scaling::{Hertz, limits, patch, restitution, smoothing, stiffness};

use super::answer::Answer;
use super::figure::{FigureInfo, Shown};
use super::on_floor::OnFloor;

macro_rules! figures {
    ($($(#[doc = $doc:literal])+ $variant:ident = $name:literal, $label:literal, $unit:literal, $equation:literal, $limit:expr, $shown:ident: $answer:expr;)+) => {
        /// A figure of a sphere that stands, see [`FigureInfo`].
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Figure {
            $($(#[doc = $doc])+ $variant,)+
        }

        impl Figure {
            /// Every figure, in the order in which it is shown.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Everything about it but its value.
            #[must_use]
            pub const fn info(self) -> &'static FigureInfo {
                match self {
                    $(Self::$variant => &const {
                        FigureInfo {
                            name: $name,
                            label: $label,
                            unit: $unit,
                            equation: $equation,
                            meaning: concat!($($doc),+),
                            limit: $limit,
                            shown: Shown::$shown,
                            answer: $answer,
                        }
                    },)+
                }
            }
        }
    };
}

figures! {
    /// Radius R.
    Radius = "radius_m", "radius", "m", "", None, Always: |s| Answer::Known(s.sphere.radius_m);
    /// Composite modulus E*; the sum where several forces press the sphere.
    CompositeModulus = "composite_modulus_n_m2", "composite modulus", "N/m2", "A.3", None, Nowhere:
        |s| Answer::Known(s.composite_modulus());
    /// Dissipation α; absent where forces of different α press the sphere.
    Dissipation = "dissipation_s_m", "dissipation", "s/m", "", None, Nowhere: |s| s.dissipation().into();
    /// The sphere's share of one body weight, W/n.
    Load = "load_n", "load at 1 BW", "N", "", None, Always: |s| s.one(|rest| Some(rest.load_n));
    /// x̂ under its share of one body weight, by the Hertz law.
    Indentation = "relative_indentation_hertz", "x/R at 1 BW, Hertz", "", "11", HERTZ, Always:
        |s| s.one(|rest| rest.hertz);
    /// The same by the model's law; below 0 where the smoothing alone carries the load.
    IndentationModelLaw = "relative_indentation_model_law", "  by the model's law", "", "C.9", HERTZ, Smooth:
        |s| s.one(|rest| rest.model_law);
    /// x̂ with the bottoms of all spheres of the limb level, under one body weight, by the Hertz law.
    LevelIndentation = "relative_indentation_hertz_level", "  level, Hertz", "", "", HERTZ, Mixed:
        |s| s.one(|rest| rest.level_hertz);
    /// The same by the model's law.
    LevelIndentationModelLaw = "relative_indentation_model_law_level", "  level, the model's law", "", "", HERTZ, MixedSmooth:
        |s| s.one(|rest| rest.level_model_law);
    /// x̂ under its share of two body weights, by the Hertz law.
    IndentationAtTwo = "relative_indentation_hertz_at_two", "x/R at 2 BW, Hertz", "", "", HERTZ, Always:
        |s| s.two(|rest| rest.hertz);
    /// The same by the model's law.
    IndentationModelLawAtTwo = "relative_indentation_model_law_at_two", "  by the model's law", "", "", HERTZ, Smooth:
        |s| s.two(|rest| rest.model_law);
    /// x̂ with the bottoms of all spheres of the limb level, under two body weights, by the Hertz law.
    LevelIndentationAtTwo = "relative_indentation_hertz_level_at_two", "  level, Hertz", "", "", HERTZ, Mixed:
        |s| s.two(|rest| rest.level_hertz);
    /// The same by the model's law.
    LevelIndentationModelLawAtTwo = "relative_indentation_model_law_level_at_two", "  level, the model's law", "", "", HERTZ,
        MixedSmooth: |s| s.two(|rest| rest.level_model_law);
    /// Stiffness k of the Hertz law under one body weight.
    ContactStiffness = "contact_stiffness_n_m", "stiffness k", "N/m", "B.2", None, Always: |s| contact_stiffness(s).into();
    /// k̂ = k R n / F under one body weight.
    DimensionlessStiffness = "dimensionless_stiffness", "k R n/F", "", "B.3", None, Always: |s| {
        let k = contact_stiffness(s).zip(s.load());
        k.and_then(|(k, load)| stiffness::dimensionless(k, s.sphere.radius_m, &load).ok()).into()
    };
    /// Natural frequency f_n about the rest under one body weight, from k and the mass on the sphere, M/n.
    NaturalFrequency = "natural_frequency_hz", "frequency f_n", "Hz", "B.4", None, Always: |s| {
        let k = contact_stiffness(s).zip(s.mass_on_sphere());
        k.and_then(|(k, mass)| stiffness::natural_frequency(k, mass).ok()).into()
    };
    /// Mean contact stress σ under one body weight.
    MeanContactStress = "mean_contact_stress_n_m2", "mean stress", "N/m2", "15", None, Always: |s| {
        let rest = s.at_one().and_then(|rest| Some((rest.load_n, rest.hertz?)));
        rest.and_then(|(load_n, x_hat)| patch::mean_stress(load_n, s.sphere.radius_m, x_hat).ok()).into()
    };
    /// Restitution c_r of the law at the impact speed.
    RestitutionExact = "restitution_exact", "restitution, exact", "", "", None, Always:
        |s| s.impact().and_then(|(alpha, speed)| restitution::exact(alpha, speed).ok()).into();
    /// Restitution by (13); absent where that is below 0.
    RestitutionApproximate = "restitution_approximate", "  by (13)", "", "", Some(&limits::RESTITUTION), Always:
        |s| match s.impact() {
            Some((alpha, speed)) => restitution::approximate(alpha, speed).map_or(Answer::Beyond, Answer::Known),
            None => Answer::Unknown,
        };
    /// Constant indentation √cf / R; absent for a `HuntCrossleyForce`. Of several forces the largest.
    ConstantIndentation = "constant_indentation", "sqrt(cf)/R", "", "C.2", Some(&limits::CONSTANT_INDENTATION), Always:
        |s| s.most(|values, radius| smoothing::constant_indentation(values.constant_contact_force, radius)).into();
    /// Width Δx̂ over which the contact state goes from 5 % to 95 %, in radii. Of several forces the largest.
    TransitionWidth = "transition_width", "transition, in R", "", "C.7", Some(&limits::TRANSITION_WIDTH), Always: |s| {
        let threshold = limits::TRANSITION_THRESHOLD;
        s.most(|values, radius| smoothing::transition_width(threshold, values.hertz_smoothing, radius)).into()
    };
    /// Force at rest while the sphere just touches, x = 0.
    ForceJustTouching = "force_just_touching_n", "force at touch", "N", "C.9", None, Always: |s| s.force_just_touching().into();
    /// The same over the sphere's share of one body weight.
    TouchingShare = "touching_share", "  over the load at 1 BW", "", "", Some(&limits::TOUCHING_SHARE), Always: |s| {
        let share = s.force_just_touching().zip(s.load());
        share.map(|(force, load)| force / load.per_sphere_n()).into()
    };
}

/// The limit of every relative indentation.
const HERTZ: Option<&limits::Limit> = Some(&limits::INDENTATION);

fn contact_stiffness(on_floor: &OnFloor<'_>) -> Option<f64> {
    let x_hat = on_floor.at_one()?.hertz?;
    let hertz = Hertz::sphere(on_floor.composite_modulus(), on_floor.sphere.radius_m).ok()?;
    Some(hertz.stiffness_at_relative_indentation(x_hat))
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn names_are_one_each_and_end_in_their_unit() {
        let names: HashSet<&str> = Figure::ALL.iter().map(|figure| figure.info().name).collect();
        assert_eq!(names.len(), Figure::ALL.len());
        for info in Figure::ALL.iter().map(|figure| figure.info()) {
            let end = match info.unit {
                "" => continue,
                "Hz" => "_hz".to_owned(),
                unit => format!("_{}", unit.to_lowercase().replace('/', "_")),
            };
            assert!(info.name.ends_with(&end), "{} in {}", info.name, info.unit);
        }
    }
}

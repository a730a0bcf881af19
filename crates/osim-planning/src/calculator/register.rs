//! The one register of what a design without a model finds. A new quantity is a new entry here, a line in `calculate.rs` that
//! adds its value, and a test.

use contact_scaling::limits;
use osim_inspect::Quantity;
use osim_model::Property;

osim_inspect::quantities! {
    /// A quantity of a design, see [`Quantity`]; its equation may be another in a case.
    DesignQuantity {
        /// Load F/n on each sphere.
        LoadPerSphere = Quantity::new("load_per_sphere_n", "load per sphere", "N").by("3");
        /// Radius R.
        Radius = Quantity::RADIUS.by("11, B.2");
        /// Relative indentation x̂ under the load.
        RelativeIndentation = Quantity::new("relative_indentation", "relative indentation", "")
            .by("2, 11").within(&limits::INDENTATION);
        /// Indentation x under the load.
        Indentation = Quantity::new("indentation_m", "indentation", "m").by("2");
        /// Composite modulus E* of both surfaces; by (11), from `stiffness` or from `young`.
        CompositeModulus = Quantity::COMPOSITE_MODULUS.by("11");
        /// Plane strain modulus E₁* of one of two equal surfaces: the number for OpenSim.
        Stiffness = Quantity::property(Property::Stiffness).by("A.4");
        /// Stiffness k of one sphere under the load.
        ContactStiffness = Quantity::CONTACT_STIFFNESS;
        /// k̂ = k R n / F under the load.
        DimensionlessStiffness = Quantity::DIMENSIONLESS_STIFFNESS;
        /// Mean contact stress σ under the load.
        MeanContactStress = Quantity::MEAN_CONTACT_STRESS;
        /// Diameter of the contact patch under the load.
        ContactPatchDiameter = Quantity::new("contact_patch_diameter_m", "contact patch diameter", "m").by("15");
        /// Natural frequency f_n about the rest under one body weight, from k and the mass on the sphere, M/n.
        NaturalFrequency = Quantity::NATURAL_FREQUENCY;
        /// The same from gravity and the indentation at rest.
        EquilibriumFrequency = Quantity::new("equilibrium_frequency_hz", "equilibrium frequency", "Hz").by("B.5");
        /// Speed before the impact.
        ImpactSpeed = Quantity::IMPACT_SPEED.by("13");
        /// Coefficient of restitution c_r that is wanted.
        Restitution = Quantity::new("restitution", "restitution", "").by("13").within(&limits::RESTITUTION);
        /// Dissipation α that gives it.
        Dissipation = Quantity::property(Property::Dissipation).by("13");
        /// Restitution of the law itself with that dissipation.
        RestitutionExact
            = Quantity::new("restitution_exact_at_this_dissipation", "restitution exact at this dissipation", "")
            .by(DesignQuantity::EXACT);
        /// Dissipation with which the law itself has the restitution that is wanted; absent for a restitution of 0.
        DissipationExact
            = Quantity::new("dissipation_for_exact_restitution_s_m", "dissipation for exact restitution", "s/m")
            .by(DesignQuantity::EXACT);
        /// cf, which gives the constant indentation √cf / R that is wanted.
        ConstantContactForce = Quantity::property(Property::ConstantContactForce).by("C.2");
        /// bd, which gives the width of the contact transition that is wanted.
        HertzSmoothing = Quantity::property(Property::HertzSmoothing).by("C.8");
        /// bv, which gives the width in speed that is wanted.
        HuntCrossleySmoothing = Quantity::property(Property::HuntCrossleySmoothing).by("C.10");
        /// Force at rest while the sphere just touches, x = 0; by (C.3) where no dissipation is known.
        ForceJustTouching = Quantity::FORCE_JUST_TOUCHING;
    }
}

impl DesignQuantity {
    /// In the place of an equation: the law itself, which has no number.
    pub const EXACT: &'static str = "exact";
}

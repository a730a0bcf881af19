//! Table 1 of the paper: its printed numbers, and the same numbers computed.
//!
//! `printed.csv` was typed from the paper. Figures, the models of `fixtures/table1` and the tests of printed numbers read it.
//!
//! ```
//! use contact_scaling::table1;
//!
//! let taxa: Vec<&str> = table1::animals().map(|animal| animal.taxon()).collect();
//! assert_eq!(taxa, ["human", "human", "mouse", "emu", "emu", "horse", "giraffe"]);
//! ```

use crate::drop_test::{DropError, DropTest};
use crate::{Contact, ContactValues, Hertz, Ratios, Result, Scale, ScaleValues, falisse2022};

/// Gravity of the drop tests, m/s². The paper says "gravity on Earth"; its digits follow from 9.81, not from OpenSim's 9.80665.
pub const GRAVITY_M_S2: f64 = 9.81;

/// Height of the drop tests, in sphere radii (Section 3).
pub const DROP_HEIGHT_RADII: f64 = 0.25;

/// Duration of the drop tests, s (Section 3).
pub const DURATION_S: f64 = 2.0;

/// A computed column of Table 1; the other columns (mass, spheres, radius) are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Column {
    /// Composite modulus E*, MPa.
    CompositeModulus,
    /// Plane strain modulus E₁*, MPa: OpenSim's `stiffness` in millions of N/m².
    PlaneStrainModulus,
    /// Dissipation α with the same value for all animals, s/m.
    BaseDissipation,
    /// Dissipation α scaled by R^(−1/2), s/m.
    ScaledDissipation,
    /// Relative indentation x̂ at the end of the drop test, without unit.
    FinalIndentation,
    /// Stiffness k of one sphere at the end of the drop test, kN/m.
    ContactStiffness,
}

impl Column {
    /// All columns, in the order of the table.
    pub const ALL: [Self; 6] = [
        Self::CompositeModulus,
        Self::PlaneStrainModulus,
        Self::BaseDissipation,
        Self::ScaledDissipation,
        Self::FinalIndentation,
        Self::ContactStiffness,
    ];

    /// Name, label, unit and equation of the column.
    const fn texts(self) -> [&'static str; 4] {
        match self {
            Self::CompositeModulus => ["composite_modulus_mpa", "E*", "MPa", "A.4"],
            Self::PlaneStrainModulus => ["stiffness_mpa", "E1*", "MPa", "10"],
            Self::BaseDissipation => ["base_dissipation_s_m", "base alpha", "s/m", ""],
            Self::ScaledDissipation => ["scaled_dissipation_s_m", "scaled alpha", "s/m", "14"],
            Self::FinalIndentation => ["final_relative_indentation", "final x/R", "", ""],
            Self::ContactStiffness => ["contact_stiffness_kn_m", "k of one sphere", "kN/m", "B.2"],
        }
    }

    /// Name of the column for programs; it ends with the unit, if there is one.
    pub const fn name(self) -> &'static str {
        self.texts()[0]
    }

    /// Label of the column, without special letters.
    pub const fn label(self) -> &'static str {
        self.texts()[1]
    }

    /// The unit of the column in the paper; empty for a pure number.
    pub const fn unit(self) -> &'static str {
        self.texts()[2]
    }

    /// Number of the equation of the column; empty if the column is given, or is a result of the drop test.
    pub const fn equation(self) -> &'static str {
        self.texts()[3]
    }
}

/// A number of Table 1, as printed and as computed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ComparedNumber {
    /// Column of the number.
    pub column: Column,
    /// The number as the paper prints it.
    pub printed: &'static str,
    /// The computed number, in the unit of the paper.
    pub computed: f64,
    /// The number computed from the rounded number of the human in the paper; `None` if this is not possible.
    pub from_rounded: Option<f64>,
}

impl ComparedNumber {
    /// The printed number; NaN if it is not a number.
    pub fn printed_value(&self) -> f64 {
        self.printed.parse().unwrap_or(f64::NAN)
    }

    /// Computed minus printed, in the unit of the paper.
    pub fn difference(&self) -> f64 {
        self.computed - self.printed_value()
    }

    /// The difference divided by the printed number, without unit.
    pub fn relative_difference(&self) -> f64 {
        self.difference() / self.printed_value()
    }

    /// Half a unit of the last printed digit, in the unit of the paper.
    pub fn half_unit_of_last_digit(&self) -> f64 {
        // An index of bytes says where the point is; what follows it are the decimals.
        let decimals = self.printed.find('.').map_or(0, |point| self.printed.len() - point - 1);
        0.5 * 10.0_f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX))
    }

    /// Whether the computed number is within half a unit of the last printed digit.
    pub fn is_within_last_digit(&self) -> bool {
        self.prints_as(self.computed)
    }

    /// Whether the printed number does not follow from the exact number of the human, but from the rounded one: the paper
    /// then was computed from the rounded number.
    pub fn is_from_rounded(&self) -> bool {
        !self.is_within_last_digit() && self.from_rounded.is_some_and(|value| self.prints_as(value))
    }

    /// Whether `value`, rounded as in the paper, is the printed number.
    fn prints_as(&self, value: f64) -> bool {
        // 2.065 - 2.07 is not 0.005 in binary; nothing that matters is hidden by one part in 1e9 of a digit.
        (value - self.printed_value()).abs() <= self.half_unit_of_last_digit() * (1.0 + 1e-9)
    }
}

/// A row of Table 1: an animal with its contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Animal {
    taxon: &'static str,
    scale: Scale,
    printed: [&'static str; Column::ALL.len()],
}

/// The rows of the table, in order; the first is the human from which all others are scaled.
pub fn animals() -> impl Iterator<Item = Animal> {
    // The first two lines say what the table is, and name the columns.
    include_str!("table1/printed.csv").lines().skip(2).filter_map(Animal::of_line)
}

/// The animals with the name `taxon`, in the order of the table.
pub fn animals_called(taxon: &str) -> impl Iterator<Item = Animal> {
    animals().filter(move |animal| animal.taxon() == taxon)
}

impl Animal {
    /// The animal in a line of the file; `None` if the line has no animal.
    fn of_line(line: &'static str) -> Option<Self> {
        let mut cells = line.split(',');
        let taxon = cells.next()?;
        let mut number = || cells.next()?.parse::<f64>().ok();
        let (mass_kg, sphere_count, radius_m) = (number()?, number()?, number()?);
        let values = ScaleValues { mass_kg, radius_m, sphere_count, gravity_m_s2: GRAVITY_M_S2 };
        let printed: Vec<&'static str> = cells.collect();
        Some(Self { taxon, scale: Scale::new(values).ok()?, printed: printed.try_into().ok()? })
    }

    /// Name of the animal: `"mouse"`.
    pub const fn taxon(&self) -> &'static str {
        self.taxon
    }

    /// Mass, number of spheres and sphere radius of the animal, under [`GRAVITY_M_S2`].
    pub const fn scale(&self) -> Scale {
        self.scale
    }

    /// The text that the paper prints in a column.
    pub fn printed(&self, column: Column) -> &'static str {
        let index = Column::ALL.iter().position(|&known| known == column);
        index.and_then(|index| self.printed.get(index)).copied().unwrap_or_default()
    }

    /// The contact of the 62 kg human, scaled to this animal by (10), (14), (C.2), (C.5) and (C.10).
    ///
    /// # Errors
    /// None for the numbers of the table.
    pub fn contact(&self) -> Result<Contact> {
        Ok(falisse2022().contact.scaled(&self.ratios()?))
    }

    /// The contact of the animal without smoothing, for a `HuntCrossleyForce`, as in the paper's drop tests.
    ///
    /// # Errors
    /// None for the numbers of the table.
    pub fn contact_without_smoothing(&self) -> Result<Contact> {
        Contact::new(ContactValues { smoothing: None, ..self.contact()?.values() })
    }

    /// Ratios from the paper's human to this animal.
    fn ratios(&self) -> Result<Ratios> {
        let human = ScaleValues { gravity_m_s2: GRAVITY_M_S2, ..falisse2022().scale.values() };
        Ratios::between(&Scale::new(human)?, &self.scale)
    }

    /// All columns, printed and computed. It runs the drop test of the paper: from a quarter of the radius, for 2 s.
    ///
    /// # Errors
    /// None for the numbers of the table.
    pub fn compared(&self) -> Result<Vec<ComparedNumber>, DropError> {
        let contact = self.contact_without_smoothing()?;
        let radius = self.scale.radius_m();
        let drop = DropTest::of(&contact, &self.scale, DROP_HEIGHT_RADII, DURATION_S)?.run()?;
        let x_hat = drop.final_indentation_m / radius;
        let stiffness = Hertz::of(&contact, radius)?.stiffness_at_relative_indentation(x_hat);
        let of = |column| -> Result<ComparedNumber, DropError> {
            let (computed, from_rounded) = match column {
                Column::CompositeModulus => {
                    (contact.composite_modulus() / 1e6, self.modulus_from_rounded_human()?)
                }
                Column::PlaneStrainModulus => (contact.plane_strain_modulus() / 1e6, None),
                Column::BaseDissipation => (falisse2022().contact.dissipation(), None),
                Column::ScaledDissipation => (contact.dissipation(), None),
                Column::FinalIndentation => (x_hat, None),
                Column::ContactStiffness => (stiffness / 1e3, None),
            };
            Ok(ComparedNumber { column, printed: self.printed(column), computed, from_rounded })
        };
        Column::ALL.into_iter().map(of).collect()
    }

    /// E* in MPa, scaled by (10) from the three digits that the paper prints for the human.
    fn modulus_from_rounded_human(&self) -> Result<Option<f64>> {
        let human =
            animals().next().and_then(|human| human.printed(Column::CompositeModulus).parse::<f64>().ok());
        let ratio = self.ratios()?.plane_strain_modulus();
        Ok(human.map(|printed| printed * ratio))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn compared(printed: &'static str, computed: f64) -> ComparedNumber {
        ComparedNumber { column: Column::ContactStiffness, printed, computed, from_rounded: None }
    }

    #[test]
    fn half_a_unit_of_the_last_printed_digit_is_allowed() {
        for (printed, half) in [("207", 0.5), ("13.4", 0.05), ("0.218", 0.0005), ("2.00", 0.005)] {
            assert_eq!(compared(printed, 0.0).half_unit_of_last_digit(), half, "{printed}");
        }
        assert!(compared("13.4", 13.4495).is_within_last_digit());
        assert!(compared("13.4", 13.35).is_within_last_digit());
        assert!(!compared("13.4", 13.4505).is_within_last_digit());
        assert!(!compared("13.5", 13.4495).is_within_last_digit());
    }

    #[test]
    fn differences_are_computed_minus_printed() {
        let seen = compared("200", 207.0);
        assert_eq!((seen.difference(), seen.relative_difference()), (7.0, 0.035));
    }

    #[test]
    fn a_number_computed_from_a_rounded_one_is_recognised() {
        let seen = ComparedNumber { from_rounded: Some(0.09155), ..compared("0.0916", 0.0915) };
        assert!(seen.is_from_rounded());
        assert!(!ComparedNumber { from_rounded: Some(0.0915), ..seen }.is_from_rounded());
        assert!(!ComparedNumber { computed: 0.0916, ..seen }.is_from_rounded());
    }
}

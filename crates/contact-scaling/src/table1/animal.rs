//! The rows of the table.

use super::column::Column;
use super::compared::Compared;
use super::printed::{DURATION_S, GRAVITY_M_S2, HEIGHT_RADII, lines};
use crate::drop_test::{DropError, DropTest};
use crate::{Contact, ContactValues, DomainError, Hertz, Ratios, Scale, ScaleValues, falisse2022};

/// One row of Table 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Animal {
    taxon: &'static str,
    scale: Scale,
    printed: [&'static str; Column::ALL.len()],
}

/// The rows of the table, in its order; the first is the human from which all others are scaled.
pub fn animals() -> impl Iterator<Item = Animal> {
    lines().filter_map(Animal::of_line)
}

/// The animals called `taxon`, in the order of the table.
pub fn called(taxon: &str) -> impl Iterator<Item = Animal> {
    animals().filter(move |animal| animal.taxon() == taxon)
}

impl Animal {
    /// The row that a line holds; `None` where it holds none.
    fn of_line(line: &'static str) -> Option<Self> {
        let mut cells = line.split(',');
        let taxon = cells.next()?;
        let mut number = || cells.next()?.parse::<f64>().ok();
        let (mass_kg, sphere_count, radius_m) = (number()?, number()?, number()?);
        let values = ScaleValues { mass_kg, radius_m, sphere_count, gravity_m_s2: GRAVITY_M_S2 };
        let printed: Vec<&'static str> = cells.collect();
        Some(Self { taxon, scale: Scale::new(values).ok()?, printed: printed.try_into().ok()? })
    }

    /// What it is called: `"mouse"`.
    #[must_use]
    pub const fn taxon(&self) -> &'static str {
        self.taxon
    }

    /// Its mass, its spheres and their radius, under [`GRAVITY_M_S2`].
    #[must_use]
    pub const fn scale(&self) -> Scale {
        self.scale
    }

    /// What the paper prints in a column, digit by digit.
    #[must_use]
    pub fn printed(&self, column: Column) -> &'static str {
        let index = Column::ALL.iter().position(|&known| known == column);
        index.and_then(|index| self.printed.get(index)).copied().unwrap_or_default()
    }

    /// The contact of the 62 kg human, scaled to this animal by (10), (14), (C.2), (C.5) and (C.10).
    ///
    /// # Errors
    /// None with the numbers of the table.
    pub fn contact(&self) -> Result<Contact, DomainError> {
        Ok(falisse2022().contact.scaled(&self.ratios()?))
    }

    /// The same without smoothing, as a `HuntCrossleyForce` has it: the drop tests of the paper used these.
    ///
    /// # Errors
    /// None with the numbers of the table.
    pub fn plain_contact(&self) -> Result<Contact, DomainError> {
        Contact::new(ContactValues { smoothing: None, ..self.contact()?.values() })
    }

    /// What the paper's human becomes this animal by.
    fn ratios(&self) -> Result<Ratios, DomainError> {
        let human = ScaleValues { gravity_m_s2: GRAVITY_M_S2, ..falisse2022().scale.values() };
        Ratios::between(&Scale::new(human)?, &self.scale)
    }

    /// Every column, printed and computed. The drop test is done, as in the paper: from a quarter of the radius, for 2 s.
    ///
    /// # Errors
    /// None with the numbers of the table.
    pub fn compared(&self) -> Result<Vec<Compared>, DropError> {
        let contact = self.plain_contact()?;
        let radius = self.scale.radius_m();
        let drop = DropTest::of(&contact, &self.scale, HEIGHT_RADII, DURATION_S)?.run()?;
        let x_hat = drop.final_indentation_m / radius;
        let stiffness = Hertz::of(&contact, radius)?.stiffness_at_relative_indentation(x_hat);
        let of = |column| -> Result<Compared, DropError> {
            let (computed, from_rounded) = match column {
                Column::CompositeModulus => (contact.composite_modulus() / 1e6, self.modulus_of_rounded()?),
                Column::PlaneStrainModulus => (contact.plane_strain_modulus() / 1e6, None),
                Column::BaseDissipation => (falisse2022().contact.dissipation(), None),
                Column::ScaledDissipation => (contact.dissipation(), None),
                Column::FinalIndentation => (x_hat, None),
                Column::ContactStiffness => (stiffness / 1e3, None),
            };
            Ok(Compared { column, printed: self.printed(column), computed, from_rounded })
        };
        Column::ALL.into_iter().map(of).collect()
    }

    /// E* in MPa, scaled by (10) from the three digits that are printed for the human.
    fn modulus_of_rounded(&self) -> Result<Option<f64>, DomainError> {
        let human =
            animals().next().and_then(|human| human.printed(Column::CompositeModulus).parse::<f64>().ok());
        let ratio = self.ratios()?.plane_strain_modulus();
        Ok(human.map(|printed| printed * ratio))
    }
}

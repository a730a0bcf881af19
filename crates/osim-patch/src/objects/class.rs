//! The class of forces that are new, and the values that a class has.

use osim_model::{Class, Fault, ForceKind, Property};

use super::convert::{Convert, SMOOTHING, smooth};
use super::layout::{Layout, NewContact};

impl Layout {
    /// The same contacts with forces of the class `kind`, as [`convert`](crate::convert()) makes them: what a class does not have goes,
    /// and what the other had not comes from Falisse et al. (2022), without dimensions, at the radius of each sphere.
    ///
    /// # Errors
    /// A radius outside its domain.
    pub fn into_class(mut self, kind: ForceKind) -> Result<Self, Fault> {
        for contact in self.contacts.iter_mut().filter(|contact| contact.kind != kind) {
            contact.set_class(kind)?;
        }
        Ok(self)
    }
}

impl NewContact {
    /// Gives the force the class `kind`.
    fn set_class(&mut self, kind: ForceKind) -> Result<(), Fault> {
        self.kind = kind;
        if kind == ForceKind::SmoothSphereHalfSpace {
            return smooth(&mut self.values, self.radius_m, &Convert::new(kind));
        }
        self.values.retain(|(property, _)| !SMOOTHING.contains(property));
        Ok(())
    }

    /// The same with a value for each parameter of its class. What is not given gets OpenSim's default. OpenSim's smoothing suits
    /// no size, so smoothing is that of Falisse et al. (2022), without dimensions, at this radius.
    ///
    /// ```
    /// use osim_model::{ForceKind, Property};
    /// use osim_patch::NewContact;
    ///
    /// let mut heel = NewContact::new(ForceKind::SmoothSphereHalfSpace, "force_heel", "heel");
    /// heel.radius_m = 0.032;
    /// let heel = heel.with_defaults()?;
    /// let of = |wanted| heel.values.iter().find(|(property, _)| *property == wanted).map(|(_, value)| *value);
    /// assert_eq!((of(Property::StaticFriction), of(Property::TransitionVelocity)), (Some(0.0), Some(0.01)));
    /// assert_eq!(of(Property::HertzSmoothing), Some(300.0));
    /// # Ok::<(), osim_model::Fault>(())
    /// ```
    ///
    /// # Errors
    /// A radius outside its domain.
    pub fn with_defaults(mut self) -> Result<Self, Fault> {
        self.set_class(self.kind)?;
        let classes: &[Class] = match self.kind {
            ForceKind::SmoothSphereHalfSpace => &[Class::SmoothSphereHalfSpaceForce],
            _ => &[Class::ContactParameters, Class::HuntCrossleyForce],
        };
        for &class in classes {
            for &property in class.parameters() {
                if !self.values.iter().any(|(known, _)| *known == property) {
                    self.values.push((property, class.default(property)));
                }
            }
        }
        Ok(self)
    }

    /// Gives a parameter this value.
    pub fn set_value(&mut self, property: Property, value: f64) {
        match self.values.iter_mut().find(|(known, _)| *known == property) {
            Some((_, old)) => *old = value,
            None => self.values.push((property, value)),
        }
    }
}

//! Python functions of lists of spheres that a body rests on.

use contact_scaling::equations::symbols::X;
use contact_scaling::equilibrium::{self, RaisedSpheres};
use contact_scaling::{DomainError, Hertz, HuntCrossley, Law, SmoothSphere, SmoothingValues, Spheres};

use crate::scaling::function::{Argument, Parameter, Returns, docstring};
use crate::scaling::function::{Columns, EquationError, Result, forms, parameter};

/// An equation for a body on several spheres, whose bottoms are at one height or each at its own height.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SphereListFunction {
    pub name: &'static str,
    /// The function of `contact-scaling` for spheres whose bottoms are at one height.
    pub level: &'static str,
    /// The function of `contact-scaling` for spheres at their own heights.
    pub raised: &'static str,
    /// Arguments for each sphere, besides the height of the sphere.
    pub spheres: &'static [Parameter],
    /// The kind of value that the function returns.
    pub returns: Returns,
    alike: fn(&[f64]) -> Result<Spheres>,
    rest_level: fn(&[Spheres], f64) -> Result<f64, DomainError>,
    rest_raised: fn(&[RaisedSpheres], f64) -> Result<f64, DomainError>,
}

/// The type of an argument that is a list of numbers, in docstrings.
pub(super) const LIST_TYPE: &str = "sequence of float";
/// Height of a sphere's bottom above the lowest bottom; left out if all bottoms are at one height.
pub(crate) const HEIGHT: Parameter = parameter!(height: H_I);
/// The load on all spheres together.
pub(crate) const LOAD: Parameter = parameter!(load: F_LOAD);

/// The functions for Hertz's law and for the smoothed law.
pub(crate) const SPHERE_LIST_FUNCTIONS: [SphereListFunction; 2] = [
    SphereListFunction {
        name: "hertz_rest_indentation",
        level: "equilibrium::hertz_indentation",
        raised: "equilibrium::hertz_indentation_of_lowest",
        spheres: &[
            parameter!(composite_modulus: E_I),
            parameter!(radius: R_I),
            parameter!(number_of_spheres: N_I = 1.0),
        ],
        returns: Returns::Value(X),
        alike: |values| {
            let &[modulus, radius, number] = values else {
                return Err(EquationError::arguments(values.len()));
            };
            let law = HuntCrossley::new(Hertz::sphere(modulus, radius)?, 0.0)?;
            Ok(Spheres::new(Law::HuntCrossley(law), number)?)
        },
        rest_level: equilibrium::hertz_indentation,
        rest_raised: equilibrium::hertz_indentation_of_lowest,
    },
    SphereListFunction {
        name: "smooth_rest_indentation",
        level: "equilibrium::indentation",
        raised: "equilibrium::indentation_of_lowest",
        spheres: &[
            parameter!(composite_modulus: E_I),
            parameter!(radius: R_I),
            parameter!(dissipation: ALPHA),
            parameter!(constant_contact_force: CF),
            parameter!(hertz_smoothing: BD),
            parameter!(hunt_crossley_smoothing: BV),
            parameter!(number_of_spheres: N_I = 1.0),
        ],
        returns: Returns::Value(X),
        alike: |values| {
            let &[modulus, radius, dissipation, cf, bd, bv, number] = values else {
                return Err(EquationError::arguments(values.len()));
            };
            let smoothing = SmoothingValues {
                constant_contact_force: cf,
                hertz_smoothing: bd,
                hunt_crossley_smoothing: bv,
            };
            let law = SmoothSphere::new(Hertz::sphere(modulus, radius)?, dissipation, smoothing)?;
            Ok(Spheres::new(Law::Smooth(law), number)?)
        },
        rest_level: equilibrium::indentation,
        rest_raised: equilibrium::indentation_of_lowest,
    },
];

impl SphereListFunction {
    /// Indentation of the lowest sphere (m) when the body is in equilibrium. `columns` has a list for each parameter of a sphere, with
    /// one element if the parameter is the same for all spheres; `heights` (m) are the heights of the bottoms above the lowest bottom.
    ///
    /// # Errors
    /// A value is outside of its domain, with the index of the sphere; lists differ in length; or there is no sphere.
    pub(crate) fn value(&self, columns: &[&[f64]], heights: Option<&[f64]>, load_n: f64) -> Result<f64> {
        EquationError::unless_finite(std::iter::once((LOAD.name, load_n)))?;
        let lists: Vec<&[f64]> = columns.iter().copied().chain([heights.unwrap_or(&[0.0])]).collect();
        let names = || self.spheres.iter().chain([&HEIGHT]).map(|parameter| parameter.name);
        let spheres = Columns::new(names(), &lists)?.each(|row| {
            let named = names().zip(row.iter().copied());
            EquationError::unless_finite(named.clone())?;
            self.raised_spheres(row).map_err(|failure| failure.with_argument(named))
        })?;
        if spheres.is_empty() {
            return Err(EquationError::no_sphere());
        }
        let lowest = spheres.iter().map(|raised| raised.height_m).fold(f64::INFINITY, f64::min);
        if lowest > 0.0 {
            return Err(EquationError::lowest(HEIGHT.name, lowest));
        }
        let rest = if heights.is_some() {
            (self.rest_raised)(&spheres, load_n)
        } else {
            (self.rest_level)(&spheres.iter().map(|raised| raised.spheres).collect::<Vec<_>>(), load_n)
        };
        rest.map_err(|error| EquationError::from(error).with_argument(std::iter::once((LOAD.name, load_n))))
    }

    fn raised_spheres(&self, row: &[f64]) -> Result<RaisedSpheres> {
        let Some((&height, values)) = row.split_last() else { return Err(EquationError::arguments(0)) };
        Ok(RaisedSpheres::new((self.alike)(values)?, height)?)
    }

    pub(crate) fn docstring(&self) -> String {
        let spheres = self.spheres.iter().map(|&parameter| Argument::new(parameter, LIST_TYPE));
        let height = Argument::new(HEIGHT, &format!("{LIST_TYPE}, optional"));
        let arguments = [Argument::new(LOAD, "float")].into_iter().chain(spheres).chain([height]);
        docstring(forms(self.level).chain(forms(self.raised)), arguments, self.returns)
    }
}

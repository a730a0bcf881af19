//! Normal forces of OpenSim's two contact classes: reads lines of parameters and prints the force of each line (N), with all
//! digits.
//!
//! A line is the name of the class and texts `NAME=NUMBER`, with OpenSim's names, in SI units:
//!
//! ```text
//! SmoothSphereHalfSpaceForce radius=0.032 stiffness=1e6 dissipation=2 constant_contact_force=1e-5
//!     hertz_smoothing=300 hunt_crossley_smoothing=50 indentation=0.01 speed=-0.1        (all on one line)
//! HuntCrossleyForce radius=0.032 stiffness=1e6 dissipation=2 indentation=0.01 speed=-0.1
//! ```
//!
//! A `HuntCrossleyForce` may have a second surface of another material (`stiffness_2` with `dissipation_2`) and, in
//! place of the half-space, a second sphere (`radius_2`). `speed` is the rate of the indentation.
//!
//!     cargo run --release -p contact-scaling --example forces < lines.txt

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
use std::collections::BTreeMap;
use std::error::Error;
use std::io::{self, BufRead, BufWriter, Write};

use contact_scaling::modulus::{self, SurfaceValues};
use contact_scaling::{Contact, ContactValues, Hertz, HuntCrossley, Law, SmoothingValues};

type Fault = Box<dyn Error>;

fn main() -> Result<(), Fault> {
    let mut out = BufWriter::new(io::stdout().lock());
    for (index, line) in io::stdin().lock().lines().enumerate() {
        let force = force(&line?).map_err(|fault| format!("line {}: {fault}", index + 1))?;
        writeln!(out, "{force:e}")?;
    }
    Ok(out.flush()?)
}

fn force(line: &str) -> Result<f64, Fault> {
    let (class, words) = line.split_once(' ').ok_or("a class, then NAME=NUMBER words expected")?;
    let mut given = Given::new(words)?;
    let law = match class {
        "SmoothSphereHalfSpaceForce" => smooth(&mut given)?,
        "HuntCrossleyForce" => hunt_crossley(&mut given)?,
        _ => return Err(format!("{class} is not a class known here").into()),
    };
    let force = law.force(given.take("indentation")?, given.take("speed")?);
    given.is_used_up()?;
    Ok(force)
}

fn smooth(given: &mut Given<'_>) -> Result<Law, Fault> {
    let smoothing = SmoothingValues {
        constant_contact_force: given.take("constant_contact_force")?,
        hertz_smoothing: given.take("hertz_smoothing")?,
        hunt_crossley_smoothing: given.take("hunt_crossley_smoothing")?,
    };
    let contact = contact(surface(given)?, Some(smoothing))?;
    Ok(Law::of(&contact, given.take("radius")?)?)
}

fn hunt_crossley(given: &mut Given<'_>) -> Result<Law, Fault> {
    let first = surface(given)?;
    let mut radius = given.take("radius")?;
    if let Some(second) = given.find("radius_2") {
        radius = modulus::composite_radius(radius, second)?;
    }
    let Some(plane_strain_modulus) = given.find("stiffness_2") else {
        return Ok(Law::of(&contact(first, None)?, radius)?);
    };
    let second = SurfaceValues { plane_strain_modulus, dissipation: given.take("dissipation_2")? };
    let composite = modulus::composite_sherman(first.plane_strain_modulus, plane_strain_modulus)?;
    let hertz = Hertz::sphere(composite, radius)?;
    Ok(Law::HuntCrossley(HuntCrossley::new(hertz, modulus::mixed_dissipation(first, second)?)?))
}

fn surface(given: &mut Given<'_>) -> Result<SurfaceValues, Fault> {
    let plane_strain_modulus = given.take("stiffness")?;
    Ok(SurfaceValues { plane_strain_modulus, dissipation: given.take("dissipation")? })
}

fn contact(surface: SurfaceValues, smoothing: Option<SmoothingValues>) -> Result<Contact, Fault> {
    let SurfaceValues { plane_strain_modulus, dissipation } = surface;
    Ok(Contact::new(ContactValues { plane_strain_modulus, dissipation, smoothing })?)
}

/// The `NAME=NUMBER` texts of a line that are not used yet.
struct Given<'a>(BTreeMap<&'a str, f64>);

impl<'a> Given<'a> {
    fn new(words: &'a str) -> Result<Self, Fault> {
        let pair = |word: &'a str| {
            let (name, number) = word.split_once('=').ok_or_else(|| format!("{word} is not NAME=NUMBER"))?;
            Ok((name, number.parse().map_err(|_| format!("{word}: not a number"))?))
        };
        words.split_whitespace().map(pair).collect::<Result<_, Fault>>().map(Self)
    }

    fn find(&mut self, name: &str) -> Option<f64> {
        self.0.remove(name)
    }

    fn take(&mut self, name: &str) -> Result<f64, Fault> {
        self.find(name).ok_or_else(|| format!("{name} is missing").into())
    }

    fn is_used_up(&self) -> Result<(), Fault> {
        self.0.keys().next().map_or(Ok(()), |name| Err(format!("{name} has no meaning here").into()))
    }
}

//! What looks like a slip, a mass among others: a number that is read as it is, and is done only if the caller confirms it.

use std::fmt;
use std::str::FromStr;

use crate::messages::{Input, Phrase, four_significant, phrase, readable};

/// One pound, by its definition of 1959.
pub(crate) const POUND_KG: f64 = 0.453_592_37;

/// What makes a mass look like a slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MassSlip {
    /// As many grams as the bodies have kilograms.
    Grams,
    /// As many tonnes.
    Tonnes,
    /// As many pounds.
    Pounds,
    BodiesInPounds,
    /// The other rows of its table have.
    OthersInPounds,
    /// Ten times what the other rows of its table have.
    TenTimes,
    Tenth,
    NoAnimal,
}

// A mass among those of the other rows of its table.

/// So many other rows are needed to say what is usual.
const FEWEST: usize = 3;
/// A mass that is so many times below or above all others is out of line.
const MARGIN: f64 = 1.3;
/// Bodies that are further apart are of several kinds, and nothing is usual among them: children and adults differ by a factor of 5.
const MOST_APART: f64 = 5.0;
/// From this many others on, the lightest and the heaviest twentieth of them do not count: slips are seldom alone.
const MANY: usize = 20;

/// The masses that other rows of a table have in the same column.
///
/// ```
/// use osim_model::{MassSlip, MassesBeside};
///
/// // The row of 150 kg among four adults, from the lightest to the heaviest.
/// let adults = MassesBeside::of(&[55.0, 62.0, 71.0, 80.0, 150.0], 150.0).unwrap();
/// // 150 lb are 68 kg.
/// assert_eq!(adults.slip(150.0), Some(MassSlip::Pounds));
/// assert_eq!(adults.slip(620.0), Some(MassSlip::TenTimes));
/// assert_eq!(adults.slip(95.0), None);
/// // A mouse among adults is meant: no slip makes 20 g of a person.
/// assert_eq!(adults.slip(0.02), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassesBeside {
    pub lightest_kg: f64,
    pub heaviest_kg: f64,
}

impl MassesBeside {
    /// What is usual among the masses of a column but one, `own_kg`. `sorted` are all of them in kg, from the lightest to the
    /// heaviest. `None` where the others are too few to say, or of several kinds.
    pub fn of(sorted: &[f64], own_kg: f64) -> Option<Self> {
        let count = sorted.len().checked_sub(1).filter(|&count| count >= FEWEST)?;
        let own = sorted.partition_point(|&kg| kg < own_kg);
        let other = |at: usize| sorted.get(if at < own { at } else { at + 1 }).copied();
        let ends = if count < MANY { 0 } else { count / MANY };
        let (lightest_kg, heaviest_kg) = (other(ends)?, other(count - 1 - ends)?);
        (heaviest_kg <= lightest_kg * MOST_APART).then_some(Self { lightest_kg, heaviest_kg })
    }

    /// What would bring `kg` among them, where it is out of line.
    pub fn slip(&self, kg: f64) -> Option<MassSlip> {
        let usual = self.lightest_kg..=self.heaviest_kg;
        if (self.lightest_kg / MARGIN..=self.heaviest_kg * MARGIN).contains(&kg) {
            return None;
        }
        let slips = [
            (MassSlip::Grams, 1000.0),
            (MassSlip::TenTimes, 10.0),
            (MassSlip::Pounds, 1.0 / POUND_KG),
            (MassSlip::OthersInPounds, POUND_KG),
            (MassSlip::Tenth, 0.1),
            (MassSlip::Tonnes, 1.0 / 1000.0),
        ];
        slips.into_iter().find(|(_, times)| usual.contains(&(kg / times))).map(|(slip, _)| slip)
    }
}

/// A question that is answered with yes, by its code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Question {
    /// A mass that may be in grams or tonnes, or has a figure too many or too few.
    ImplausibleMass,
    MassInPounds,
    /// A mass for many models that contradicts the note in one of them.
    AgainstNote,
    /// A sphere that is larger than the bones around it.
    ImplausibleRadius,
    /// A place or a sole that is far from the bones.
    ImplausiblePlace,
    /// Scale factors that no two animals differ by.
    ImplausibleScale,
    /// A foot that does not lie flat at the default pose.
    TiltedFoot,
    /// Feet that are not posed alike: what is laid under them would differ.
    UnequalFeet,
    /// A change after which the contacts are wrong.
    WrongAfterwards,
    /// A very large number of files.
    ManyModels,
}

impl Question {
    pub const ALL: [Self; 10] = [
        Self::ImplausibleMass,
        Self::MassInPounds,
        Self::AgainstNote,
        Self::ImplausibleRadius,
        Self::ImplausiblePlace,
        Self::ImplausibleScale,
        Self::TiltedFoot,
        Self::UnequalFeet,
        Self::WrongAfterwards,
        Self::ManyModels,
    ];

    /// Stable short name, which answers it.
    pub fn code(&self) -> &'static str {
        match self {
            Self::ImplausibleMass => "implausible-mass",
            Self::MassInPounds => "mass-in-pounds",
            Self::AgainstNote => "against-note",
            Self::ImplausibleRadius => "implausible-radius",
            Self::ImplausiblePlace => "implausible-place",
            Self::ImplausibleScale => "implausible-scale",
            Self::TiltedFoot => "tilted-foot",
            Self::UnequalFeet => "unequal-feet",
            Self::WrongAfterwards => "wrong-afterwards",
            Self::ManyModels => "many-models",
        }
    }

    pub fn answer(self) -> Phrase {
        phrase![Input::Yes.with_value(self.code())]
    }
}

impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code())
    }
}

impl FromStr for Question {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|question| question.code() == text).ok_or_else(|| {
            let codes = Self::ALL.map(|question| question.code());
            format!("expected the code of a question: {}", codes.join(", "))
        })
    }
}

/// A number that looks like a slip.
///
/// ```
/// use osim_model::{Fault, FaultKind, MassSlip, NeedsAnswer};
/// use osim_model::messages::Input;
///
/// let grams = NeedsAnswer::Mass { input: Input::TargetMass, kg: 20_000.0, bodies_kg: Some(20.0), beside: None, slip: MassSlip::Grams };
/// let fault = Fault::new(FaultKind::NeedsAnswer(grams));
/// assert_eq!(fault.code(), "implausible-mass");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum NeedsAnswer {
    Mass {
        input: Input,
        kg: f64,
        /// What the bodies of its model weigh together, kg, if known.
        bodies_kg: Option<f64>,
        /// The masses of the other rows of its table, where it is out of line with them.
        beside: Option<MassesBeside>,
        /// Why it looks like a slip.
        slip: MassSlip,
    },
    Radius {
        sphere: String,
        /// What it would be, m.
        radius_m: f64,
        /// The longest distance between the joints of its body and of those next to it, m.
        longest_m: f64,
        /// What is usual, m, where the caller said the new one as a length, which may be in another unit: what it is in the file, else
        /// what follows from the bones.
        said_for: Option<f64>,
    },
    /// Something else, in words.
    Other {
        question: Question,
        /// What looks wrong, and what was probably meant.
        text: Phrase,
    },
}

impl NeedsAnswer {
    pub const fn question(&self) -> Question {
        match self {
            Self::Mass { .. } if self.is_about_pounds() => Question::MassInPounds,
            Self::Mass { .. } => Question::ImplausibleMass,
            Self::Radius { .. } => Question::ImplausibleRadius,
            Self::Other { question, .. } => *question,
        }
    }

    pub(crate) const fn is_about_pounds(&self) -> bool {
        use MassSlip::{BodiesInPounds, OthersInPounds, Pounds};
        matches!(self, Self::Mass { slip: Pounds | BodiesInPounds | OthersInPounds, .. })
    }

    /// What looks wrong, and what was probably meant.
    pub fn doubt(&self) -> Phrase {
        match self {
            Self::Mass { input, kg, bodies_kg, beside, slip } => {
                let others = (*bodies_kg, *beside);
                mass(*input, *kg, others, *slip)
            }
            Self::Radius { sphere, radius_m, longest_m, said_for } => {
                radius(sphere, *radius_m, *longest_m, *said_for).into()
            }
            Self::Other { text, .. } => text.clone(),
        }
    }

    /// The question, and how to say that it is right.
    pub fn phrase(&self) -> Phrase {
        let mut text = self.doubt();
        text.push("; if it is meant, say ");
        text.push(&self.question().answer());
        text
    }
}

fn mass(input: Input, kg: f64, of: (Option<f64>, Option<MassesBeside>), slip: MassSlip) -> Phrase {
    let (bodies_kg, beside) = of;
    let usual = match beside {
        Some(MassesBeside { lightest_kg, heaviest_kg }) => {
            let (least, most) = (four_significant(lightest_kg), four_significant(heaviest_kg));
            format!("{least} to {most} kg of the other rows")
        }
        None => {
            let bodies = bodies_kg.map(four_significant).unwrap_or_default();
            format!("{bodies} kg that the bodies weigh together")
        }
    };
    let than = |times: &str| format!("{times} the {usual}");
    // How many times it is more or less than the bodies, where these are what it is compared with.
    let ratio = bodies_kg.filter(|_| beside.is_none()).map(|bodies| (kg / bodies).max(bodies / kg));
    let apart = ratio.map(|ratio| format!("{ratio:.1}"));
    let unit = |unit: &str, factor: f64| format!("if it is in {unit}, write {}", readable(kg * factor));
    let why = match slip {
        MassSlip::Grams => {
            let ratio = ratio.unwrap_or(1000.0);
            // As it is written where it is another one.
            let times = if (ratio / 1000.0 - 1.0).abs() <= 0.15 { 1000.0 } else { ratio.round() };
            format!("about {}: {}", than(&format!("{times} times")), unit("g", 1.0 / 1000.0))
        }
        MassSlip::Tonnes => format!("about {}: {}", than("1/1000 of"), unit("tonnes", 1000.0)),
        MassSlip::Pounds => {
            let times = format!("{} times", apart.unwrap_or_else(|| "2.2".to_owned()));
            format!("about {}: {}", than(&times), unit("lb", POUND_KG))
        }
        MassSlip::BodiesInPounds => {
            let part = format!("1/{} of", apart.unwrap_or_else(|| "2.2".to_owned()));
            format!("about {}: masses are in kg, in the model too", than(&part))
        }
        MassSlip::OthersInPounds => {
            format!("about {}: masses are in kg, in all rows", than("1/2.2 of"))
        }
        MassSlip::TenTimes => format!("about {}: masses are in kg", than("10 times")),
        MassSlip::Tenth => format!("about {}: masses are in kg", than("1/10 of")),
        MassSlip::NoAnimal => "outside 1 mg to 200 t: masses are in kg".to_owned(),
    };
    phrase![input.with_value(readable(kg)), format!(" is {why}")]
}

/// The units in which a length was probably given that is `times` as long as usual, and how many of each are a metre.
///
/// ```
/// use osim_model::probable_units;
///
/// assert_eq!(probable_units(1100.0), [("mm", 1000.0)]);
/// assert_eq!(probable_units(300.0), [("mm", 1000.0), ("cm", 100.0)]);
/// assert!(probable_units(10.0).is_empty());
/// ```
pub fn probable_units(times: f64) -> &'static [(&'static str, f64)] {
    const UNITS: [(&str, f64); 2] = [("mm", 1000.0), ("cm", 100.0)];
    let of = match times {
        // What is usual differs by a factor of two and a half or so.
        _ if times < 30.0 => 0..0,
        _ if times < 150.0 => 1..2,
        _ if times < 600.0 => 0..2,
        _ => 0..1,
    };
    UNITS.get(of).unwrap_or_default()
}

fn radius(sphere: &str, radius_m: f64, longest_m: f64, said_for: Option<f64>) -> String {
    let (radius, longest) = (readable(radius_m), four_significant(longest_m));
    let meant = said_for.map(|like_m| {
        let units: Vec<String> = probable_units(radius_m / like_m)
            .iter()
            .map(|(unit, per_metre)| format!("{} if it is in {unit}", readable(radius_m / per_metre)))
            .collect();
        let write = if units.is_empty() { "" } else { ", write " };
        format!(": radii are in m{write}{}", units.join(", or "))
    });
    format!(
        "the radius of {sphere} would be {radius} m, and the joints of its body and of those next to it are at most \
         {longest} m apart{}",
        meant.unwrap_or_default()
    )
}

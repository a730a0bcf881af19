//! Numbers that look wrong, such as a mass in grams. The numbers are used only if the caller confirms them.

use std::fmt;
use std::str::FromStr;

use crate::messages::{Input, Phrase, four_significant, named, phrase, readable};

/// Mass of one pound, by its definition of 1959.
pub(crate) const POUND_KG: f64 = 0.453_592_37;

/// The probable mistake that explains a mass that looks wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MassMistake {
    /// The mass is about 1000 times the bodies' kilograms: perhaps grams.
    Grams,
    /// The mass is about 1/1000 of the bodies' kilograms: perhaps tonnes.
    Tonnes,
    /// The mass is about 2.2 times the bodies' kilograms: perhaps pounds.
    Pounds,
    /// The masses of the model's bodies may be in pounds.
    BodiesInPounds,
    /// The masses in the other rows of the table may be in pounds.
    OthersInPounds,
    /// The mass is about ten times the masses in the other rows of the table.
    TenTimes,
    /// The mass is about a tenth of the masses in the other rows of the table.
    Tenth,
    /// No animal is so light or so heavy.
    NoAnimal,
}

// A mass among those of the other rows of its table.

/// A mass in a table is compared with other rows only if there are at least this many.
const FEWEST_ROWS_TO_COMPARE: usize = 3;
/// A mass looks wrong if it is lighter or heavier than all others by more than this factor.
const ODD_MASS_FACTOR: f64 = 1.3;
/// Masses of a table are not compared if the heaviest is more than this many times the lightest: the animals are then of several kinds.
const LARGEST_SPREAD_OF_MASSES: f64 = 5.0;
/// From this number of rows on, the lightest and the heaviest twentieth are left out, because they may be wrong, too.
const ROWS_WITH_OUTLIERS: usize = 20;

/// The range of the masses that the other rows of a table have in the same column.
///
/// ```
/// use osim_model::{MassMistake, MassesOfOtherRows};
///
/// // The row of 150 kg among four adults, from the lightest to the heaviest.
/// let adults = MassesOfOtherRows::without(&[55.0, 62.0, 71.0, 80.0, 150.0], 150.0).unwrap();
/// // 150 lb are 68 kg.
/// assert_eq!(adults.mistake(150.0), Some(MassMistake::Pounds));
/// assert_eq!(adults.mistake(620.0), Some(MassMistake::TenTimes));
/// assert_eq!(adults.mistake(95.0), None);
/// // A mouse among adults: no mistake of units makes 20 g of a person.
/// assert_eq!(adults.mistake(0.02), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassesOfOtherRows {
    pub lightest_kg: f64,
    pub heaviest_kg: f64,
}

impl MassesOfOtherRows {
    /// The range of the masses of a column, without the mass of the row itself, `own_kg`. `sorted` has all masses of the column, kg, in
    /// rising order. `None` if there are too few other masses, or masses of several kinds of animals.
    pub fn without(sorted: &[f64], own_kg: f64) -> Option<Self> {
        let count = sorted.len().checked_sub(1).filter(|&count| count >= FEWEST_ROWS_TO_COMPARE)?;
        let own = sorted.partition_point(|&kg| kg < own_kg);
        let other = |at: usize| sorted.get(if at < own { at } else { at + 1 }).copied();
        let ends = if count < ROWS_WITH_OUTLIERS { 0 } else { count / ROWS_WITH_OUTLIERS };
        let (lightest_kg, heaviest_kg) = (other(ends)?, other(count - 1 - ends)?);
        (heaviest_kg <= lightest_kg * LARGEST_SPREAD_OF_MASSES).then_some(Self { lightest_kg, heaviest_kg })
    }

    /// The mistake that explains `kg`, if this mass is outside the range of the other rows.
    pub fn mistake(&self, kg: f64) -> Option<MassMistake> {
        let usual = self.lightest_kg..=self.heaviest_kg;
        if (self.lightest_kg / ODD_MASS_FACTOR..=self.heaviest_kg * ODD_MASS_FACTOR).contains(&kg) {
            return None;
        }
        let mistakes = [
            (MassMistake::Grams, 1000.0),
            (MassMistake::TenTimes, 10.0),
            (MassMistake::Pounds, 1.0 / POUND_KG),
            (MassMistake::OthersInPounds, POUND_KG),
            (MassMistake::Tenth, 0.1),
            (MassMistake::Tonnes, 1.0 / 1000.0),
        ];
        mistakes.into_iter().find(|(_, times)| usual.contains(&(kg / times))).map(|(mistake, _)| mistake)
    }
}

named! {
    /// A question to the caller, who answers it with `--yes` and its code.
    pub enum YesQuestion {
        /// Is the mass right? It may be in grams or tonnes, or have a digit too many or too few.
        ImplausibleMass = "implausible-mass",
        MassInPounds = "mass-in-pounds",
        /// Is the mass for many models right? It contradicts the note in one of the models.
        AgainstNote = "against-note",
        /// Is the radius right? The sphere would be larger than the bones around it.
        ImplausibleRadius = "implausible-radius",
        /// Is the place right? A sphere or a sole would be far from the bones.
        ImplausiblePlace = "implausible-place",
        /// Are the scale factors right? No two animals differ so much.
        ImplausibleScale = "implausible-scale",
        /// May spheres be placed under a foot that does not lie flat at the default pose?
        TiltedFoot = "tilted-foot",
        /// May spheres be placed under feet with different poses? Left and right would differ.
        UnequalFeet = "unequal-feet",
        /// Should the change be made? The contacts would be wrong afterwards.
        WrongAfterwards = "wrong-afterwards",
        ManyModels = "many-models",
        /// Should a fit be written that is hardly better than a model that never touches, or worse than the model as it is?
        PoorFit = "poor-fit",
    }
}

impl YesQuestion {
    pub fn answer_option(self) -> Phrase {
        phrase![Input::Yes.with_value(self.as_str())]
    }
}

impl fmt::Display for YesQuestion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl FromStr for YesQuestion {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::ALL.iter().copied().find(|question| question.as_str() == text).ok_or_else(|| {
            let codes: Vec<&str> = Self::ALL.iter().map(|question| question.as_str()).collect();
            format!("expected the code of a question: {}", codes.join(", "))
        })
    }
}

/// A number that looks wrong, so that the caller has to confirm it.
///
/// ```
/// use osim_model::{Fault, FaultKind, MassMistake, Suspicion};
/// use osim_model::messages::Input;
///
/// let grams = Suspicion::Mass { input: Input::TargetMass, kg: 20_000.0, bodies_kg: Some(20.0), other_rows: None, mistake: MassMistake::Grams };
/// let fault = Fault::new(FaultKind::Suspicion(grams));
/// assert_eq!(fault.code(), "implausible-mass");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Suspicion {
    /// A mass that looks wrong. `bodies_kg` is that of all bodies of the model, `other_rows` the range of the other masses in a table, if
    /// the mass is outside it.
    Mass {
        input: Input,
        kg: f64,
        bodies_kg: Option<f64>,
        other_rows: Option<MassesOfOtherRows>,
        mistake: MassMistake,
    },
    /// A radius that is large against `longest_m`, the longest distance between joints on the sphere's body or a neighbouring body.
    /// `usual_m` is the radius in the file, else one that follows from the bones; `None` unless the caller gave the new radius as a length,
    /// perhaps in another unit.
    Radius { sphere: String, radius_m: f64, longest_m: f64, usual_m: Option<f64> },
    /// Another doubt, with the text of the verb or check that found it: what looks wrong, and what was probably meant.
    Other { question: YesQuestion, text: Phrase },
}

impl Suspicion {
    pub const fn question(&self) -> YesQuestion {
        match self {
            Self::Mass { .. } if self.is_about_pounds() => YesQuestion::MassInPounds,
            Self::Mass { .. } => YesQuestion::ImplausibleMass,
            Self::Radius { .. } => YesQuestion::ImplausibleRadius,
            Self::Other { question, .. } => *question,
        }
    }

    /// Whether the doubt is that a mass may be in pounds.
    pub(crate) const fn is_about_pounds(&self) -> bool {
        use MassMistake::{BodiesInPounds, OthersInPounds, Pounds};
        matches!(self, Self::Mass { mistake: Pounds | BodiesInPounds | OthersInPounds, .. })
    }

    /// The doubt: what looks wrong, and what was probably meant.
    pub fn doubt(&self) -> Phrase {
        match self {
            Self::Mass { input, kg, bodies_kg, other_rows, mistake } => {
                let others = (*bodies_kg, *other_rows);
                doubt_about_mass(*input, *kg, others, *mistake)
            }
            Self::Radius { sphere, radius_m, longest_m, usual_m } => {
                doubt_about_radius(sphere, *radius_m, *longest_m, *usual_m).into()
            }
            Self::Other { text, .. } => text.clone(),
        }
    }

    /// The doubt, and the answer with which the caller confirms the number.
    pub fn phrase(&self) -> Phrase {
        let mut text = self.doubt();
        text.push("; if it is correct, confirm it with ");
        text.push(&self.question().answer_option());
        text
    }
}

fn doubt_about_mass(
    input: Input,
    kg: f64,
    others: (Option<f64>, Option<MassesOfOtherRows>),
    mistake: MassMistake,
) -> Phrase {
    let (bodies_kg, other_rows) = others;
    let usual = match other_rows {
        Some(MassesOfOtherRows { lightest_kg, heaviest_kg }) => {
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
    let ratio = bodies_kg.filter(|_| other_rows.is_none()).map(|bodies| (kg / bodies).max(bodies / kg));
    let apart = ratio.map(|ratio| format!("{ratio:.1}"));
    let unit = |unit: &str, factor: f64| format!("if it is in {unit}, write {}", readable(kg * factor));
    let why = match mistake {
        MassMistake::Grams => {
            let ratio = ratio.unwrap_or(1000.0);
            // As it is written where it is another one.
            let times = if (ratio / 1000.0 - 1.0).abs() <= 0.15 { 1000.0 } else { ratio.round() };
            format!("about {}: {}", than(&format!("{times} times")), unit("g", 1.0 / 1000.0))
        }
        MassMistake::Tonnes => format!("about {}: {}", than("1/1000 of"), unit("tonnes", 1000.0)),
        MassMistake::Pounds => {
            let times = format!("{} times", apart.unwrap_or_else(|| "2.2".to_owned()));
            format!("about {}: {}", than(&times), unit("lb", POUND_KG))
        }
        MassMistake::BodiesInPounds => {
            let part = format!("1/{} of", apart.unwrap_or_else(|| "2.2".to_owned()));
            format!("about {}: masses are in kg, in the model too", than(&part))
        }
        MassMistake::OthersInPounds => {
            format!("about {}: masses are in kg, in all rows", than("1/2.2 of"))
        }
        MassMistake::TenTimes => format!("about {}: masses are in kg", than("10 times")),
        MassMistake::Tenth => format!("about {}: masses are in kg", than("1/10 of")),
        MassMistake::NoAnimal => "outside 1 mg to 200 t: masses are in kg".to_owned(),
    };
    phrase![input.with_value(readable(kg)), format!(" is {why}")]
}

/// The units in which a length was probably given, if it is longer than usual by the factor `times`; each with the number of units in a metre.
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
    let units = match times {
        // What is usual differs by a factor of two and a half or so.
        _ if times < 30.0 => 0..0,
        _ if times < 150.0 => 1..2,
        _ if times < 600.0 => 0..2,
        _ => 0..1,
    };
    UNITS.get(units).unwrap_or_default()
}

/// What to write instead of a length that is `times` as large as expected, in other units: `, write 0.03 if it is in mm`.
pub fn advice_on_units(length_m: f64, times: f64) -> String {
    let units: Vec<String> = probable_units(times)
        .iter()
        .map(|(unit, per_metre)| format!("{} if it is in {unit}", readable(length_m / per_metre)))
        .collect();
    if units.is_empty() { String::new() } else { format!(", write {}", units.join(", or ")) }
}

fn doubt_about_radius(sphere: &str, radius_m: f64, longest_m: f64, usual_m: Option<f64>) -> String {
    let (radius, longest) = (readable(radius_m), four_significant(longest_m));
    let meant =
        usual_m.map(|like_m| format!(": radii are in m{}", advice_on_units(radius_m, radius_m / like_m)));
    format!(
        "the radius of {sphere} would be {radius} m, and the joints of its body and of those next to it are at most \
         {longest} m apart{}",
        meant.unwrap_or_default()
    )
}

//! Says where contacts stand beside measured feet. The measurements are cited as others cite them, where nobody of us read the original.

use osim_model::messages::{counted, four_significant};
use osim_model::{Model, Sphere, least_and_most};

use crate::body_bones::BodyBones;
use crate::{Figure, Inspection, LimbFigures, SphereFigures};

/// k R n/F of mammals' foot pads: 3 to 13 times the paper's 4.24.
const PAD_STIFFNESS: [f64; 2] = [3.0 * 4.24, 13.0 * 4.24];
/// Stiffness of the heels of adult humans, N/m: 30 to 50 times the 27 kN/m of the paper.
const HEEL_STIFFNESS_N_M: [f64; 2] = [30.0 * 27e3, 50.0 * 27e3];
/// Share of the energy that an isolated heel pad loses: the least and the largest that was measured.
const ISOLATED_LOSS: [f64; 2] = [0.309, 0.482];
/// Share of the energy that heels of living adults lose: the least and the largest that was measured.
const LIVING_LOSS: [f64; 2] = [0.69, 0.79];
/// Masses of adult humans, kg.
const ADULT_KG: std::ops::RangeInclusive<f64> = 40.0..=150.0;

/// The component paths of spheres that are under a heel: on a calcaneus, with their centres at most 1.5 radii ahead of the ankle.
pub(crate) fn spheres_under_heels(model: &Model) -> Vec<String> {
    let Some(bones) = BodyBones::of(model) else { return Vec::new() };
    let is_under_heel = |sphere: &&Sphere| {
        let ahead_m = || bones.ahead_of_ankle_m(sphere.body.as_deref()?, model.centre_m(sphere.id)?);
        ahead_m().zip(sphere.radius_m().ok()).is_some_and(|(ahead_m, radius_m)| ahead_m <= 1.5 * radius_m)
    };
    model.spheres().iter().filter(is_under_heel).map(|sphere| sphere.path.clone()).collect()
}

impl Inspection {
    /// Sentences about stiffness and loss of energy of the contacts, each beside what was measured.
    pub fn beside_real_feet(&self) -> Vec<String> {
        let range = |figure| {
            let values = self.figures.spheres().filter_map(|sphere| sphere.value(figure));
            let (least, most) = least_and_most(values);
            (least <= most).then_some([least, most])
        };
        let dimensionless = range(Figure::DimensionlessStiffness).map(|own| {
            let pads =
                "foot pads of mammals (Alexander et al. 1986, as the paper cites them, without their load)";
            let (own, measured) = (between(own), between(PAD_STIFFNESS));
            format!("k R n/F at one body weight is {own}; {measured} in {pads}")
        });
        let is_adult = self.figures.mass_kg.is_some_and(|kg| ADULT_KG.contains(&kg));
        let limbs = self.figures.limbs.iter().filter(|_| is_adult && self.figures.limbs.len() <= 2);
        let heel = limbs.filter_map(|limb| self.heel_of(limb)).next();
        let has_heel = heel.is_some();
        let speed = self.figures.impact_speed_m_s.filter(|_| has_heel);
        let restitution = range(Figure::RestitutionExact).filter(|_| has_heel);
        let lost = speed.zip(restitution).map(|(speed, [least, most])| {
            let percent = |shares: [f64; 2]| between(shares.map(|share| 100.0 * share));
            format!(
                "an impact at {} m/s loses {} % of its energy (1 - c_r^2, exact); isolated heel pads lose {} (Aerts et al. 1995, as the \
                 paper cites them), heels of living adults {} (Wearing et al. 2009, walking, as cited by others; Kinoshita et al. \
                 1993, 5 kg at 0.72 to 0.93 m/s, abstract)",
                four_significant(speed),
                percent([1.0 - most * most, 1.0 - least * least]),
                percent(ISOLATED_LOSS),
                percent(LIVING_LOSS),
            )
        });
        [dimensionless, heel, lost].into_iter().flatten().collect()
    }

    /// A sentence about the stiffness of all spheres under the heel of a limb.
    fn heel_of(&self, limb: &LimbFigures) -> Option<String> {
        let is_under_heel = |sphere: &&SphereFigures| self.heel_spheres.contains(&sphere.path);
        let stiffness_n_m =
            limb.spheres.iter().filter(is_under_heel).map(|sphere| sphere.value(Figure::ContactStiffness));
        let each: Vec<f64> = stiffness_n_m.collect::<Option<_>>()?;
        (!each.is_empty()).then(|| {
            let kilonewtons = |newtons: f64| four_significant(newtons / 1e3);
            let of_heel = kilonewtons(each.iter().sum());
            let [least, most] = HEEL_STIFFNESS_N_M.map(kilonewtons);
            format!(
                "{} under the heel: {of_heel} kN/m together at one body weight; heels of adults {least} to {most} (Aerts et al. 1995, \
                 impacts, as the paper cites them, without load and speed)",
                counted(each.len(), "sphere")
            )
        })
    }
}

/// A range in words; one number if both ends look the same.
fn between(range: [f64; 2]) -> String {
    let [least, most] = range.map(four_significant);
    if least == most { least } else { format!("{least} to {most}") }
}

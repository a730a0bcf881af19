//! The words for a body over its floor: `check`, `inspect` and changes share it.

use osim_model::messages::{readable, shown};

use super::standing::{OnFeet, StandingBody};

impl StandingBody {
    /// How far inside or above the floor the lowest sphere is: `945 mm inside the floor`; `on the floor` within a tenth of a millimetre.
    #[must_use]
    pub fn place(&self) -> Option<String> {
        let height_m = self.lowest()?.height_m;
        let millimetres = readable((height_m.abs() * 1e4).round() / 10.0);
        Some(match height_m {
            height if height.abs() < 1e-4 => "on the floor".to_owned(),
            height if height < 0.0 => format!("{millimetres} mm inside the floor"),
            _ => format!("{millimetres} mm above the floor"),
        })
    }

    /// What puts it on its feet: `pelvis_ty = 0.981 (now 0) puts it on its feet`, or why nothing does.
    #[must_use]
    pub fn way_to_stand(&self) -> String {
        if let Some(why) = &self.why_no_coordinate {
            return format!("no coordinate puts it on its feet: {why}");
        }
        let carried = self.as_posed.as_ref().filter(|rest| rest.carried).and_then(|rest| rest.value_m);
        match (carried, self.touching_m) {
            (Some(value), _) => format!("{} puts it on its feet", self.set_to(value)),
            (None, Some(value)) => format!("{} lets its lowest sphere touch the floor", self.set_to(value)),
            (None, None) => "what puts it on its feet is not known".to_owned(),
        }
    }

    /// The coordinate at a value, and where it is: `pelvis_ty = 0.981 (now 0)`.
    fn set_to(&self, value: f64) -> String {
        let (name, now) = (self.coordinate_name().unwrap_or_default(), self.default_m.unwrap_or_default());
        format!("{name} = {} (now {})", readable(self.rounded(value)), readable(now))
    }

    /// The coordinate, with its joint if OpenSim made the name: `_coord_4` comes more than once.
    fn coordinate_name(&self) -> Option<String> {
        let name = shown(self.coordinate.as_deref()?).to_string();
        let joint = self.joint.as_deref().filter(|joint| name.starts_with("_coord_") && !joint.is_empty());
        Some(joint.map_or(name.clone(), |joint| format!("{name} of {}", shown(joint))))
    }

    /// A value of the coordinate in so many decimals that a hundredth of the smallest radius shows, m.
    #[must_use]
    pub fn rounded(&self, value_m: f64) -> f64 {
        let smallest = self.bottoms.iter().map(|bottom| bottom.radius_m).fold(1.0, f64::min);
        let decimals = (-(smallest / 100.0).log10().floor()).clamp(2.0, 12.0);
        let unit = 10_f64.powf(decimals);
        (value_m * unit).round() / unit
    }

    /// The coordinate at rest on `feet`: `pelvis_ty = 0.981`; `None` if no coordinate lifts it.
    #[must_use]
    pub fn coordinate_on(&self, feet: &OnFeet) -> Option<String> {
        Some(format!("{} = {}", self.coordinate_name()?, readable(self.rounded(feet.value_m?))))
    }
}

//! Spheres that move after everything else was planned, because their feet are made level.

use foldhash::HashMap;
use osim_model::{Fault, Model, SphereId};

use crate::builder::PlanBuilder;
use crate::change::Move;
use crate::plan::{LEVEL, Plan};
use crate::remarks::LEVEL_FEET;

impl Plan {
    /// Moves the centres of spheres to these places in their own frames, m, wherever the plan puts them; `model` is the one that the
    /// plan was made for.
    ///
    /// # Errors
    /// A place that is not finite, or a sphere of an included file.
    pub fn level(&mut self, model: &Model, places: &[(SphereId, [f64; 3])]) -> Result<(), Fault> {
        if places.is_empty() {
            return Ok(());
        }
        let ground = self.ground(model);
        let path = |sphere: SphereId| ground.sphere(sphere).map(|sphere| sphere.path.clone());
        let paths: Vec<String> = places.iter().filter_map(|&(sphere, _)| path(sphere)).collect();
        let mut builder = PlanBuilder::new(ground);
        for &(sphere, location_m) in places {
            builder.location(sphere, location_m, LEVEL)?;
        }
        let new: Vec<Move> = builder.moves;
        let mut moves: Vec<Move> =
            self.moves.iter().filter(|old| !paths.contains(&old.path)).cloned().chain(new).collect();
        moves.sort_by_key(|one| (one.slot.file, one.slot.offset));
        let moved: HashMap<&str, [f64; 3]> = moves.iter().map(|one| (one.path.as_str(), one.to)).collect();
        let places = ground.places_digest(|sphere| moved.get(sphere.path.as_str()).copied());
        self.moves = moves;
        self.note_places(places);
        self.remarks.push(LEVEL_FEET.into());
        Ok(())
    }
}

//! Requests that add contacts to a model, and changes between adding and removing them.

use osim_model::{Model, YesQuestion};
use serde_json::{Value, json};

pub const TABLE_OF_PLACES: &str = "places.csv";
/// The name of the call that leaves the contacts that the model has.
const BESIDE_OTHER_CONTACTS: &str = "beside others";

/// A request that adds contacts, and the table that it reads.
pub struct AddCall {
    pub name: &'static str,
    pub request: Value,
    pub table: String,
}

/// One `add` request for each way in which this model can get contacts; the requests call the model `name`.
pub fn add_calls(name: &str, model: &Model) -> Vec<AddCall> {
    let bodies: Vec<&str> = model.bodies().iter().map(|body| body.name.as_str()).collect();
    let (Some(first), Some(last)) = (bodies.first(), bodies.last()) else { return Vec::new() };
    let yes: Vec<&str> = YesQuestion::ALL.iter().map(|question| question.as_str()).collect();
    let request = |fields: Value| {
        let mut request = json!({"verb": "add", "models": [name], "yes": yes, "mass": 61.5});
        request.as_object_mut().unwrap().extend(fields.as_object().unwrap().clone());
        request
    };
    let row = |(at, body): (usize, &&str)| format!("s{at},{body},0.0{at},-0.01,0.005,0.03\n");
    let table_of = |bodies: &[&str]| {
        let rows: String = bodies.iter().enumerate().map(row).collect();
        format!("name,body,x,y,z,radius\n{rows}")
    };
    let feet = ["calcn_r", "calcn_l", "toes_r", "toes_l"];
    let has_feet = feet.iter().all(|foot| bodies.contains(foot));
    // Of two feet with toes, or of one foot.
    let of_reference = |class: &str| match has_feet {
        true => {
            let factors: serde_json::Map<_, _> =
                feet.iter().map(|foot| ((*foot).to_owned(), json!(1.0))).collect();
            request(json!({"from": "falisse2022", "class": class, "body_scale": factors}))
        }
        false => request(json!({
            "from": "format/v40600.osim", "class": class, "reference_mass": 61.5, "body_scale": {"calcn_r": [1.1, 0.9, 1.2]},
        })),
    };
    let by_table = |class: &str| {
        request(json!({
            "contacts": TABLE_OF_PLACES, "class": class, "indentation": 0.1, "restitution": 0.3, "load": 30.0, "spheres": 2, "impact_speed": 0.3,
        }))
    };
    let mut calls = Vec::new();
    if has_feet || bodies.contains(&"calcn_r") {
        for (name, class) in [("reference", "smooth"), ("reference, Hunt-Crossley", "hunt-crossley")] {
            calls.push(AddCall { name, request: of_reference(class), table: String::new() });
        }
    }
    calls.extend([
        AddCall { name: "table", request: by_table("smooth"), table: table_of(&[first, last]) },
        AddCall {
            name: "table, Hunt-Crossley",
            request: by_table("hunt-crossley"),
            table: table_of(&[last]),
        },
        AddCall {
            name: "table, every body",
            request: by_table("smooth"),
            table: table_of(&bodies.iter().copied().take(9).collect::<Vec<_>>()),
        },
    ]);
    if has_feet && name.starts_with("feet/") | name.starts_with("corpus/") {
        let fields = json!({"feet": ["calcn_r", "calcn_l"], "count": 3, "pad": 0.01, "from": "falisse2022"});
        calls.push(AddCall { name: "meshes", request: request(fields), table: String::new() });
    }
    let loaded: Vec<&str> = model.spheres().iter().filter_map(|sphere| sphere.body.as_deref()).collect();
    let free: Vec<&str> = bodies.iter().copied().filter(|body| !loaded.contains(body)).take(2).collect();
    if model.forces().iter().any(|force| model.meets_half_space(force)) {
        if free.is_empty() {
            return Vec::new();
        }
        let mut request = by_table("smooth");
        request["exclude"] = json!(["*"]);
        return vec![AddCall { name: BESIDE_OTHER_CONTACTS, request, table: table_of(&free) }];
    }
    calls
}

/// Changes between adding and removing contacts: none, one or two requests. If the model has other contacts, they apply only to the new
/// forces.
pub fn between(name: &str, call: &AddCall) -> Vec<(&'static str, Vec<Value>)> {
    let one = |mut request: Value| {
        request["models"] = json!([name]);
        if call.name == BESIDE_OTHER_CONTACTS && request["verb"] != "note" {
            request["select"] = json!([if request["verb"] == "remove" { "force_s0*" } else { "force_s*" }]);
        }
        request
    };
    let rescale = one(json!({"verb": "rescale", "contacts_mass": 61.5, "target_mass": 150.0}));
    let note = one(json!({"verb": "note", "contacts_mass": 77.0}));
    vec![
        ("nothing", vec![]),
        ("rescale", vec![rescale.clone()]),
        ("note", vec![note.clone()]),
        ("set", vec![one(json!({"verb": "set", "set": {"stiffness": "x2", "viscous_friction": 0.7}}))]),
        ("convert to smooth", vec![one(json!({"verb": "convert", "to": "smooth"}))]),
        ("convert to hunt-crossley", vec![one(json!({"verb": "convert", "to": "hunt-crossley"}))]),
        ("note, rescale", vec![note, rescale]),
        ("part", vec![one(json!({"verb": "remove", "select": ["*s0*", "*_r"]}))]),
    ]
}

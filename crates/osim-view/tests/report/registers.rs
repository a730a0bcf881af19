//! Tests of the registers of figures: of `inspect`, of `drop-test` and its series, and of `design` without a model.

use std::collections::{BTreeMap, BTreeSet};

use osim_inspect::{Figure, Quantity, SphereFigures};
use osim_model::Property;
use osim_model::files::InMemory;
use osim_planning::{
    DesignQuantity, DesignSheet, DropColumn, DropFigure, DropResult, design_sheet, run_drop_test,
};
use osim_requests::Request;
use osim_view::report::results::DropRecord;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde_json::{Value, json};

use crate::support::open;

/// All registers with their quantities.
fn registers() -> [(&'static str, Vec<&'static Quantity>); 4] {
    [
        ("inspect", Figure::ALL.iter().map(|figure| figure.info()).collect()),
        ("drop-test", DropFigure::ALL.iter().map(|figure| figure.info()).collect()),
        ("series of a drop-test", DropColumn::ALL.iter().map(|column| column.info()).collect()),
        ("design", DesignQuantity::ALL.iter().map(|quantity| quantity.info()).collect()),
    ]
}

/// The result of a drop test: a body of 62 kg on six spheres of the paper. `others` are further options.
fn drop_result(others: &Value) -> DropResult {
    let mut request = json!({
        "verb": "drop-test", "mass": 62, "spheres": 6, "radius": 0.032, "stiffness": 1e6, "dissipation": 2, "samples": 3,
    });
    request.as_object_mut().unwrap().extend(others.as_object().unwrap().clone());
    let Ok(Request::DropTest(request)) = Request::from_json(request.to_string().as_bytes()) else { panic!() };
    run_drop_test(&request, &InMemory::default()).unwrap()
}

/// A design sheet with every figure that a design can have.
fn full_design_sheet() -> DesignSheet {
    let request = json!({
        "verb": "design", "mass": 62, "spheres": 6, "radius": 0.032, "young": 2e6, "poisson": 0.5,
        "other_young": 2e6, "other_poisson": 0.5, "restitution": 0.9,
        "constant_indentation": 0.1, "state_width": 0.3, "speed_width": 0.3,
    });
    let Ok(Request::Design(request)) = Request::from_json(request.to_string().as_bytes()) else { panic!() };
    design_sheet(&request).unwrap()
}

fn schema_of_type<T: JsonSchema>() -> Value {
    let generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
    Schema::to_value(generator.into_root_schema_for::<T>())
}

fn field_names(object: &Value) -> Vec<&str> {
    object.as_object().unwrap().keys().map(String::as_str).collect()
}

/// Asserts that a schema requires the fields of `object`, in their order, and only allows `optional` besides them.
#[track_caller]
fn assert_lists(schema: &Value, object: &Value, optional: &[&str]) {
    assert_eq!(schema["required"], json!(field_names(object)));
    let mut listed = field_names(&schema["properties"]);
    listed.retain(|field| !optional.contains(field));
    assert_eq!(listed, field_names(object));
    assert_eq!(schema["properties"].as_object().unwrap().len(), listed.len() + optional.len());
}

#[test]
fn names_are_one_each_and_end_in_their_unit() {
    for (register, quantities) in registers() {
        let names: BTreeSet<&str> = quantities.iter().map(|info| info.name).collect();
        assert_eq!(names.len(), quantities.len(), "{register}");
        for info in quantities {
            // OpenSim's names are its own.
            if info.name.parse::<Property>().is_ok() {
                continue;
            }
            let end = match info.unit {
                "" => continue,
                unit => format!("_{}", unit.to_lowercase().replace('/', "_")),
            };
            assert!(info.name.ends_with(&end), "{register}: {} in {}", info.name, info.unit);
        }
    }
}

#[test]
fn what_has_one_name_has_one_unit_everywhere() {
    let mut units = BTreeMap::new();
    for (register, info) in
        registers().iter().flat_map(|(name, all)| all.iter().map(move |info| (name, info)))
    {
        let first = *units.entry(info.name).or_insert(info.unit);
        assert_eq!(first, info.unit, "{register}: {}", info.name);
        assert!(!info.unit.contains('^'), "{register}: {} in {}", info.name, info.unit);
    }
}

#[test]
fn every_quantity_says_what_it_is() {
    for (register, info) in
        registers().iter().flat_map(|(name, all)| all.iter().map(move |info| (name, info)))
    {
        let meaning = info.meaning().to_string();
        assert!(meaning.ends_with('.') && meaning.len() > 3, "{register}: {} is {meaning:?}", info.name);
        assert!(!info.label.is_empty(), "{register}: {}", info.name);
    }
}

#[test]
fn schemas_list_what_is_printed() {
    let (record, of_drop) = (
        serde_json::to_value(DropRecord(&drop_result(&json!({})))).unwrap(),
        schema_of_type::<DropRecord<'_>>(),
    );
    assert_lists(&of_drop, &record, &["model_bytes"]);
    assert_lists(&of_drop["$defs"]["DropSeriesRecord"], &record["series"], &[]);

    let model = open("table1/mouse_smooth_sphere.osim");
    let inspected = osim_inspect::InspectOptions::default().inspect("mouse.osim", &model.model, None);
    let sphere = serde_json::to_value(inspected.figures.spheres().next().unwrap()).unwrap();
    assert_lists(&schema_of_type::<SphereFigures>(), &sphere, &[]);

    let of_design = schema_of_type::<DesignSheet>();
    let names: Vec<&str> = DesignQuantity::ALL.iter().map(|quantity| quantity.info().name).collect();
    assert_eq!(of_design["$defs"]["DesignFigure"]["properties"]["name"]["enum"], json!(names));
}

#[test]
fn what_a_schema_calls_a_number_is_always_known() {
    // It is still in the air when the time is up.
    let in_the_air = drop_result(&json!({"height": 10, "duration": 0.1}));
    for figure in DropFigure::ALL {
        let known = figure.value(&in_the_air).is_some();
        assert_eq!(known, figure.is_always_known(), "{}", figure.info().name);
    }
}

#[test]
fn a_design_finds_every_quantity_of_its_register_in_that_order() {
    let sheet = full_design_sheet();
    let found: Vec<DesignQuantity> = sheet.figures.iter().map(|figure| figure.quantity).collect();
    assert_eq!(found, DesignQuantity::ALL);
    for figure in &sheet.figures {
        let info = figure.quantity.info();
        assert_eq!((figure.name, figure.unit), (info.name, info.unit));
        assert_eq!(figure.limit.is_some(), info.limit.is_some(), "{}", figure.name);
    }
}

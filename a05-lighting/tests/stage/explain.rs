//! The plans of the scenes name the work that the lesson leaves out.

use a05_lighting::stage;
use common::Settings;

#[test]
fn plans_name_objects_lights_and_powers_that_are_not_taken() {
    let powers = "powers where the light is mirrored away from the eye or comes from behind";
    for (scene, lights, shading) in [
        ("lighting-1", 0, Some("all shading by lights")),
        ("lambert", 1, None),
        ("phong", 1, Some(powers)),
    ] {
        let stage = stage();
        let scene = stage.scene(scene).unwrap();
        let plan = scene.plan(&Settings::default()).unwrap();
        let needs = ["objects: 4".to_owned(), format!("lights: {lights}")];
        assert_eq!(plan.needs[1..], needs);
        let omitted = plan.omissions.iter().map(|omission| omission.what.as_str());
        let expected = ["random numbers"].into_iter().chain(shading);
        let expected: Vec<_> = expected.chain(["shadows and mirrors"]).collect();
        assert_eq!(omitted.collect::<Vec<_>>(), expected);
    }
}

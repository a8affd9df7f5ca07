//! Scenes of everything that a scene file can say: the three renderers draw the same pictures, also
//! if each 0 in the files is negated.

use a03_rays_cameras::View;
use a07_transforms::kinds::FORMAT;
use common::{Settings, Size};
use scene_file::{Error, KINDS, Mesh};

use crate::same_pictures::{compare, compare_scenes, or_asked};
use crate::written::Written;

fn view(files: &Written) -> Result<View, Error> {
    let file = FORMAT.read(&files.scene, &|_| Mesh::read(files.mesh.as_bytes()))?;
    FORMAT.scene(&file).map(|(_, view)| view)
}

#[test]
fn random_files_have_every_key() {
    let files: Vec<_> = (0..50).map(|seed| Written::new(seed).scene).collect();
    let all = files.concat();
    // The settings of a picture are those of the tests.
    let kinds = KINDS.iter().filter(|kind| kind.name != "picture");
    for kind in kinds {
        // Tables in a table have no meaning of their own.
        for key in kind.keys.iter().filter(|key| !key.about.is_empty()) {
            let (table, name) = (kind.name, key.name);
            assert!(
                all.contains(&format!("{name} = ")),
                "no file of random_worlds/written.rs has a {table} with {name}"
            );
        }
    }
}

#[test]
fn all_renderers_draw_the_same_pictures() {
    compare_scenes(420..460, |seed, _| view(&Written::new(seed)));
}

#[test]
fn the_sign_of_a_zero_changes_no_picture() {
    let settings = Settings {
        size: Size::new(24, 18).unwrap(),
        depth: 3,
        ..Settings::default()
    };
    for seed in or_asked(200..240) {
        let files = Written::new(seed);
        let pictures = [files.with_negative_zeros(), files].map(|files| {
            let again = || view(&files).unwrap();
            view(&files)
                .is_ok()
                .then(|| compare(seed, again, &settings))
        });
        assert!(pictures[0] == pictures[1], "seed {seed}");
    }
}

/// The light lies in the plane of a face, so that its dot product with the normal is 0 or -0.
#[test]
fn light_along_a_face_of_a_mirrored_mesh_does_not_depend_on_a_zero() {
    let scene = |direction: &str| {
        format!(
            "[camera]\neye = [3, 4, 7]\nlook_at = [0, 0, 0]\nangle = 35\n\
             [material.m]\ndiffuse = [1, 1, 1]\n\
             [[directional_light]]\ncolor = [1, 1, 1]\ndirection = {direction}\n\
             [[mesh]]\nfile = \"m\"\nsmooth = true\nmaterial = \"m\"\n\
             transform = [{{ scale = [1, -1, 1] }}]\n"
        )
    };
    let mesh = "v -0.4 0 0.4\nv 0.4 0 1.2\nv 0.4 -0.03 0.4\nv 1.2 0 1.2\nf 1 2 3\nf 3 2 4\n";
    let settings = Settings {
        size: Size::new(160, 120).unwrap(),
        ..Settings::default()
    };
    let [plain, negated] = ["[1, 0, 0]", "[1, -0.0, 0]"].map(|direction| {
        let files = Written {
            scene: scene(direction),
            mesh: mesh.into(),
        };
        compare(0, || view(&files).unwrap(), &settings)
    });
    assert!(plain == negated);
}

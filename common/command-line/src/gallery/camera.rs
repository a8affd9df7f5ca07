//! The camera of a gallery, which a person moves by the mouse.

use common::Edits;

use super::Gallery;

/// The angle by which the camera rotates for a pixel of the mouse's way, in radians.
const ANGLE: f64 = 0.01;

/// The way of the camera from its place in the scene.
#[derive(Default)]
pub(super) struct MovedCamera {
    pub edits: Edits,
    /// Whether it has moved since the rendering began.
    pub has_moved: bool,
}

impl Gallery<'_> {
    /// Returns the camera to its place in the scene, and renders the picture.
    pub fn reset(&mut self) {
        self.camera.edits = Edits::default();
        self.start_or_fail();
    }

    /// Rotates the camera around the middle of the scene, by a displacement of the mouse in pixels.
    pub fn rotate(&mut self, [right, down]: [i32; 2]) {
        self.move_camera(|edits| {
            edits.orbit[0] -= ANGLE * f64::from(right);
            edits.orbit[1] -= ANGLE * f64::from(down);
        });
    }

    /// Moves the camera towards the middle of the scene, by steps of a tenth of the distance.
    pub fn approach(&mut self, steps: i32) {
        self.move_camera(|edits| edits.steps += steps);
    }

    /// A scene without a camera, or one that is not there yet, has none to move.
    fn move_camera(&mut self, edit: impl FnOnce(&mut Edits)) {
        self.end_answer();
        if self.scene().is_some_and(|scene| scene.rays().is_ok()) {
            edit(&mut self.camera.edits);
            self.camera.has_moved = true;
        }
    }
}

//! The camera of a gallery, which a person moves by the mouse.

use common::Edits;

use super::Gallery;

/// The angle by which the camera rotates for a pixel of the mouse's way, in radians.
const ANGLE: f64 = 0.01;

impl Gallery<'_> {
    /// Returns the camera to its place in the scene, and renders the picture.
    pub fn reset(&mut self) {
        self.edits = Edits::default();
        self.message.clear();
        self.start_or_fail();
    }

    /// Rotates the camera around the middle of the scene, by a way of the mouse in pixels.
    pub fn rotate(&mut self, [right, down]: [i32; 2]) {
        self.edits.orbit[0] -= ANGLE * f64::from(right);
        self.edits.orbit[1] -= ANGLE * f64::from(down);
        self.move_camera();
    }

    /// Moves the camera towards the middle of the scene, by steps of a tenth of the distance.
    pub fn approach(&mut self, steps: i32) {
        self.edits.steps += steps;
        self.move_camera();
    }

    fn move_camera(&mut self) {
        self.message.clear();
        self.has_moved = self.scene().is_some_and(|scene| scene.rays().is_ok());
    }
}

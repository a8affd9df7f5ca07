//! The renderer of a gallery, which a person may change to the fast one.

use common::Renderer;

use super::Gallery;

impl Gallery<'_> {
    /// Whether the fast renderer could draw the scene instead of the lesson's.
    #[must_use]
    pub fn could_be_fast(&self) -> bool {
        self.scene().is_some_and(|scene| {
            let settings = self.settings(scene);
            let is_lesson = settings.is_ok_and(|settings| settings.renderer == Renderer::Lesson);
            scene.uses.sampling && is_lesson
        })
    }

    /// Renders this picture and the next ones by the fast renderer.
    pub fn render_fast(&mut self) {
        if self.could_be_fast() {
            self.options.render_fast();
            self.start_or_fail();
        }
    }
}

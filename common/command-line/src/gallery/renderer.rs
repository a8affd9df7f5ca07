//! The renderer of a gallery, which a person may change to the fast one.

use common::{Renderer, Settings};

use super::Gallery;

impl Gallery<'_> {
    /// The settings of a picture that the lesson draws, and the fast renderer could.
    #[must_use]
    pub fn could_be_fast(&self) -> Option<Settings> {
        let scene = self.scene().filter(|scene| scene.uses.sampling)?;
        let settings = self.settings(scene).ok()?;
        (settings.renderer == Renderer::Lesson).then_some(settings)
    }

    /// Renders this picture and the next ones by the fast renderer.
    pub fn render_fast(&mut self) {
        if self.could_be_fast().is_some() {
            self.options.render_fast();
            self.start_or_fail();
        }
    }
}

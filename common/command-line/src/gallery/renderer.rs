//! The renderer of a gallery, which a person may change to the fast one and back.

use common::{Renderer, Settings};

use super::Gallery;

impl Gallery<'_> {
    /// The settings of the picture by the other renderer: the fast one instead of the lesson, or the lesson instead of it.
    #[must_use]
    pub fn by_other_renderer(&self) -> Option<Settings> {
        let scene = self.scene().filter(|scene| scene.uses.sampling)?;
        let settings = self.settings(scene).ok()?;
        let renderer = match settings.renderer {
            Renderer::Lesson => Renderer::Engine,
            Renderer::Engine => Renderer::Lesson,
            Renderer::NoOmissions => return None,
        };
        Some(Settings {
            renderer,
            ..settings
        })
    }

    /// Renders this picture and the next ones by the other renderer.
    pub fn change_renderer(&mut self) {
        if let Some(settings) = self.by_other_renderer() {
            self.options.fast = settings.renderer == Renderer::Engine;
            self.start_or_fail();
        }
    }
}

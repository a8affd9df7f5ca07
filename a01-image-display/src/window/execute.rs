//! Executes the commands of the window.

use program::{Gallery, Theme};

use super::command::{Command, Page};
use super::content::{Content, Kind};
use super::placement::Zoom;
use super::screen::Screen;
use super::{NO_FILE, choose_file};

impl Screen {
    /// Executes a command. False if the window is to be closed.
    pub fn execute(&mut self, command: Command, content: &Content, gallery: &mut Gallery) -> bool {
        let placement = content.placement;
        // Far from the picture where the mouse is outside of the window.
        let cursor = self.mouse.cursor.unwrap_or((i32::MAX, i32::MAX));
        match command {
            Command::Close => return false,
            Command::Escape if self.selected.take().is_some() => {}
            Command::Escape if gallery.pixel.is_none() => return false,
            Command::Escape => gallery.explain(None),
            Command::Save => self.notify(match &gallery.outcome {
                None => "the picture is not finished yet".to_owned(),
                Some(Err(_)) => "there is no picture to save".to_owned(),
                Some(Ok(image)) => match gallery.save(image) {
                    Ok(path) => format!("saved {}", path.display()),
                    Err(error) => format!("error: {error}"),
                },
            }),
            Command::Open if !gallery.scene.uses.file => {}
            Command::Open => match choose_file() {
                None => self.notify(NO_FILE.to_owned()),
                file => {
                    gallery.options.open = file;
                    self.go_to(gallery.number(), gallery);
                }
            },
            Command::Scene(number) => self.go_to(number, gallery),
            Command::RenderWith(renderer) => gallery.render_with(renderer),
            Command::Zoom(larger) => self.zoom = placement.zoomed(larger, cursor),
            Command::Fit => self.zoom = Zoom::Fit,
            Command::Pan(x, y) => self.zoom = placement.panned(self.zoom, (x, y)),
            Command::Turn(x, y) => gallery.turn(x, y),
            Command::Reset => gallery.reset(),
            Command::Letters(larger) => {
                let factor = if larger { 1.125 } else { 1.0 / 1.125 };
                self.set_scale((self.scale * factor).clamp(0.5, 4.0));
            }
            Command::Theme => {
                let is_dark = self.theme == Theme::Dark;
                self.theme = if is_dark { Theme::Light } else { Theme::Dark };
            }
            Command::Page(page) => {
                self.page = Some(page).filter(|page| self.page != Some(*page));
                (self.scroll, self.selected) = (0, None);
                let content = self.content(gallery);
                self.select(1, &content);
            }
            Command::Scroll(lines) => self.scroll += self.ui(20.0) * lines,
            Command::Explain => {
                let middle = (
                    placement.picture.width() / 2,
                    placement.picture.height() / 2,
                );
                let (x, y) = placement.pixel(cursor).unwrap_or(middle);
                gallery.explain(Some([x, y]));
                (self.page, self.selected) = (Some(Page::Pixel), None);
            }
            Command::Slider(_) => self.selected = Some(command),
            Command::Choose => {
                if let Some(chosen) = self.selected.take() {
                    return self.execute(chosen, content, gallery);
                }
            }
            Command::Arrow(x, y) => self.arrow((x, y), content, gallery),
        }
        true
    }

    fn arrow(&mut self, (x, y): (i32, i32), content: &Content, gallery: &mut Gallery) {
        if let (Some(Command::Slider(slider)), 1 | -1) = (self.selected, x) {
            let at = gallery.sliders.get(slider).map_or(0, |slider| slider.at);
            gallery.slide(slider, at.saturating_add_signed(x as isize));
        } else if self.selected.is_some() && y != 0 {
            self.select(y, content);
        } else if let Some([column, row]) = gallery.pixel {
            let size = content.placement.picture;
            let moved = |at: u32, way, side: u32| at.saturating_add_signed(way).min(side - 1);
            gallery.explain(Some([
                moved(column, x, size.width()),
                moved(row, y, size.height()),
            ]));
        } else if x != 0 {
            let count = gallery.stage.scenes.len() as i32;
            self.go_to(
                (gallery.number() as i32 + x).rem_euclid(count) as usize,
                gallery,
            );
        }
    }

    /// Selects the next or the previous entry or slider of the panel, and keeps it in view.
    fn select(&mut self, step: i32, content: &Content) {
        let is_selectable = |kind| matches!(kind, Kind::Entry(_) | Kind::Slider(_));
        let items: Vec<_> = content
            .items
            .iter()
            .filter(|item| is_selectable(item.kind))
            .collect();
        let at = items.iter().position(|item| item.command == self.selected);
        let to = at.map_or(0, |at| (at as i32 + step).rem_euclid(items.len() as i32));
        if let Some(item) = items.get(to as usize) {
            self.selected = item.command;
            let middle = content.panel.height / 2;
            self.scroll = (self.scroll + item.area.y - middle).max(0);
        }
    }

    fn go_to(&mut self, number: usize, gallery: &mut Gallery) {
        (self.notice, self.zoom, self.selected) = (None, Zoom::Fit, None);
        gallery.go_to(number);
        self.window.set_title(&gallery.title());
    }
}

//! `Mouse`: clicks, drags and the wheel.

use std::time::{Duration, Instant};

use minifb::{MouseButton, MouseMode};
use program::Gallery;

use super::command::Command;
use super::content::Content;
use super::screen::Screen;

/// The longest time between the two clicks of a double click.
const DOUBLE: Duration = Duration::from_millis(400);
/// The longest way of the mouse that is a click and no drag, in pixels.
const STILL: i32 = 3;

/// The mouse at the last update.
#[derive(Clone, Debug, Default)]
pub struct Mouse {
    /// The pixel of the window under the mouse; none outside of it.
    pub cursor: Option<(i32, i32)>,
    at: (i32, i32),
    left: bool,
    right: bool,
    /// Where the left button went down on the picture.
    pressed: Option<(i32, i32)>,
    is_dragging: bool,
    clicked: Option<Instant>,
    /// The way of the wheel that has had no effect yet.
    wheel: f32,
}

/// The way of the wheel for a step: X11 reports a notch twice, when it begins and ends.
const NOTCH: f32 = 2.0;

impl Screen {
    /// The commands of the mouse since the last call. Moves a slider at once.
    pub fn mouse_commands(&mut self, content: &Content, gallery: &mut Gallery) -> Vec<Command> {
        let (window, mouse) = (&self.window, &mut self.mouse);
        let before = mouse.clone();
        let position = |mode| {
            window
                .get_mouse_pos(mode)
                .map(|(x, y)| (x as i32, y as i32))
        };
        mouse.cursor = position(MouseMode::Discard);
        mouse.at = position(MouseMode::Pass).unwrap_or_default();
        mouse.left = window.get_mouse_down(MouseButton::Left);
        mouse.right = window.get_mouse_down(MouseButton::Right);
        let (x, y) = (mouse.at.0 - before.at.0, mouse.at.1 - before.at.1);
        let item = content.item_at(mouse.at).filter(|_| !mouse.is_dragging);
        let command = item.and_then(|item| item.command);
        let mut commands = Vec::new();
        match (before.left, mouse.left) {
            (false, true) if item.is_some() => commands.extend(command),
            (false, true) => mouse.pressed = Some(mouse.at),
            (true, false) => {
                let is_click = mouse.pressed.take().is_some() && !mouse.is_dragging;
                mouse.is_dragging = false;
                if is_click {
                    let again = mouse.clicked.is_some_and(|at| at.elapsed() < DOUBLE);
                    mouse.clicked = (!again).then(Instant::now);
                    commands.push(if again {
                        Command::Fit
                    } else {
                        Command::Explain
                    });
                }
            }
            _ => {}
        }
        if let (Some(Command::Slider(slider)), Some(item), true) = (command, item, mouse.left) {
            let way = f64::from(mouse.at.0 - item.area.x) / f64::from(item.area.width.max(1));
            let last = gallery.sliders.get(slider).map_or(0, program::Slider::last);
            gallery.slide(slider, (way.clamp(0.0, 1.0) * last as f64).round() as usize);
        }
        if let Some((left, top)) = mouse.pressed {
            mouse.is_dragging |= (mouse.at.0 - left).abs().max((mouse.at.1 - top).abs()) > STILL;
        }
        if (x, y) != (0, 0) && mouse.is_dragging {
            commands.push(Command::Pan(x, y));
        }
        if (x, y) != (0, 0) && mouse.right && before.right {
            commands.push(Command::Turn(x, y));
        }
        mouse.wheel += window.get_scroll_wheel().map_or(0.0, |(_, lines)| lines);
        if mouse.wheel.abs() >= NOTCH {
            let is_up = std::mem::take(&mut mouse.wheel) > 0.0;
            let scroll = Command::Scroll(if is_up { -3 } else { 3 });
            let is_panel = content.panel.contains(mouse.at);
            commands.push(if is_panel {
                scroll
            } else {
                Command::Zoom(is_up)
            });
        }
        commands
    }
}

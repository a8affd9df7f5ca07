//! `Events`: waits for events of the window, and passes them to the screen.
//!
//! Where nothing happens, the thread sleeps until the system reports an event. It wakes by itself
//! only while a picture is rendered, while a scene file is watched, and when a notice has to
//! disappear.

use std::time::{Duration, Instant};

use program::{Gallery, NotShown};
use winit::application::ApplicationHandler;
use winit::event::{StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::keyboard::ModifiersState;
use winit::window::WindowId;

use super::keyboard::Press;
use super::mouse::Mouse;
use super::screen::Screen;
use super::surface::Surface;

/// The shortest time between two drawings of the window.
const FRAME: Duration = Duration::from_millis(16);
/// The longest time between two drawings while a picture is rendered.
const REFRESH: Duration = Duration::from_millis(250);
/// The time after which a watched file is looked at again.
const WATCH: Duration = Duration::from_millis(200);

/// The window with its scenes.
pub struct Events<'gallery, 'scope, 'a> {
    gallery: &'gallery mut Gallery<'scope, 'a>,
    screen: Screen,
    /// None before the window is open.
    surface: Option<Surface>,
    modifiers: ModifiersState,
    /// The mouse after movements of which the screen does not know yet.
    moved: Mouse,
    /// Whether the window does not show the newest state.
    is_stale: bool,
    /// When the window was drawn, and how long that took.
    drawn: Instant,
    cost: Duration,
    /// Why the window ends by itself.
    failure: Option<NotShown>,
}

/// Shows the screen in a window until it is closed.
pub fn run(gallery: &mut Gallery, screen: Screen) -> Result<(), NotShown> {
    if !has_keyboard_libraries() {
        let missing = "libxkbcommon and libxkbcommon-x11 are not installed";
        return Err(NotShown::NoWindow(missing.to_owned()));
    }
    let event_loop = EventLoop::new().map_err(no_display)?;
    let mut events = Events {
        gallery,
        screen,
        surface: None,
        modifiers: ModifiersState::empty(),
        moved: Mouse::default(),
        is_stale: true,
        drawn: Instant::now(),
        cost: Duration::ZERO,
        failure: None,
    };
    let ended = event_loop.run_app(&mut events);
    match events.failure {
        Some(failure) => Err(failure),
        None => ended.map_err(no_display),
    }
}

/// Whether the libraries are there without which `winit` panics.
fn has_keyboard_libraries() -> bool {
    #[cfg(target_os = "linux")]
    return xkbcommon_dl::xkbcommon_option().is_some()
        && xkbcommon_dl::x11::xkbcommon_x11_option().is_some();
    #[cfg(not(target_os = "linux"))]
    return true;
}

/// An error of the display. That of `winit` begins with the place in its code, and may end with a
/// note for those who build it.
fn no_display(error: impl std::fmt::Display) -> NotShown {
    let error = error.to_string();
    let place = error.strip_prefix("os error at ");
    let reason = place.and_then(|place| place.split_once(": "));
    let reason = reason.map_or(error.as_str(), |(_, reason)| reason);
    let reason = reason.split("; note:").next().unwrap_or(reason);
    let reason = reason.trim_end_matches('.');
    NotShown::NoWindow(format!("no display to open it on ({reason})"))
}

impl Events<'_, '_, '_> {
    /// Passes an input to the screen. The movements of the mouse before it come first.
    fn input(&mut self, event_loop: &ActiveEventLoop, press: Press, mouse: Mouse) {
        self.is_stale = true;
        if !self.screen.input(press, mouse, self.gallery) {
            event_loop.exit();
        }
    }

    fn pass_movement(&mut self, event_loop: &ActiveEventLoop) {
        if self.moved != self.screen.ui.mouse {
            self.input(event_loop, Press::default(), self.moved);
        }
    }

    /// The time until the window is to be drawn; none if it shows the newest state.
    fn wait_to_draw(&self) -> Option<Duration> {
        let wait = if self.is_stale {
            FRAME
        } else if self.screen.drawn != self.screen.fingerprint(self.gallery) {
            // Progress leaves most of the time for the rendering.
            (3 * self.cost).clamp(FRAME, REFRESH)
        } else if self.gallery.is_rendering() {
            REFRESH
        } else {
            return None;
        };
        Some(wait.saturating_sub(self.drawn.elapsed()))
    }

    fn draw(&mut self) -> Result<(), NotShown> {
        let Some(surface) = &mut self.surface else {
            return Ok(());
        };
        let start = Instant::now();
        surface.set_title(self.gallery.title());
        self.screen.draw(self.gallery);
        let shown = surface.show(self.screen.size, &self.screen.ui.frame.pixels);
        (self.drawn, self.is_stale) = (Instant::now(), false);
        self.cost = self.drawn - start;
        shown.map_err(|error| {
            NotShown::NoWindow(format!("the display refused the picture ({error})"))
        })
    }
}

impl ApplicationHandler for Events<'_, '_, '_> {
    fn new_events(&mut self, _: &ActiveEventLoop, cause: StartCause) {
        if matches!(cause, StartCause::ResumeTimeReached { .. }) {
            self.screen.update(self.gallery);
        }
    }

    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.surface.is_some() {
            return;
        }
        let monitor = event_loop.primary_monitor();
        let monitor = monitor.or_else(|| event_loop.available_monitors().next());
        let scale = monitor.map_or(1.0, |monitor| monitor.scale_factor());
        self.screen
            .begin(self.gallery, event_loop.system_theme(), scale);
        let (title, scale) = (self.gallery.title(), self.screen.ui.scale);
        match Surface::open(event_loop, title, self.screen.size, scale) {
            Ok(surface) => {
                self.screen.size = surface.window.inner_size().into();
                surface.window.request_redraw();
                self.surface = Some(surface);
            }
            Err(reason) => {
                self.failure = Some(no_display(reason));
                event_loop.exit();
            }
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        if let WindowEvent::CursorMoved { position, .. } = event {
            self.moved.at = [position.x.floor() as i32, position.y.floor() as i32];
            return;
        }
        self.pass_movement(event_loop);
        let (nothing, mouse) = (Press::default(), self.screen.ui.mouse);
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                if let Err(failure) = self.draw() {
                    self.failure = Some(failure);
                    event_loop.exit();
                }
            }
            WindowEvent::Resized(size) => {
                self.screen.size = size.into();
                self.is_stale = true;
            }
            WindowEvent::ScaleFactorChanged { scale_factor, .. } => {
                self.screen.rescale(self.gallery, scale_factor);
                self.is_stale = true;
            }
            WindowEvent::Focused(is_active) => {
                self.screen.is_active = is_active;
                self.is_stale = true;
            }
            WindowEvent::ModifiersChanged(modifiers) => self.modifiers = modifiers.state(),
            // A synthetic press is that of a key which was held before the window had the keyboard.
            WindowEvent::KeyboardInput {
                event,
                is_synthetic: false,
                ..
            } => {
                if let Some(press) = Press::new(&event, self.modifiers) {
                    self.input(event_loop, press, mouse);
                }
            }
            WindowEvent::MouseInput { button, state, .. } => {
                self.moved = mouse.with_button(button, state);
                self.input(event_loop, nothing, self.moved);
            }
            WindowEvent::MouseWheel { delta, .. } => {
                self.moved = mouse.with_wheel(delta);
                self.input(event_loop, nothing, self.moved);
            }
            WindowEvent::DroppedFile(path) => {
                self.screen.open_file(&path, self.gallery);
                self.is_stale = true;
            }
            _ => {}
        }
    }

    /// All events are handled: draws what they have changed, and chooses when to wake.
    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        self.pass_movement(event_loop);
        self.screen.update(self.gallery);
        let mut wait = self.wait_to_draw();
        if wait == Some(Duration::ZERO)
            && let Some(surface) = &self.surface
        {
            surface.window.request_redraw();
            wait = None;
        }
        let busy = self.gallery.is_busy().then_some(FRAME);
        let watch = self.gallery.watches().then_some(WATCH);
        let notice = self.screen.notice_ends_in();
        let next = [wait, busy, watch, notice].into_iter().flatten().min();
        event_loop.set_control_flow(next.map_or(ControlFlow::Wait, |next| {
            ControlFlow::WaitUntil(Instant::now() + next)
        }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_of_the_display_is_a_clause() {
        for (error, clause) in [
            (
                "os error at /a/mod.rs:7: DISPLAY is not set; note: x",
                "DISPLAY is not set",
            ),
            ("Failed to load.", "Failed to load"),
        ] {
            let shown = no_display(error).to_string();
            assert_eq!(shown, format!("no display to open it on ({clause})"));
        }
    }
}

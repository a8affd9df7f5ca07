//! `Rendering`: renders the picture of a gallery in a thread of its own.

use std::mem;
use std::sync::Arc;
use std::thread::{self, JoinHandle};

use common::{Error, Image, Scene, Settings};
use rayon::ThreadPool;

use crate::LivePicture;
use crate::options::Options;

/// The rendering of a picture.
pub(super) struct Rendering {
    /// The picture as far as it is known.
    pub picture: Arc<LivePicture>,
    job: Job,
}

enum Job {
    /// There is nothing to render.
    Idle,
    /// A thread renders.
    Running(Running),
    /// The finished picture, or the reason for its absence.
    Done(Result<Image, Error>),
}

struct Running {
    thread: JoinHandle<Result<Image, Error>>,
    /// It paints the next picture, too, if that one begins before the end of this one: a stopped one ends at its
    /// next pixels. A window that has its picture needs no threads.
    pool: Arc<ThreadPool>,
}

/// Threads that render.
fn pool(options: &Options) -> Result<ThreadPool, Error> {
    let pool = options.thread_pool()?;
    // The window answers keys while all processors render.
    #[cfg(target_os = "linux")]
    pool.broadcast(|_| rustix::process::nice(10));
    Ok(pool)
}

impl Rendering {
    /// Nothing is rendered into this picture yet.
    pub fn new(picture: LivePicture) -> Self {
        Self {
            picture: Arc::new(picture),
            job: Job::Idle,
        }
    }

    /// Stops; there is nothing to render.
    pub fn stop(&mut self) {
        self.picture.stop();
        self.job = Job::Idle;
    }

    /// Starts to render a scene. An earlier rendering stops.
    pub fn start(
        &mut self,
        scene: Scene,
        settings: Settings,
        options: &Options,
    ) -> Result<(), Error> {
        self.picture.stop();
        let pool = match mem::replace(&mut self.job, Job::Idle) {
            Job::Running(running) => running.pool,
            Job::Idle | Job::Done(_) => Arc::new(pool(options)?),
        };
        let picture = Arc::new(LivePicture::new(settings.size, settings.transfer));
        picture.begin_with(&self.picture);
        self.picture = Arc::clone(&picture);
        let threads = Arc::clone(&pool);
        // The pixels of a large picture take long to pack, too.
        let render = move || {
            let image = threads.install(|| picture.render(&scene, &settings))?;
            picture.finish(&image);
            Ok(image)
        };
        let thread = thread::spawn(render);
        self.job = Job::Running(Running { thread, pool });
        Ok(())
    }

    /// Ends with the reason why there is no picture.
    pub fn fail(&mut self, error: Error) {
        self.picture.stop();
        self.job = Job::Done(Err(error));
    }

    /// Whether nothing was started.
    pub const fn is_idle(&self) -> bool {
        matches!(self.job, Job::Idle)
    }

    /// Whether a picture is being rendered.
    pub const fn is_running(&self) -> bool {
        matches!(self.job, Job::Running(_))
    }

    /// Whether a rendering has ended of which nobody has taken the outcome.
    pub fn has_ended(&self) -> bool {
        match &self.job {
            Job::Running(running) => running.thread.is_finished(),
            _ => false,
        }
    }

    /// Waits for the end of the rendering; false if there is none.
    pub fn wait(&mut self) -> bool {
        let running = match mem::replace(&mut self.job, Job::Idle) {
            Job::Running(running) => running,
            job => {
                self.job = job;
                return false;
            }
        };
        let outcome = running.thread.join();
        let outcome = outcome.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        if let Ok(image) = &outcome
            && self.picture.size() != image.size()
        {
            // The size of a file is not known before.
            self.picture = Arc::new(self.picture.replaced_by(image));
        }
        self.job = Job::Done(outcome);
        true
    }

    /// The finished picture.
    pub const fn image(&self) -> Option<&Image> {
        match &self.job {
            Job::Done(Ok(image)) => Some(image),
            _ => None,
        }
    }

    /// The reason why there is no picture.
    pub const fn error(&self) -> Option<&Error> {
        match &self.job {
            Job::Done(Err(error)) => Some(error),
            _ => None,
        }
    }

    /// Takes the reason why there is no picture.
    pub fn take_error(&mut self) -> Option<Error> {
        match mem::replace(&mut self.job, Job::Idle) {
            Job::Done(Err(error)) => Some(error),
            job => {
                self.job = job;
                None
            }
        }
    }
}

/// A window that is closed ends the rendering.
impl Drop for Rendering {
    fn drop(&mut self) {
        self.picture.stop();
    }
}

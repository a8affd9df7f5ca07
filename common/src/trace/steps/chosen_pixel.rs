//! Traces one pixel that is chosen after its picture has been rendered.
//!
//! The code of an exercise stands between the one who chooses and the one who renders, and has no
//! parameter for the choice. So the recorder of the thread passes it on.

use super::recorder::RECORDER;
use crate::{Image, PixelTrace};

/// Chooses a pixel of a picture.
type Choose = Box<dyn Fn(&Image) -> Option<[u32; 2]>>;

/// Who chooses a pixel, and the trace of the chosen one.
pub(super) struct Choice {
    choose: Option<Choose>,
    trace: Option<PixelTrace>,
}

impl Choice {
    /// Nobody chooses.
    pub const NONE: Self = Self {
        choose: None,
        trace: None,
    };
}

/// Runs `render`, and returns its result and the trace of the pixel that `choose` finds.
pub fn with_chosen_pixel<T>(
    choose: impl Fn(&Image) -> Option<[u32; 2]> + 'static,
    render: impl FnOnce() -> T,
) -> (T, Option<PixelTrace>) {
    let swap = |choice| RECORDER.with(|recorder| recorder.choice.replace(choice));
    let outer = swap(Choice {
        choose: Some(Box::new(choose)),
        trace: None,
    });
    let result = render();
    (result, swap(outer).trace)
}

/// Called with a rendered picture: traces its chosen pixel, if there is one.
pub fn trace_chosen(image: &Image, trace: impl FnOnce([u32; 2]) -> PixelTrace) {
    let pixel = RECORDER.with(|recorder| {
        let choice = recorder.choice.borrow();
        choice.choose.as_ref().and_then(|choose| choose(image))
    });
    let trace = pixel.map(trace);
    RECORDER.with(|recorder| recorder.choice.borrow_mut().trace = trace);
}

//! Traces one pixel of a picture that a function renders, where only the picture says which
//! pixel: code in between, as that of an exercise, passes on nothing.

use std::cell::RefCell;

use crate::{Image, PixelTrace};

/// Chooses a pixel of a picture.
type Choose = Box<dyn Fn(&Image) -> Option<[u32; 2]>>;

thread_local!(static CHOICE: RefCell<(Option<Choose>, Option<PixelTrace>)> = RefCell::default());

/// Runs `render`, and returns its result and the trace of the pixel that `choose` finds.
pub fn traced<T>(
    choose: impl Fn(&Image) -> Option<[u32; 2]> + 'static,
    render: impl FnOnce() -> T,
) -> (T, Option<PixelTrace>) {
    CHOICE.set((Some(Box::new(choose)), None));
    let result = render();
    (result, CHOICE.take().1)
}

/// Called with a rendered picture: traces its chosen pixel, if there is one.
pub fn trace_chosen(image: &Image, trace: impl FnOnce([u32; 2]) -> PixelTrace) {
    let pixel = CHOICE.with_borrow(|(choose, _)| choose.as_ref()?(image));
    let trace = pixel.map(trace);
    CHOICE.with_borrow_mut(|choice| choice.1 = trace);
}

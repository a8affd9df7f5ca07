//! The stages' lessons for the book's pages: pictures that the reader renders on the
//! page, and the numbers behind the figures.
//!
//! A page sends a request, a name and numbers, to [`call`] and shows the [`Reply`].
//! Compiled to WebAssembly, the crate exports it as plain functions on memory.

mod catalogue;
mod figures;
mod file;
mod measuring;
mod omissions;
mod picture;
mod sensitivity;
mod sweeps;

use common::Error;

pub use page::Reply;

/// The answer to a request, or the reason why there is none.
type Answered = Result<Reply, Error>;

/// Answers a request of a page: `render`, `about`, `export`, `trace` or `drawing` and a picture, with the
/// settings and a pixel as numbers, `measure` and a request to the measurement of error against run time,
/// `sweeps`, `sweep NAME` with a power of ten, `work`, `done` or `timed` and a picture, `pictures`, or the name of a figure
/// with its numbers. The text of a scene file is a picture, too, behind a line `file`; `numbers`,
/// `responses` and `changes` take no other picture. An error is a sentence for the reader.
pub fn call(request: &str, numbers: &[f64]) -> Result<Reply, String> {
    let answer = match request.split_once(' ') {
        Some(("render", name)) => picture::render(name, numbers),
        Some(("export", name)) => picture::export(name),
        Some(("trace", name)) => picture::trace(name, numbers),
        Some(("drawing", name)) => picture::drawing(name, numbers),
        Some(("numbers", name)) => sensitivity::numbers(name),
        Some(("responses", name)) => sensitivity::responses(name, numbers),
        Some(("changes", name)) => sensitivity::changes(name, numbers),
        Some(("about", name)) => picture::about(name),
        Some(("measure", request)) => measuring::answer(request, numbers),
        Some(("sweep", name)) => sweeps::sweep(name, numbers),
        Some(("sweep-questions", name)) => sweeps::questions(name),
        Some(("sweep-errors", name)) => sweeps::errors(name, numbers),
        Some(("work", name)) => omissions::work(name, numbers),
        Some(("done", name)) => omissions::done(name, numbers),
        None if request == "sweeps" => Ok(sweeps::all()),
        None if request == "pictures" => Ok(Reply::text(catalogue::names().join("\n"))),
        _ => figures::answer(request, numbers),
    };
    answer.map_err(|error| error.to_string())
}

/// Answers the request of a page, which lies in the module's memory.
#[cfg(target_family = "wasm")]
#[expect(unsafe_code, reason = "exporting a name is `unsafe`; no code here is")]
#[unsafe(no_mangle)]
extern "C" fn answer() -> bool {
    page::answer_request(call)
}

//! `Output`: what a program prints while it runs. Only its beginning is shown, and a program that
//! prints much waits for no terminal: the output is read as fast as it comes.

use std::io::{BufRead, BufReader, PipeReader, Read};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use judge::answers::WORDS_MARK;

/// The most bytes of a program that are kept.
const MAX_KEPT_BYTES: usize = 1 << 20;

/// The most bytes that are read as one line.
const MAX_LINE_BYTES: u64 = 1 << 16;

/// How long the end of the output is waited for after the end of the program, whose own child
/// processes may keep it open.
const END: Duration = Duration::from_secs(1);

/// What a program has printed so far.
#[derive(Default)]
pub struct Output {
    /// The beginning of the output, without the lines of the check.
    pub kept: Vec<u8>,
    /// The number of lines, without those of the check.
    pub lines: usize,
    /// What the check says.
    pub words: String,
}

impl Output {
    /// The first lines, at most `most`, and how many more there are.
    pub fn beginning(&self, most: usize) -> String {
        let text = String::from_utf8_lossy(&self.kept);
        let first: Vec<_> = text.lines().take(most).collect();
        match self.lines.saturating_sub(first.len()) {
            0 => first.join("\n"),
            more => format!("{}\n… {more} more lines", first.join("\n")),
        }
    }

    /// Whether the program has ended because its calls nest too deeply, in the words of Rust's
    /// runtime.
    pub fn overflows_stack(&self) -> bool {
        String::from_utf8_lossy(&self.kept).contains("has overflowed its stack")
    }

    /// Whether the program has ended because it got no more memory, in the words of Rust's runtime.
    pub fn exhausts_memory(&self) -> bool {
        let printed = String::from_utf8_lossy(&self.kept);
        printed.contains("memory allocation of ") && printed.contains(" bytes failed")
    }

    /// Adds a line of the program, after which the check may have begun one of its own.
    fn add(&mut self, line: &[u8]) {
        let Some(at) = line.iter().position(|byte| *byte == WORDS_MARK as u8) else {
            self.lines += 1;
            self.keep(line);
            return;
        };
        if at > 0 {
            self.lines += 1;
            self.keep(&line[..at]);
            self.keep(b"\n");
        }
        self.words += &String::from_utf8_lossy(&line[at + 1..]);
    }

    fn keep(&mut self, bytes: &[u8]) {
        let space = MAX_KEPT_BYTES - self.kept.len();
        self.kept.extend(&bytes[..bytes.len().min(space)]);
    }
}

/// Reads the output of a program in the background.
pub struct OutputReader {
    output: Arc<Mutex<Output>>,
    thread: JoinHandle<()>,
}

impl OutputReader {
    pub fn start(pipe: PipeReader) -> Self {
        let output = Arc::new(Mutex::new(Output::default()));
        let shared = output.clone();
        let thread = thread::spawn(move || {
            let mut pipe = BufReader::new(pipe);
            let mut line = Vec::new();
            // A line that cannot be read ends the output.
            while matches!(
                (&mut pipe)
                    .take(MAX_LINE_BYTES)
                    .read_until(b'\n', &mut line),
                Ok(1..)
            ) {
                lock(&shared).add(&line);
                line.clear();
            }
        });
        Self { output, thread }
    }

    /// Everything, after the program has ended.
    pub fn finish(self) -> Output {
        let end = Instant::now() + END;
        while !self.thread.is_finished() && Instant::now() < end {
            thread::sleep(Duration::from_millis(1));
        }
        std::mem::take(&mut *lock(&self.output))
    }
}

/// A reader that panics leaves what it has read.
fn lock(output: &Mutex<Output>) -> MutexGuard<'_, Output> {
    output.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use std::io::{self, Write};

    use super::*;

    fn read(text: &[u8]) -> Output {
        let (reader, mut writer) = io::pipe().unwrap();
        let reader = OutputReader::start(reader);
        writer.write_all(text).unwrap();
        drop(writer);
        reader.finish()
    }

    #[test]
    fn lines_of_the_check_are_told_from_those_of_the_program() {
        let text = format!("a\nb{WORDS_MARK}wrong\nlast");
        let output = read(text.as_bytes());
        assert_eq!(output.beginning(3), "a\nb\nlast");
        assert_eq!(output.words, "wrong\n");
        assert_eq!(read(b"").beginning(3), "");
    }

    #[test]
    fn much_output_is_cut_and_counted_and_hides_no_word_of_the_check() {
        let many = "x\n".repeat(MAX_KEPT_BYTES);
        let output = read(format!("{many}{WORDS_MARK}wrong\n").as_bytes());
        let beginning = "x\n".repeat(50);
        let more = MAX_KEPT_BYTES - 50;
        assert_eq!(
            output.beginning(50),
            format!("{beginning}… {more} more lines")
        );
        assert_eq!(output.kept.len(), MAX_KEPT_BYTES);
        assert_eq!(output.words, "wrong\n");
        // A line without end, and bytes that are no text.
        let output = read(&vec![0xFF; 3 * MAX_KEPT_BYTES]);
        assert_eq!(output.kept.len(), MAX_KEPT_BYTES);
    }
}

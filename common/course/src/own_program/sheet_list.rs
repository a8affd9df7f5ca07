//! `SheetList`: what `sheet.txt` says.

/// The sheets that a program is handed in for, and how it starts.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct SheetList {
    pub names: Vec<String>,
    /// The words of a line such as `program: python3 tracer.py`, for a program that Cargo does not build.
    pub command: Option<Vec<String>>,
}

impl SheetList {
    /// Names of sheets stand between spaces or commas or on lines of their own, in large or small letters.
    pub fn read(text: &str) -> Self {
        let mut list = Self::default();
        for line in text.trim_start_matches('\u{feff}').lines() {
            if let Some(command) = line.trim().strip_prefix("program:") {
                let words = command.split_whitespace().map(str::to_owned);
                list.command = Some(words.collect());
            } else {
                let words = line.replace(',', " ");
                let names = words.split_whitespace().map(str::to_lowercase);
                list.names.extend(names);
            }
        }
        list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_a_command_are_read() {
        let list = SheetList::read("\u{feff}Glass, lens\r\n  tree\nprogram: python3 my.py\r\n");
        assert_eq!(list.names, ["glass", "lens", "tree"]);
        assert_eq!(list.command.unwrap(), ["python3", "my.py"]);
        assert_eq!(SheetList::read("lamp").command, None);
    }
}

//! Commands can be pasted as they stand, into every shell.
//!
//! zsh and `cmd.exe` know no comments at the prompt, and a button that copies a block copies a `$` before
//! a command, too. The commands of the README mean the same in bash, zsh, PowerShell and `cmd.exe`.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use crate::files::{Files, blocks, complaint, ending, resolve};

/// The pages for those who begin, on any system.
const FIRST_PAGES: [&str; 2] = ["README.md", "common/course/handout/README.md"];

/// Programs with which a command begins.
const PROGRAMS: [&str; 5] = ["cargo ", "rustup ", "povray ", "sudo ", "git "];

/// Characters that mean something else in one of the shells, outside of words such as `2x`.
const SPECIAL: &str = "#$*?~^%!&|;<>()[]{}'\"`\\@";

/// The lines of code of a page, each with its first byte and the language of its block.
fn code(text: &str) -> Vec<(usize, &str, &str)> {
    let mut lines = Vec::new();
    for (start, block) in blocks(text) {
        let Some(code) = block.strip_prefix("```") else {
            continue;
        };
        let language = code.lines().next().unwrap_or_default();
        let mut at = start;
        for line in block.split_inclusive('\n') {
            if !line.starts_with("```") {
                lines.push((at, language, line.trim_end()));
            }
            at += line.len();
        }
    }
    lines
}

/// The commands of a page.
fn commands(text: &str) -> Vec<&str> {
    let mut commands = Vec::new();
    for (_, language, line) in code(text) {
        if language == "sh" {
            commands.push(line);
        }
    }
    commands
}

/// The lines that cannot be pasted, and the links of the README to pages that need the built book.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    for (path, text) in files.below("") {
        if ending(path) != "md" {
            continue;
        }
        for (at, language, line) in code(text) {
            let mut complain = |mistake| complaints.push(complaint(path, text, at, mistake));
            if line.starts_with("$ ") {
                complain("a button copies the `$`, too");
            }
            let is_command = PROGRAMS.iter().any(|program| line.starts_with(program));
            if is_command && line.contains(" #") {
                complain("zsh and cmd.exe know no comments at the prompt");
            }
            let next = text[at + line.len()..].trim_start_matches(['\r', '\n']);
            if line == "cargo learn" && !next.starts_with("```") {
                complain("it would read the commands behind it as keys");
            }
            let is_first = FIRST_PAGES.contains(&path) && language == "sh";
            // The handout's page gets the name of its last stage.
            let line = line.replace("{stage}", "");
            if is_first && line.contains(|c| SPECIAL.contains(c)) {
                complain("a character means something else in another shell");
            }
        }
    }
    let readme = files.text("README.md").unwrap_or_default();
    for (at, link) in readme.match_indices("](") {
        let target = &readme[at + link.len()..];
        let target = target.split([')', '#']).next().unwrap_or_default();
        let page = resolve("README.md", target).unwrap_or_default();
        if files
            .text(&page)
            .is_some_and(|page| page.contains("{{#include"))
        {
            let mistake = format!("without mdBook, {page} shows no listings");
            complaints.push(complaint("README.md", readme, at, &mistake));
        }
    }
    complaints
}

/// A folder with programs that print their arguments instead of running.
fn programs_that_print() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("programs-that-print");
    fs::create_dir_all(&folder).expect("a folder");
    for program in PROGRAMS {
        let name = program.trim_end();
        let file = folder.join(name);
        let script =
            "#!/bin/sh\nfor word in \"${0##*/}\" \"$@\"; do printf '[%s]' \"$word\"; done; echo\n";
        fs::write(&file, script).expect("a script");
        let made = Command::new("chmod").arg("+x").arg(&file).status();
        assert!(made.expect("chmod").success());
    }
    folder
}

/// The lines that programs print which an interactive shell starts for pasted commands.
fn pasted(shell: &[&str], commands: &[&str]) -> Option<Vec<String>> {
    let mut folders = vec![programs_that_print()];
    let path = env::var_os("PATH").unwrap_or_default();
    folders.extend(env::split_paths(&path));
    let path = env::join_paths(folders).expect("folders");
    let input = env!("CARGO_TARGET_TMPDIR").to_owned() + "/pasted";
    fs::write(&input, commands.join("\n") + "\n").expect("a file");
    let output = Command::new(shell[0])
        .args(&shell[1..])
        .env("PATH", path)
        .stdin(fs::File::open(&input).expect("the file"))
        .stderr(Stdio::null())
        .output()
        .ok()?;
    let output = String::from_utf8_lossy(&output.stdout);
    let lines = output.lines().filter(|line| line.starts_with('['));
    Some(lines.map(str::to_owned).collect())
}

#[cfg(unix)]
#[test]
fn shells_read_the_words_of_each_command() {
    let files = Files::read().expect("the repository");
    for page in FIRST_PAGES {
        let text = files.text(page).expect(page).replace("{stage}", "a07");
        let commands = commands(&text);
        assert!(!commands.is_empty(), "{page} has no commands");
        let mut expected = Vec::new();
        for command in &commands {
            let words = command.split(' ').map(|word| format!("[{word}]"));
            expected.push(words.collect::<String>());
        }
        for shell in [
            &["bash", "--norc", "--noprofile", "-i", "-s"][..],
            &["zsh", "-f", "-i", "-s"],
        ] {
            match pasted(shell, &commands) {
                Some(read) => assert_eq!(read, expected, "{} reads {page}", shell[0]),
                None => eprintln!("skipped: there is no {}", shell[0]),
            }
        }
    }
}

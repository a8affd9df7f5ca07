//! The grammar of the command line, the same for every stage.

use std::path::PathBuf;

use clap::{Args, CommandFactory, Parser, Subcommand};
use common::{Scene, Stage, UsedSettings};

use crate::options::Options;

/// The whole command line; without a command the first scene is shown.
#[derive(Parser)]
#[command(version, args_conflicts_with_subcommands = true)]
pub struct CommandLine {
    #[command(subcommand)]
    pub command: Option<Command>,

    #[command(flatten)]
    pub showing: Showing,
}

/// How a scene is shown.
#[derive(Args)]
pub struct Showing {
    /// Open no window; write the PNG as if there were no display
    #[arg(long)]
    pub no_window: bool,

    /// Show a scene file anew when it is saved
    #[arg(long)]
    pub watch: bool,

    #[command(flatten)]
    pub options: Options,
}

/// The commands.
#[derive(Subcommand)]
pub enum Command {
    /// List the scenes, one a line
    List,
    /// Show a scene in a window; without a display, write its PNG
    Show {
        /// The scene, as `list` names it, or a scene file that ends in .toml
        scene: String,
        #[command(flatten)]
        showing: Showing,
    },
    /// Write scenes as PNG
    Render {
        /// The scenes, as `list` names them, or scene files that end in .toml
        #[arg(required_unless_present = "all", conflicts_with = "all")]
        scenes: Vec<String>,

        /// Render all scenes of the stage
        #[arg(long)]
        all: bool,

        /// A PNG file for one scene, or a folder, made if it is missing [default: out/]
        #[arg(short, long, value_name = "FILE|DIR")]
        output: Option<PathBuf>,

        /// Render a scene file anew when it is saved
        #[arg(long, conflicts_with = "all")]
        watch: bool,

        /// List the work that the renderer leaves out, and the time that this saves
        #[arg(long = "explain", conflicts_with_all = ["no_omit", "watch"])]
        work: bool,

        #[command(flatten)]
        options: Options,
    },
    #[command(flatten)]
    Laboratory(crate::laboratory::Command),
}

impl CommandLine {
    /// The grammar for a stage: its help shows examples, and hides flags that change
    /// nothing in the stage.
    pub fn of(stage: &Stage) -> clap::Command {
        let uses = |used: fn(&UsedSettings) -> bool| stage.scenes.iter().any(|s| used(&s.uses));
        let is_sampled = uses(|used| used.sampling);
        let mut hidden = Vec::new();
        if !is_sampled {
            hidden.extend(["samples", "sampling", "max_error", "seed", "work"]);
            hidden.extend(["threads", "fast", "no_omit"]);
        }
        if !uses(|used| used.depth) {
            hidden.push("depth");
        }
        if !uses(|used| used.file) {
            hidden.push("open");
        }
        let hide = |command: clap::Command| {
            let is_unused = !is_sampled && command.get_name() == "explain";
            command.hide(is_unused).mut_args(|argument| {
                let is_hidden = hidden.contains(&argument.get_id().as_str());
                argument.hide(is_hidden)
            })
        };
        hide(Self::command())
            .name(stage.name)
            .about(stage.about)
            .after_help(examples(stage.name, &stage.scenes, is_sampled))
            .mut_subcommands(hide)
    }
}

/// Command lines of a program, which has the name of its stage.
fn examples(program: &str, scenes: &[Scene], is_sampled: bool) -> String {
    let name = |scene: Option<&Scene>| scene.map_or("SCENE", |scene| scene.name);
    let (first, last) = (name(scenes.first()), name(scenes.last()));
    let samples = if is_sampled { " --samples 16" } else { "" };
    format!(
        "Examples:\n  \
         {program} show {last}{samples}\n  \
         {program} render {first} --size 1280x960 -o picture.png\n  \
         {program} render --all -o pictures"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_of_the_workbook_has_each_command_and_option() {
        let page = std::fs::read_to_string("../../book/src/workbook.md").unwrap();
        for command in CommandLine::command().get_subcommands() {
            let words = format!("-- {} ", command.get_name());
            assert!(page.contains(&words), "workbook.md lacks {words}");
            // The options of `explain` are in its help alone.
            let options = command.get_arguments();
            for option in options.filter(|_| command.get_name() != "explain") {
                let words = match (option.get_short(), option.get_long()) {
                    (Some(letter), _) => format!("-{letter} "),
                    (None, Some(word)) => format!("--{word}"),
                    (None, None) => continue,
                };
                assert!(page.contains(&words), "workbook.md lacks {words}");
            }
        }
    }
}

//! The command line: one file per subcommand, argument parsing and exit status only.
//!
//! Data goes to standard output or `--output`, messages to standard error. Exit status: 0 done; 1 a
//! claim's verdict differs from the recorded one, fuzzing found a counterexample, or a tolerance
//! was not reached; 2 wrong usage or bad input, and nothing is written.

mod check;
mod convert;
mod curve;
mod cut;
mod discontinuities;
mod form_factor;
#[cfg(feature = "proptest")]
mod fuzz;
mod grid;
mod light;
mod measure;
mod mends;
mod output;
mod point;
mod progress;
mod radiosity;
mod ranks;
mod refine;
mod report;
mod report_folder;
mod reproduce;
mod sample;
mod scene;
mod split;
mod store;
mod study;

use clap::{CommandFactory, Parser, Subcommand, value_parser};
use infoscene::exchange::{Ranks, failure};
use std::error::Error;
use std::process::ExitCode;

/// The results of "Information Theory Tools for Scene Discretization" (Feixas, del Acebo, Bekaert,
/// Sbert, 1999), computed.
#[derive(Debug, Parser)]
#[command(name = "infoscene", version, about, max_term_width = 100)]
struct Arguments {
    /// Threads to use, all if not given; the answer does not depend on it.
    #[arg(long, global = true, value_name = "N", value_parser = value_parser!(u16).range(1..))]
    threads: Option<u16>,
    #[command(subcommand)]
    question: Question,
}

#[derive(Debug, Subcommand)]
enum Question {
    /// Compute the paper's claims and judge them.
    Reproduce(reproduce::Reproduce),
    /// Write everything as tables, figures and one page into a folder.
    Report(report::Report),
    /// Print the curve of a figure as points, or draw it.
    Curve(curve::Curve),
    /// Find the cut of a patch that gains the most mutual information.
    Split(split::Split),
    /// Find the lines of discontinuity of a patch behind blockers, and what cuts along them gain
    /// (fig. 1, App. B).
    Discontinuities(discontinuities::Discontinuities),
    /// Find the cuts of patches whose radiosity grows as a power (§4.2).
    Cut(cut::Cut),
    /// Divide the faces of a box by a grid: its mutual information, and the best lines (figs. 4 and
    /// 5).
    Grid(grid::Grid),
    /// Compute the form factors of a scene.
    FormFactor(form_factor::FormFactor),
    /// Compute the form factors from points to the patches of a scene, past all that is in the way,
    /// and what of the sky they see.
    Point(point::Point),
    /// Measure the information of a scene: entropies and mutual information.
    Measure(measure::Measure),
    /// Estimate the information of a scene from random lines.
    Sample(sample::Sample),
    /// Solve for the radiosities of a scene, and the importances.
    Radiosity(radiosity::Radiosity),
    /// Solve for the radiosities of a scene on a mesh that an oracle refines.
    Refine(refine::Refine),
    /// Tell the state of a scene: fronts, free edges, overlap, what stands in the way.
    Check(check::Check),
    /// Look after a matrix of form factors in a folder.
    Store(store::Store),
    /// Write a scene in another format.
    Convert(convert::Convert),
    /// Throw random refinements at Theorem 1.
    #[cfg(feature = "proptest")]
    Fuzz(fuzz::Fuzz),
    /// Measure error and time of different forms of a formula, or how far the cuts of §4.2 carry.
    Study(study::Study),
    /// Print a completion script for a shell.
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// Print the manual page.
    Man,
}

/// The exit status of an answered question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    /// All is as expected.
    Done,
    /// A verdict differs from the one on record, a counterexample was found, or a tolerance was not
    /// reached.
    Differs,
}

type Answer = Result<Outcome, Box<dyn Error>>;

/// Runs the command with the process's arguments; of several ranks the first speaks for all.
pub(crate) fn run() -> ExitCode {
    let ranks = ranks::join();
    let is_first = ranks.number() == 0;
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if is_first => {
            // nothing can be said where nothing can be printed
            drop(error.print());
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
        Err(_) => return ExitCode::SUCCESS,
    };
    let threads = with_threads(arguments.threads);
    let answered = threads.and_then(|()| answer(arguments.question, &*ranks));
    let reason = answered.as_ref().err().map(ToString::to_string);
    let failed = failure(&*ranks, reason.as_deref());
    if !is_first {
        return ExitCode::SUCCESS;
    }
    match (answered, failed) {
        (Err(error), _) => {
            eprintln!("infoscene: {error}{}", mends::mend(&*error));
            ExitCode::from(2)
        }
        (Ok(_), Some(failed)) => {
            eprintln!("infoscene: {failed}");
            ExitCode::from(2)
        }
        (Ok(Outcome::Done), None) => ExitCode::SUCCESS,
        (Ok(Outcome::Differs), None) => ExitCode::from(1),
    }
}

fn with_threads(threads: Option<u16>) -> Result<(), Box<dyn Error>> {
    if let Some(threads) = threads {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads.into())
            .build_global()?;
    }
    Ok(())
}

/// Answers a question; one that is not shared out, on the first rank.
fn answer(question: Question, ranks: &dyn Ranks) -> Answer {
    let is_shared = match &question {
        Question::FormFactor(_) | Question::Measure(_) | Question::Radiosity(_) => true,
        Question::Study(study) => study.is_shared(),
        _ => false,
    };
    if !is_shared && ranks.number() > 0 {
        return Ok(Outcome::Done);
    }
    match question {
        Question::FormFactor(question) => question.answer(ranks),
        Question::Measure(question) => question.answer(ranks),
        Question::Radiosity(question) => question.answer(ranks),
        Question::Reproduce(question) => question.answer(),
        Question::Report(question) => question.answer(),
        Question::Curve(question) => question.answer(),
        Question::Split(question) => question.answer(),
        Question::Discontinuities(question) => question.answer(),
        Question::Cut(question) => question.answer(),
        Question::Grid(question) => question.answer(),
        Question::Point(question) => question.answer(),
        Question::Sample(question) => question.answer(),
        Question::Refine(question) => question.answer(),
        Question::Check(question) => question.answer(),
        Question::Store(question) => question.answer(),
        Question::Convert(question) => question.answer(),
        #[cfg(feature = "proptest")]
        Question::Fuzz(question) => question.answer(),
        Question::Study(question) => question.answer(ranks),
        Question::Completions { shell } => completions(shell),
        Question::Man => manual(),
    }
}

fn completions(shell: clap_complete::Shell) -> Answer {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "infoscene", &mut text);
    output::print(&text)
}

fn manual() -> Answer {
    let mut text = Vec::new();
    clap_mangen::Man::new(Arguments::command()).render(&mut text)?;
    output::print(&text)
}

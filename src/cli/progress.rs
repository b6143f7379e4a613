//! The progress bar of a question, and lines of progress.

use indicatif::{ProgressBar, ProgressStyle};
use infoscene::exchange::Progress;
use std::io::{IsTerminal, stderr};
use std::sync::{Mutex, PoisonError};

/// A progress bar, drawn on a terminal only, that goes when all units of work are finished.
#[derive(Debug, Default)]
pub(super) struct Bar(Mutex<Option<Drawn>>);

/// A bar that is drawn.
#[derive(Debug)]
struct Drawn {
    bar: ProgressBar,
    units: u64,
}

impl Progress for Bar {
    fn begin(&self, units: u64, name: &str) {
        let template = format!("{{wide_bar}} {{pos}}/{{len}} {name}, {{eta}} left");
        // a bar that cannot be drawn is no reason to leave a question without its answer
        let style = ProgressStyle::with_template(&template).ok();
        let bar = style.map(|style| ProgressBar::new(units).with_style(style));
        let drawn = bar.filter(|bar| !bar.is_hidden());
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) =
            drawn.map(|bar| Drawn { bar, units });
    }

    fn advance(&self, finished: usize) {
        let mut slot = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(Drawn { bar, units }) = &*slot else {
            return;
        };
        bar.inc(finished as u64);
        if bar.position() >= *units {
            bar.finish_and_clear();
            *slot = None;
        }
    }

    fn tell(&self, state: &str) {
        if stderr().is_terminal() {
            eprintln!("infoscene: {state}");
        }
    }
}

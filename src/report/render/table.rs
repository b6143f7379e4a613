//! A table of texts, with notes below it.

use super::latex;
use comfy_table::{ColumnConstraint, ContentArrangement, LineStyle, TableStyle};

/// Rows of texts under headings, and notes.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Table {
    /// Headings of the columns.
    pub columns: Vec<&'static str>,
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<String>>,
    /// The column of long texts, which gives way on a terminal.
    pub wrapped: Option<usize>,
    /// Lines below the table: a name and a text.
    pub notes: Vec<(String, String)>,
}

/// Width of a terminal table, in characters.
const TERMINAL_WIDTH: u16 = 140;

/// Rows beyond which a LaTeX table breaks over pages.
const ROWS_PER_PAGE: usize = 40;

/// Rules above, below, and under the headings; none between rows.
const STYLE: TableStyle = TableStyle::new()
    .top_border(LineStyle::none().fill('─').junction('─'))
    .header_separator(LineStyle::none().fill('─').junction('─'))
    .bottom_border(LineStyle::none().fill('─').junction('─'));

impl Table {
    /// The table with box-drawing lines, for a terminal.
    #[must_use]
    pub fn to_terminal(&self) -> String {
        let mut table = comfy_table::Table::new();
        table
            .load_style(STYLE)
            .set_content_arrangement(ContentArrangement::Dynamic)
            .set_width(TERMINAL_WIDTH)
            .set_header(&self.columns)
            .add_rows(&self.rows);
        for (index, column) in table.column_iter_mut().enumerate() {
            if self.wrapped != Some(index) {
                column.set_constraint(ColumnConstraint::ContentWidth);
            }
        }
        let mut text = format!("{table}\n");
        for (name, note) in &self.notes {
            text += &format!("{name}: {note}\n");
        }
        trimmed(&text)
    }

    /// The table in Markdown.
    #[must_use]
    pub fn to_markdown(&self) -> String {
        let line = |cells: &mut dyn Iterator<Item = &str>| {
            let cells: Vec<String> = cells.map(|cell| cell.replace('|', "\\|")).collect();
            format!("| {} |\n", cells.join(" | "))
        };
        let mut text = line(&mut self.columns.iter().copied());
        text += &line(&mut self.columns.iter().map(|_| "---"));
        for row in &self.rows {
            text += &line(&mut row.iter().map(String::as_str));
        }
        if !self.notes.is_empty() {
            text += "\n";
        }
        for (name, note) in &self.notes {
            text += &format!("* {name}: {note}\n");
        }
        trimmed(&text)
    }

    /// The table in LaTeX with `booktabs` rules and in plain ASCII: a `tabular`, or a `longtable`
    /// where it would not fit on a page.
    #[must_use]
    pub fn to_latex(&self) -> String {
        let line = |cells: &mut dyn Iterator<Item = &str>| {
            let cells: Vec<String> = cells.map(latex::escaped).collect();
            format!("{} \\\\\n", cells.join(" & "))
        };
        let is_long = self.rows.len() > ROWS_PER_PAGE;
        let environment = if is_long { "longtable" } else { "tabular" };
        let kind = |index| {
            if self.wrapped == Some(index) {
                r"p{0.4\linewidth}"
            } else {
                "l"
            }
        };
        let kinds: String = (0..self.columns.len()).map(kind).collect();
        let mut text = "% \\usepackage{booktabs}".to_owned();
        text += if is_long {
            ", \\usepackage{longtable}\n"
        } else {
            "\n"
        };
        text += &format!("\\begin{{{environment}}}{{{kinds}}}\n\\toprule\n");
        text += &line(&mut self.columns.iter().copied());
        text += "\\midrule\n";
        if is_long {
            text += "\\endhead\n";
        }
        for row in &self.rows {
            text += &line(&mut row.iter().map(String::as_str));
        }
        text += &format!("\\bottomrule\n\\end{{{environment}}}\n");
        for (name, note) in &self.notes {
            text += &format!("% {}: {}\n", latex::escaped(name), latex::escaped(note));
        }
        text
    }
}

fn trimmed(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    lines.join("\n") + "\n"
}

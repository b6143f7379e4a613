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
    /// Whether each column has numbers only, which belong to the right.
    pub(crate) fn numeric_columns(&self) -> Vec<bool> {
        let is_number = |cell: &str| cell.is_empty() || cell.parse::<f64>().is_ok();
        let is_numeric = |index: usize| {
            let mut cells = self.rows.iter().filter_map(|row| row.get(index));
            cells.all(|cell| is_number(cell))
        };
        (0..self.columns.len()).map(is_numeric).collect()
    }

    /// The place of each column's texts in LaTeX.
    fn places(&self) -> Vec<Place> {
        let is_numeric = self.numeric_columns();
        let has_decimals = |index: usize| {
            let mut cells = self.rows.iter().filter_map(|row| row.get(index));
            let is_plain = |cell: &String| cell.is_empty() || !cell.contains(['e', 'E']);
            cells.clone().all(is_plain) && cells.any(|cell| cell.contains('.'))
        };
        let place = |(index, is_numeric): (usize, bool)| {
            if self.wrapped == Some(index) {
                Place::Wrapped
            } else if !is_numeric {
                Place::Left
            } else if has_decimals(index) {
                Place::Decimal
            } else {
                Place::Right
            }
        };
        is_numeric.into_iter().enumerate().map(place).collect()
    }

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
        let places = self.places();
        let is_long = self.rows.len() > ROWS_PER_PAGE;
        let environment = if is_long { "longtable" } else { "tabular" };
        let kinds: String = places.iter().map(|place| place.kind()).collect();
        let line = |cells: Vec<String>| format!("{} \\\\\n", cells.join(" & "));
        let mut text = "% \\usepackage{booktabs}".to_owned();
        text += if is_long {
            ", \\usepackage{longtable}\n"
        } else {
            "\n"
        };
        text += &format!("\\begin{{{environment}}}{{{kinds}}}\n\\toprule\n");
        let heads = self.columns.iter().zip(&places);
        text += &line(heads.map(|(name, place)| place.heading(name)).collect());
        text += "\\midrule\n";
        if is_long {
            text += "\\endhead\n";
        }
        for row in &self.rows {
            let cells = row.iter().zip(&places);
            text += &line(cells.map(|(cell, place)| place.cell(cell)).collect());
        }
        text += &format!("\\bottomrule\n\\end{{{environment}}}\n");
        for (name, note) in &self.notes {
            text += &format!("% {}: {}\n", latex::escaped(name), latex::escaped(note));
        }
        text
    }
}

/// The place of a column's texts in LaTeX.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    Left,
    Wrapped,
    Right,
    /// Numbers with their decimal points below each other, in two columns.
    Decimal,
}

impl Place {
    const fn kind(self) -> &'static str {
        match self {
            Self::Left => "l",
            Self::Wrapped => r"p{0.4\linewidth}",
            Self::Right => "r",
            Self::Decimal => "r@{.}l",
        }
    }

    fn heading(self, name: &str) -> String {
        match self {
            Self::Decimal => format!("\\multicolumn{{2}}{{l}}{{{}}}", latex::escaped(name)),
            _ => latex::escaped(name),
        }
    }

    fn cell(self, text: &str) -> String {
        let signed = |text: &str| match text.strip_prefix('-') {
            Some(rest) => format!("$-${rest}"),
            None => text.to_owned(),
        };
        match (self, text.split_once('.')) {
            (Self::Left | Self::Wrapped, _) => latex::escaped(text),
            (Self::Decimal, Some((whole, part))) => format!("{} & {part}", signed(whole)),
            // without its decimals a number would be given the column's point
            (Self::Decimal, None) => format!("\\multicolumn{{2}}{{l}}{{{}}}", signed(text)),
            (Self::Right, _) => signed(text),
        }
    }
}

fn trimmed(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    lines.join("\n") + "\n"
}

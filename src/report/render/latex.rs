//! Text for LaTeX in plain ASCII.

/// `text` with LaTeX's special characters escaped and the symbols used here as commands.
pub(crate) fn escaped(text: &str) -> String {
    text.chars()
        .map(|c| escape(c).map_or_else(|| c.to_string(), str::to_owned))
        .collect()
}

const fn escape(c: char) -> Option<&'static str> {
    Some(match c {
        '&' => r"\&",
        '%' => r"\%",
        '$' => r"\$",
        '#' => r"\#",
        '_' => r"\_",
        '{' => r"\{",
        '}' => r"\}",
        '~' => r"\textasciitilde{}",
        '^' => r"\textasciicircum{}",
        '\\' => r"\textbackslash{}",
        '<' => "$<$",
        '>' => "$>$",
        '"' => "''",
        '§' => r"\S",
        '×' => r"$\times$",
        '±' => r"$\pm$",
        '−' => "$-$",
        '≤' => r"$\le$",
        '≥' => r"$\ge$",
        '∝' => r"$\propto$",
        '…' => r"\dots{}",
        'Σ' => r"$\Sigma$",
        'Δ' => r"$\Delta$",
        'δ' => r"$\delta$",
        'ε' => r"$\varepsilon$",
        '²' => "$^2$",
        '³' => "$^3$",
        '⁴' => "$^4$",
        'ⁿ' => "$^n$",
        'ᵐ' => "$^m$",
        'ˣ' => "$^x$",
        '°' => r"$^\circ$",
        'ρ' => r"$\rho$",
        'σ' => r"$\sigma$",
        '∞' => r"$\infty$",
        '½' => r"$\frac12$",
        '—' => "---",
        _ => return None,
    })
}

//! Text that an author pastes: a document that inputs all, a reference, a paragraph of methods.

use super::{Parts, file_name};
use crate::claims::Verdict;
use crate::question::ReportAnswer;
use crate::report::render::latex::escaped;

/// References to the program and to the paper.
pub(super) const BIBLIOGRAPHY: &str = "\
@software{infoscene,
  author  = {{The infoscene developers}},
  title   = {infoscene: information-theoretic scene discretization, checked},
  version = {0.1.0}
}

@inproceedings{feixas1999,
  author    = {Feixas, Miquel and del Acebo, Esteve and Bekaert, Philippe and Sbert, Mateu},
  title     = {Information Theory Tools for Scene Discretization},
  booktitle = {Rendering Techniques '99 (Proceedings of the Eurographics Workshop on Rendering)},
  year      = {1999}
}
";

/// A document that inputs every table and every figure.
pub(super) fn document(parts: &Parts<'_>) -> String {
    let mut text = "\
\\documentclass[8pt]{extarticle}
\\usepackage[T1]{fontenc}
\\usepackage[a3paper,landscape,margin=12mm]{geometry}
\\usepackage{booktabs,longtable,graphicx}
\\begin{document}
\\input{methods}
"
    .to_owned();
    for table in &parts.tables {
        let folder = if table.is_timed { "timed" } else { "tables" };
        let title = escaped(table.title);
        text += &format!(
            "\\section*{{{title}}}\n\\input{{{folder}/{}}}\n",
            table.name
        );
    }
    for figure in &parts.figures {
        let folder = if figure.is_timed { "timed" } else { "figures" };
        text += "\\begin{figure}[p]\\centering\n";
        text += &format!(
            "\\includegraphics[width=0.6\\linewidth,height=0.7\\textheight,keepaspectratio]\
             {{{folder}/{}.pdf}}\n",
            figure.name
        );
        if let Some(scene) = figure.scene {
            let name = file_name(scene);
            text += &format!("\\includegraphics[width=0.2\\linewidth]{{figures/{name}.pdf}}\n");
        }
        text += &format!(
            "\\caption{{{}}}\n\\end{{figure}}\n",
            escaped(&figure.caption)
        );
    }
    text + "\\nocite{*}\n\\bibliographystyle{plain}\n\\bibliography{infoscene}\n\\end{document}\n"
}

/// A paragraph that an author may adapt.
pub(super) fn methods(answer: &ReportAnswer) -> String {
    let claims = &answer.claims;
    let count = |verdict| {
        claims
            .iter()
            .filter(|claim| claim.verdict() == verdict)
            .count()
    };
    let proved = claims
        .iter()
        .filter(|claim| !claim.claim.proof.is_empty())
        .count();
    format!(
        "% A paragraph of methods, to be adapted. References: infoscene.bib.\n\
         \\paragraph{{Methods.}} The statements of~\\cite{{feixas1999}} were recomputed with \
         infoscene~{}~\\cite{{infoscene}}. Form factors are closed forms or adaptive integrals \
         with error bounds; numbers printed in the paper are compared with intervals found by \
         outward rounding at {} bits, and best cuts are certified as the only maxima of their \
         curves. Of {} claims {} are confirmed, {} supported by estimates, {} refuted and {} left \
         open; {} rest on theorems checked by Coq. Every digit shown is certain to one unit of the \
         last place. Mutual information is in bits, positions are relative to the patch.\n",
        env!("CARGO_PKG_VERSION"),
        crate::claims::DEFAULT_PRECISION,
        claims.len(),
        count(Verdict::Confirmed),
        count(Verdict::Supported),
        count(Verdict::Refuted),
        count(Verdict::Undecided) + count(Verdict::NotChecked),
        proved,
    )
}

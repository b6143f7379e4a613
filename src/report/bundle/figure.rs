//! A figure of a report, drawn in both formats.

use crate::question::StudyAnswer;
use crate::report::answers::studies::study_figure;
use crate::report::render::heat::Heat;
use crate::report::render::page::PageError;
use crate::report::render::sheet::Drawing;
use crate::report::{Figure, Net, ReportError};

/// A figure as files, with its caption.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BundleFigure {
    /// The name of its files, without the ending.
    pub name: &'static str,
    /// The caption: a sentence that stands alone.
    pub caption: String,
    /// The scene whose view stands beside it.
    pub scene: Option<&'static str>,
    /// The file in SVG.
    pub svg: String,
    /// The file in PDF.
    pub pdf: Vec<u8>,
    /// Do run times enter?
    pub is_timed: bool,
}

impl BundleFigure {
    pub(super) fn lines(
        name: &'static str,
        caption: &str,
        scene: Option<&'static str>,
        figure: &Figure,
    ) -> Result<Self, ReportError> {
        Ok(Self {
            name,
            caption: caption.to_owned(),
            scene,
            svg: figure.to_svg()?,
            pdf: figure.to_pdf()?,
            is_timed: false,
        })
    }

    pub(super) fn heat(name: &'static str, caption: &str, heat: Heat) -> Result<Self, ReportError> {
        let heat = heat.checked()?;
        Ok(Self {
            name,
            caption: caption.to_owned(),
            scene: None,
            svg: heat.svg()?,
            pdf: heat.pdf()?,
            is_timed: false,
        })
    }

    pub(super) fn net(name: &'static str, caption: &str, net: &Net) -> Result<Self, ReportError> {
        Ok(Self {
            name,
            caption: caption.to_owned(),
            scene: None,
            svg: net.to_svg()?,
            pdf: net.to_pdf()?,
            is_timed: false,
        })
    }

    pub(super) fn timed(self) -> Self {
        Self {
            is_timed: true,
            ..self
        }
    }
}

/// The figure that a study has of its own.
pub(super) fn own_figure(study: &StudyAnswer) -> Result<Figure, PageError> {
    study_figure(study).ok_or_else(|| PageError::without("figure", "a study"))
}

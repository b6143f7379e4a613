//! PDF files of one page, drawn by the same drawing library as SVG.
//!
//! Letters are Helvetica and Symbol, two of the fonts that every reader has, so no font is carried
//! along and a figure takes some kilobytes. A converter of SVG would bring a text shaper and look
//! for fonts on the machine, and the same figure would look otherwise elsewhere.
//!
//! **Not covered**: pixels, transparency; colours are drawn as mixed with white.

mod letters;

use self::letters::{Letter, SMALL, letter, width};
use super::units::FINER;
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, Str};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontTransform,
};
use std::convert::Infallible;

/// Points of PDF in a unit of the page: 96 units, or 72 points, are an inch.
const POINTS: f32 = 0.75;
/// The drawing library's size of letters over their height.
const LETTER_BOX: f64 = 1.24;
/// The heights by which letters are let down at their top, their middle and their foot, in em.
const TOP: f64 = 0.76;
const MIDDLE: f64 = 0.26;

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

/// A page that is being drawn.
pub(crate) struct PdfPage<'a> {
    content: &'a mut Content,
    missing: &'a mut Option<char>,
    size: (u32, u32),
}

/// The content of an empty page, in the units of its drawing with the ordinate downwards.
#[expect(clippy::cast_precision_loss, reason = "the page's units are few")]
pub(crate) fn content((_, height): (u32, u32)) -> Content {
    let mut content = Content::new();
    let scale = POINTS / FINER as f32;
    content.transform([scale, 0.0, 0.0, -scale, 0.0, POINTS * height as f32]);
    content
}

/// The file of a page with this content.
#[expect(clippy::cast_precision_loss, reason = "the page's units are few")]
pub(crate) fn file(content: Content, (width, height): (u32, u32)) -> Vec<u8> {
    let [catalog, pages, page, drawing, helvetica, symbol] = [1, 2, 3, 4, 5, 6].map(Ref::new);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([page]).count(1);
    let mut sheet = pdf.page(page);
    let [width, height] = [width, height].map(|length| POINTS * length as f32);
    sheet.media_box(Rect::new(0.0, 0.0, width, height));
    sheet.parent(pages);
    sheet.contents(drawing);
    let mut resources = sheet.resources();
    let mut fonts = resources.fonts();
    fonts.pair(Name(b"F"), helvetica).pair(Name(b"S"), symbol);
    fonts.finish();
    resources.finish();
    sheet.finish();
    let mut font = pdf.type1_font(helvetica);
    font.base_font(Name(b"Helvetica"));
    font.encoding_predefined(Name(b"WinAnsiEncoding"));
    font.finish();
    pdf.type1_font(symbol).base_font(Name(b"Symbol"));
    pdf.stream(drawing, &content.finish());
    pdf.finish()
}

impl<'a> PdfPage<'a> {
    /// A page to draw onto; a letter that its fonts lack is told in `missing`.
    pub(crate) const fn new(
        content: &'a mut Content,
        missing: &'a mut Option<char>,
        (width, height): (u32, u32),
    ) -> Self {
        let size = (width * FINER, height * FINER);
        Self {
            content,
            missing,
            size,
        }
    }

    fn path(&mut self, points: impl IntoIterator<Item = BackendCoord>) -> usize {
        let mut count = 0;
        for point in points {
            let [x, y] = place(point);
            if count == 0 {
                self.content.move_to(x, y);
            } else {
                self.content.line_to(x, y);
            }
            count += 1;
        }
        count
    }

    fn stroke_of<S: BackendStyle>(&mut self, style: &S) {
        let [r, g, b] = colour(style.color());
        self.content.set_stroke_rgb(r, g, b);
        #[expect(clippy::cast_precision_loss, reason = "the page's units are few")]
        self.content.set_line_width(style.stroke_width() as f32);
    }

    fn fill_of(&mut self, fill: BackendColor) {
        let [r, g, b] = colour(fill);
        self.content.set_fill_rgb(r, g, b);
    }

    /// The letters of a text; one that is not to be had is told, and left out.
    fn letters(&mut self, text: &str) -> Vec<Letter> {
        let found = text.chars().filter_map(|sign| {
            let found = letter(sign);
            if found.is_none() {
                *self.missing = self.missing.or(Some(sign));
            }
            found
        });
        found.collect()
    }
}

#[expect(clippy::cast_precision_loss, reason = "the page's units are few")]
fn place((x, y): BackendCoord) -> [f32; 2] {
    [x as f32, y as f32]
}

/// A colour on white.
fn colour(colour: BackendColor) -> [f32; 3] {
    let (r, g, b) = colour.rgb;
    [r, g, b].map(|part| {
        let mixed = 1.0 - colour.alpha * (1.0 - f64::from(part) / 255.0);
        #[expect(clippy::cast_possible_truncation, reason = "colours have few digits")]
        let mixed = mixed as f32;
        mixed
    })
}

impl DrawingBackend for PdfPage<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        self.draw_rect(point, (point.0 + 1, point.1 + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        if fill {
            return self.fill_polygon(corners, style);
        }
        self.draw_path(corners.into_iter().chain([(left, top)]), style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        if style.color().alpha > 0.0 {
            self.stroke_of(style);
            if self.path(path) > 0 {
                self.content.stroke();
            }
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Drawn {
        if style.color().alpha > 0.0 {
            self.fill_of(style.color());
            if self.path(corners) > 0 {
                self.content.close_path();
                self.content.fill_nonzero();
            }
        }
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        position: BackendCoord,
    ) -> Drawn {
        let letters = self.letters(text);
        let size = style.size() / LETTER_BOX;
        let (across, down) = (style.anchor().h_pos, style.anchor().v_pos);
        let length: f64 = letters.iter().map(width).sum();
        let back = match across {
            HPos::Left => 0.0,
            HPos::Center => 0.5 * length,
            HPos::Right => length,
        };
        let lower = match down {
            VPos::Top => TOP,
            VPos::Center => MIDDLE,
            VPos::Bottom => -MIDDLE,
        };
        // along the line and up from it, the page's ordinate downwards
        let (along, up) = match style.transform() {
            FontTransform::None => ([1.0, 0.0], [0.0, -1.0]),
            FontTransform::Rotate90 => ([0.0, 1.0], [1.0, 0.0]),
            FontTransform::Rotate180 => ([-1.0, 0.0], [0.0, 1.0]),
            FontTransform::Rotate270 => ([0.0, -1.0], [-1.0, 0.0]),
        };
        let at = [f64::from(position.0), f64::from(position.1)];
        let origin: [f64; 2] =
            std::array::from_fn(|k| at[k] - size * (back * along[k] + lower * up[k]));
        self.fill_of(style.color());
        self.show(&letters, size, [along, up, origin]);
        Ok(())
    }
}

impl PdfPage<'_> {
    /// Shows letters one after another: the directions along and up, and the place of the first.
    #[expect(clippy::cast_possible_truncation, reason = "the page's units are few")]
    fn show(&mut self, letters: &[Letter], size: f64, [along, up, origin]: [[f64; 2]; 3]) {
        self.content.begin_text();
        let mut passed = 0.0;
        for letter in letters {
            let (scale, rise) = if letter.is_raised { SMALL } else { (1.0, 0.0) };
            let own: [f64; 2] =
                std::array::from_fn(|k| origin[k] + size * (passed * along[k] + rise * up[k]));
            let name: &[u8] = if letter.is_symbol { b"S" } else { b"F" };
            self.content.set_font(Name(name), (scale * size) as f32);
            let matrix = [along[0], along[1], up[0], up[1], own[0], own[1]];
            self.content
                .set_text_matrix(matrix.map(|entry| entry as f32));
            self.content.show(Str(&[letter.code]));
            passed += width(letter);
        }
        self.content.end_text();
    }
}

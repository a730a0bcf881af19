//! Tests of PNG and PDF files of figures.

#![cfg(any(feature = "png", feature = "pdf"))]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use contact_plots::{Axis, Curve, Drawing, Figure, Look, Panel, Paper, Width};

fn svg(width_mm: f64) -> String {
    let mut panel = Panel::new("", Axis::new("x̂ = x/R (–)"), Axis::new("force (N)"));
    for (index, name) in ["first", "second"].into_iter().enumerate() {
        let points = (0..=20).map(f64::from).map(|x| (x, x * x)).collect();
        panel.curves.push(Curve { label: name.to_owned(), points, look: Look::series(index) });
    }
    let figure = Figure {
        title: "Contact force".to_owned(),
        description: "Two curves.".to_owned(),
        width: Width::Column,
        columns: 1,
        panels: vec![panel],
    };
    Drawing::Panels(figure).svg(Paper { width_mm: Some(width_mm), ..Paper::default() }).unwrap()
}

#[cfg(feature = "png")]
#[test]
fn a_png_has_the_size_of_the_figure_and_something_on_it() {
    let svg = svg(90.0);
    let bytes = contact_plots::png(&svg, 300.0).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    // 90 mm at 300 pixels to the inch are 1063.
    assert!((1062..=1064).contains(&info.width), "{}", info.width);
    assert_eq!(reader.info().pixel_dims.unwrap().xppu, 11811);
    let colours: std::collections::HashSet<&[u8]> = pixels.chunks_exact(3).collect();
    for colour in [[255, 255, 255], [0x00, 0x72, 0xB2], [0xD5, 0x5E, 0x00]] {
        assert!(colours.contains(colour.as_slice()), "{colour:?} is not on it");
    }
    // Text is there: without its font, nothing would be dark in the title's row.
    let row = usize::try_from(info.width).unwrap() * 3;
    let dark = pixels.chunks_exact(row).take(60).flatten().filter(|&&value| value < 0x60).count();
    assert!(dark > 300, "{dark}");
    assert!(contact_plots::png("no picture", 300.0).is_err());
}

/// A figure 1 m wide at 2400 pixels per inch has 94,488 pixels on each side, far more than fits into memory.
#[cfg(feature = "png")]
#[test]
fn a_picture_of_too_many_pixels_is_refused_before_memory_is_allocated() {
    let error = contact_plots::png(&svg(1000.0), 2400.0).unwrap_err();
    assert!(
        matches!(error, contact_plots::PlotError::TooManyPixels { width: 94_400..94_600, .. }),
        "{error:?}"
    );
    assert!(error.to_string().ends_with(
        "pixels are more than the 100 million that a picture may have: say a smaller dpi or width"
    ));
}

/// The PDF is a document with one page of the size of the figure. Its look is checked elsewhere, with PDF readers.
#[cfg(feature = "pdf")]
#[test]
fn a_pdf_is_one_page_of_the_size_of_the_figure() {
    let bytes = contact_plots::pdf(&svg(85.0), "Contact force").unwrap();
    let text = String::from_utf8_lossy(&bytes);
    assert!(text.starts_with("%PDF-") && text.trim_end().ends_with("%%EOF"));
    let media = text.split("/MediaBox").nth(1).unwrap().split(['[', ']']).nth(1).unwrap();
    let width: f64 = media.split_whitespace().nth(2).unwrap().parse().unwrap();
    // 85 mm in points of 1/72 inch.
    assert!((width - 240.945).abs() < 0.01, "{width}");
    assert!(contact_plots::pdf("no picture", "").is_err());
}

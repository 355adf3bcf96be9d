use crate::say::words::escape;
use slideway_figures::Rendered;

/// Styles of the report: readable on a phone, in light and in dark.
const STYLE: &str = include_str!("page.css");

/// What every report has, whatever was compared.
pub(crate) struct Page<'a> {
    pub(crate) title: &'a str,
    pub(crate) description: &'a str,
    pub(crate) holds: bool,
    pub(crate) verdict: &'a str,
    /// Tables, as HTML.
    pub(crate) body: String,
    pub(crate) figures: &'a [Rendered],
    /// Text of the scenario file, if there is one.
    pub(crate) scenario: Option<&'a str>,
}

impl Page<'_> {
    /// The report as one file that opens from disk without a network.
    pub(crate) fn render(&self) -> String {
        let title = escape(self.title);
        let figures: String = self.figures.iter().map(figure).collect();
        let file =
            |text| format!("<details><summary>The scenario file</summary><pre>{}</pre></details>\n", escape(text));
        format!(
            "{}<h1>{title}</h1>\n<p>{}</p>\n\
             <p class=\"verdict {}\">{}</p>\n{}\n{figures}\n{}</main>\n</body>\n</html>\n",
            page_head(self.title),
            escape(self.description),
            if self.holds { "holds" } else { "fails" },
            escape(self.verdict),
            self.body,
            self.scenario.map_or_else(String::new, file),
        )
    }
}

/// A page up to its content.
pub(crate) fn page_head(title: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{} - slideway</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n",
        escape(title)
    )
}

fn figure(figure: &Rendered) -> String {
    format!("<figure>{}<figcaption>{}</figcaption></figure>\n", inline_svg(&figure.svg), escape(&figure.caption))
}

/// A figure's SVG as part of a page: its own colours of paper, ink and grid become the page's, so that they follow the
/// reader's colour scheme.
pub(crate) fn inline_svg(svg: &str) -> String {
    let svg = svg.replace("#FFFFFF", "var(--paper)").replace("#1A1A1A", "var(--ink)").replace("#D9D9D9", "var(--grid)");
    svg.find("<svg").map_or(svg.clone(), |start| svg[start..].to_owned())
}

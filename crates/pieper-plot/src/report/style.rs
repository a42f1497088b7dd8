//! The report's style sheet: the figures' inks, the page, and print.

use crate::ink;

/// The theme switch: three radio buttons the style sheet reads, so no script is needed.
pub(super) const SWITCH: &str = "<fieldset class=\"switch\"><legend>Theme</legend>\
<label><input type=\"radio\" name=\"theme\" value=\"auto\" checked><span>Auto</span></label>\
<label><input type=\"radio\" name=\"theme\" value=\"light\"><span>Light</span></label>\
<label><input type=\"radio\" name=\"theme\" value=\"dark\"><span>Dark</span></label></fieldset>\n";

const LIGHT_PAGE: &str =
    "--page:#f3f5f7;--line:#d5dae0;--link:#005f96;--warning:#c25700;color-scheme:light;";
const DARK_PAGE: &str =
    "--page:#0e1013;--line:#2f353d;--link:#7cc4f0;--warning:#f0a04b;color-scheme:dark;";

/// The whole style sheet.
pub(super) fn sheet() -> String {
    let light = format!("{}{LIGHT_PAGE}", ink::light_variables());
    let dark = format!("{}{DARK_PAGE}", ink::dark_variables());
    let rules = ink::page_rules();
    format!(
        ":root{{{light}}}\n\
         @media (prefers-color-scheme:dark){{:root{{{dark}}}}}\n\
         :root[data-theme=light],:root:has(input[value=light]:checked){{{light}}}\n\
         :root[data-theme=dark],:root:has(input[value=dark]:checked){{{dark}}}\n\
         @media print{{:root:root:root{{{light}}}}}\n\
         {rules}\n{PAGE}"
    )
}

const PAGE: &str = include_str!("page.css");

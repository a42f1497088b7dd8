//! Numbers for people: aligned columns, no negative zeros, units named.

/// A number with six decimals, without dust: what is zero to the last shown digit shows as 0.
pub(crate) fn number(value: f64) -> String {
    let shown = format!("{value:.6}");
    if shown
        .trim_start_matches('-')
        .chars()
        .all(|c| c == '0' || c == '.')
    {
        return "0.000000".to_owned();
    }
    shown
}

/// Rows of cells with their columns aligned to the right, two spaces apart, each line indented by two.
pub(crate) fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter()
            .filter_map(|row| row.get(column))
            .map(|cell| cell.chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut out = String::new();
    for row in rows {
        let cells = row.iter().zip(&widths);
        let line = cells.map(|(cell, &width)| {
            let pad = width - cell.chars().count();
            format!("{}{cell}", " ".repeat(pad))
        });
        out.push_str("  ");
        out.push_str(line.collect::<Vec<_>>().join("  ").trim_end());
        out.push('\n');
    }
    out
}

/// As [`table`], columns aligned to the left.
pub(crate) fn listing(rows: &[Vec<String>]) -> String {
    let padded: Vec<Vec<String>> = rows
        .iter()
        .map(|row| {
            let width = |column: usize| {
                rows.iter()
                    .filter_map(|r| r.get(column))
                    .map(|cell| cell.chars().count())
                    .max()
                    .unwrap_or(0)
            };
            let cell = |(column, cell): (usize, &String)| {
                format!("{cell}{}", " ".repeat(width(column) - cell.chars().count()))
            };
            row.iter().enumerate().map(cell).collect()
        })
        .collect();
    table(&padded)
}

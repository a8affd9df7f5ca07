//! A table as a spreadsheet in Office Open XML. A double click opens it in every language; of a CSV file, a program
//! whose decimals have commas makes one column.

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use zip::ZipWriter;
use zip::result::ZipError;
use zip::write::SimpleFileOptions;

/// The files that name the only sheet.
const PARTS: [(&str, &str); 4] = [
    (
        "[Content_Types].xml",
        r#"<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Override PartName="/xl/workbook.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/>
<Override PartName="/xl/worksheets/sheet1.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml"/>
</Types>"#,
    ),
    (
        "_rels/.rels",
        r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/>
</Relationships>"#,
    ),
    (
        "xl/workbook.xml",
        r#"<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"
xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships">
<bookViews><workbookView/></bookViews><sheets><sheet name="results" sheetId="1" r:id="rId1"/></sheets></workbook>"#,
    ),
    (
        "xl/_rels/workbook.xml.rels",
        r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/>
</Relationships>"#,
    ),
];

/// The sheet begins with names of columns that stay in view.
const SHEET: &str = r#"<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main">
<sheetViews><sheetView workbookViewId="0"><pane ySplit="1" topLeftCell="A2" state="frozen"/></sheetView></sheetViews>
<sheetFormatPr defaultColWidth="20" defaultRowHeight="15"/>
<sheetData>
"#;

const DECLARATION: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";

/// Text for a cell: without the marks of XML, and without `_x0041_`, in which spreadsheets see one letter by its number
/// (ECMA-376, part 1, `ST_Xstring`).
fn escaped(cell: &str) -> String {
    cell.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace("_x", "_x005F_x")
}

/// The bytes of a spreadsheet. All cells are text, which nothing computes, but for the numbers in one column.
pub fn spreadsheet<const N: usize>(
    rows: &[[String; N]],
    of_numbers: usize,
) -> Result<Vec<u8>, ZipError> {
    let mut sheet = SHEET.to_owned();
    for (number, row) in (1..).zip(rows) {
        let _ = write!(sheet, "<row r=\"{number}\">");
        for (column, (letter, cell)) in ('A'..='Z').zip(row).enumerate() {
            let is_number = column == of_numbers && cell.parse::<f64>().is_ok();
            let cell = escaped(cell);
            let _ = if is_number {
                write!(sheet, "<c r=\"{letter}{number}\"><v>{cell}</v></c>")
            } else {
                let text = format!("<t xml:space=\"preserve\">{cell}</t>");
                write!(
                    sheet,
                    "<c r=\"{letter}{number}\" t=\"inlineStr\"><is>{text}</is></c>"
                )
            };
        }
        sheet += "</row>\n";
    }
    sheet += "</sheetData></worksheet>";
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in PARTS
        .into_iter()
        .chain([("xl/worksheets/sheet1.xml", &*sheet)])
    {
        zip.start_file(name, SimpleFileOptions::default())?;
        zip.write_all([DECLARATION, text].concat().as_bytes())?;
    }
    Ok(zip.finish()?.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_has_marks_of_xml_or_letters_by_number() {
        let cell = "Vec<&[&[f64]]> size_x1920_";
        let right = "Vec&lt;&amp;[&amp;[f64]]&gt; size_x005F_x1920_";
        assert_eq!(escaped(cell), right);
    }
}

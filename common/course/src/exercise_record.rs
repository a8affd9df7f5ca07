//! The recorded answers of an exercise.

use judge::answers::Record;
use learn::exercise::Exercise;
use learn::files;

/// The recorded answers of an exercise in the lecturer's workbook.
pub fn record(e: &Exercise) -> Result<Record, String> {
    let file = record_file(e);
    Record::read(&files::read(&file)?).map_err(|error| format!("{file}: {error}"))
}

/// The file with the recorded answers, from the workbook.
pub fn record_file(e: &Exercise) -> String {
    format!("{}/exercises/answers/{}.txt", e.stage, e.name)
}

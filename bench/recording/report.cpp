#include "bench/recording/report.hpp"

namespace tandem::bench {

std::string recording_table(const std::vector<RecordingRow>& rows) {
  std::string text = "| target | measured | |\n|---|---|---|\n";
  for (const RecordingRow& row : rows) {
    text += "| " + row.target + " | " + row.measured + " | " + (row.is_met ? "met" : "**missed**") + " |\n";
  }
  return text;
}

std::string recording_report(const std::vector<RecordingRow>& rows, const ReportHead& head) {
  return "# Recording and replay\n\n" + head.date + ", commit " + head.commit + ", " + head.machine + ". Command: `" +
         head.command + "`.\n\n" + recording_table(rows) +
         "\nThe load is `scan` messages on the bus of one host, which `tandem-recorder`, a process, records with its "
         "usual\nsettings. A killed recorder's file must open by itself, without damage, and have every message up to "
         "its "
         "last.\nLateness is how much later than the first a replayed message comes, against the recording's times. "
         "Truncation cuts a\nfile of 1 MB at each byte (or every N-th), and counts cuts after which a whole record or "
         "chunk was not read.\n";
}

}  // namespace tandem::bench

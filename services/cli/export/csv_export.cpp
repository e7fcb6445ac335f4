#include "services/cli/export/csv_export.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <optional>

#include "services/common/csv.hpp"
#include "services/common/file_io.hpp"
#include "services/recorder/core/disposed_record.hpp"
#include "services/recorder/core/message_table.hpp"
#include "services/recorder/core/topic_choice.hpp"

namespace tandem::cli {
namespace {

constexpr std::size_t kMessagesBetweenReports = 1000;

/// One topic's file; it has its name once it is whole.
class CsvFile {
 public:
  CsvFile(std::filesystem::path file, recorder::MessageTable table)
      : file_(std::move(file)), part_(file_.string() + ".part"), stream_(part_), table_(std::move(table)) {
    if (!stream_) throw FileError(file_.string() + ": cannot be created: " + std::strerror(errno));
    std::vector<std::string> head{"log_time_ns", "publish_time_ns", "sequence"};
    head.insert(head.end(), table_.columns().begin(), table_.columns().end());
    stream_ << csv_line(head);
  }
  ~CsvFile() {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);  // there only if it was not finished
  }
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  /// False if `message` is not what the schema says.
  bool write(const mcap::Message& message) {
    const auto row = table_.row_of(message.data);
    if (!row) return false;
    std::vector<std::string> cells{std::to_string(message.log_time), std::to_string(message.publish_time),
                                   std::to_string(message.sequence)};
    cells.insert(cells.end(), row->begin(), row->end());
    stream_ << csv_line(cells);
    return true;
  }
  void finish() {
    stream_.close();
    if (!stream_) throw FileError(file_.string() + ": cannot be written: " + std::strerror(errno));
    std::filesystem::rename(part_, file_);
  }

 private:
  std::filesystem::path file_;
  std::filesystem::path part_;
  std::ofstream stream_;
  recorder::MessageTable table_;
};

struct Output {
  CsvExport result;
  std::unique_ptr<CsvFile> file;
};

/// A topic's name as that of a file: others' begin with a slash and have more.
std::string file_name_of(std::string topic) {
  if (topic.starts_with('/')) topic.erase(0, 1);
  std::replace(topic.begin(), topic.end(), '/', '_');
  return topic + ".csv";
}

Output output_of(const mcap::Reader& reader, const mcap::Channel& channel, const std::filesystem::path& folder) {
  Output output;
  output.result.topic = channel.topic;
  const auto schema = reader.schemas().find(channel.schema_id);
  if (schema == reader.schemas().end() || schema->second.encoding != "omgidl" || channel.message_encoding != "cdr") {
    output.result.problem = "its messages are not CDR with an IDL schema";
    return output;
  }
  auto types = idl::parse(schema->second.text);
  auto table = types ? recorder::MessageTable::of(*std::move(types), schema->second.name) : std::nullopt;
  if (table) {
    output.file = std::make_unique<CsvFile>(folder / file_name_of(channel.topic), *std::move(table));
  } else {
    output.result.problem = "its schema (" + schema->second.name + ") has IDL that is not understood here";
  }
  return output;
}

}  // namespace

std::vector<CsvExport> export_csv(mcap::Reader& reader, const std::filesystem::path& folder,
                                  const std::vector<std::string>& topics,
                                  const std::function<bool(double share)>& keep_going) {
  std::error_code ignored;  // creating a file says what is wrong
  std::filesystem::create_directories(folder, ignored);
  std::map<std::uint16_t, Output> outputs;
  for (const auto& [id, channel] : reader.channels()) {
    const bool is_message = !recorder::disposed_topic(channel.topic);
    if (is_message && recorder::is_chosen(channel.topic, topics, {})) {
      outputs.emplace(id, output_of(reader, channel, folder));
    }
  }
  for (std::size_t i = 0; i < reader.message_count(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(reader.message_count());
    if (i % kMessagesBetweenReports == 0 && !keep_going(share)) return {};
    const auto output = outputs.find(reader.channel_at(i));
    if (output == outputs.end() || !output->second.file) continue;
    const auto message = reader.message_at(i);
    if (!message) continue;  // damaged; the reader has noted it
    const bool is_whole = output->second.file->write(*message);
    ++(is_whole ? output->second.result.rows : output->second.result.broken);
  }
  std::vector<CsvExport> results;
  for (auto& [id, output] : outputs) {
    if (output.file) output.file->finish();
    results.push_back(output.result);
  }
  return results;
}

}  // namespace tandem::cli

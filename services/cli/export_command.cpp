#include "services/cli/export_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>

#include "services/cli/command.hpp"
#include "services/cli/export/csv_export.hpp"
#include "services/cli/export/foxglove_scene.hpp"
#include "services/cli/export/foxglove_schemas.hpp"
#include "services/cli/progress.hpp"
#include "services/recorder/recording_file.hpp"

namespace tandem::cli {
namespace {

struct ExportOptions {
  std::string file;
  std::string output;
  std::vector<std::string> topics;
};

constexpr std::size_t kMessagesBetweenReports = 1000;

void fail_if_damaged(const mcap::Reader& reader) {
  for (const std::string& damage : reader.damages()) std::fprintf(stderr, "tandem: %s\n", damage.c_str());
  if (!reader.damages().empty()) throw Failed{};
}

void run_csv(const ExportOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  mcap::Reader reader{mcap::file_source(options.file), options.file};
  Progress progress{"export"};
  const auto results = export_csv(reader, options.output, options.topics, [&progress](double share) {
    progress.show(share);
    return !stop_requested();
  });
  if (stop_requested()) throw Interrupted{};
  for (const CsvExport& result : results) {
    if (!result.problem.empty()) {
      std::fprintf(stderr, "tandem: %s is left out: %s\n", result.topic.c_str(), result.problem.c_str());
    } else if (result.broken > 0) {
      std::fprintf(stderr, "tandem: %s: %llu messages are not what their schema says and are left out\n",
                   result.topic.c_str(), static_cast<unsigned long long>(result.broken));
    }
  }
  std::fprintf(stderr, "%s: %zu topics\n", options.output.c_str(), results.size());
  fail_if_damaged(reader);
}

/// Writes what the messages of `reader` look like. Returns how many messages that were.
std::uint64_t write_scene(mcap::Reader& reader, mcap::Writer& writer) {
  Progress progress{"export"};
  std::map<std::string, std::uint16_t> channels;  // by topic
  std::map<std::string, std::uint16_t> schemas;   // by name
  std::map<std::uint16_t, std::uint32_t> sequences;
  std::uint64_t written = 0;
  const auto channel_of = [&](const FoxgloveMessage& message) {
    const auto [schema, is_new_schema] =
        schemas.emplace(message.schema, static_cast<std::uint16_t>(schemas.size() + 1));
    if (is_new_schema) {
      writer.write(mcap::Schema{schema->second, message.schema, "jsonschema", foxglove_schema(message.schema)});
    }
    const auto [channel, is_new] = channels.emplace(message.topic, static_cast<std::uint16_t>(channels.size() + 1));
    if (is_new) writer.write(mcap::Channel{channel->second, schema->second, message.topic, "json", {}});
    return channel->second;
  };
  for (std::size_t i = 0; i < reader.message_count(); ++i) {
    if (i % kMessagesBetweenReports == 0) {
      if (stop_requested()) throw Interrupted{};
      progress.show(static_cast<double>(i) / static_cast<double>(reader.message_count()));
    }
    const auto message = reader.message_at(i);
    if (!message) continue;  // damaged; the reader has noted it
    const std::string& topic = reader.channels().at(message->channel_id).topic;
    for (const FoxgloveMessage& shown : foxglove_messages(topic, message->data, message->log_time)) {
      const std::uint16_t channel = channel_of(shown);
      const mcap::ByteView json{reinterpret_cast<const std::uint8_t*>(shown.json.data()), shown.json.size()};
      writer.write(mcap::Message{channel, sequences[channel]++, message->log_time, message->publish_time, json});
      ++written;
    }
  }
  return written;
}

void run_foxglove(const ExportOptions& options) {
  (void)stop_requested();
  mcap::Reader reader{mcap::file_source(options.file), options.file};
  std::uint64_t written = 0;
  recorder::write_recording(options.output, [&](mcap::Writer& writer) { written = write_scene(reader, writer); });
  std::fprintf(stderr, "%s: %llu messages\n", options.output.c_str(), static_cast<unsigned long long>(written));
  fail_if_damaged(reader);
}

}  // namespace

void add_export_command(CLI::App& tandem) {
  CLI::App* command = add_command(tandem, "export", "Turn a recording into what other programs read",
                                  "tandem export csv episode.mcap -o episode_csv");
  command->require_subcommand(1);
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* csv =
      add_command(*command, "csv", "One table per topic, columns named as the recording's IDL names the fields",
                  "tandem export csv episode.mcap -o episode_csv --topics 'robot_pose,link_*'");
  csv->add_option("FILE", options->file, "Recording (.mcap)")->required();
  csv->add_option("-o,--output", options->output, "Folder to write TOPIC.csv into")->required();
  csv->add_option("--topics", options->topics, "Only these, as patterns (*, ?) separated by commas")->delimiter(',');
  csv->callback([options] { run_csv(*options); });
  CLI::App* foxglove = add_command(*command, "foxglove",
                                   "A recording of Foxglove's standard schemas: its 3D panel shows map, belief, team, "
                                   "plan, scans and finds",
                                   "tandem export foxglove episode.mcap -o episode_foxglove.mcap");
  foxglove->add_option("FILE", options->file, "Recording (.mcap)")->required();
  foxglove->add_option("-o,--output", options->output, "Recording to write (.mcap)")->required();
  foxglove->callback([options] { run_foxglove(*options); });
}

}  // namespace tandem::cli

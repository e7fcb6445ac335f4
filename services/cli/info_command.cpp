#include "services/cli/info_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "services/cli/command.hpp"
#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/recording_summary.hpp"

namespace tandem::cli {
namespace {

struct InfoOptions {
  std::string file;
  bool json = false;
};

void print_json(const InfoOptions& options, mcap::Reader& reader) {
  nlohmann::ordered_json topics = nlohmann::ordered_json::array();
  for (const recorder::TopicSummary& topic : recorder::summary_of(reader)) {
    topics.push_back({{"topic", topic.topic},
                      {"type", topic.type},
                      {"count", topic.count},
                      {"rate_hz", topic.rate_hz},
                      {"first_time_ns", topic.first_time_ns},
                      {"last_time_ns", topic.last_time_ns}});
  }
  nlohmann::ordered_json metadata = nlohmann::ordered_json::object();
  for (const mcap::Metadata& record : reader.metadata()) metadata[record.name] = record.entries;
  nlohmann::ordered_json attachments = nlohmann::ordered_json::array();
  for (const mcap::Attachment& attachment : reader.attachments()) attachments.push_back(attachment.name);
  const nlohmann::ordered_json info{
      {"file", options.file}, {"complete", reader.complete()}, {"messages", reader.message_count()}, {"topics", topics},
      {"metadata", metadata}, {"attachments", attachments},    {"damages", reader.damages()}};
  std::puts(info.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

void print_text(const InfoOptions& options, mcap::Reader& reader) {
  std::printf("%s: %zu messages, %s\n", options.file.c_str(), reader.message_count(),
              reader.complete() ? "complete" : "not complete: what is whole can be read");
  std::printf("%-24s %-34s %9s %9s %12s\n", "topic", "type", "count", "rate", "span");
  for (const recorder::TopicSummary& topic : recorder::summary_of(reader)) {
    std::printf("%-24s %-34s %9llu %6.2f Hz %10.3f s\n", topic.topic.c_str(), topic.type.c_str(),
                static_cast<unsigned long long>(topic.count), topic.rate_hz,
                static_cast<double>(topic.last_time_ns - topic.first_time_ns) * 1e-9);
  }
  for (const mcap::Metadata& record : reader.metadata()) {
    for (const auto& [key, value] : record.entries) {
      std::printf("%s %s: %s\n", record.name.c_str(), key.c_str(), value.c_str());
    }
  }
  for (const mcap::Attachment& attachment : reader.attachments()) {
    std::printf("attached %s, %zu bytes\n", attachment.name.c_str(), attachment.data.size());
  }
}

/// Reads every message once, so that damage inside a chunk is found.
void check(mcap::Reader& reader) {
  for (std::size_t i = 0; i < reader.message_count(); ++i) (void)reader.message_at(i);
}

void run(const InfoOptions& options) {
  mcap::Reader reader{mcap::file_source(options.file), options.file};
  check(reader);
  if (options.json) {
    print_json(options, reader);
  } else {
    print_text(options, reader);
  }
  for (const std::string& damage : reader.damages()) std::fprintf(stderr, "tandem: %s\n", damage.c_str());
  if (!reader.damages().empty()) throw Failed{};
}

}  // namespace

void add_info_command(CLI::App& tandem) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = add_command(tandem, "info", "Say what a recording holds", "tandem info episode.mcap --json");
  command->add_option("FILE", options->file, "Recording (.mcap)")->required();
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli

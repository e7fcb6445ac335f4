#include "services/cli/merge_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "services/cli/command.hpp"
#include "services/recorder/clock_offsets.hpp"
#include "services/recorder/core/recording_merge.hpp"
#include "services/recorder/recording_file.hpp"

namespace tandem::cli {
namespace {

struct MergeOptions {
  std::vector<std::string> files;
  std::string output;
  std::optional<double> offset_s;
};

recorder::ClockLine clock_of(const MergeOptions& options, mcap::Reader& first, mcap::Reader& other,
                             const std::string& file) {
  if (options.offset_s) return recorder::ClockLine{*options.offset_s};
  if (auto clock = recorder::clock_ahead(first, other)) return *std::move(clock);
  throw std::runtime_error(file + ": neither this recording nor " + options.files.front() +
                           " tells how the clocks of their hosts differ (link_status): say it with --offset");
}

void run(const MergeOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  std::vector<std::unique_ptr<mcap::Reader>> readers;
  std::vector<recorder::MergedRecording> recordings;
  for (const std::string& file : options.files) {
    readers.push_back(std::make_unique<mcap::Reader>(mcap::file_source(file), file));
    mcap::Reader& reader = *readers.back();
    const bool is_first = readers.size() == 1;
    auto clock = is_first ? recorder::ClockLine{0.0} : clock_of(options, *readers.front(), reader, file);
    if (!is_first && reader.message_count() > 0) {
      std::fprintf(stderr, "%s: the clock of %s is %+.6f s ahead of its own\n", file.c_str(),
                   options.files.front().c_str(), clock.offset_s_at(reader.log_time_at(0)));
    }
    recordings.push_back({&reader, recorder::host_of(reader), std::move(clock)});
  }
  recorder::MergeCount count;
  recorder::write_recording(options.output, [&](mcap::Writer& writer) {
    count = recorder::merge(recordings, writer);
    if (stop_requested()) throw Interrupted{};
  });
  std::fprintf(stderr, "%s: %llu messages, %llu that were in more than one recording are there once\n",
               options.output.c_str(), static_cast<unsigned long long>(count.written),
               static_cast<unsigned long long>(count.doubled));
  bool is_damaged = false;
  for (const auto& reader : readers) {
    for (const std::string& damage : reader->damages()) std::fprintf(stderr, "tandem: %s\n", damage.c_str());
    is_damaged = is_damaged || !reader->damages().empty();
  }
  if (is_damaged) throw Failed{};
}

}  // namespace

void add_merge_command(CLI::App& tandem) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* command =
      add_command(tandem, "merge",
                  "Make one recording of those of two hosts, or of the parts of one, on the clock of the "
                  "first",
                  "tandem merge robot.mcap laptop.mcap -o episode.mcap");
  command->add_option("FILES", options->files, "Recordings (.mcap)")->required()->expected(2, 1000);
  command->add_option("-o,--output", options->output, "Recording to write (.mcap)")->required();
  command->add_option("--offset", options->offset_s,
                      "First clock minus the others' [s]; default: as the relays measured it");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli

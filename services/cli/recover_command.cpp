#include "services/cli/recover_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "services/cli/command.hpp"
#include "services/recorder/recording_file.hpp"

namespace tandem::cli {
namespace {

struct RecoverOptions {
  std::string file;
  std::string output;
};

void run(const RecoverOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  mcap::Reader reader{mcap::file_source(options.file), options.file, mcap::ReadBy::Records};
  recorder::rewrite_recording(reader, options.output);
  for (const std::string& damage : reader.damages()) std::fprintf(stderr, "tandem: %s\n", damage.c_str());
  std::fprintf(stderr, "%s: %zu messages; %s\n", options.output.c_str(), reader.message_count(),
               reader.damages().empty() ? "nothing was damaged" : "what is named above is lost");
  if (!reader.damages().empty()) throw Failed{};
}

}  // namespace

void add_recover_command(CLI::App& tandem) {
  const auto options = std::make_shared<RecoverOptions>();
  CLI::App* command = add_command(tandem, "recover",
                                  "Write what is whole of a damaged or unfinished recording to a new one, with index; "
                                  "exit code 1 if something was damaged",
                                  "tandem recover episode.mcap -o episode-recovered.mcap");
  command->add_option("FILE", options->file, "Recording (.mcap)")->required();
  command->add_option("-o,--output", options->output, "Recording to write (.mcap)")->required();
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli

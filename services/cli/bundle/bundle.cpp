#include "services/cli/bundle/bundle.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <fstream>

#include "services/recorder/core/mcap_copy.hpp"
#include "services/recorder/recording_file.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

/// Copies the files of `from` with the extension into `to`; nothing below, nothing else.
void copy_files(const fs::path& from, const std::string& extension, const fs::path& to,
                std::vector<std::string>& left_out) {
  std::error_code error;
  fs::create_directories(to);
  for (const auto& entry : fs::directory_iterator{from, error}) {
    if (!entry.is_regular_file() || entry.path().extension() != extension) continue;
    std::error_code failure;
    fs::copy_file(entry.path(), to / entry.path().filename(), failure);
    if (failure) left_out.push_back(entry.path().string() + ": " + failure.message());
  }
  if (error) left_out.push_back(from.string() + ": " + error.message());
}

/// The last `length` of `recording`, as a whole file of its own.
void copy_end(const fs::path& recording, Duration length, const fs::path& file) {
  mcap::Reader reader{mcap::file_source(recording), recording.string()};
  const std::size_t count = reader.message_count();
  const std::uint64_t end = count == 0 ? 0 : reader.log_time_at(count - 1);
  const auto span = static_cast<std::uint64_t>(length.count());
  std::ofstream stream{file, std::ios::binary};
  mcap::IndexedWriter writer{[&](mcap::ByteView bytes) {
                               stream.write(reinterpret_cast<const char*>(bytes.data()),
                                            static_cast<std::streamsize>(bytes.size()));
                               return stream.good();
                             },
                             {.profile = "", .library = "tandem"}};
  if (!mcap::copy(reader, writer, end > span ? end - span : 0) || !writer.finish()) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
}

}  // namespace

fs::path newest_recording(const fs::path& folder) {
  fs::path newest;
  fs::file_time_type when = fs::file_time_type::min();
  std::error_code error;
  for (const auto& entry : fs::directory_iterator{folder, error}) {
    if (!entry.is_regular_file() || entry.path().extension() != ".mcap") continue;
    if (newest.empty() || entry.last_write_time() > when) {
      newest = entry.path();
      when = entry.last_write_time();
    }
  }
  return newest;
}

std::vector<std::string> fill_bundle(const BundlePlan& plan, const fs::path& folder) {
  std::vector<std::string> left_out;
  copy_files(plan.config_folder, ".toml", folder / "config", left_out);
  if (!plan.log_folder.empty()) copy_files(plan.log_folder, ".log", folder / "logs", left_out);
  if (plan.recordings.empty()) return left_out;
  const fs::path recording = newest_recording(plan.recordings);
  if (recording.empty()) {
    left_out.push_back(plan.recordings.string() + ": no recording");
    return left_out;
  }
  try {
    copy_end(recording, plan.recording_length, folder / recording.filename());
  } catch (const std::exception& error) {
    left_out.push_back(error.what());
  }
  return left_out;
}

bool keep_output(const std::vector<std::string>& words, const fs::path& file) {
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: execvp's interface
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 1, file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int failure = ::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return false;
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace tandem::cli

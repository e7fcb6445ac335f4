#include "services/cli/study/study_file.hpp"

#include <string_view>
#include <utility>

#include "services/cli/command.hpp"
#include "services/common/file_io.hpp"

namespace tandem::cli {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

}  // namespace

StudyFile::StudyFile(experiment::StudySettings settings, std::filesystem::path file)
    : settings_(std::move(settings)), file_(std::move(file)) {
  if (std::filesystem::exists(file_)) {
    const std::string before = read_file(file_);
    const auto lines = lines_of(before);
    if (!lines.empty() && lines.front() != experiment::settings_line(settings_)) {
      throw WrongUse(file_.string() + " holds another study; choose another --output. There: " +
                     std::string{lines.front()} + " Asked for: " + experiment::settings_line(settings_));
    }
    for (std::size_t i = 1; i < lines.size(); ++i) {
      // A line that is none was being written when the program was ended: that episode is played again.
      if (auto episode = experiment::parse_episode_line(lines[i])) episodes_[episode->seed] = std::move(*episode);
    }
  }
  write_and_append();
}

void StudyFile::add(const experiment::EpisodeResult& episode) {
  const std::string line = experiment::episode_line(episode);
  episodes_[episode.seed] = *experiment::parse_episode_line(line);  // rounded, as the next run would read it
  if (file_.empty()) return;
  append_ << line << '\n' << std::flush;
  if (!append_) throw FileError("cannot write " + file_.string());
}

std::vector<experiment::EpisodeResult> StudyFile::episodes(std::uint64_t first, std::uint64_t count) const {
  std::vector<experiment::EpisodeResult> list;
  for (const auto& [seed, episode] : episodes_) {
    if (seed >= first && seed - first < count) list.push_back(episode);
  }
  return list;
}

void StudyFile::finish() {
  if (!file_.empty()) write_and_append();
}

std::string StudyFile::text() const {
  std::string text = experiment::settings_line(settings_) + "\n";
  for (const auto& [seed, episode] : episodes_) text += experiment::episode_line(episode) + "\n";
  return text;
}

void StudyFile::write_and_append() {
  append_.close();
  write_file_atomically(file_, text());
  append_.clear();
  append_.open(file_, std::ios::app | std::ios::binary);
  if (!append_) throw FileError("cannot write " + file_.string());
}

}  // namespace tandem::cli

#include "services/cli/session_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/cli/command.hpp"
#include "services/cli/host_bus.hpp"
#include "services/cli/session/kept_recordings.hpp"
#include "services/cli/up/episode.hpp"
#include "services/cli/up/screen.hpp"
#include "services/common/config.hpp"
#include "services/common/file_io.hpp"
#include "services/mapping/map_messages.hpp"
#include "services/recorder/core/recorder_config.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

constexpr Duration kMapWithin = std::chrono::seconds{20};
constexpr Duration kMeeting = std::chrono::seconds{3};
constexpr Duration kLastWords = std::chrono::seconds{1};

struct StartOptions {
  HostOptions host;
  std::string code;
  std::string condition = "search";
  std::string reminder = "none";
  std::string mode = "human_robot";
  double limit_s = 600.0;
  double ready_within_s = 60.0;
  std::vector<double> robot_pose;  ///< map_from_base: x [m], y [m], heading [rad]; empty: it is known
  std::string json_file;
  std::string picture;
  bool is_headless = false;
};

/// A code that is fit for files and tables and is nobody's name in full.
std::string checked_code(const std::string& code) {
  constexpr std::size_t kLongest = 32;
  const bool is_fit = !code.empty() && code.size() <= kLongest && std::ranges::all_of(code, [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '-' || letter == '_';
  });
  if (!is_fit) {
    throw WrongUse("session: '" + code + "' is no code: 1 to 32 letters, digits, - and _; a code, never a name (P07)");
  }
  return code;
}

OccupancyGrid map_on(bus::Bus& bus) {
  auto maps = bus.latest(topic::kMap);
  std::ignore = bus::wait_until(bus, kMapWithin, [&] { return maps.newest().has_value() || stop_requested(); });
  if (stop_requested()) throw Interrupted{};
  const auto newest = maps.newest();
  if (!newest) {
    throw std::runtime_error(
        "no map on this host within 20 s: do the services run here (tandem doctor), and does the robot have one?");
  }
  auto map = to_grid(newest->message);
  if (!map) throw std::runtime_error("the map on this host is damaged: look at its map server (tandem doctor)");
  return std::move(*map);
}

/// Whose health a search needs; the camera is none of them: a person can find the object, too.
std::vector<std::string> needed_services(bool without_robot) {
  if (without_robot) return {"gateway"};
  return {"base", "laser", "localization", "navigator", "tracker", "planner", "gateway", "relay"};
}

nlohmann::ordered_json result_of(const Episode& episode, const StartOptions& options) {
  const EpisodeView& view = episode.view();
  return {{"session", options.code},
          {"found", episode.phase() == Episode::Phase::Found},
          {"found_by", view.found_by},
          {"time_s", view.time_s},
          {"explored", view.explored},
          {"explored_robot", view.explored_robot},
          {"explored_human", view.explored_human},
          {"stops", view.stops},
          {"messages", view.messages},
          {"reason", episode.reason()}};
}

void say_result(const Episode& episode) {
  const EpisodeView& view = episode.view();
  if (view.found_at) {
    std::printf("Found by %s after %.0f s at (%.1f, %.1f) m.\n", view.found_by.c_str(), view.time_s, view.found_at->x(),
                view.found_at->y());
  } else {
    std::printf("Not found: %s (after %.0f s).\n", episode.reason().c_str(), view.time_s);
  }
  std::printf("Explored %.0f %%: robot %.0f %%, person %.0f %%. %d messages, %d stops.\n", 100.0 * view.explored,
              100.0 * view.explored_robot, 100.0 * view.explored_human, view.messages, view.stops);
}

void refuse_second_session(bus::Bus& bus, const SiteConfig& site) {
  auto sessions = bus.latest(topic::kSession);
  const auto running = [&]() -> std::string {
    for (const auto& received : sessions.each()) {
      const auto& session = received.message;
      if (session.robot() == site.robot && session.phase() != msg::SESSION_ENDED && received.writer_alive) {
        return session.code();
      }
    }
    return "";
  };
  std::ignore = bus::wait_until(bus, kMeeting, [&] { return !running().empty() || stop_requested(); });
  if (const auto code = running(); !code.empty()) {
    throw std::runtime_error("session " + code + " of " + site.robot +
                             " runs already: end it first (tandem session end)");
  }
}

void start(const StartOptions& options) {
  std::ignore = stop_requested();  // from now on Ctrl-C ends it in order
  const SiteConfig site = site_of(options.host);
  const bool without_robot = options.mode == "human_human";
  EpisodePlan plan{.session_code = checked_code(options.code),
                   .condition = options.condition,
                   .reminder = options.reminder,
                   .mode = options.mode,
                   .limit_s = options.limit_s,
                   .robot_start = std::nullopt,
                   .without_robot = without_robot,
                   .needed = needed_services(without_robot),
                   .ready_within = from_seconds(options.ready_within_s)};
  if (!options.robot_pose.empty()) {
    plan.robot_start = Pose2{options.robot_pose[0], options.robot_pose[1], wrap_to_pi(options.robot_pose[2])};
  }
  bus::Bus bus{bus::host_domain(site, "session")};
  refuse_second_session(bus, site);
  Episode episode{bus, site, std::move(plan), map_on(bus)};
  Screen screen{options.is_headless};
  while (!episode.is_over()) {
    bus.wait(std::chrono::milliseconds{200});
    episode.step();
    screen.show(episode.view(), bus.clock().now());
    if (stop_requested()) episode.abort("interrupted");
  }
  screen.finish(episode.view());
  // The end of the session still has to reach everybody: with its writer gone it would look as if it had crashed.
  std::ignore = bus::wait_until(bus, kLastWords, [] { return false; });
  if (!options.picture.empty()) write_file_atomically(options.picture, picture_of(episode.view()));
  if (!options.json_file.empty()) {
    write_file_atomically(options.json_file, result_of(episode, options).dump(2) + "\n");
  }
  say_result(episode);
  if (stop_requested()) throw Interrupted{};
  if (episode.phase() != Episode::Phase::Found) throw Failed{};
}

struct EndOptions {
  HostOptions host;
  std::string outcome = "aborted";
};

void end(const EndOptions& options) {
  std::ignore = stop_requested();
  const SiteConfig site = site_of(options.host);
  bus::Bus bus{bus::host_domain(site, "session")};
  auto sessions = bus.latest(topic::kSession);
  const auto running = [&]() -> std::optional<msg::SessionState> {
    for (const auto& received : sessions.each()) {
      if (received.message.robot() == site.robot && received.message.phase() == msg::SESSION_RUNNING) {
        return received.message;
      }
    }
    return std::nullopt;
  };
  std::ignore = bus::wait_until(bus, kMeeting, [&] { return running().has_value() || stop_requested(); });
  auto session = running();
  if (!session) throw std::runtime_error("no session of " + site.robot + " runs on this host");
  auto writer = bus.writer(topic::kSession);
  session->phase(msg::SESSION_ENDED);
  session->stamp_ns(to_stamp_ns(bus.clock().now()));
  session->ended_ns(session->stamp_ns());
  session->outcome(options.outcome);
  writer.write(*session);
  std::ignore = bus::wait_until(bus, kLastWords, [] { return false; });  // whoever leads it says so itself by then
  std::printf("session %s ended: %s\n", session->code().c_str(), options.outcome.c_str());
}

struct KeptOptions {
  HostOptions host;
  std::string folder;  ///< empty: the recorder's
  std::string code;
  bool json = false;
  bool is_sure = false;
};

std::vector<KeptRecording> kept_for(const KeptOptions& options) {
  if (!options.folder.empty()) return kept_recordings(options.folder);
  const fs::path file = options.host.config_folder / "recorder.toml";
  return kept_recordings(fs::exists(file) ? load_config<recorder::RecorderConfig>(file).folder
                                          : recorder::RecorderConfig{}.folder);
}

void list(const KeptOptions& options) {
  std::ignore = stop_requested();
  auto rows = nlohmann::ordered_json::array();
  for (const KeptRecording& kept : kept_for(options)) {
    for (const RecordedSession& session : kept.sessions) {
      rows.push_back({{"session", session.code},
                      {"started", utc_time(session.started_ns)},
                      {"duration_s", session.duration_s},
                      {"outcome", session.outcome},
                      {"condition", session.condition},
                      {"file", kept.file.string()}});
    }
  }
  if (options.json) {
    std::puts(rows.dump(2).c_str());
    return;
  }
  std::printf("%-20s %-20s %9s  %-11s %-14s %s\n", "session", "started", "duration", "outcome", "condition", "file");
  for (const auto& row : rows) {
    const auto words = [&](const char* key) { return row[key].get<std::string>(); };
    std::printf("%-20s %-20s %7.1f s  %-11s %-14s %s\n", words("session").c_str(), words("started").c_str(),
                row["duration_s"].get<double>(), words("outcome").c_str(), words("condition").c_str(),
                words("file").c_str());
  }
}

void remove_session(const KeptOptions& options) {
  std::ignore = stop_requested();
  std::vector<fs::path> own;
  std::vector<std::string> shared;
  for (const KeptRecording& kept : kept_for(options)) {
    const auto is_it = [&](const RecordedSession& session) { return session.code == options.code; };
    if (std::ranges::none_of(kept.sessions, is_it)) continue;
    if (std::ranges::all_of(kept.sessions, is_it)) {
      own.push_back(kept.file);
    } else {
      shared.push_back(kept.file.string());
    }
  }
  if (own.empty() && shared.empty()) throw std::runtime_error("no recording of session " + options.code);
  for (const std::string& file : shared) {
    std::fprintf(stderr, "tandem: %s holds other sessions, too, and stays\n", file.c_str());
  }
  for (const fs::path& file : own) {
    if (options.is_sure) fs::remove(file);
    std::printf("%s %s\n", options.is_sure ? "deleted" : "would be deleted:", file.c_str());
  }
  if (!options.is_sure) throw WrongUse("session delete: say --yes to delete these for good");
  if (!shared.empty()) throw Failed{};
}

CLI::App* add_part(CLI::App& session, const std::string& name, const std::string& purpose, HostOptions& host) {
  CLI::App* part = session.add_subcommand(name, purpose);
  part->add_option("--config", host.config_folder, "Folder with site.toml")->capture_default_str();
  return part;
}

}  // namespace

void add_session_command(CLI::App& tandem) {
  CLI::App* session =
      add_command(tandem, "session", "Start and end a search of the team; list and delete recorded ones",
                  "tandem session start P07 --condition app --reminder multimodal");
  session->require_subcommand(1);

  const auto to_start = std::make_shared<StartOptions>();
  CLI::App* starting =
      add_part(*session, "start", "Lead a search until it is found, time is up, or Ctrl-C", to_start->host);
  starting->add_option("CODE", to_start->code, "Of the session: a code, never a name")->required();
  starting->add_option("--domain", to_start->host.domain, "DDS domain, instead of the site's");
  starting->add_option("--condition", to_start->condition, "Of the study; groups in tandem report")
      ->capture_default_str();
  starting->add_option("--reminder", to_start->reminder, "On the phone")
      ->check(CLI::IsMember({"none", "toast", "popup", "multimodal", "counters"}))
      ->capture_default_str();
  starting->add_option("--mode", to_start->mode, "Who searches")
      ->check(CLI::IsMember({"human_robot", "human_human"}))
      ->capture_default_str();
  starting->add_option("--limit-s", to_start->limit_s, "Give up after so many seconds")
      ->check(CLI::Range(1.0, 36000.0))
      ->capture_default_str();
  starting->add_option("--ready-within-s", to_start->ready_within_s, "Wait so long for services and the robot's pose")
      ->check(CLI::Range(1.0, 3600.0))
      ->capture_default_str();
  starting
      ->add_option("--robot-pose", to_start->robot_pose,
                   "Where the robot stands on the map: x [m], y [m], heading [rad] (default: it knows, or is told by "
                   "Robot pose on the phone)")
      ->expected(3);
  starting->add_flag("--headless", to_start->is_headless, "Lines instead of a live picture");
  starting->add_option("--json", to_start->json_file, "Write the result to this file");
  starting->add_option("--picture", to_start->picture, "Write map, belief and both ways to this PNG file");
  starting->callback([to_start] { start(*to_start); });

  const auto to_end = std::make_shared<EndOptions>();
  CLI::App* ending = add_part(*session, "end", "End the search that runs", to_end->host);
  ending->add_option("--domain", to_end->host.domain, "DDS domain, instead of the site's");
  ending->add_option("--outcome", to_end->outcome, "Why")
      ->check(CLI::IsMember({"aborted", "found", "time_limit"}))
      ->capture_default_str();
  ending->callback([to_end] { end(*to_end); });

  const auto to_list = std::make_shared<KeptOptions>();
  CLI::App* listing = add_part(*session, "list", "The sessions in recordings", to_list->host);
  listing->add_option("--folder", to_list->folder, "Folder of recordings (default: the recorder's)");
  listing->add_flag("--json", to_list->json, "As JSON");
  listing->callback([to_list] { list(*to_list); });

  const auto to_delete = std::make_shared<KeptOptions>();
  CLI::App* deleting = add_part(*session, "delete", "Delete the recordings of a session", to_delete->host);
  deleting->add_option("CODE", to_delete->code, "Of the session")->required();
  deleting->add_option("--folder", to_delete->folder, "Folder of recordings (default: the recorder's)");
  deleting->add_flag("--yes", to_delete->is_sure, "You are sure");
  deleting->callback([to_delete] { remove_session(*to_delete); });
}

}  // namespace tandem::cli

#include "bench/recording/live_recorder.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>

#include "services/bus/bus.hpp"
#include "services/bus/domain_lease.hpp"
#include "services/common/file_io.hpp"
#include "services/common/random.hpp"
#include "services/recorder/carmen_import.hpp"
#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/support/process_use.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::bench {
namespace {

constexpr int kRate_hz = 5000;
constexpr std::size_t kBeams = 480;  // 2 kB
constexpr Duration kPatience = std::chrono::seconds{30};
constexpr Duration kSettling = std::chrono::seconds{1};  ///< the recorder's side of the discovery ends after ours

class Child {
 public:
  explicit Child(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT
    arguments.push_back(nullptr);
    id_ = fork();
    if (id_ != 0) return;
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  ~Child() { end(SIGTERM); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void end(int signal) {
    if (id_ <= 0) return;
    kill(id_, signal);
    wait();
  }
  void wait() {
    if (id_ > 0) waitpid(id_, nullptr, 0);
    id_ = -1;
  }
  [[nodiscard]] double cpu_s() const { return test::cpu_s_of(id_); }

 private:
  pid_t id_ = -1;
};

/// A host for one measurement: its folder, its domain, ourselves on its bus.
struct Host {
  Host() {
    write_file_atomically(folder / "site.toml", "host_domain = " + std::to_string(lease[0]) + "\n");
    write_file_atomically(folder / "recorder.toml", "folder = \"" + recordings().string() + "\"\nname = \"a\"\n");
  }
  [[nodiscard]] std::filesystem::path recordings() const { return folder / "recordings"; }
  [[nodiscard]] bus::DomainOptions domain() const {
    bus::DomainOptions options;
    options.domain = lease[0];
    options.participant = "bench@robot";
    return options;
  }
  [[nodiscard]] std::vector<std::string> recorder(const Programs& programs) const {
    return {(programs.folder / "tandem-recorder").string(), "--config", folder.path().string(), "--log-level", "warn"};
  }
  test::TemporaryFolder folder;
  bus::DomainLease lease{1};
  bus::Bus bus{domain()};
};

/// Scans with a number each, as many a second as asked for.
class Sender {
 public:
  explicit Sender(bus::Bus& bus) : bus_(bus), scans_(bus.writer(topic::kScan)) {
    scan_.robot("robot1");
    scan_.ranges_m(std::vector<float>(kBeams, 1.0F));
  }
  void wait_for_recorder() {
    if (!bus::wait_until(bus_, kPatience, [this] { return scans_.raw().matched_readers() > 0; })) {
      throw std::runtime_error("tandem-recorder does not record: is it there, and built?");
    }
    const Time settled = bus_.clock().now() + kSettling;
    while (bus_.clock().now() < settled) bus_.wait(kSettling);
  }
  void send_for(Duration span) {
    const Time start = bus_.clock().now();
    const std::uint64_t before = sent_;
    for (Time now = start; now - start < span; now = bus_.clock().now()) {
      const auto due = before + static_cast<std::uint64_t>(to_seconds(now - start) * kRate_hz);
      while (sent_ < due) send();
      usleep(1000);
    }
  }
  [[nodiscard]] std::uint64_t sent() const { return sent_; }

 private:
  void send() {
    scan_.sequence_number(++sent_);
    for (float& range : scan_.ranges_m()) range = static_cast<float>(rng_.uniform(0.0, 30.0));
    scans_.write(scan_);
  }
  bus::Bus& bus_;
  bus::Writer<msg::LaserScan, msg::LaserScanPubSubType> scans_;
  msg::LaserScan scan_;
  Rng rng_{1};
  std::uint64_t sent_ = 0;
};

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    if (entry.path().extension() == ".mcap") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Numbers of the scans of a recording, in its order.
std::vector<std::uint64_t> numbers_in(mcap::Reader& reader) {
  std::vector<std::uint64_t> numbers;
  const mcap::Channel* channel = reader.channel_of(std::string{topic::kScan.name});
  for (std::size_t i = 0; channel != nullptr && i < reader.message_count(); ++i) {
    if (reader.channel_at(i) != channel->id) continue;
    const auto message = reader.message_at(i);
    const auto scan =
        message ? bus::decode<msg::LaserScanPubSubType>({message->data.begin(), message->data.end()}) : std::nullopt;
    if (scan) numbers.push_back(scan->sequence_number());
  }
  return numbers;
}

/// The recorder's own count of the scans it wrote: what the bus lost on the way is not its fault.
std::vector<std::uint32_t> counts_in(mcap::Reader& reader) {
  std::vector<std::uint32_t> counts;
  const mcap::Channel* channel = reader.channel_of(std::string{topic::kScan.name});
  for (std::size_t i = 0; channel != nullptr && i < reader.message_count(); ++i) {
    const auto message = reader.message_at(i);
    if (message && message->channel_id == channel->id) counts.push_back(message->sequence);
  }
  return counts;
}

std::vector<mcap::Bytes> payloads_in(const std::filesystem::path& file, std::string_view topic) {
  mcap::Reader reader{mcap::file_source(file), file.string()};
  std::vector<mcap::Bytes> all;
  const mcap::Channel* channel = reader.channel_of(std::string{topic});
  for (std::size_t i = 0; channel != nullptr && i < reader.message_count(); ++i) {
    const auto message = reader.message_at(i);
    if (message && message->channel_id == channel->id) all.emplace_back(message->data.begin(), message->data.end());
  }
  return all;
}

/// Notes when each message came.
class ArrivalTimes final : public bus::Mailbox {
 public:
  void put(bus::RawSample sample) override {
    const std::lock_guard lock{mutex_};
    times_.push_back(sample.received);
  }
  [[nodiscard]] std::vector<Time> times() const {
    const std::lock_guard lock{mutex_};
    return times_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Time> times_;
};

/// Odometry and scans in turn, a hundred times a second.
void write_drive(const std::filesystem::path& file, double seconds) {
  std::vector<carmen::Event> events;
  for (int i = 0; i < static_cast<int>(seconds * 100.0); ++i) {
    const double time_s = 1.0 + 0.01 * i;
    events.push_back(carmen::Odometry{time_s, Pose2{0.01 * i, 0.0, 0.0}});
    events.push_back(
        carmen::Scan{time_s + 0.005, -1.5, 0.01, std::vector<float>(kBeams, 0.01F * static_cast<float>(i))});
  }
  recorder::write_recording(file,
                            [&events](mcap::Writer& writer) { recorder::write_carmen(events, "robot1", writer); });
}

}  // namespace

LoadResult record_under_load(const Programs& programs, double seconds) {
  Host host;
  Sender sender{host.bus};
  Child recorder{host.recorder(programs)};
  sender.wait_for_recorder();
  const double cpu_s = recorder.cpu_s();
  const Time start = host.bus.clock().now();
  sender.send_for(from_seconds(seconds));
  const double span_s = to_seconds(host.bus.clock().now() - start);
  LoadResult result;
  result.cpu_share = (recorder.cpu_s() - cpu_s) / span_s;
  result.sent = sender.sent();
  usleep(500'000);  // the last are on their way
  recorder.end(SIGTERM);
  std::uint64_t bytes = 0;
  for (const auto& file : files_in(host.recordings())) {
    mcap::Reader reader{mcap::file_source(file), file.string()};
    result.recorded += numbers_in(reader).size();
  }
  bytes = result.sent * kBeams * sizeof(float);
  result.megabytes_per_s = static_cast<double>(bytes) * 1e-6 / span_s;
  return result;
}

KillResult kill_recorders(const Programs& programs, int times) {
  KillResult result;
  Rng rng{3};
  for (int i = 0; i < times; ++i) {
    Host host;
    Sender sender{host.bus};
    Child recorder{host.recorder(programs)};
    sender.wait_for_recorder();
    sender.send_for(from_seconds(rng.uniform(0.01, 1.0)));
    recorder.end(SIGKILL);
    ++result.killed;
    try {
      const auto file = files_in(host.recordings()).at(0);
      mcap::Reader reader{mcap::file_source(file), file.string()};
      const auto counts = counts_in(reader);
      if (!reader.damages().empty()) ++result.unreadable;
      const bool has_gap = !counts.empty() && counts.back() + std::size_t{1} != counts.size();
      if (has_gap) ++result.gaps;
    } catch (const std::exception&) {  // it does not open at all
      ++result.unreadable;
    }
  }
  return result;
}

ReplayResult replay_and_record(const Programs& programs, double seconds) {
  Host host;
  const auto original = host.folder / "drive.mcap";
  write_drive(original, seconds);
  const auto box = std::make_shared<ArrivalTimes>();
  const auto subscription = host.bus.subscribe(info_of(topic::kOdometry), box);
  {
    Child recorder{host.recorder(programs)};
    auto probe = host.bus.writer(topic::kScan);
    if (!bus::wait_until(host.bus, kPatience, [&probe] { return probe.raw().matched_readers() > 0; })) {
      throw std::runtime_error("tandem-recorder does not record: is it there, and built?");
    }
    Child player{
        {(programs.folder / "tandem").string(), "replay", original.string(), "--config", host.folder.path().string()}};
    player.wait();
    usleep(500'000);  // the last are on their way
  }
  ReplayResult result;
  const std::vector<Time> times = box->times();
  result.messages = times.size();
  std::vector<double> lags_s;
  for (std::size_t i = 0; i < times.size(); ++i) {
    lags_s.push_back(to_seconds(times[i] - times[0]) - 0.01 * static_cast<double>(i));
  }
  if (lags_s.empty()) throw std::runtime_error("nothing was replayed");
  const double soonest_s = *std::min_element(lags_s.begin(), lags_s.end());
  std::sort(lags_s.begin(), lags_s.end());
  result.lateness_p99_ms = 1000.0 * (lags_s[(lags_s.size() - 1) * 99 / 100] - soonest_s);
  result.lateness_max_ms = 1000.0 * (lags_s.back() - soonest_s);
  const auto again = files_in(host.recordings()).at(0);
  result.is_same_again = true;
  for (const std::string_view topic : {topic::kOdometry.name, topic::kScan.name}) {
    const auto before = payloads_in(original, topic);
    const auto after = payloads_in(again, topic);
    result.is_same_again = result.is_same_again && before == after;
    result.lost += before.size() - std::min(before.size(), after.size());
  }
  return result;
}

}  // namespace tandem::bench

#include "services/cli/offline_localization.hpp"

#include <set>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/cli/thread_time.hpp"
#include "services/localization/core/localizer.hpp"
#include "services/localization/localization_messages.hpp"

namespace tandem::cli {
namespace {

template <class PubSubType>
std::optional<typename PubSubType::type> decoded(const mcap::Message& message) {
  return bus::decode<PubSubType>({message.data.begin(), message.data.end()});
}

/// One run through a recording.
class Run {
 public:
  Run(const OccupancyGrid& map, const OfflineOptions& options)
      : map_(map), options_(options), localizer_(map, options.config), rng_(kidnap_seed(options.config)) {}

  void add(const std::string& topic, const mcap::Message& message) {
    if (topic == topic::kOdometry.name) {
      const auto odometry = decoded<msg::OdometryPubSubType>(message);
      if (odometry && is_ours(odometry->robot())) add_odometry(*odometry);
    } else if (topic == topic::kScan.name) {
      const auto scan = decoded<msg::LaserScanPubSubType>(message);
      if (scan && is_ours(scan->robot())) add_scan(*scan);
    } else if (topic == topic::kPoseHint.name) {
      const auto hint = decoded<msg::PoseHintPubSubType>(message);
      if (hint && is_ours(hint->robot())) add_hint(*hint);
    }
  }
  OfflineResult result;

 private:
  static std::uint64_t kidnap_seed(const LocalizationConfig& config) {
    return static_cast<std::uint64_t>(config.seed) + 1'000'000;
  }
  /// The first robot of a recording is the one to localize.
  bool is_ours(const std::string& robot) {
    if (!robot_) robot_ = robot;
    return robot == *robot_;
  }
  void add_odometry(const msg::Odometry& message) {
    if (const auto sample = from_message(message)) localizer_.add_odometry(*sample);
  }
  /// An event is repeated until its receipt comes; it counts once.
  void add_hint(const msg::PoseHint& message) {
    if (!hints_.insert(message.id()).second) return;
    if (const auto hint = from_message(message)) localizer_.add_hint(*hint);
  }
  void add_scan(const msg::LaserScan& message) {
    const auto scan = from_message(message);
    if (!scan) return;
    kidnap(scan->time);
    const double before = thread_cpu_ms();
    const auto pose = localizer_.add_scan(*scan);
    result.faults = localizer_.faults();
    if (!pose) return;
    result.update_ms.push_back(thread_cpu_ms() - before);
    result.poses.push_back({{pose->time, pose->map_from_base}, pose->covariance, pose->status});
  }
  void kidnap(Time time) {
    if (!options_.kidnap_s || kidnapped_ || time < Time{from_seconds(*options_.kidnap_s)}) return;
    kidnapped_ = true;
    const Particles anywhere = particles_everywhere(map_, 1, rng_);
    if (!anywhere.empty()) localizer_.add_hint({time, anywhere.front().map_from_base, true, 0.1});
  }

  const OccupancyGrid& map_;
  const OfflineOptions& options_;
  Localizer localizer_;
  Rng rng_;
  std::optional<std::string> robot_;
  std::set<std::string> hints_;
  bool kidnapped_ = false;
};

}  // namespace

OfflineResult localize_offline(mcap::Reader& recording, const OccupancyGrid& map, const OfflineOptions& options,
                               const std::function<bool(double)>& keep_going) {
  Run run{map, options};
  for (std::size_t i = 0; i < recording.message_count(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(recording.message_count());
    if (i % 100 == 0 && !keep_going(share)) break;
    const auto message = recording.message_at(i);
    if (!message) {
      ++run.result.damaged;
      continue;
    }
    run.add(recording.channels().at(message->channel_id).topic, *message);
  }
  return std::move(run.result);
}

}  // namespace tandem::cli

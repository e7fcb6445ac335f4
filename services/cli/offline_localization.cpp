#include "services/cli/offline_localization.hpp"

#include <chrono>
#include <set>
#include <utility>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/cli/thread_time.hpp"
#include "services/localization/core/localizer.hpp"
#include "services/localization/localization_messages.hpp"

namespace tandem::cli {
namespace {

constexpr Duration kCarrying = std::chrono::seconds{1};

template <class PubSubType>
std::optional<typename PubSubType::type> decoded(const mcap::Message& message) {
  return bus::decode<PubSubType>({message.data.begin(), message.data.end()});
}

/// One run through a recording.
class Run {
 public:
  Run(const OccupancyGrid& map, const OfflineOptions& options) : localizer_(map, options.config) {}

  /// The robot is put down elsewhere: what comes now happened there, and its wheels did not turn meanwhile.
  void carry(const Kidnapping& kidnapping) {
    result.before_kidnapping = result.poses.size();
    later_ = kidnapping.lifted_at + kCarrying - kidnapping.put_down_at;
    lifted_ = last_odometry_;
    put_down_.reset();
  }

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
  /// The first robot of a recording is the one to localize.
  bool is_ours(const std::string& robot) {
    if (!robot_) robot_ = robot;
    return robot == *robot_;
  }
  void add_odometry(const msg::Odometry& message) {
    auto sample = from_message(message);
    if (!sample) {
      localizer_.add_fault(InputFault::OdometryNotFinite);
      return;
    }
    sample->time += later_;
    if (lifted_) {
      if (!put_down_) put_down_ = sample;
      sample->odom_from_base = lifted_->odom_from_base * inverse(put_down_->odom_from_base) * sample->odom_from_base;
      sample->epoch = lifted_->epoch;
    }
    if (last_odometry_ && last_odometry_->epoch == sample->epoch) {
      way_m_ += (sample->odom_from_base.position() - last_odometry_->odom_from_base.position()).norm();
    }
    last_odometry_ = sample;
    const double before = thread_cpu_ms();
    localizer_.add_odometry(*sample);
    spent_ms_ += thread_cpu_ms() - before;
  }
  /// An event is repeated until its receipt comes; it counts once.
  void add_hint(const msg::PoseHint& message) {
    if (!hints_.insert(message.id()).second) return;
    if (const auto hint = from_message(message)) localizer_.add_hint(*hint);
  }
  void add_scan(const msg::LaserScan& message) {
    auto scan = from_message(message);
    if (!scan) localizer_.add_fault(InputFault::ScanNotFinite);
    if (scan && lifted_ && !put_down_) return;  // nothing is known yet of the wheels there
    std::optional<LocalizationResult> pose;
    if (scan) {
      scan->time += later_;
      const double before = thread_cpu_ms();
      pose = localizer_.add_scan(*scan);
      spent_ms_ += thread_cpu_ms() - before;
    }
    result.faults = localizer_.faults();
    if (localizer_.setup_fault() == InputFault::MapScaleWrong) result.map_scale = localizer_.map_scale();
    if (!pose) return;
    result.update_ms.push_back(std::exchange(spent_ms_, 0.0));
    result.way_m.push_back(way_m_);
    result.poses.push_back({{pose->time - later_, pose->map_from_base}, pose->covariance, pose->status});
  }

  Localizer localizer_;
  std::optional<std::string> robot_;
  std::set<std::string> hints_;
  std::optional<OdometrySample> last_odometry_;
  double way_m_ = 0.0;
  double spent_ms_ = 0.0;                   ///< since the last pose
  Duration later_{};                        ///< what is added to the recording's times, after a kidnapping
  std::optional<OdometrySample> lifted_;    ///< where the wheels were then ...
  std::optional<OdometrySample> put_down_;  ///< ... and where they were in the recording at the other place
};

}  // namespace

OfflineResult localize_offline(mcap::Reader& recording, const OccupancyGrid& map, const OfflineOptions& options,
                               const std::function<bool(double)>& keep_going) {
  Run run{map, options};
  bool is_carried = false;
  for (std::size_t i = 0; i < recording.message_count(); ++i) {
    if (options.kidnapping && i == options.kidnapping->lifted && !is_carried) {
      is_carried = true;
      run.carry(*options.kidnapping);
      i = options.kidnapping->put_down;
    }
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

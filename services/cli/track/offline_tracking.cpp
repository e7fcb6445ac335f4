#include "services/cli/track/offline_tracking.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/cli/thread_time.hpp"
#include "services/tracking/core/pose_history.hpp"
#include "services/tracking/core/teammate.hpp"
#include "services/tracking/tracking_messages.hpp"

namespace tandem::cli {
namespace {

constexpr double kGate_m = 0.5;
constexpr Duration kMyPosePeriod = std::chrono::seconds{10};  // the paper's limit
constexpr Duration kHistory = std::chrono::seconds{5};

Pose2 pose_of(const msg::Pose& pose) {
  return {pose.x(), pose.y(), pose.heading()};
}

class Run {
 public:
  Run(const tracking::TrackingConfig& config, const std::vector<Annotation>& truth)
      : config_(config),
        truth_(truth),
        people_(config),
        teammate_(config),
        odom_from_base_(kHistory, from_seconds(config.max_extrapolation_s)) {}

  void add_odometry(const msg::Odometry& message) {
    has_odometry_ = true;
    odom_from_base_.add(from_stamp_ns(message.stamp_ns()), pose_of(message.odom_from_base()));
  }

  void add_scan(const tracking::LaserScan& scan) {
    score_until(scan.stamp);
    const auto at_start = frame_from_laser(scan.stamp, scan.base_from_laser);
    const auto at_end = frame_from_laser(scan.end(), scan.base_from_laser);
    if (!at_start || !at_end) return;
    const double before = thread_cpu_ms();
    people_.update(scan.stamp,
                   tracking::pair_legs(config_, tracking::find_legs(config_, scan, *at_start, *at_end, nullptr)));
    teammate_.see(scan.stamp, people_);
    result.scan_ms.push_back(thread_cpu_ms() - before);
    last_scan_ = scan.stamp;
    base_from_laser_ = scan.base_from_laser;
    if (truth_.empty()) result.people.add({}, found_at(scan.stamp));
  }

  /// Judges the annotations after the last scan, too.
  void finish() { score_until(Time::max()); }

  TrackingRun result;

 private:
  [[nodiscard]] std::optional<Pose2> frame_from_laser(Time time, const Pose2& base_from_laser) const {
    if (!has_odometry_) return Pose2{};
    const auto base = odom_from_base_.at(time);
    return base ? std::optional{*base * base_from_laser} : std::nullopt;
  }

  [[nodiscard]] std::vector<tracking::FoundPerson> found_at(Time time) const {
    std::vector<tracking::FoundPerson> found;
    for (const tracking::Track& track : people_.tracks()) {
      if (!track.person) continue;
      found.push_back({track.id, track.motion.position() + to_seconds(time - *last_scan_) * track.motion.velocity()});
    }
    return found;
  }

  /// Judges the annotations before `time` by what the scans before them showed.
  void score_until(Time time) {
    while (next_ < truth_.size() && truth_[next_].time < time) {
      const Time moment = truth_[next_].time;
      std::vector<tracking::AnnotatedPerson> annotated;
      const auto frame = !last_scan_ ? std::nullopt : frame_from_laser(moment, base_from_laser_);
      for (; next_ < truth_.size() && truth_[next_].time == moment; ++next_) {
        if (!frame) continue;
        annotated.push_back({truth_[next_].id, *frame * truth_[next_].position_in_laser});
      }
      if (annotated.empty()) continue;
      result.people.add(annotated, found_at(moment));
      follow(moment, annotated);
    }
  }

  void follow(Time moment, const std::vector<tracking::AnnotatedPerson>& annotated) {
    const auto person = std::find_if(annotated.begin(), annotated.end(),
                                     [&](const tracking::AnnotatedPerson& one) { return one.id == truth_.front().id; });
    if (person == annotated.end()) return;
    if (!pressed_ || moment - *pressed_ >= kMyPosePeriod) {
      pressed_ = moment;
      ++result.named;
      teammate_.hear({moment, person->position, std::nullopt}, people_);
    }
    const auto estimate = teammate_.estimate(moment);
    ++result.to_follow;
    if (!estimate) return;
    const double error = (estimate->map_from_agent.position() - person->position).norm();
    result.teammate_error_m.push_back(error);
    result.followed += error <= kGate_m ? 1 : 0;
  }

  tracking::TrackingConfig config_;
  const std::vector<Annotation>& truth_;
  std::size_t next_ = 0;
  std::optional<Time> pressed_;
  tracking::PeopleTracker people_;
  tracking::Teammate teammate_;
  tracking::PoseHistory odom_from_base_;
  bool has_odometry_ = false;
  std::optional<Time> last_scan_;
  Pose2 base_from_laser_;
};

template <class PubSubType>
std::optional<typename PubSubType::type> decoded(const mcap::Message& message) {
  return bus::decode<PubSubType>({message.data.begin(), message.data.end()});
}

}  // namespace

std::vector<Annotation> parse_annotations(std::string_view text, const std::string& file_name) {
  std::vector<Annotation> annotations;
  std::istringstream lines{std::string{text}};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (!line.starts_with("PERSON ")) continue;
    std::istringstream words{line.substr(7)};
    double time_s = 0.0;
    Annotation annotation;
    if (!(words >> time_s >> annotation.id >> annotation.position_in_laser.x() >> annotation.position_in_laser.y())) {
      throw std::runtime_error(file_name + ":" + std::to_string(number) + ": wanted is PERSON t id x y");
    }
    annotation.time = Time{} + from_seconds(time_s);
    annotations.push_back(annotation);
  }
  std::stable_sort(annotations.begin(), annotations.end(),
                   [](const Annotation& a, const Annotation& b) { return a.time < b.time; });
  return annotations;
}

TrackingRun track_offline(mcap::Reader& recording, const tracking::TrackingConfig& config,
                          const std::vector<Annotation>& truth, const std::function<bool(double)>& keep_going) {
  Run run{config, truth};
  for (std::size_t i = 0; i < recording.message_count(); ++i) {
    const auto message = recording.message_at(i);
    if (!message) continue;
    const std::string& topic = recording.channels().at(message->channel_id).topic;
    if (topic == topic::kOdometry.name) {
      if (const auto odometry = decoded<msg::OdometryPubSubType>(*message)) run.add_odometry(*odometry);
    } else if (topic == topic::kScan.name) {
      if (const auto scan = decoded<msg::LaserScanPubSubType>(*message)) run.add_scan(tracking::laser_scan(*scan));
    }
    if (!keep_going(static_cast<double>(i + 1) / static_cast<double>(recording.message_count()))) break;
  }
  run.finish();
  return run.result;
}

}  // namespace tandem::cli

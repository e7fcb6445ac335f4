#include "services/cli/kidnapping.hpp"

#include <algorithm>
#include <cmath>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/common/random.hpp"

namespace tandem::cli {
namespace {

constexpr double kLeastTimeAway_s = 10.0;
constexpr double kLeastTimeLeft_s = 20.0;
constexpr double kLeastWayAway_m = 3.0;
constexpr double kRight_m = 0.5;
constexpr double kRight_deg = 10.0;

struct ScanAt {
  std::size_t message = 0;
  Time time{};
};

std::vector<ScanAt> scans_of(mcap::Reader& recording) {
  std::vector<ScanAt> scans;
  for (std::size_t i = 0; i < recording.message_count(); ++i) {
    if (recording.channels().at(recording.channel_at(i)).topic != topic::kScan.name) continue;
    const auto message = recording.message_at(i);
    if (!message) continue;
    const auto scan = bus::decode<msg::LaserScanPubSubType>({message->data.begin(), message->data.end()});
    if (scan) scans.push_back({i, from_stamp_ns(scan->stamp_ns())});
  }
  return scans;
}

bool is_right(const Pose2& estimate, const Pose2& truth) {
  return (estimate.position() - truth.position()).norm() <= kRight_m &&
         std::abs(to_degrees(turn_between(estimate.heading, truth.heading))) <= kRight_deg;
}

}  // namespace

std::optional<Kidnapping> kidnapping_at(mcap::Reader& recording, Time time, std::span<const TimedPose> truth,
                                        std::uint64_t seed) {
  const std::vector<ScanAt> scans = scans_of(recording);
  const auto lifted = std::find_if(scans.begin(), scans.end(), [&](const ScanAt& scan) { return scan.time >= time; });
  if (lifted == scans.end()) return std::nullopt;
  const auto from = pose_at(truth, lifted->time);
  std::vector<ScanAt> places;
  for (const ScanAt& scan : scans) {
    if (std::abs(to_seconds(scan.time - lifted->time)) < kLeastTimeAway_s) continue;
    if (to_seconds(scans.back().time - scan.time) < kLeastTimeLeft_s) continue;
    const auto to = pose_at(truth, scan.time);
    if (!truth.empty() && !(from && to && (to->position() - from->position()).norm() >= kLeastWayAway_m)) continue;
    places.push_back(scan);
  }
  if (places.empty()) return std::nullopt;
  Rng rng{seed};
  const ScanAt& there = places[rng.index(places.size())];
  return Kidnapping{lifted->message, there.message, lifted->time, there.time};
}

Recovery recovery_of(std::span<const EstimatedPose> poses, std::span<const double> way_m, Time put_down_at,
                     std::span<const TimedPose> truth, double truth_offset_s) {
  Recovery recovery;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double since_s = to_seconds(poses[i].pose.time - put_down_at);
    const auto there = pose_at(truth, poses[i].pose.time + from_seconds(truth_offset_s));
    const bool ok = poses[i].status == LocalizationStatus::Ok;
    const bool right =
        truth.empty() ? recovery.flagged_s.has_value() : there && is_right(poses[i].pose.map_from_base, *there);
    if (!ok && !recovery.flagged_s) recovery.flagged_s = since_s;
    if (ok && !right && (truth.empty() || there)) ++recovery.ok_but_wrong;
    if (ok && right && !recovery.recovered_s) {
      recovery.recovered_s = since_s;
      recovery.recovered_m = way_m[i];
    }
  }
  return recovery;
}

}  // namespace tandem::cli

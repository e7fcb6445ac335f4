#include "services/tracking/tracker_service.hpp"

#include <spdlog/spdlog.h>

#include "services/tracking/tracking_messages.hpp"

namespace tandem::tracking {
namespace {

constexpr Duration kHistory = std::chrono::seconds{5};
constexpr std::size_t kMostWaiting = 20;  ///< scans

}  // namespace

TrackerService::TrackerService(const TrackingConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& clock)
    : config_(config),
      site_(site),
      bus_(bus),
      clock_(clock),
      health_(bus, site, "tracker"),
      scans_(bus.in_order(topic::kScan)),
      poses_(bus.in_order(topic::kRobotPose)),
      plans_(bus.in_order(topic::kTeamPlan)),
      maps_(bus.latest(topic::kMap)),
      messages_(bus, topic::kHumanMessage, "tracker"),
      people_writer_(bus.writer(topic::kPeople)),
      teammate_writer_(bus.writer(topic::kTeammates)),
      map_from_base_(kHistory, from_seconds(config.max_extrapolation_s)),
      people_(config),
      epoch_(clock.epoch()) {}

void TrackerService::begin_anew() {
  epoch_ = clock_.epoch();
  map_from_base_ = PoseHistory{kHistory, from_seconds(config_.max_extrapolation_s)};
  waiting_.clear();
  people_ = PeopleTracker{config_};
  teammates_.clear();
  plan_id_.clear();
  last_scan_ = tracked_at_ = people_published_ = next_teammates_ = {};
}

void TrackerService::step() {
  if (clock_.epoch() != epoch_) begin_anew();
  const Time now = clock_.now();
  take_map();
  for (const auto& pose : poses_.take()) {
    if (pose.message.robot() != site_.robot) continue;
    if (const auto map_from_base = usable_pose(pose.message)) {
      map_from_base_.add(from_stamp_ns(pose.message.stamp_ns()), *map_from_base);
    }
  }
  take_plan();
  take_scans();
  take_messages(now);
  publish_teammates(now);
  report_health(now);
}

void TrackerService::take_map() {
  constexpr double kFarEnough = 1.0;  // [m] distances beyond do not matter here
  const auto map = maps_.take_new();
  if (!map || map->message.sha256() == map_sha256_) return;
  const auto grid = occupancy_grid(map->message);
  if (!grid) {
    spdlog::warn("map refused: id={} reason=its size is not that of its cells", map->message.map_id());
    return;
  }
  map_ = DistanceField{*grid, kFarEnough};
  map_sha256_ = map->message.sha256();
  spdlog::info("map: id={} width={} height={}", map->message.map_id(), grid->width(), grid->height());
}

void TrackerService::take_messages(Time now) {
  for (const auto& message : messages_.take()) {
    if (message.robot() != site_.robot || message.kind() != msg::HUMAN_MY_POSE) {
      messages_.applied(message.id());  // concerns others; said to be done so that it is not repeated for us
      continue;
    }
    const PoseMessage pose = pose_message(message);
    const double age_s = to_seconds(now - pose.stamp);
    if (!pose.point_in_map.allFinite()) {
      messages_.refused(message.id(), "the point is not a place");
    } else if (age_s > config_.message_max_age_s) {
      messages_.refused(message.id(), "too old: the person has walked on");
    } else {
      auto [teammate, is_new] = teammates_.try_emplace(message.agent(), config_);
      if (is_new) plan_id_.clear();  // so that the plan is looked at again for the new one
      teammate->second.hear(pose, people_);
      messages_.applied(message.id());
      spdlog::info("message applied: id={} agent={} x={:.2f} y={:.2f} track={}", message.id(), message.agent(),
                   pose.point_in_map.x(), pose.point_in_map.y(), teammate->second.track_id().value_or(0));
    }
  }
}

void TrackerService::take_plan() {
  for (const auto& received : plans_.take()) {
    const auto& plan = received.message;
    if (plan.robot() != site_.robot || plan.state() != msg::PLAN_ACCEPTED || plan.id() == plan_id_) continue;
    plan_id_ = plan.id();
    for (auto& [agent, teammate] : teammates_) teammate.follow(accepted_path(plan, agent));
  }
}

void TrackerService::take_scans() {
  for (const auto& received : scans_.take()) {
    if (received.message.robot() != site_.robot) continue;
    waiting_.push_back({laser_scan(received.message), received.received});
    if (waiting_.size() > kMostWaiting) waiting_.pop_front();
  }
  while (!waiting_.empty()) {
    const WaitingScan& next = waiting_.front();
    const bool covered = map_from_base_.covers(next.scan.end());
    const double waited_s = to_seconds(bus_.clock().now() - next.received);
    const bool may_wait = bus_.pace() == bus::Pace::Lockstep || waited_s < config_.pose_wait_s;
    if (!covered && may_wait) return;
    if (next.scan.stamp > last_scan_) track(next.scan);
    waiting_.pop_front();
  }
}

void TrackerService::track(const LaserScan& scan) {
  const auto map_from_base = map_from_base_.at(scan.stamp);
  const auto map_from_base_at_end = map_from_base_.at(scan.end());
  if (!map_from_base || !map_from_base_at_end) return;  // nobody knows where this scan was taken
  last_scan_ = scan.stamp;
  tracked_at_ = clock_.now();

  const auto legs = find_legs(config_, scan, *map_from_base * scan.base_from_laser,
                              *map_from_base_at_end * scan.base_from_laser, map_.empty() ? nullptr : &map_);
  people_.update(scan.stamp, pair_legs(config_, legs));
  for (auto& [agent, teammate] : teammates_) teammate.see(scan.stamp, people_);

  constexpr double kEarly = 0.9;  // of a period: a scan that comes a little early is not left out
  if (to_seconds(scan.stamp - people_published_) < kEarly * config_.people_period_s) return;
  people_published_ = scan.stamp;
  people_writer_.write(tracked_people(people_.tracks(), site_.robot, scan.stamp, *map_from_base));
}

void TrackerService::publish_teammates(Time now) {
  if (now < next_teammates_) return;
  next_teammates_ = now + from_seconds(config_.teammates_period_s);
  for (const auto& [agent, teammate] : teammates_) {
    if (const auto estimate = teammate.estimate(now)) {
      teammate_writer_.write(teammate_state(*estimate, agent, site_.robot));
    }
  }
}

void TrackerService::report_health(Time now) {
  constexpr double kSilent = 1.0;  // [s]
  if (to_seconds(now - tracked_at_) > kSilent) {
    health_.step(msg::HEALTH_DEGRADED, "no scan with a pose of its time");
  } else if (map_.empty()) {
    health_.step(msg::HEALTH_DEGRADED, "no map: walls may be taken for people");
  } else {
    health_.step(msg::HEALTH_OK);
  }
}

}  // namespace tandem::tracking

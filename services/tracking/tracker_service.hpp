#pragma once

#include <deque>
#include <map>
#include <string>

#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/bus/health.hpp"
#include "services/mapping/core/distance_field.hpp"
#include "services/tracking/core/people_tracker.hpp"
#include "services/tracking/core/pose_history.hpp"
#include "services/tracking/core/teammate.hpp"

namespace tandem::tracking {

/// The tracker on the bus: every scan, in order, with the pose of its time; people and teammates out.
class TrackerService {
 public:
  TrackerService(const TrackingConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& clock);
  void step();

 private:
  struct WaitingScan {
    LaserScan scan;
    Time received;
  };

  void begin_anew();
  void take_map();
  void take_messages(Time now);
  void take_plan();
  void take_scans();
  void track(const LaserScan& scan);
  void publish_teammates(Time now);
  void report_health(Time now);

  TrackingConfig config_;
  SiteConfig site_;
  bus::Bus& bus_;
  Clock& clock_;
  bus::HealthReporter health_;

  bus::InOrder<msg::LaserScan, msg::LaserScanPubSubType> scans_;
  bus::InOrder<msg::RobotPose, msg::RobotPosePubSubType> poses_;
  bus::InOrder<msg::TeamPlan, msg::TeamPlanPubSubType> plans_;
  bus::Latest<msg::OccupancyGrid, msg::OccupancyGridPubSubType> maps_;
  bus::EventReceiver<msg::HumanMessage, msg::HumanMessagePubSubType> messages_;
  bus::Writer<msg::TrackedPeople, msg::TrackedPeoplePubSubType> people_writer_;
  bus::Writer<msg::TeammateState, msg::TeammateStatePubSubType> teammate_writer_;

  std::string map_sha256_;
  DistanceField map_;  ///< empty until there is a map
  PoseHistory map_from_base_;
  std::deque<WaitingScan> waiting_;
  PeopleTracker people_;
  std::map<std::string, Teammate> teammates_;  ///< by agent
  std::string plan_id_;                        ///< of the plan the teammates are thought to follow
  Time last_scan_{};                           ///< stamp of the last scan that was tracked
  Time tracked_at_{};
  Time people_published_{};
  Time next_teammates_{};
  int epoch_ = 0;
};

}  // namespace tandem::tracking

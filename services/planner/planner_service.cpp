#include "services/planner/planner_service.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include "services/planner/core/mission/planner_lease.hpp"
#include "services/planner/edit_messages.hpp"
#include "services/planner/planner_messages.hpp"

namespace tandem {
namespace {

constexpr Duration kPlanPeriod = std::chrono::seconds{1};  ///< a plan not refreshed for 2 s is dead
constexpr Duration kBeliefPeriod = std::chrono::seconds{1};
constexpr Duration kStatusPeriod = std::chrono::milliseconds{200};  ///< while computing
constexpr std::uint64_t kNsPerMs = 1'000'000;

const char* name_of(PlanStanding standing) {
  switch (standing) {
    case PlanStanding::None:
      return "none";
    case PlanStanding::Proposed:
      return "proposed";
    case PlanStanding::Accepted:
      return "accepted";
    case PlanStanding::Rejected:
      return "rejected";
    case PlanStanding::Superseded:
      return "superseded";
    case PlanStanding::Expired:
      break;
  }
  return "expired";
}

/// Writes what is new or has changed since `published`, and disposes of what is gone.
template <typename Key, typename Value, typename Writer>
void publish_changes(std::map<Key, Value> current, std::map<Key, Value>& published, Writer& writer) {
  for (const auto& [key, value] : published) {
    if (!current.contains(key)) writer.dispose(to_message(value));
  }
  for (const auto& [key, value] : current) {
    const auto before = published.find(key);
    if (before == published.end() || !(before->second == value)) writer.write(to_message(value));
  }
  published = std::move(current);
}

}  // namespace

PlannerService::PlannerService(const PlannerConfig& config, const SiteConfig& site, MapZones zones, bus::Bus& bus,
                               const Clock& clock)
    : config_(config),
      site_(site),
      clock_(clock),
      mission_(config, site.robot, site.agent),
      zones_(std::move(zones)),
      identity_(site.host + "/" + std::to_string(::getpid())),
      map_(bus.latest(topic::kMap)),
      robot_pose_(bus.latest(topic::kRobotPose)),
      teammates_(bus.latest(topic::kTeammates)),
      session_(bus.latest(topic::kSession)),
      execution_(bus.latest(topic::kPlanExecution)),
      human_messages_(bus, topic::kHumanMessage, "planner"),
      belief_edits_(bus, topic::kBeliefEdit, "planner"),
      source_edits_(bus, topic::kSourceEdit, "planner"),
      detections_(bus, topic::kDetection, "planner"),
      team_plan_(bus.writer(topic::kTeamPlan)),
      status_(bus.writer(topic::kPlannerStatus)),
      belief_(bus.writer(topic::kBelief)),
      reward_source_(bus.writer(topic::kRewardSource)),
      source_relation_(bus.writer(topic::kSourceRelation)),
      informs_(bus, topic::kInform, from_seconds(config.inform_life_s)),
      health_(bus, site, "planner"),
      sequence_number_(static_cast<std::uint64_t>(to_stamp_ns(clock.now())) / kNsPerMs) {}

void PlannerService::step() {
  const Time now = clock_.now();
  read_world();
  read_session(now);
  read_events(now);
  read_edits(now);
  const bool new_plan = mission_.step(now, [&] { return to_seconds(clock_.now() - now) > config_.slice_s; });
  if (new_plan) {
    const MissionPlan& plan = *mission_.plan();
    spdlog::info("plan proposed: id={} reason=\"{}\" expected_time_s={:.1f} agents={}", plan.id, plan.reason,
                 plan.forecast.expected_time_s, plan.members.size());
  }
  const Time done = clock_.now();
  computing_s_ =
      mission_.activity() == MissionActivity::Computing || new_plan ? computing_s_ + to_seconds(done - now) : 0.0;
  publish_plan(done);
  publish_status(done);
  publish_belief(done);
  publish_sources();
  tell_person(done);
  const bool failed = mission_.activity() == MissionActivity::Failed;
  health_.step(failed || !zone_trouble_.empty() ? msg::HEALTH_DEGRADED : msg::HEALTH_OK,
               failed ? mission_.failure() : zone_trouble_);
  if (mission_.certify()) plan_due_ = done;  // told with the plan's next refresh, at once
}

void PlannerService::read_world() {
  if (const auto map = map_.take_new()) {
    if (auto grid = to_core(map->message)) {
      spdlog::info("map received: id={} width={} height={}", map->message.map_id(), grid->width(), grid->height());
      const bool zones_count = zones_.areas.empty() || zones_.map_sha256 == map->message.sha256();
      zone_trouble_ =
          zones_count ? "" : "the hard zones of this host are of another map, and the plans do not mind them";
      if (!zones_count) spdlog::warn("{}: map={}", zone_trouble_, map->message.map_id());
      mission_.set_map(std::move(*grid), zones_count ? zones_.areas : std::vector<MapArea>{});
    } else {
      spdlog::warn("map refused: id={}", map->message.map_id());
    }
  }
  for (const auto& pose : robot_pose_.each()) {
    if (pose.message.robot() != site_.robot || pose.message.status() == msg::LOCALIZATION_LOST) continue;
    if (const auto map_from_base = to_core(pose.message.map_from_base())) {
      mission_.robot_at(from_stamp_ns(pose.message.stamp_ns()), *map_from_base);
    }
  }
  for (const auto& teammate : teammates_.each()) {
    if (teammate.message.agent() != site_.agent || teammate.message.robot() != site_.robot) continue;
    if (const auto map_from_agent = to_core(teammate.message.map_from_agent())) {
      const double age_s = teammate.message.state() == msg::TRACK_TRACKED ? 0.0 : teammate.message.age_s();
      mission_.person_at(from_stamp_ns(teammate.message.stamp_ns()), *map_from_agent, age_s);
    }
  }
  for (const auto& execution : execution_.each()) {
    if (execution.message.robot() == site_.robot) mission_.robot_progress(to_core(execution.message), clock_.now());
  }
}

void PlannerService::read_session(Time now) {
  for (const auto& session : session_.each()) {
    if (session.message.robot() != site_.robot) continue;
    // Whoever led it and is gone can no longer end it.
    running_ = session.message.phase() == msg::SESSION_RUNNING && session.writer_alive;
    if (running_) {
      session_code_ = session.message.code();
      mission_.run_session(session_code_, now);
    } else {
      mission_.end_session();
    }
  }
}

void PlannerService::read_events(Time now) {
  for (const auto& message : human_messages_.take()) {
    if (message.robot() != site_.robot || message.agent() != site_.agent) {
      human_messages_.refused(message.id(), "of another team");
      continue;
    }
    const auto request = to_core(message);
    const auto refusal = request ? mission_.request(*request, now) : std::optional<std::string>{"not understood"};
    if (refusal) {
      spdlog::info("message refused: id={} reason=\"{}\"", message.id(), *refusal);
      human_messages_.refused(message.id(), *refusal);
    } else {
      spdlog::info("message applied: id={}", message.id());
      human_messages_.applied(message.id());
    }
  }
  for (const auto& detection : detections_.take()) {
    if (detection.robot() != site_.robot) {
      detections_.refused(detection.id(), "of another team");
    } else if (!running_) {
      detections_.refused(detection.id(), "no search is running");
    } else {
      spdlog::info("object found: by={} x_m={:.2f} y_m={:.2f}", detection.detected_by(), detection.point_in_map().x(),
                   detection.point_in_map().y());
      mission_.found();
      detections_.applied(detection.id());
    }
  }
}

void PlannerService::read_edits(Time now) {
  const auto answer = [&](auto& events, const auto& event, auto apply) {
    std::optional<std::string> refusal = "of another team";
    if (event.robot() == site_.robot) {
      const auto edit = to_core(event);
      refusal = edit ? apply(*edit) : std::optional<std::string>{"not understood"};
    }
    if (refusal) {
      spdlog::info("edit refused: id={} who={} reason=\"{}\"", event.id(), event.who(), *refusal);
      events.refused(event.id(), *refusal);
    } else {
      spdlog::info("edit applied: id={} who={}", event.id(), event.who());
      events.applied(event.id());
    }
  };
  for (const auto& event : belief_edits_.take()) {
    answer(belief_edits_, event, [&](const BeliefEdit& edit) { return mission_.edit_belief(edit); });
  }
  for (const auto& event : source_edits_.take()) {
    answer(source_edits_, event, [&](const SourceEdit& edit) { return mission_.edit_source(edit, now); });
  }
}

void PlannerService::publish_plan(Time now) {
  if (!mission_.plan()) return;
  const PlanStanding standing = mission_.standing(now);
  const bool holds = standing == PlanStanding::Proposed || standing == PlanStanding::Accepted;
  const bool is_news = mission_.plan()->id != published_plan_ || standing != published_standing_;
  if (!is_news && (!holds || now < plan_due_)) return;
  if (is_news && standing != PlanStanding::Proposed)
    spdlog::info("plan {}: id={}", name_of(standing), mission_.plan()->id);
  team_plan_.write(
      to_message(*mission_.plan(), standing, {site_.robot, session_code_, identity_, ++sequence_number_, now}));
  published_plan_ = mission_.plan()->id;
  published_standing_ = standing;
  plan_due_ = now + kPlanPeriod;
}

void PlannerService::publish_status(Time now) {
  const bool is_news = published_activity_ != mission_.activity();
  const bool computing = mission_.activity() == MissionActivity::Computing;
  if (!is_news && (!computing || now < status_due_)) return;
  if (is_news && mission_.activity() == MissionActivity::Failed) {
    spdlog::warn("no plan: reason=\"{}\"", mission_.failure());
  }
  status_.write(status_message(mission_, site_.robot, computing_s_, now));
  published_activity_ = mission_.activity();
  status_due_ = now + kStatusPeriod;
}

void PlannerService::publish_belief(Time now) {
  if (mission_.area() == nullptr || mission_.belief() == nullptr || now < belief_due_) return;
  belief_.write(belief_message(mission_, site_.robot, now));
  belief_due_ = now + kBeliefPeriod;
}

void PlannerService::publish_sources() {
  std::map<std::string, RewardSource> sources;
  for (RewardSource& source : mission_.sources()) sources.emplace(source.id, std::move(source));
  publish_changes(std::move(sources), published_sources_, reward_source_);
  std::map<std::pair<std::string, std::string>, Relation> relations;
  for (const Relation& relation : mission_.relations()) relations[{relation.from, relation.to}] = relation;
  publish_changes(std::move(relations), published_relations_, source_relation_);
}

void PlannerService::tell_person(Time now) {
  informs_.step();
  if (!told_id_.empty() && informs_.outcome(told_id_).state == bus::EventOutcome::State::Applied) {
    spdlog::info("person informed: id={}", told_id_);
    mission_.inform_heard(told_number_);
    told_id_.clear();
  }
  const auto& inform = mission_.inform();
  if (!inform || inform->number == told_number_) return;
  msg::Inform message;
  message.agent(site_.agent);
  message.id(bus::new_event_id("planner", clock_));
  message.stamp_ns(to_stamp_ns(now));
  message.source_id(inform->source_id);
  message.reason(inform->reason);
  spdlog::info("informing person: id={} source={} reason=\"{}\"", message.id(), inform->source_id, inform->reason);
  informs_.send(message);
  told_number_ = inform->number;
  told_id_ = message.id();
}

std::string other_planner(const SiteConfig& site, bus::Bus& bus, Duration listen) {
  auto heartbeats = bus.in_order(topic::kServiceHealth);
  bus::HealthReporter starting(bus, site, "planner");
  const PlannerIdentity self{site.host, static_cast<std::uint32_t>(::getpid())};
  std::string refusal;
  bus::wait_until(bus, listen, [&] {
    starting.step(msg::HEALTH_STARTING);
    std::vector<PlannerHeartbeat> heard;
    for (const auto& heartbeat : heartbeats.take()) {
      if (heartbeat.message.service() != "planner") continue;
      heard.push_back({{heartbeat.message.host(), heartbeat.message.process_id()},
                       heartbeat.message.robot(),
                       heartbeat.message.state() == msg::HEALTH_STARTING});
    }
    refusal = refusal_to_plan(site.robot, self, heard);
    return !refusal.empty();
  });
  return refusal;
}

}  // namespace tandem

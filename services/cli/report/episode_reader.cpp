#include "services/cli/report/episode_reader.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/bus/stop_reasons.hpp"
#include "services/common/time.hpp"
#include "services/mapping/map_messages.hpp"

namespace tandem::cli {
namespace {

using Eigen::Vector2d;
using experiment::EpisodeLog;

constexpr double kSamePerson_m = 0.7;  ///< a tracked person this near to the teammate is the teammate

Pose2 pose_of(const msg::Pose& pose) {
  return {pose.x(), pose.y(), pose.heading()};
}
Vector2d point_of(const msg::Point2& point) {
  return {point.x(), point.y()};
}

std::string word_of(msg::HumanMessageKind kind) {
  switch (kind) {
    case msg::HUMAN_MY_POSE:
      return "my_pose";
    case msg::HUMAN_MY_GOAL:
      return "my_goal";
    case msg::HUMAN_ROBOT_GOAL:
      return "robot_goal";
    case msg::HUMAN_REPLAN:
      return "replan";
    case msg::HUMAN_CLEAR_MY_GOAL:
      return "clear_my_goal";
    case msg::HUMAN_CLEAR_ROBOT_GOAL:
      return "clear_robot_goal";
  }
  return "unknown";
}

experiment::PlanAt::State state_of(msg::PlanState state) {
  using State = experiment::PlanAt::State;
  switch (state) {
    case msg::PLAN_PROPOSED:
      return State::Proposed;
    case msg::PLAN_ACCEPTED:
      return State::Accepted;
    case msg::PLAN_REJECTED:
      return State::Rejected;
    case msg::PLAN_SUPERSEDED:
      break;
  }
  return State::Superseded;
}

Role role_of(msg::CollaborationRole role) {
  switch (role) {
    case msg::ROLE_LEADER_FOLLOWER:
      return Role::LeaderFollower;
    case msg::ROLE_PEER_PEER:
      return Role::PeerPeer;
    case msg::ROLE_MASTER_SLAVE:
      return Role::MasterSlave;
    case msg::ROLE_LEADER_LEADER:
      break;
  }
  return Role::LeaderLeader;
}

/// A session, while its messages are gathered.
struct Session {
  msg::SessionState state;  ///< as it ran
  std::int64_t began_ns = 0;
  std::optional<std::int64_t> ended_ns;
  std::string outcome;
  EpisodeLog log;
  std::set<std::string> ids;                        ///< of events that are in
  std::map<std::string, msg::PlanState> standings;  ///< of plans, by id
  std::optional<std::uint32_t> collisions_before;
  bool has_truth_of_person = false;
  bool has_truth_of_others = false;
};

template <class PubSubType>
std::optional<typename PubSubType::type> decoded(const mcap::Message& message) {
  return bus::decode<PubSubType>({message.data.begin(), message.data.end()});
}

/// Takes the messages of one recording in and tells them apart by session.
class Gathering {
 public:
  void add_session(const msg::SessionState& state) {
    if (state.phase() == msg::SESSION_PREPARING || state.started_ns() == 0) return;
    auto session = std::ranges::find(sessions_, state.started_ns(), &Session::began_ns);
    if (session == sessions_.end()) {
      sessions_.emplace_back();
      sessions_.back().state = state;
      sessions_.back().began_ns = state.started_ns();
      session = sessions_.end() - 1;
    }
    if (state.phase() != msg::SESSION_ENDED) return;
    session->ended_ns = state.ended_ns();
    session->outcome = state.outcome();
  }
  void sort_sessions() { std::ranges::sort(sessions_, {}, &Session::began_ns); }
  [[nodiscard]] const std::vector<Session>& sessions() const { return sessions_; }

  void add(const std::string& topic, const mcap::Message& message) {
    last_ns_ = std::max(last_ns_, static_cast<std::int64_t>(message.publish_time));
    if (topic == topic::kMap.name) {
      if (const auto map = decoded<msg::OccupancyGridPubSubType>(message)) map_ = to_grid(*map);
    } else if (topic == topic::kHumanMessage.name) {
      if (const auto press = decoded<msg::HumanMessagePubSubType>(message)) add_press(*press);
    } else if (topic == topic::kTeamPlan.name) {
      if (const auto plan = decoded<msg::TeamPlanPubSubType>(message)) add_plan(*plan);
    } else if (topic == topic::kBelief.name) {
      if (const auto belief = decoded<msg::SearchBeliefPubSubType>(message)) add_belief(*belief);
    } else if (topic == topic::kRobotPose.name) {
      if (const auto pose = decoded<msg::RobotPosePubSubType>(message)) add_robot(*pose);
    } else if (topic == topic::kTeammates.name) {
      if (const auto teammate = decoded<msg::TeammateStatePubSubType>(message)) add_teammate(*teammate);
    } else if (topic == topic::kPeople.name) {
      if (const auto people = decoded<msg::TrackedPeoplePubSubType>(message)) add_people(*people);
    } else if (topic == topic::kGroundTruth.name) {
      if (const auto truth = decoded<msg::GroundTruthPubSubType>(message)) add_truth(*truth);
    } else if (topic == topic::kBaseStatus.name) {
      if (const auto base = decoded<msg::BaseStatusPubSubType>(message)) add_base(*base);
    } else if (topic == topic::kLinkStatus.name) {
      if (const auto link = decoded<msg::LinkStatusPubSubType>(message)) add_link(*link);
    } else if (topic == topic::kReminder.name) {
      if (const auto reminder = decoded<msg::ReminderEventPubSubType>(message)) add_reminder(*reminder);
    } else if (topic == topic::kQuestionnaireAnswer.name) {
      if (const auto answer = decoded<msg::QuestionnaireAnswerPubSubType>(message)) add_answer(*answer);
    } else if (topic == topic::kDetection.name) {
      if (const auto detection = decoded<msg::ObjectDetectionPubSubType>(message)) add_detection(*detection);
    }
  }

  std::vector<EpisodeLog> finish(const std::string& name) {
    std::vector<EpisodeLog> logs;
    for (Session& session : sessions_) {
      complete(session, name);
      logs.push_back(std::move(session.log));
    }
    return logs;
  }

 private:
  /// The session that runs at `stamp_ns`; null in none.
  Session* running_at(std::int64_t stamp_ns) {
    for (Session& session : sessions_) {
      if (session.began_ns <= stamp_ns && stamp_ns <= session.ended_ns.value_or(last_of_all())) return &session;
    }
    return nullptr;
  }
  /// The session that runs at `stamp_ns`, or else the next one.
  Session* running_or_next(std::int64_t stamp_ns) {
    for (Session& session : sessions_) {
      if (stamp_ns <= session.ended_ns.value_or(last_of_all())) return &session;
    }
    return nullptr;
  }
  /// The last that had begun at `stamp_ns`; null before the first.
  Session* begun_at(std::int64_t stamp_ns) {
    Session* last = nullptr;
    for (Session& session : sessions_) {
      if (session.began_ns <= stamp_ns) last = &session;
    }
    return last;
  }
  static std::int64_t last_of_all() { return std::numeric_limits<std::int64_t>::max(); }
  static double seconds_in(const Session& session, std::int64_t stamp_ns) {
    return static_cast<double>(stamp_ns - session.began_ns) * 1e-9;
  }

  void add_press(const msg::HumanMessage& press) {
    Session* session = running_or_next(press.stamp_ns());
    if (session == nullptr || press.robot() != session->state.robot() || !session->ids.insert(press.id()).second)
      return;
    experiment::PressAt at{.time_s = seconds_in(*session, press.stamp_ns()), .kind = word_of(press.kind())};
    if (press.kind() == msg::HUMAN_MY_POSE || press.kind() == msg::HUMAN_MY_GOAL ||
        press.kind() == msg::HUMAN_ROBOT_GOAL) {
      at.point_in_map = point_of(press.point_in_map());
    }
    session->log.presses.push_back(std::move(at));
  }

  void add_plan(const msg::TeamPlan& plan) {
    Session* session = running_at(plan.stamp_ns());
    if (session == nullptr || plan.robot() != session->state.robot()) return;
    for (experiment::PlanAt& known : session->log.plans) {  // the bound is found after the plan is out
      if (known.id == plan.id()) known.lower_bound_s = std::max(known.lower_bound_s, plan.lower_bound_s());
    }
    const auto [told, is_new] = session->standings.try_emplace(plan.id(), plan.state());
    if (!is_new && told->second == plan.state()) return;  // told again, for those who did not hear it
    told->second = plan.state();
    experiment::PlanAt at{.time_s = seconds_in(*session, plan.stamp_ns()),
                          .id = plan.id(),
                          .state = state_of(plan.state()),
                          .role = role_of(plan.role()),
                          .expected_time_s = plan.value(),
                          .lower_bound_s = plan.lower_bound_s()};
    for (const auto& path : plan.paths()) {
      experiment::PlanAt::Path way{.agent = path.agent()};
      for (const auto& point : path.points()) {
        way.times_s.push_back(seconds_in(*session, point.stamp_ns()));
        way.points_in_map.emplace_back(point.x_m(), point.y_m());
      }
      at.paths.push_back(std::move(way));
    }
    session->log.plans.push_back(std::move(at));
  }

  void add_belief(const msg::SearchBelief& message) {
    Session* session = running_at(message.stamp_ns());
    if (session == nullptr || message.robot() != session->state.robot()) return;
    experiment::BeliefAt belief;
    belief.time_s = seconds_in(*session, message.stamp_ns());
    belief.explored = message.explored();
    for (const auto& share : message.explored_by()) {
      (share.agent() == session->state.robot() ? belief.explored_robot : belief.explored_human) += share.share();
    }
    belief.probability_left = message.probability_left();
    if (static_cast<std::size_t>(message.width()) * message.height() == message.cells().size()) {
      belief.width = static_cast<int>(message.width());
      belief.height = static_cast<int>(message.height());
      belief.resolution_m = message.resolution_m();
      belief.origin_in_map = point_of(message.origin_in_map());
      belief.peak = message.peak();
      belief.cells = message.cells();
    }
    session->log.beliefs.push_back(std::move(belief));
  }

  void add_robot(const msg::RobotPose& pose) {
    Session* session = running_at(pose.stamp_ns());
    if (session == nullptr || pose.robot() != session->state.robot()) return;
    session->log.robot_poses.push_back({seconds_in(*session, pose.stamp_ns()), pose_of(pose.map_from_base())});
  }

  void add_teammate(const msg::TeammateState& teammate) {
    Session* session = running_at(teammate.stamp_ns());
    if (session == nullptr || teammate.agent() != session->state.agent()) return;
    if (session->has_truth_of_person || teammate.state() != msg::TRACK_TRACKED) return;
    session->log.human_poses.push_back({seconds_in(*session, teammate.stamp_ns()), pose_of(teammate.map_from_agent())});
  }

  void add_people(const msg::TrackedPeople& people) {
    Session* session = running_at(people.stamp_ns());
    if (session == nullptr || people.robot() != session->state.robot() || session->has_truth_of_others) return;
    experiment::PassersByAt at{.time_s = seconds_in(*session, people.stamp_ns())};
    for (const auto& person : people.people()) {
      const Vector2d point = point_of(person.position_in_map());
      const auto& teammate = session->log.human_poses;
      if (!teammate.empty() && (teammate.back().map_from_agent.position() - point).norm() < kSamePerson_m) continue;
      at.points_in_map.push_back(point);
    }
    if (!at.points_in_map.empty()) session->log.passers_by.push_back(std::move(at));
  }

  void add_truth(const msg::GroundTruth& truth) {
    Session* session = running_at(truth.stamp_ns());
    if (session == nullptr) return;
    EpisodeLog& log = session->log;
    const double time_s = seconds_in(*session, truth.stamp_ns());
    experiment::PassersByAt others{.time_s = time_s};
    for (const auto& person : truth.people()) {
      if (person.id() != session->state.agent()) {
        others.points_in_map.push_back(pose_of(person.map_from_agent()).position());
        continue;
      }
      if (!session->has_truth_of_person) log.human_poses.clear();  // what was tracked before the first truth
      session->has_truth_of_person = true;
      log.human_poses.push_back({time_s, pose_of(person.map_from_agent())});
    }
    if (!session->has_truth_of_others) log.passers_by.clear();
    session->has_truth_of_others = true;
    if (!others.points_in_map.empty()) log.passers_by.push_back(std::move(others));
    if (!truth.objects().empty()) log.object_in_map = point_of(truth.objects().front().position_in_map());
    if (!session->collisions_before) session->collisions_before = truth.collisions();
    log.collisions = truth.collisions() - std::min(*session->collisions_before, truth.collisions());
  }

  void add_base(const msg::BaseStatus& status) {
    Session* session = running_at(status.stamp_ns());
    if (session == nullptr || status.robot() != session->state.robot()) return;
    experiment::BaseAt base{.time_s = seconds_in(*session, status.stamp_ns()),
                            .speed_limit_mps = status.speed_limit_mps(),
                            .latched = status.latched()};
    for (const auto reason : status.stop_reasons()) base.stop_reasons.push_back(bus::words_of(reason));
    session->log.base.push_back(std::move(base));
  }

  void add_link(const msg::LinkStatus& status) {
    Session* session = running_at(status.stamp_ns());
    if (session == nullptr || status.peer().empty()) return;
    session->log.link.push_back(
        {seconds_in(*session, status.stamp_ns()), status.up(), status.round_trip_s(), status.loss()});
  }

  void add_reminder(const msg::ReminderEvent& reminder) {
    Session* session = running_at(reminder.stamp_ns());
    if (session == nullptr || !session->ids.insert(reminder.id()).second) return;
    session->log.reminders.push_back({seconds_in(*session, reminder.stamp_ns()), reminder.kind(), reminder.obeyed()});
  }

  void add_answer(const msg::QuestionnaireAnswer& answer) {
    Session* session = begun_at(answer.stamp_ns());
    if (session == nullptr || answer.question().starts_with("layer ")) return;  // a layer shown or hidden is no answer
    session->log.fields[answer.question()] = answer.answer();
  }

  void add_detection(const msg::ObjectDetection& detection) {
    Session* session = running_at(detection.stamp_ns());
    if (session == nullptr || detection.robot() != session->state.robot() || !session->log.found_by.empty()) return;
    session->log.found_by = detection.detected_by();
    if (!session->log.object_in_map) session->log.object_in_map = point_of(detection.point_in_map());
  }

  void complete(Session& session, const std::string& name) const {
    EpisodeLog& log = session.log;
    log.name = sessions_.size() == 1 ? name : name + " " + session.state.code();
    log.code = session.state.code();
    log.started_ns = session.began_ns;
    log.human_is_true = session.has_truth_of_person;
    log.robot = session.state.robot();
    log.agent = session.state.agent();
    log.fields["condition"] = session.state.condition();
    log.fields["reminder"] = session.state.reminder();
    log.fields["mode"] = session.state.mode();
    log.outcome = session.outcome;
    log.duration_s = std::max(0.0, seconds_in(session, session.ended_ns.value_or(last_ns_)));
    log.map = map_;
    if (!log.found()) log.found_by.clear();
    std::ranges::stable_sort(log.presses, {}, &experiment::PressAt::time_s);
    std::ranges::stable_sort(log.plans, {}, &experiment::PlanAt::time_s);
    std::ranges::stable_sort(log.beliefs, {}, &experiment::BeliefAt::time_s);
    std::ranges::stable_sort(log.robot_poses, {}, &experiment::PoseAt::time_s);
    std::ranges::stable_sort(log.human_poses, {}, &experiment::PoseAt::time_s);
    std::ranges::stable_sort(log.base, {}, &experiment::BaseAt::time_s);
    std::ranges::stable_sort(log.link, {}, &experiment::LinkAt::time_s);
  }

  std::vector<Session> sessions_;
  std::optional<OccupancyGrid> map_;
  std::int64_t last_ns_ = 0;
};

const std::string& topic_at(const mcap::Reader& recording, std::size_t index) {
  return recording.channels().at(recording.channel_at(index)).topic;
}

Gathering with_sessions(mcap::Reader& recording) {
  Gathering gathering;
  for (std::size_t i = 0; i < recording.message_count(); ++i) {
    if (topic_at(recording, i) != topic::kSession.name) continue;
    const auto message = recording.message_at(i);
    if (!message) continue;
    if (const auto state = decoded<msg::SessionStatePubSubType>(*message)) gathering.add_session(*state);
  }
  gathering.sort_sessions();
  return gathering;
}

}  // namespace

std::vector<EpisodeLog> read_episodes(mcap::Reader& recording, const std::string& name,
                                      const std::function<bool(double)>& keep_going) {
  Gathering gathering = with_sessions(recording);
  if (gathering.sessions().empty()) return {};
  for (std::size_t i = 0; i < recording.message_count(); ++i) {
    if (const auto message = recording.message_at(i)) gathering.add(topic_at(recording, i), *message);
    if (!keep_going(static_cast<double>(i + 1) / static_cast<double>(recording.message_count()))) return {};
  }
  return gathering.finish(name);
}

std::vector<RecordedSession> read_sessions(mcap::Reader& recording) {
  std::vector<RecordedSession> sessions;
  const Gathering gathering = with_sessions(recording);
  for (const Session& session : gathering.sessions()) {
    const double duration_s = session.ended_ns ? static_cast<double>(*session.ended_ns - session.began_ns) * 1e-9 : 0.0;
    sessions.push_back({session.state.code(), session.state.condition(), session.state.agent(), session.began_ns,
                        duration_s, session.outcome});
  }
  return sessions;
}

}  // namespace tandem::cli

#include "services/experiment/core/report/episode_log.hpp"

#include <utility>

namespace tandem::experiment {
namespace {

template <class Item>
void keep_longer(std::vector<Item>& kept, std::vector<Item>& other) {
  if (other.size() > kept.size()) kept = std::move(other);
}

}  // namespace

bool is_same_search(const EpisodeLog& a, const EpisodeLog& b) {
  return a.robot == b.robot && a.code == b.code && a.started_ns == b.started_ns;
}

EpisodeLog merged(EpisodeLog a, EpisodeLog b) {
  if (a.outcome.empty()) {  // its recording ended before the session did
    a.outcome = b.outcome;
    a.duration_s = b.duration_s;
  }
  if (a.found_by.empty()) a.found_by = b.found_by;
  if (b.object_in_map && (!a.object_in_map || b.human_is_true)) a.object_in_map = b.object_in_map;
  if (!a.map) a.map = std::move(b.map);
  if (b.human_is_true == a.human_is_true) {
    keep_longer(a.human_poses, b.human_poses);
  } else if (b.human_is_true) {
    a.human_poses = std::move(b.human_poses);
    a.passers_by = std::move(b.passers_by);
    a.human_is_true = true;
    a.collisions = b.collisions;
  }
  a.fields.merge(b.fields);
  keep_longer(a.presses, b.presses);
  keep_longer(a.plans, b.plans);
  keep_longer(a.beliefs, b.beliefs);
  keep_longer(a.robot_poses, b.robot_poses);
  keep_longer(a.base, b.base);
  keep_longer(a.link, b.link);
  keep_longer(a.reminders, b.reminders);
  if (a.human_is_true == b.human_is_true) keep_longer(a.passers_by, b.passers_by);
  return a;
}

std::vector<std::string> gaps_of(const EpisodeLog& episode) {
  std::vector<std::string> gaps;
  if (episode.outcome.empty()) gaps.push_back("the recording ends before the session does");
  if (episode.beliefs.empty()) gaps.push_back("no belief: what was explored is not known");
  if (episode.robot_poses.empty()) gaps.push_back("no robot_pose: the robot's way is not known");
  if (episode.human_poses.empty()) {
    gaps.push_back("neither teammates nor ground_truth: the person's way is not known");
  } else if (!episode.human_is_true) {
    gaps.push_back("the person's way is as tracked");
  }
  if (episode.base.empty()) gaps.push_back("no base_status: stops are not known");
  if (!episode.map) gaps.push_back("no map");
  return gaps;
}

}  // namespace tandem::experiment

#include "services/cli/study/study_run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "services/cli/study/study_recorder.hpp"
#include "services/cli/thread_time.hpp"
#include "services/recorder/recording_file.hpp"

namespace tandem::cli {
namespace {

/// The work that is left, and what becomes of it; shared by the threads.
struct Work {
  std::vector<std::uint64_t> seeds;
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;

  std::mutex mutex;  ///< of all below
  std::condition_variable changed;
  StudyFile* file = nullptr;
  std::uint64_t finished = 0;
  unsigned at_work = 0;
  std::exception_ptr failure;
};

std::optional<experiment::PlanningTime> planning_time(double budget_ms, double& began_ms) {
  if (budget_ms <= 0.0) return std::nullopt;
  return experiment::PlanningTime{[&began_ms] { began_ms = thread_cpu_ms(); },
                                  [&began_ms, budget_ms] { return thread_cpu_ms() - began_ms >= budget_ms; }};
}

std::optional<experiment::EpisodeResult> play_one(const StudyPlan& plan, experiment::EpisodeWorld& world,
                                                  std::uint64_t seed,
                                                  const std::optional<experiment::PlanningTime>& time,
                                                  const std::function<bool()>& stop) {
  if (plan.recordings.empty()) return world.play(plan.human, seed, time, stop);
  std::optional<experiment::EpisodeResult> result;
  struct GivenUp {};
  try {
    recorder::write_recording(study_recording(plan, seed), [&](mcap::Writer& writer) {
      StudyRecorder recorder{writer, plan.map, {}, plan.human, plan.scenario.name + "-" + std::to_string(seed)};
      result = world.play(plan.human, seed, time, stop, &recorder);
      if (!result) throw GivenUp{};  // half an episode is not kept
    });
  } catch (const GivenUp&) {
    return std::nullopt;
  }
  return result;
}

void play_some(const StudyPlan& plan, Work& work) {
  experiment::EpisodeWorld world(plan.scenario, plan.map, plan.team);
  double began_ms = 0.0;
  const auto time = planning_time(plan.budget_ms, began_ms);
  const auto stop = [&work] { return work.stop.load(); };
  for (;;) {
    const std::size_t index = work.next++;
    if (index >= work.seeds.size() || work.stop) return;
    const auto episode = play_one(plan, world, work.seeds[index], time, stop);
    if (!episode) return;
    const std::lock_guard lock(work.mutex);
    if (!work.file->has(episode->seed)) work.file->add(*episode);
    ++work.finished;
    work.changed.notify_all();
  }
}

void work_on(const StudyPlan& plan, Work& work) {
  std::exception_ptr failure;
  try {
    play_some(plan, work);
  } catch (...) {
    failure = std::current_exception();
    work.stop = true;
  }
  const std::lock_guard lock(work.mutex);
  if (failure && !work.failure) work.failure = failure;
  --work.at_work;
  work.changed.notify_all();
}

}  // namespace

std::filesystem::path study_recording(const StudyPlan& plan, std::uint64_t seed) {
  return plan.recordings / (plan.scenario.name + "-" + plan.human + "-" + std::to_string(seed) + ".mcap");
}

void play_study(const StudyPlan& plan, StudyFile& file, const std::function<bool(std::uint64_t)>& keep_going) {
  Work work;
  work.file = &file;
  for (std::uint64_t seed = plan.seed; seed - plan.seed < plan.episodes; ++seed) {
    const bool is_recorded = plan.recordings.empty() || std::filesystem::exists(study_recording(plan, seed));
    if (!file.has(seed) || !is_recorded) work.seeds.push_back(seed);
  }
  work.finished = plan.episodes - work.seeds.size();
  work.at_work = std::min<unsigned>(std::max(1U, plan.threads), static_cast<unsigned>(work.seeds.size()));
  std::vector<std::jthread> threads;
  for (unsigned i = 0, count = work.at_work; i < count; ++i) threads.emplace_back([&] { work_on(plan, work); });
  {
    std::unique_lock lock(work.mutex);
    while (work.at_work > 0) {
      work.changed.wait_for(lock, std::chrono::milliseconds{100});
      if (!keep_going(work.finished)) work.stop = true;
    }
  }
  threads.clear();  // joins
  if (work.failure) std::rethrow_exception(work.failure);
  file.finish();
}

}  // namespace tandem::cli

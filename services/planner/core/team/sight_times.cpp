#include "services/planner/core/team/sight_times.hpp"

#include <array>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

// The innermost loops of planning. Which cells a leg is the first to show is as good as random, and a processor that
// guesses wrong loses more than the sum costs: so eight cells are compared at once, and only those that count are
// touched. Both ways of doing it add in the same order, so that every machine gets the same sums, bit for bit.

namespace tandem {
namespace {

constexpr std::size_t kLanes = 8;

float sum_of(const std::array<float, kLanes>& lanes) {
  return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) + ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

void overwrite(std::int32_t cell, float time_s, float* first_s, Overwritten::Entry*& note) {
  *note++ = {cell, first_s[cell]};
  first_s[cell] = time_s;
}

/// One cell of take_sooner().
void sooner_at(const LegCells& leg, std::size_t i, float start_s, float horizon_s, const float* mass, float* first_s,
               std::array<float, kLanes>& sums, Overwritten::Entry*& note) {
  const std::int32_t cell = leg.cell[i];
  const float seen_s = start_s + leg.enter_s[i];
  if (seen_s >= first_s[cell] || seen_s >= horizon_s) return;
  sums[i % kLanes] += mass[cell] * (first_s[cell] - seen_s);
  overwrite(cell, seen_s, first_s, note);
}

/// One cell of take_later().
void later_at(const LegCells& leg, std::size_t i, std::int32_t visit, const float* mass, SightTimes& times,
              std::array<float, kLanes>& sums, Overwritten::Entry*& note) {
  const auto cell = static_cast<std::size_t>(leg.cell[i]);
  if (times.first[cell] != visit) return;
  sums[i % kLanes] += mass[cell] * (times.second_s[cell] - times.first_s[cell]);
  overwrite(leg.cell[i], times.second_s[cell], times.first_s.data(), note);
}

#if defined(__x86_64__)

bool has_avx2() {
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
}

__attribute__((target("avx2"))) std::size_t sooner_by_eights(const LegCells& leg, float start_s, float horizon_s,
                                                             const float* mass, float* first_s,
                                                             std::array<float, kLanes>& sums,
                                                             Overwritten::Entry*& note) {
  const __m256 start = _mm256_set1_ps(start_s);
  const __m256 horizon = _mm256_set1_ps(horizon_s);
  __m256 sum = _mm256_setzero_ps();
  std::size_t i = 0;
  for (; i + kLanes <= leg.count; i += kLanes) {
    const __m256i cell = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(leg.cell + i));
    const __m256 seen = _mm256_add_ps(start, _mm256_loadu_ps(leg.enter_s + i));
    const __m256 first = _mm256_i32gather_ps(first_s, cell, sizeof(float));
    const __m256 counts =
        _mm256_and_ps(_mm256_cmp_ps(seen, first, _CMP_LT_OQ), _mm256_cmp_ps(seen, horizon, _CMP_LT_OQ));
    auto which = static_cast<unsigned>(_mm256_movemask_ps(counts));
    if (which == 0) continue;
    const __m256 weight = _mm256_and_ps(_mm256_i32gather_ps(mass, cell, sizeof(float)), counts);
    sum = _mm256_add_ps(sum, _mm256_mul_ps(weight, _mm256_sub_ps(first, seen)));
    alignas(sizeof(__m256)) std::array<float, kLanes> seen_at{};
    _mm256_store_ps(seen_at.data(), seen);
    for (; which != 0; which &= which - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(which));
      overwrite(leg.cell[i + lane], seen_at[lane], first_s, note);
    }
  }
  _mm256_storeu_ps(sums.data(), sum);
  return i;
}

__attribute__((target("avx2"))) std::size_t later_by_eights(const LegCells& leg, std::int32_t visit, const float* mass,
                                                            SightTimes& times, std::array<float, kLanes>& sums,
                                                            Overwritten::Entry*& note) {
  const __m256i wanted = _mm256_set1_epi32(visit);
  float* first_s = times.first_s.data();
  const float* second_s = times.second_s.data();
  __m256 sum = _mm256_setzero_ps();
  std::size_t i = 0;
  for (; i + kLanes <= leg.count; i += kLanes) {
    const __m256i cell = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(leg.cell + i));
    const __m256i first_visit = _mm256_i32gather_epi32(times.first.data(), cell, sizeof(std::int32_t));
    const __m256 counts = _mm256_castsi256_ps(_mm256_cmpeq_epi32(first_visit, wanted));
    auto which = static_cast<unsigned>(_mm256_movemask_ps(counts));
    if (which == 0) continue;
    const __m256 first = _mm256_i32gather_ps(first_s, cell, sizeof(float));
    const __m256 second = _mm256_i32gather_ps(second_s, cell, sizeof(float));
    const __m256 weight = _mm256_and_ps(_mm256_i32gather_ps(mass, cell, sizeof(float)), counts);
    sum = _mm256_add_ps(sum, _mm256_mul_ps(weight, _mm256_sub_ps(second, first)));
    for (; which != 0; which &= which - 1) {
      const std::int32_t at = leg.cell[i + static_cast<std::size_t>(__builtin_ctz(which))];
      overwrite(at, second_s[at], first_s, note);
    }
  }
  _mm256_storeu_ps(sums.data(), sum);
  return i;
}

#endif

}  // namespace

float take_sooner(const LegCells& leg, float start_s, float horizon_s, const std::vector<float>& mass,
                  SightTimes& times, Overwritten& overwritten) {
  Overwritten::Entry* const begin = overwritten.room_for(leg.count);
  Overwritten::Entry* note = begin;
  std::array<float, kLanes> sums{};
  std::size_t i = 0;
#if defined(__x86_64__)
  if (has_avx2()) i = sooner_by_eights(leg, start_s, horizon_s, mass.data(), times.first_s.data(), sums, note);
#endif
  for (; i < leg.count; ++i) sooner_at(leg, i, start_s, horizon_s, mass.data(), times.first_s.data(), sums, note);
  overwritten.add(static_cast<std::size_t>(note - begin));
  return sum_of(sums);
}

float take_later(const LegCells& leg, std::int32_t visit, const std::vector<float>& mass, SightTimes& times,
                 Overwritten& overwritten) {
  Overwritten::Entry* const begin = overwritten.room_for(leg.count);
  Overwritten::Entry* note = begin;
  std::array<float, kLanes> sums{};
  std::size_t i = 0;
#if defined(__x86_64__)
  if (has_avx2()) i = later_by_eights(leg, visit, mass.data(), times, sums, note);
#endif
  for (; i < leg.count; ++i) later_at(leg, i, visit, mass.data(), times, sums, note);
  overwritten.add(static_cast<std::size_t>(note - begin));
  return sum_of(sums);
}

}  // namespace tandem

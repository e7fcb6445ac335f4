#pragma once

#include <optional>

#include "services/common/time.hpp"

namespace tandem {

/// How far a pose can be believed.
enum class LocalizationStatus { Ok, Uncertain, Lost };

/// Judges a pose by how well scans fit the map there: agreement tells a wrong pose, a covariance does not.
class AgreementMonitor {
 public:
  AgreementMonitor(double ok, Duration lost_after) : ok_(ok), lost_after_(lost_after) {}

  /// Takes the agreement of a scan: Ok at or above `ok`; below it Uncertain, and Lost once that lasts for `lost_after`.
  LocalizationStatus add(Time time, double agreement) {
    if (agreement >= ok_) {
      bad_since_.reset();
      return LocalizationStatus::Ok;
    }
    if (!bad_since_) bad_since_ = time;
    const bool lasting = time - *bad_since_ >= lost_after_;
    return lasting ? LocalizationStatus::Lost : LocalizationStatus::Uncertain;
  }

  /// Forgets the past: a new start.
  void reset() { bad_since_.reset(); }

 private:
  double ok_;
  Duration lost_after_;
  std::optional<Time> bad_since_;
};

}  // namespace tandem

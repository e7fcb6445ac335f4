#pragma once

#include <filesystem>
#include <string>

#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::test {

/// A search by hand, whose numbers a report must give: 120 s, found by human1.
///
/// - *My pose* 3 s before it begins, then at 5, 10, 15, 20, 25, 30, 50, 100 s: 7 in the first minute (6 of them within
///   10 s after the one before), 7 by 90 s, 8 in all (6 within 10 s).
/// - Plans: the robot leads from 0 s, peers from 50 s, the person commands from 80 s: 50, 30 and 40 s.
/// - Explored: at t the robot t/240, all t/150, told every 10 s: half and 0.8 at the end.
/// - The base stood twice: for an obstacle from 20 to 30 s, without link from 60 to 65 s.
/// - Answers: ease 6, expert yes; one layer shown, which is no answer.
///
/// Events are told three times, as on a bad link. `code` names the session; with `began_s` several fit into one file.
void write_scripted_search(mcap::Writer& writer, const std::string& code, double began_s);

}  // namespace tandem::test

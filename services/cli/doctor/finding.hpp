#pragma once

#include <string>

namespace tandem::cli {

enum class Verdict { Ok, NotApplicable, Warning, Error };

/// One line of `tandem doctor`: what was looked at, what was found, what is wanted, and how to get there.
struct Finding {
  std::string what;
  Verdict verdict = Verdict::Ok;
  std::string found;
  std::string wanted;  ///< empty where nothing more is wanted
  std::string fix;     ///< empty where nothing is to be done
};

[[nodiscard]] inline Finding fine(std::string what, std::string found) {
  return {std::move(what), Verdict::Ok, std::move(found), "", ""};
}
/// A line that says nothing of this host, and why.
[[nodiscard]] inline Finding not_applicable(std::string what, std::string why) {
  return {std::move(what), Verdict::NotApplicable, std::move(why), "", ""};
}
[[nodiscard]] inline Finding warning(std::string what, std::string found, std::string wanted, std::string fix) {
  return {std::move(what), Verdict::Warning, std::move(found), std::move(wanted), std::move(fix)};
}
[[nodiscard]] inline Finding fault(std::string what, std::string found, std::string wanted, std::string fix) {
  return {std::move(what), Verdict::Error, std::move(found), std::move(wanted), std::move(fix)};
}

}  // namespace tandem::cli

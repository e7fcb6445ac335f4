#include "robot/laser/core/laser_session.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "robot/laser/core/cola_session.hpp"
#include "robot/laser/core/lms_session.hpp"
#include "robot/laser/core/scip_session.hpp"
#include "services/common/random.hpp"

namespace tandem {
namespace {

constexpr Time kOpened{std::chrono::seconds{100}};
constexpr Duration kStep = std::chrono::milliseconds{50};

using Family = std::function<std::unique_ptr<LaserSession>()>;

/// What holds of every family's session.
class EverySession : public testing::TestWithParam<std::string> {
 protected:
  static std::unique_ptr<LaserSession> opened() {
    static const std::map<std::string, Family> families{
        {"scip", [] { return std::make_unique<ScipSession>(LaserConfig{}, kOpened, 115'200); }},
        {"lms2xx", [] { return std::make_unique<LmsSession>(LaserConfig{}, kOpened, 38'400); }},
        {"cola", [] { return std::make_unique<ColaSession>(LaserConfig{}, kOpened); }}};
    return families.at(GetParam())();
  }
};

TEST_P(EverySession, BeginsByAskingAndGivesUpOnWhoNeverAnswers) {
  const auto session = opened();
  EXPECT_EQ(session->state(), LaserSession::State::Opening);
  std::string sent;
  Time now = kOpened;
  const Time latest = kOpened + std::chrono::minutes{2};
  for (; session->state() == LaserSession::State::Opening && now < latest; now += kStep) {
    EXPECT_FALSE(session->was_answered());
    const auto output = session->step({}, now);
    sent += output.send;
    EXPECT_TRUE(output.scans.empty());
  }
  EXPECT_FALSE(sent.empty());
  EXPECT_EQ(session->state(), LaserSession::State::Failed);
  EXPECT_NE(session->reason(), "");
  EXPECT_FALSE(session->was_answered());
  EXPECT_EQ(session->damaged(), 0u);
}

TEST_P(EverySession, SaysNothingMoreOnceItHasFailed) {
  const auto session = opened();
  Time now = kOpened;
  while (session->state() != LaserSession::State::Failed) static_cast<void>(session->step({}, now += kStep));
  const std::string reason = session->reason();
  for (int i = 0; i < 200; ++i) EXPECT_EQ(session->step({}, now += kStep).send, "");
  EXPECT_EQ(session->state(), LaserSession::State::Failed);
  EXPECT_EQ(session->reason(), reason);
}

TEST_P(EverySession, TakesNoNoiseForAScan) {
  const auto session = opened();
  Rng rng{7};
  Time now = kOpened;
  for (int i = 0; i < 400 && session->state() != LaserSession::State::Failed; ++i) {
    std::vector<std::uint8_t> noise(1 + rng.index(64));
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(rng.index(256));
    EXPECT_TRUE(session->step(noise, now += kStep).scans.empty());
    EXPECT_NE(session->state(), LaserSession::State::Streaming);
  }
}

TEST_P(EverySession, KnowsHowToEndAStream) {
  EXPECT_NE(opened()->farewell(), "");
}

INSTANTIATE_TEST_SUITE_P(Families, EverySession, testing::Values("scip", "lms2xx", "cola"),
                         [](const auto& family) { return family.param; });

}  // namespace
}  // namespace tandem

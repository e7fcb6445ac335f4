// Every topic of ours goes to Cyclone DDS and comes back from it, unchanged: types, keys and deliveries are DDS, not a
// dialect of one implementation.
//
// Disposal does not cross: Fast DDS 2.9.1 sends the hash of a key without the key, of which Cyclone DDS 0.10 can make
// nothing, and takes the first bytes of the key that Cyclone sends for its hash. Between Fast DDS and Fast DDS it
// works.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "services/bus/bus.hpp"
#include "services/common/file_io.hpp"
#include "tests/idl/samples.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::test {
namespace {

using std::chrono::seconds;

const char* word_of(Delivery delivery) {
  switch (delivery) {
    case Delivery::SensorStream:
      return "stream";
    case Delivery::State:
    case Delivery::Bulk:
      return "state";
    case Delivery::Command:
      return "command";
    case Delivery::Event:
      return "event";
  }
  return "";
}

/// Cyclone DDS between two domains of this machine, for all topics of the contract.
class CycloneEcho {
 public:
  CycloneEcho(int from, int to) {
    // Cyclone sends no multicast over the loopback interface, so it is told where to look, and how often.
    setenv("CYCLONEDDS_URI",
           "<CycloneDDS><Domain><General><Interfaces><NetworkInterface address='127.0.0.1' multicast='false'/>"
           "</Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery><SPDPInterval>1s</SPDPInterval>"
           "<ParticipantIndex>auto</ParticipantIndex><Peers><Peer address='127.0.0.1'/></Peers></Discovery>"
           "</Domain></CycloneDDS>",
           1);
    std::string command = TANDEM_BINARY_DIR "/tests/cyclone_echo " + std::to_string(from) + " " + std::to_string(to);
    for (const TopicInfo& topic : all_topics())
      command += " " + std::string{topic.name} + ":" + word_of(topic.delivery);
    pipe_ = popen(command.c_str(), "w");
  }
  ~CycloneEcho() { EXPECT_EQ(pclose(pipe_), 0); }
  CycloneEcho(const CycloneEcho&) = delete;
  CycloneEcho& operator=(const CycloneEcho&) = delete;

 private:
  FILE* pipe_ = nullptr;
};

bus::DomainOptions host(int domain, const std::string& name) {
  bus::DomainOptions options;
  options.domain = domain;
  options.participant = name;
  return options;
}

class Interop : public testing::Test {
 protected:
  /// Sends a sample on one side until it is there on the other.
  template <class PubSubType>
  void exchange(const Topic<PubSubType>& topic) {
    SCOPED_TRACE(topic.name);
    auto reader = there_.in_order(topic);
    auto writer = here_.writer(topic);
    ASSERT_TRUE(bus::wait_until(there_, seconds{20},
                                [&] { return reader.matched_writers() == 1 && writer.raw().matched_readers() == 1; }));
    const auto sample = filled<typename PubSubType::type>();
    std::optional<typename PubSubType::type> arrived;
    // A stream may lose its first samples: Cyclone's side of a match can be later than ours.
    for (int attempt = 0; attempt < 20 && !arrived; ++attempt) {
      writer.write(sample);
      bus::wait_until(there_, seconds{1}, [&] {
        for (auto& received : reader.take()) arrived = std::move(received.message);
        return arrived.has_value();
      });
    }
    ASSERT_TRUE(arrived);
    EXPECT_EQ(*arrived, sample);
  }

  DomainLease domains_{2};
  bus::Bus here_{host(domains_[0], "here")};
  bus::Bus there_{host(domains_[1], "there")};
};

TEST_F(Interop, EveryTopicComesBackUnchanged) {
  const CycloneEcho echo{domains_[0], domains_[1]};
  exchange(topic::kOdometry);
  exchange(topic::kBaseStatus);
  exchange(topic::kSonar);
  exchange(topic::kVelocityCommand);
  exchange(topic::kStopRequest);
  exchange(topic::kResumeRequest);
  exchange(topic::kScan);
  exchange(topic::kCameraImage);
  exchange(topic::kDetection);
  exchange(topic::kTeammates);
  exchange(topic::kPeople);
  exchange(topic::kMap);
  exchange(topic::kMapHolding);
  exchange(topic::kCompressedMap);
  exchange(topic::kRobotPose);
  exchange(topic::kPoseHint);
  exchange(topic::kTeamPlan);
  exchange(topic::kPlannerStatus);
  exchange(topic::kPlanExecution);
  exchange(topic::kInform);
  exchange(topic::kBelief);
  exchange(topic::kRewardSource);
  exchange(topic::kSourceRelation);
  exchange(topic::kSourceEdit);
  exchange(topic::kBeliefEdit);
  exchange(topic::kHumanMessage);
  exchange(topic::kMessageReceipt);
  exchange(topic::kSession);
  exchange(topic::kReminder);
  exchange(topic::kQuestionnaireAnswer);
  exchange(topic::kLinkStatus);
  exchange(topic::kLinkHeartbeat);
  exchange(topic::kServiceHealth);
  exchange(topic::kClock);
  exchange(topic::kGroundTruth);
}

TEST_F(Interop, AMapOf300KilobytesIsThereForALateReader) {
  const CycloneEcho echo{domains_[0], domains_[1]};
  auto writer = here_.writer(topic::kMap);
  auto map = filled<msg::OccupancyGrid>();
  map.width(600);
  map.height(500);
  map.cells().assign(300'000, 0);
  for (std::size_t i = 0; i < map.cells().size(); ++i) map.cells()[i] = static_cast<std::uint8_t>(i * 7);
  writer.write(map);
  ASSERT_TRUE(bus::wait_until(here_, seconds{20}, [&] { return writer.raw().matched_readers() == 1; }));
  auto reader = there_.latest(topic::kMap);
  ASSERT_TRUE(bus::wait_until(there_, seconds{20}, [&] { return reader.newest().has_value(); }));
  EXPECT_EQ(reader.newest()->message, map);
}

TEST(InteropOfServices, OneOfOursSendsAndOneOfOursReceivesThroughIt) {
  const DomainLease domains{2};
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "config");
  write_file_atomically(folder / "config/site.toml", "host_domain = " + std::to_string(domains[0]) + "\n");
  write_file_atomically(folder / "config/map-server.toml", "map = \"" TANDEM_SOURCE_DIR "/config/maps/room.yaml\"\n");
  const std::string tandem = TANDEM_BINARY_DIR "/bin/tandem";
  const std::string recording = (folder / "there.mcap").string();
  {
    const CycloneEcho echo{domains[0], domains[1]};
    const Process maps{{TANDEM_BINARY_DIR "/bin/tandem-map-server", "--config", (folder / "config").string()}};
    const std::string record =
        tandem + " record -o " + recording + " --seconds 10 --domain " + std::to_string(domains[1]);
    ASSERT_EQ(std::system(record.c_str()), 0);
  }
  const std::string info = (folder / "info.json").string();
  ASSERT_EQ(std::system((tandem + " info " + recording + " --json > " + info).c_str()), 0);
  std::map<std::string, int> counts;
  const auto recorded = nlohmann::json::parse(read_file(info));
  for (const auto& topic : recorded.at("topics")) counts[topic.at("topic")] = topic.at("count");
  EXPECT_EQ(counts["map"], 1);
  EXPECT_GE(counts["service_health"], 5);
}

}  // namespace
}  // namespace tandem::test

// Reads topics in one DDS domain and writes them in another, with Cyclone DDS: what arrives there has been through the
// types and the protocol of another implementation both ways.
//
//   cyclone_echo FROM TO [TOPIC:DELIVERY ...]     DELIVERY: stream, state, command, event
//
// Says "ready" once it listens, and ends when its input ends.
#include <base.h>
#include <dds/dds.h>
#include <human.h>
#include <localization.h>
#include <perception.h>
#include <planning.h>
#include <poll.h>
#include <system.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace {

const std::map<std::string, const dds_topic_descriptor_t*> kTypes{
    {"odometry", &tandem_msg_Odometry_desc},
    {"base_status", &tandem_msg_BaseStatus_desc},
    {"sonar", &tandem_msg_SonarRanges_desc},
    {"velocity_command", &tandem_msg_VelocityCommand_desc},
    {"stop_request", &tandem_msg_StopRequest_desc},
    {"resume_request", &tandem_msg_ResumeRequest_desc},
    {"scan", &tandem_msg_LaserScan_desc},
    {"camera_image", &tandem_msg_CameraImage_desc},
    {"detection", &tandem_msg_ObjectDetection_desc},
    {"teammates", &tandem_msg_TeammateState_desc},
    {"people", &tandem_msg_TrackedPeople_desc},
    {"map", &tandem_msg_OccupancyGrid_desc},
    {"map_holding", &tandem_msg_MapHolding_desc},
    {"compressed_map", &tandem_msg_CompressedMap_desc},
    {"robot_pose", &tandem_msg_RobotPose_desc},
    {"pose_hint", &tandem_msg_PoseHint_desc},
    {"team_plan", &tandem_msg_TeamPlan_desc},
    {"planner_status", &tandem_msg_PlannerStatus_desc},
    {"plan_execution", &tandem_msg_PlanExecution_desc},
    {"inform", &tandem_msg_Inform_desc},
    {"belief", &tandem_msg_SearchBelief_desc},
    {"reward_source", &tandem_msg_RewardSource_desc},
    {"source_relation", &tandem_msg_SourceRelation_desc},
    {"source_edit", &tandem_msg_SourceEdit_desc},
    {"belief_edit", &tandem_msg_BeliefEdit_desc},
    {"human_message", &tandem_msg_HumanMessage_desc},
    {"message_receipt", &tandem_msg_MessageReceipt_desc},
    {"session", &tandem_msg_SessionState_desc},
    {"reminder", &tandem_msg_ReminderEvent_desc},
    {"questionnaire_answer", &tandem_msg_QuestionnaireAnswer_desc},
    {"link_status", &tandem_msg_LinkStatus_desc},
    {"link_heartbeat", &tandem_msg_LinkHeartbeat_desc},
    {"service_health", &tandem_msg_ServiceHealth_desc},
    {"clock", &tandem_msg_Clock_desc},
    {"ground_truth", &tandem_msg_GroundTruth_desc},
};

[[noreturn]] void fail(const std::string& what, dds_return_t code = DDS_RETCODE_ERROR) {
  std::fprintf(stderr, "cyclone_echo: %s: %s\n", what.c_str(), dds_strretcode(code));
  std::exit(1);
}

dds_entity_t made(dds_entity_t entity, const std::string& what) {
  if (entity < 0) fail(what, entity);
  return entity;
}

dds_qos_t* qos_of(const std::string& delivery) {
  const bool latched = delivery == "state";
  const bool reliable = latched || delivery == "event";
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, DDS_MSECS(100));
  dds_qset_durability(qos, latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
  dds_qset_writer_data_lifecycle(qos, false);
  return qos;
}

/// One topic on its way from one domain to the other.
class Echo {
 public:
  Echo(dds_entity_t from, dds_entity_t to, const std::string& topic, const std::string& delivery) {
    const auto type = kTypes.find(topic);
    if (type == kTypes.end()) fail("no type is known of topic " + topic);
    dds_qos_t* qos = qos_of(delivery);
    const auto topic_in = made(dds_create_topic(from, type->second, topic.c_str(), nullptr, nullptr), topic);
    const auto topic_out = made(dds_create_topic(to, type->second, topic.c_str(), nullptr, nullptr), topic);
    reader_ = made(dds_create_reader(from, topic_in, qos, nullptr), topic);
    writer_ = made(dds_create_writer(to, topic_out, qos, nullptr), topic);
    dds_delete_qos(qos);
  }

  void carry() const {
    void* sample = nullptr;
    dds_sample_info_t info;
    while (dds_take(reader_, &sample, &info, 1, 1) > 0) {
      if (info.valid_data) dds_write(writer_, sample);
      dds_return_loan(reader_, &sample, 1);
      sample = nullptr;
    }
  }

 private:
  dds_entity_t reader_;
  dds_entity_t writer_;
};

bool input_ended() {
  pollfd input{STDIN_FILENO, POLLIN | POLLHUP, 0};
  if (poll(&input, 1, 2) <= 0) return false;
  char byte = 0;
  return read(STDIN_FILENO, &byte, 1) <= 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) fail("usage: cyclone_echo FROM TO [TOPIC:DELIVERY ...]");
  const auto domain = [&](int argument) { return static_cast<dds_domainid_t>(std::atoi(argv[argument])); };
  const dds_entity_t from = made(dds_create_participant(domain(1), nullptr, nullptr), "domain");
  const dds_entity_t to = made(dds_create_participant(domain(2), nullptr, nullptr), "domain");
  std::vector<Echo> echoes;
  for (int i = 3; i < argc; ++i) {
    const std::string word = argv[i];
    const auto colon = word.find(':');
    if (colon == std::string::npos) fail("no delivery is given for " + word);
    echoes.emplace_back(from, to, word.substr(0, colon), word.substr(colon + 1));
  }
  std::puts("ready");
  std::fflush(stdout);
  while (!input_ended()) {
    for (const Echo& echo : echoes) echo.carry();
  }
  dds_delete(from);
  dds_delete(to);
  return 0;
}

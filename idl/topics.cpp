#include "idl/topics.hpp"

namespace tandem {

const std::vector<TopicInfo>& all_topics() {
  using namespace topic;  // NOLINT: names every topic of the contract once
  static const std::vector<TopicInfo> topics{info_of(kOdometry),       info_of(kBaseStatus),
                                             info_of(kSonar),          info_of(kVelocityCommand),
                                             info_of(kStopRequest),    info_of(kResumeRequest),
                                             info_of(kScan),           info_of(kCameraImage),
                                             info_of(kDetection),      info_of(kTeammates),
                                             info_of(kPeople),         info_of(kMap),
                                             info_of(kMapHolding),     info_of(kCompressedMap),
                                             info_of(kRobotPose),      info_of(kPoseHint),
                                             info_of(kTeamPlan),       info_of(kPlannerStatus),
                                             info_of(kPlanExecution),  info_of(kInform),
                                             info_of(kBelief),         info_of(kRewardSource),
                                             info_of(kSourceRelation), info_of(kSourceEdit),
                                             info_of(kBeliefEdit),     info_of(kHumanMessage),
                                             info_of(kMessageReceipt), info_of(kSession),
                                             info_of(kReminder),       info_of(kQuestionnaireAnswer),
                                             info_of(kLinkStatus),     info_of(kLinkHeartbeat),
                                             info_of(kServiceHealth),  info_of(kClock),
                                             info_of(kGroundTruth)};
  return topics;
}

}  // namespace tandem

#include "services/bus/outside_settings.hpp"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;

constexpr const char* kDefaultFile = "DEFAULT_FASTRTPS_PROFILES.xml";

bool is_link(const DomainOptions& options) {
  return options.kind == DomainOptions::Kind::Link;
}

const char* value_of(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

}  // namespace

std::vector<std::string> outside_settings(const DomainOptions& options) {
  std::vector<std::string> settings;
  const auto report = [&](const char* variable) {
    if (const char* value = value_of(variable)) settings.push_back(std::string{variable} + "=" + value);
  };
  // Fast DDS obeys these by itself, in every domain.
  for (const char* variable : {"ROS_DISCOVERY_SERVER", "FASTDDS_ENVIRONMENT_FILE", "FASTDDS_STATISTICS"}) {
    report(variable);
  }
  if (!is_link(options)) return settings;
  report("FASTRTPS_DEFAULT_PROFILES_FILE");
  if (value_of("SKIP_DEFAULT_XML_FILE") == nullptr && std::filesystem::exists(kDefaultFile)) {
    settings.push_back("file=" + std::filesystem::absolute(kDefaultFile).string());
  }
  return settings;
}

void refuse_what_breaks_security(const DomainOptions& options) {
  if (!options.security) return;
  // No discovery server works with security in Fast DDS 2.9, and the permissions name no topic of its statistics.
  for (const char* variable : {"ROS_DISCOVERY_SERVER", "FASTDDS_STATISTICS"}) {
    if (value_of(variable) == nullptr) continue;
    throw std::runtime_error(std::string{variable} +
                             " is set, and does not go with secure_link in site.toml: unset it");
  }
}

bool has_outside_profile(dds::DomainParticipantFactory& factory, const DomainOptions& options,
                         dds::DomainParticipantQos& qos) {
  if (!is_link(options)) return false;
  factory.load_profiles();
  dds::DomainParticipantQos profile;
  if (factory.get_participant_qos_from_profile(kOutsideProfile, profile) != ReturnCode_t::RETCODE_OK) return false;
  profile.name(qos.name());                             // the name tells whose participant it is
  profile.flow_controllers() = qos.flow_controllers();  // our writers ask for it by name
  if (options.security) profile.properties() = qos.properties();
  qos = profile;
  return true;
}

bool has_outside_profile(const dds::Publisher& publisher, const std::string& topic, const DomainOptions& options,
                         dds::DataWriterQos& qos) {
  return is_link(options) && publisher.get_datawriter_qos_from_profile(topic, qos) == ReturnCode_t::RETCODE_OK;
}

bool has_outside_profile(const dds::Subscriber& subscriber, const std::string& topic, const DomainOptions& options,
                         dds::DataReaderQos& qos) {
  return is_link(options) && subscriber.get_datareader_qos_from_profile(topic, qos) == ReturnCode_t::RETCODE_OK;
}

}  // namespace tandem::bus

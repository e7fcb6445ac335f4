#include "services/security/documents.hpp"

#include <ctime>
#include <regex>
#include <stdexcept>

#include "services/common/format.hpp"

namespace tandem::security {
namespace {

std::string opening(const char* schema) {
  return formatted(R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="%s.xsd">
)",
                   schema);
}

std::string domains_xml(const Domains& domains) {
  return formatted("<domains><id_range><min>%d</min><max>%d</max></id_range></domains>\n", domains.first, domains.last);
}

std::string criteria_xml(const char* name, const std::vector<std::string>& topics, const std::string& robot) {
  if (topics.empty()) return "";
  std::string xml = formatted("<%s>\n<topics>\n", name);
  for (const auto& topic : topics) xml += "<topic>" + topic + "</topic>\n";
  return xml + "</topics>\n<partitions><partition>" + robot + "</partition></partitions>\n" +
         formatted("</%s>\n", name);
}

std::string without_comments(const std::string& xml) {
  std::string text;
  std::size_t from = 0;
  while (from < xml.size()) {
    const std::size_t comment = xml.find("<!--", from);
    text += xml.substr(from, comment - from);
    if (comment == std::string::npos) break;
    const std::size_t end = xml.find("-->", comment);
    if (end == std::string::npos) break;
    from = end + 3;
  }
  return text;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

// Fast DDS 2.9 takes a DATA submessage that is not protected although it should be, but a payload must be encrypted:
// so the payload is what keeps forgers out. The submessage around it hides the payload, or it could be sent again under
// another sequence number. A third layer around the message would be taken off by whoever wants to.
std::string governance_xml(const Domains& domains) {
  return opening("omg_shared_ca_governance") + R"(  <domain_access_rules>
    <domain_rule>
      )" +
         domains_xml(domains) +
         R"(      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
      <rtps_protection_kind>NONE</rtps_protection_kind>
      <topic_access_rules>
        <topic_rule>
          <topic_expression>*</topic_expression>
          <enable_discovery_protection>true</enable_discovery_protection>
          <enable_liveliness_protection>true</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>ENCRYPT</metadata_protection_kind>
          <data_protection_kind>ENCRYPT</data_protection_kind>
        </topic_rule>
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
)";
}

std::string permissions_xml(const Permissions& permissions, const Domains& domains) {
  // Without indentation: hosts show it to each other in one datagram.
  return opening("omg_shared_ca_permissions") + "<permissions>\n<grant name=\"host\">\n<subject_name>" +
         permissions.subject + "</subject_name>\n<validity>\n<not_before>" + text_of(permissions.validity.begins) +
         "</not_before>\n<not_after>" + text_of(permissions.validity.ends) +
         "</not_after>\n</validity>\n<allow_rule>\n" + domains_xml(domains) +
         criteria_xml("publish", permissions.publishes, permissions.robot) +
         criteria_xml("subscribe", permissions.subscribes, permissions.robot) +
         "</allow_rule>\n<default>DENY</default>\n</grant>\n</permissions>\n</dds>\n";
}

std::vector<std::string> texts_of(const std::string& xml, const std::string& name) {
  const std::string text = without_comments(xml);
  const std::string begin = "<" + name + ">";
  const std::string end = "</" + name + ">";
  std::vector<std::string> texts;
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    const std::size_t stop = text.find(end, at);
    if (stop == std::string::npos) break;
    texts.push_back(trimmed(text.substr(at, stop - at)));
  }
  return texts;
}

std::string element_of(const std::string& xml, const std::string& name) {
  const auto texts = texts_of(xml, name);
  return texts.empty() ? "" : texts.front();
}

std::string text_of(Time time) {
  const auto unix_s = static_cast<std::time_t>(to_stamp_ns(time) / 1'000'000'000);
  std::tm utc{};
  gmtime_r(&unix_s, &utc);
  return formatted("%04d-%02d-%02dT%02d:%02d:%02d", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday, utc.tm_hour,
                   utc.tm_min, utc.tm_sec);
}

Time time_of(const std::string& text) {
  static const std::regex form{R"((\d{4})-(\d\d)-(\d\d)T(\d\d):(\d\d):(\d\d)Z?)"};
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) {
    throw std::runtime_error("\"" + text + "\" is no time like 2026-11-26T12:00:00");
  }
  std::tm utc{};
  utc.tm_year = std::stoi(parts[1]) - 1900;
  utc.tm_mon = std::stoi(parts[2]) - 1;
  utc.tm_mday = std::stoi(parts[3]);
  utc.tm_hour = std::stoi(parts[4]);
  utc.tm_min = std::stoi(parts[5]);
  utc.tm_sec = std::stoi(parts[6]);
  return from_stamp_ns(static_cast<std::int64_t>(timegm(&utc)) * 1'000'000'000);
}

}  // namespace tandem::security

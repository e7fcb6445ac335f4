#pragma once

#include <string>
#include <vector>

#include "services/security/certificates.hpp"

namespace tandem::security {

/// DDS domains that a document speaks of, both included.
struct Domains {
  int first = 0;
  int last = 101;  ///< the last that site.toml takes
};

/// What a host may do on the link.
struct Permissions {
  std::string subject;                  ///< of its certificate, RFC 2253
  std::string robot;                    ///< its team
  std::vector<std::string> publishes;   ///< topics
  std::vector<std::string> subscribes;  ///< topics
  Validity validity;                    ///< whole seconds
};

/// How the link is protected, as DDS Security's XML: nobody without a certificate takes part, all is encrypted, and
/// every topic needs a permission.
[[nodiscard]] std::string governance_xml(const Domains& domains = {});

/// What `permissions` say, as DDS Security's XML; all else is denied.
[[nodiscard]] std::string permissions_xml(const Permissions& permissions, const Domains& domains = {});

/// The text of each element `name` of `xml`, without the blanks around it. Comments are left out; it need not be well
/// formed.
[[nodiscard]] std::vector<std::string> texts_of(const std::string& xml, const std::string& name);

/// The part of `xml` between the first <name> and its end; empty if there is none.
[[nodiscard]] std::string element_of(const std::string& xml, const std::string& name);

/// As documents have it: "2026-11-26T12:00:00", UTC.
[[nodiscard]] std::string text_of(Time time);
/// The inverse; also with a Z at the end. Throws std::runtime_error on any other text.
[[nodiscard]] Time time_of(const std::string& text);

}  // namespace tandem::security

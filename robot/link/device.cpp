#include "robot/link/device.hpp"

#include <charconv>

#include "services/common/config.hpp"

namespace tandem {

Device parse_device(const std::string& name) {
  const ConfigError wrong{"device \"" + name + "\" is neither \"tcp://HOST:PORT\" nor a device file \"/dev/...\""};
  constexpr std::string_view kTcp = "tcp://";
  if (name.starts_with(kTcp)) {
    const auto colon = name.rfind(':');
    if (colon <= kTcp.size()) throw wrong;  // no host, or no colon but that of the scheme
    TcpDevice device{.host = name.substr(kTcp.size(), colon - kTcp.size())};
    const char* const end = name.data() + name.size();
    const auto [parsed_to, error] = std::from_chars(name.data() + colon + 1, end, device.port);
    if (error != std::errc{} || parsed_to != end || device.port == 0) throw wrong;
    return device;
  }
  if (!name.starts_with("/")) throw wrong;
  return SerialDevice{name};
}

}  // namespace tandem

#include "robot/link/device.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"

namespace tandem {
namespace {

TEST(Device, IsANetworkAddressOrADeviceFile) {
  const Device lidar = parse_device("tcp://192.168.0.10:10940");
  EXPECT_EQ(std::get<TcpDevice>(lidar).host, "192.168.0.10");
  EXPECT_EQ(std::get<TcpDevice>(lidar).port, 10940);
  EXPECT_EQ(std::get<SerialDevice>(parse_device("/dev/ttyACM0")).path, "/dev/ttyACM0");
}

TEST(Device, RefusesEveryOtherName) {
  for (const char* name : {"", "tcp://", "tcp://host", "tcp://:10940", "tcp://host:", "tcp://host:0",
                           "tcp://host:70000", "tcp://host:10940x", "COM1", "udp://host:1"}) {
    EXPECT_THROW((void)parse_device(name), ConfigError) << name;
  }
}

}  // namespace
}  // namespace tandem

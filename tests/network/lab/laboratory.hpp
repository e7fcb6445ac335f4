#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "services/common/clock.hpp"
#include "tests/network/lab/air.hpp"
#include "tests/network/lab/network_namespace.hpp"

namespace tandem::test {

/// A host of a laboratory: a network namespace with an interface "wifi0" on the air.
class LabHost {
 public:
  LabHost(std::string name, std::size_t number);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  /// IPv4 address of wifi0.
  [[nodiscard]] const std::string& address() const { return address_; }

  /// Does `work` in this host's network; sockets, threads and processes made there stay there.
  template <class Work>
  auto run(const Work& work) const {
    return namespace_.run(work);
  }
  /// Gives wifi0 another address, as another access point or a new lease does.
  void change_address(const std::string& address);
  void interface_down();
  void interface_up();
  /// Its network, as `ip link set ... netns` wants it.
  [[nodiscard]] std::string network_path() const { return namespace_.path(); }

 private:
  friend class Laboratory;
  void add_routes() const;

  std::string name_;
  std::size_t number_;
  std::string address_;
  NetworkNamespace namespace_;
};

/// Hosts as network namespaces, joined by an air that loses, delays, limits, ... what each is to receive.
///
/// A thread carries the frames between raw sockets; nothing but `ip` is needed of the machine, no netem and no bridge.
class Laboratory {
 public:
  /// Hosts get 10.66.0.1, 10.66.0.2, ... in order. isolate_network() must have succeeded. Throws std::runtime_error.
  explicit Laboratory(const std::vector<std::string>& hosts, std::uint64_t seed = 1);
  ~Laboratory();
  Laboratory(const Laboratory&) = delete;
  Laboratory& operator=(const Laboratory&) = delete;

  [[nodiscard]] LabHost& host(const std::string& name);
  /// Joins two hosts by a cable besides, which loses nothing: they are 10.67.N.1 and 10.67.N.2 on it, N counting the
  /// cables from 0. Gives the address of `b`.
  std::string join_by_cable(const std::string& a, const std::string& b);
  /// What `name` is to receive, from now on.
  void set(const std::string& name, const Conditions& conditions);
  /// The same for every host: each direction of each link.
  void set_all(const Conditions& conditions);
  [[nodiscard]] Air::Count count(const std::string& name);

 private:
  void carry_frames();

  std::vector<std::unique_ptr<LabHost>> hosts_;
  std::vector<int> sockets_;  // of the air, one for each host
  std::mutex air_mutex_;
  Air air_;
  SteadyClock clock_;
  int wake_ = -1;
  int cables_ = 0;
  std::thread carrier_;
};

/// Must tests fail rather than skip where the laboratory cannot run?
[[nodiscard]] bool laboratory_is_required();

}  // namespace tandem::test

/// Skips the test, with the reason, where this machine allows no network namespaces; fails it where they are required
/// (TANDEM_REQUIRE_NETNS=1).
#define TANDEM_NEEDS_LABORATORY()                                                    \
  if (const std::string reason = tandem::test::isolate_network(); !reason.empty()) { \
    if (tandem::test::laboratory_is_required())                                      \
      FAIL() << "the network laboratory is required, and cannot run: " << reason;    \
    GTEST_SKIP() << "the network laboratory cannot run: " << reason;                 \
  }

#include "tests/network/lab/network_namespace.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace tandem::test {
namespace {

int open_own_namespace() {
  const int file = open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC);
  if (file < 0) throw std::system_error{errno, std::generic_category(), "/proc/thread-self/ns/net"};
  return file;
}

void write_proc(const std::string& file, const std::string& text) {
  std::ofstream{file} << text;
}

std::string isolate() {
  if (unshare(CLONE_NEWNET) != 0) {
    const auto user = std::to_string(geteuid());
    const auto group = std::to_string(getegid());
    if (unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
      return std::string{"network namespaces need root or user namespaces: "} + std::strerror(errno);
    }
    write_proc("/proc/self/uid_map", "0 " + user + " 1");
    write_proc("/proc/self/setgroups", "deny");
    write_proc("/proc/self/gid_map", "0 " + group + " 1");
  }
  try {
    run_program({"ip", "link", "set", "lo", "up"});
    run_program({"ip", "link", "add", "probe0", "type", "veth", "peer", "name", "probe1"});
    run_program({"ip", "link", "del", "probe0"});
  } catch (const std::exception& error) {
    return std::string{"virtual network interfaces cannot be made: "} + error.what();
  }
  return "";
}

}  // namespace

std::string isolate_network() {
  static const std::string reason = isolate();
  return reason;
}

NetworkNamespace::NetworkNamespace() : home_(open_own_namespace()) {
  if (unshare(CLONE_NEWNET) != 0) throw std::system_error{errno, std::generic_category(), "unshare"};
  own_ = open_own_namespace();
  const Stay back{own_, home_};
}

NetworkNamespace::~NetworkNamespace() {
  close(own_);
  close(home_);
}

std::string NetworkNamespace::path() const {
  return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(own_);
}

NetworkNamespace::Stay::Stay(int own, int home_namespace) : home(home_namespace) {
  if (setns(own, CLONE_NEWNET) != 0) throw std::system_error{errno, std::generic_category(), "setns"};
}

NetworkNamespace::Stay::~Stay() {
  // Whoever went on in the wrong network would measure the wrong thing.
  if (setns(home, CLONE_NEWNET) != 0) std::abort();
}

void run_program(const std::vector<std::string>& words) {
  std::array<int, 2> output{};
  if (pipe2(output.data(), O_CLOEXEC) != 0) throw std::system_error{errno, std::generic_category(), "pipe"};
  std::vector<char*> arguments;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: execvp's interface
  arguments.push_back(nullptr);
  const pid_t id = fork();
  if (id == 0) {
    dup2(output[1], STDOUT_FILENO);
    dup2(output[1], STDERR_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  close(output[1]);
  std::string said;
  std::array<char, 512> part{};
  for (ssize_t size = 0; (size = read(output[0], part.data(), part.size())) > 0;) {
    said.append(part.data(), static_cast<std::size_t>(size));
  }
  close(output[0]);
  int status = 0;
  waitpid(id, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  std::string line;
  for (const auto& word : words) line += word + " ";
  throw std::runtime_error(line + "failed: " + said);
}

}  // namespace tandem::test

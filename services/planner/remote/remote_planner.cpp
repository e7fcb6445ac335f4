#include "services/planner/remote/remote_planner.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <string_view>

#include "services/common/clock.hpp"
#include "services/planner/remote/remote_messages.hpp"

namespace tandem {

/// The other program, and lines to and from it.
class RemotePlanner::Program {
 public:
  Program(const std::string& command, double patience_s)
      : command_(command), patience_(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(patience_s))) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail(std::strerror(errno));
    process_ = fork();
    if (process_ < 0) fail(std::strerror(errno));
    if (process_ == 0) {
      dup2(ends[1], STDIN_FILENO);
      dup2(ends[1], STDOUT_FILENO);
      execl("/bin/sh", "sh", "-c", command_.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    socket_ = ends[0];
    fcntl(socket_, F_SETFL, O_NONBLOCK);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Its end of the line is closed, which a program that reads lines takes as the end; who does not is killed.
  ~Program() {
    shutdown(socket_, SHUT_RDWR);
    close(socket_);
    for (int i = 0; i < 50; ++i) {
      if (waitpid(process_, nullptr, WNOHANG) == process_) return;
      poll(nullptr, 0, 10);
    }
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }

  void send_line(std::string line) {
    line += '\n';
    const Time deadline = clock_.now() + patience_;
    for (std::size_t sent = 0; sent < line.size();) {
      wait_for(POLLOUT, deadline);
      const ssize_t now = send(socket_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
      if (now < 0 && errno != EAGAIN && errno != EINTR) fail("it has ended");
      sent += now > 0 ? static_cast<std::size_t>(now) : 0;
    }
  }

  std::string receive_line() {
    const Time deadline = clock_.now() + patience_;
    while (true) {
      if (const std::size_t end = received_.find('\n'); end != std::string::npos) {
        std::string line = received_.substr(0, end);
        received_.erase(0, end + 1);
        return line;
      }
      wait_for(POLLIN, deadline);
      std::array<char, 65536> chunk{};
      const ssize_t now = recv(socket_, chunk.data(), chunk.size(), 0);
      if (now == 0 || (now < 0 && errno != EAGAIN && errno != EINTR)) fail("it ended without an answer");
      if (now > 0) received_.append(chunk.data(), static_cast<std::size_t>(now));
    }
  }

 private:
  void wait_for(short what, Time deadline) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - clock_.now());
    pollfd socket{socket_, what, 0};
    if (left.count() <= 0 || poll(&socket, 1, static_cast<int>(left.count())) == 0) fail("it does not answer");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw RemotePlannerError("planner '" + command_ + "': " + what);
  }

  std::string command_;
  Duration patience_;
  SteadyClock clock_;
  pid_t process_ = -1;
  int socket_ = -1;
  std::string received_;
};

RemotePlanner::RemotePlanner(const RemotePlannerOptions& options)
    : options_(options), program_(std::make_unique<Program>(options.command, options.patience_s)) {}

RemotePlanner::~RemotePlanner() = default;

void RemotePlanner::begin(const SearchProblem& problem, Rng rng) {
  if (told_world_ != problem.world) {
    program_->send_line(remote::world_message(*problem.world));
    told_world_ = problem.world;
  }
  program_->send_line(remote::plan_message(problem, options_.budget_s, rng.bits() >> 12));
  best_ = evaluated(problem, remote::paths_of_answer(program_->receive_line(), problem));
}

void RemotePlanner::run(int /*rollouts*/, const std::function<bool()>& /*stop*/) {}

}  // namespace tandem

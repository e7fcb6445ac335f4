#include "services/cli/up/supervisor.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "services/common/clock.hpp"

namespace tandem::cli {
namespace {

int exit_code(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::string last_line(const std::filesystem::path& file) {
  std::ifstream stream{file};
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

Supervisor::~Supervisor() {
  stop_all(std::chrono::seconds{2});
}

void Supervisor::start(const ProcessPlan& plan) {
  if (access(plan.program.c_str(), X_OK) != 0) {
    throw std::runtime_error(plan.program.string() + ": no such program; build it with ./run dev release");
  }
  std::filesystem::create_directories(plan.log_file.parent_path());
  std::vector<std::string> words{plan.program.string()};
  words.insert(words.end(), plan.arguments.begin(), plan.arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const int log = open(plan.log_file.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0644);
  if (log < 0) throw std::runtime_error(plan.log_file.string() + ": cannot be written: " + std::strerror(errno));
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);  // the parent died in between
    setpgid(0, 0);                        // Ctrl-C on the terminal reaches the parent alone, which stops all in order
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    const int null = open("/dev/null", O_RDONLY);
    dup2(null, STDIN_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  close(log);
  if (pid < 0) throw std::runtime_error(plan.name + " cannot be started: " + std::strerror(errno));
  children_.push_back({plan, pid});
}

std::vector<ProcessEnd> Supervisor::ended() {
  std::vector<ProcessEnd> ends;
  std::erase_if(children_, [&](const Child& child) {
    int status = 0;
    if (waitpid(child.pid, &status, WNOHANG) != child.pid) return false;
    ends.push_back({child.plan.name, exit_code(status), last_line(child.plan.log_file)});
    return true;
  });
  return ends;
}

void Supervisor::stop_all(Duration patience) {
  // The newest depend on the oldest, so they end first; a frozen one must wake up to hear it.
  for (auto child = children_.rbegin(); child != children_.rend(); ++child) {
    kill(child->pid, SIGTERM);
    kill(child->pid, SIGCONT);
  }
  SteadyClock clock;
  const Time deadline = clock.now() + patience;
  while (!children_.empty() && clock.now() < deadline) {
    ended();
    clock.wait_until(clock.now() + std::chrono::milliseconds{20}, [] { return false; });
  }
  for (const auto& child : children_) {
    kill(child.pid, SIGKILL);
    waitpid(child.pid, nullptr, 0);
  }
  children_.clear();
}

bool Supervisor::signal(const std::string& name, int signal) {
  const auto id = id_of(name);
  return id && kill(*id, signal) == 0;
}

bool Supervisor::is_running(const std::string& name) const {
  return std::any_of(children_.begin(), children_.end(), [&](const Child& c) { return c.plan.name == name; });
}

std::optional<pid_t> Supervisor::id_of(const std::string& name) const {
  const auto child =
      std::find_if(children_.begin(), children_.end(), [&](const Child& c) { return c.plan.name == name; });
  return child == children_.end() ? std::nullopt : std::optional{child->pid};
}

std::filesystem::path Supervisor::log_of(const std::string& name) const {
  for (const auto& child : children_) {
    if (child.plan.name == name) return child.plan.log_file;
  }
  return {};
}

double Supervisor::processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

}  // namespace tandem::cli

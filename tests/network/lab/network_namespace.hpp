#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tandem::test {

/// Moves this process into a network of its own, once, as root or in a user namespace where those are allowed; what is
/// done to networks afterwards cannot touch the machine's. To be called before other threads are started.
///
/// Gives the reason when this machine does not allow it, else nothing.
[[nodiscard]] std::string isolate_network();

/// A network namespace of its own. The calling thread enters it for a piece of work; sockets and threads that the work
/// makes stay inside.
class NetworkNamespace {
 public:
  /// @throws std::system_error
  NetworkNamespace();
  ~NetworkNamespace();
  NetworkNamespace(const NetworkNamespace&) = delete;
  NetworkNamespace& operator=(const NetworkNamespace&) = delete;

  template <class Work>
  auto run(const Work& work) const {
    const Stay stay{own_, home_};
    return work();
  }
  /// Its file descriptor, as `ip link set ... netns` wants it: /proc/PID/fd/N.
  [[nodiscard]] std::string path() const;

 private:
  struct Stay {
    Stay(int own, int home);
    ~Stay();
    int home;
  };
  int own_ = -1;
  int home_ = -1;
};

/// Runs a program to its end in the calling thread's namespace. Throws std::runtime_error, with what it said, when it
/// fails.
void run_program(const std::vector<std::string>& words);

}  // namespace tandem::test

#include "services/simulator/wire/line_rate.hpp"

// Rates without a name of their own need the kernel's structure, whose header does not stand beside <termios.h>.
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <sys/ioctl.h>

namespace tandem::simulator {

int line_rate(int descriptor) {
  termios2 settings{};
  return ::ioctl(descriptor, TCGETS2, &settings) == 0 ? static_cast<int>(settings.c_ospeed) : 0;
}

}  // namespace tandem::simulator

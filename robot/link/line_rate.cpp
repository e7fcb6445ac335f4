#include "robot/link/line_rate.hpp"

// Rates without a name of their own need the kernel's structure, whose header does not stand beside <termios.h>.
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <sys/ioctl.h>

namespace tandem {

bool set_line_rate(int descriptor, int baud_rate) {
  termios2 settings{};
  if (::ioctl(descriptor, TCGETS2, &settings) != 0) return false;
  settings.c_cflag &= ~static_cast<tcflag_t>(CBAUD | (CBAUD << IBSHIFT));
  settings.c_cflag |= static_cast<tcflag_t>(BOTHER | (BOTHER << IBSHIFT));
  settings.c_ispeed = static_cast<speed_t>(baud_rate);
  settings.c_ospeed = static_cast<speed_t>(baud_rate);
  return ::ioctl(descriptor, TCSETSW2, &settings) == 0;
}

}  // namespace tandem

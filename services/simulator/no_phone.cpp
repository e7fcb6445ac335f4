#include "services/simulator/phone.hpp"

namespace tandem::simulator {

std::unique_ptr<Phone> make_phone(const std::string&, const std::string&) {
  return nullptr;
}

}  // namespace tandem::simulator

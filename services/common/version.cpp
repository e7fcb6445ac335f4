#include "services/common/version.hpp"

namespace tandem {

std::string version() {
  return TANDEM_VERSION;
}
std::string commit() {
  return TANDEM_COMMIT;
}
std::string contract_hash() {
  return TANDEM_CONTRACT_HASH;
}
std::string version_line() {
  return version() + " (commit " + commit() + ", contract " + contract_hash() + ")";
}

}  // namespace tandem

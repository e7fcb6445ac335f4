#pragma once

#include "services/bus/domain_lease.hpp"

namespace tandem::test {

using bus::DomainLease;  ///< A test runs on DDS domains of its own.

}  // namespace tandem::test

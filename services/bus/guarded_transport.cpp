#include "services/bus/guarded_transport.hpp"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <memory>
#include <mutex>
#include <utility>

#include "services/common/clock.hpp"

namespace tandem::bus {
namespace {

namespace fastdds = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;

class GuardedTransportDescriptor final : public fastdds::ChainingTransportDescriptor {
 public:
  GuardedTransportDescriptor(const std::shared_ptr<fastdds::TransportDescriptorInterface>& below, bool secured,
                             DatagramDropped dropped)
      : ChainingTransportDescriptor(below), secured_(secured), dropped_(std::move(dropped)) {}

  [[nodiscard]] fastdds::TransportInterface* create_transport() const override;
  [[nodiscard]] bool secured() const { return secured_; }
  [[nodiscard]] const DatagramDropped& dropped() const { return dropped_; }

 private:
  bool secured_;
  DatagramDropped dropped_;
};

class GuardedTransport final : public fastdds::ChainingTransport {
 public:
  explicit GuardedTransport(const GuardedTransportDescriptor& descriptor)
      : ChainingTransport(descriptor), dropped_(descriptor.dropped()), guard_(descriptor.secured()) {}

  fastdds::TransportDescriptorInterface* get_configuration() override {
    return low_level_transport_->get_configuration();
  }

  bool send(rtps::SenderResource* below, const rtps::octet* datagram, std::uint32_t size, rtps::LocatorsIterator* begin,
            rtps::LocatorsIterator* end, const std::chrono::steady_clock::time_point& timeout) override {
    return below->send(datagram, size, begin, end, timeout);
  }

  /// Each port has a thread of its own.
  void receive(fastdds::TransportReceiverInterface* above, const rtps::octet* datagram, std::uint32_t size,
               const rtps::Locator_t& here, const rtps::Locator_t& from) override {
    if (const auto fault = fault_of({datagram, size})) {
      dropped_(rtps::IPLocator::toIPv4string(from), *fault);
    } else {
      above->OnDataReceived(datagram, size, here, from);
    }
  }

 private:
  std::optional<RtpsFault> fault_of(std::span<const std::uint8_t> datagram) {
    const std::lock_guard lock{mutex_};
    return guard_.fault_of(datagram, clock_.now());
  }

  DatagramDropped dropped_;
  SteadyClock clock_;
  std::mutex mutex_;
  RtpsGuard guard_;
};

fastdds::TransportInterface* GuardedTransportDescriptor::create_transport() const {
  return new GuardedTransport{*this};
}

}  // namespace

void guard_transports(eprosima::fastdds::dds::DomainParticipantQos& qos, bool secured, const DatagramDropped& dropped) {
  for (auto& transport : qos.transport().user_transports) {
    transport = std::make_shared<GuardedTransportDescriptor>(transport, secured, dropped);
  }
}

}  // namespace tandem::bus

#include "services/simulator/core/laser_device.hpp"

#include <algorithm>

#include "services/simulator/core/cola_device.hpp"
#include "services/simulator/core/lms_device.hpp"
#include "services/simulator/core/scip_device.hpp"

namespace tandem::simulator {
namespace {

struct Model {
  std::string name;
  std::function<std::unique_ptr<LaserDevice>(Time)> make;
};

template <typename Device, typename Options>
Model model(std::string name, Options options) {
  return {std::move(name), [options](Time now) { return std::make_unique<Device>(options, now); }};
}

const std::vector<Model>& models() {
  static const std::vector<Model> all{
      model<ScipDevice>("utm-30lx", ScipOptions{}),
      model<ScipDevice>("ust-10lx", ScipOptions{.parameters = scip::ust_10lx()}),
      model<ScipDevice>("ust-20lx", ScipOptions{.parameters = scip::ust_20lx()}),
      model<ScipDevice>("urg-04lx", urg_04lx_serial()),
      model<ColaDevice>("lms111", lms111()),
      model<ColaDevice>("tim561", tim561()),
      model<LmsDevice>("lms200", LmsOptions{}),
      model<LmsDevice>("lms291", LmsOptions{.type = "LMS291;S05;V02.10"}),
  };
  return all;
}

}  // namespace

std::unique_ptr<LaserDevice> make_laser_device(const std::string& name, Time now) {
  const auto found = std::find_if(models().begin(), models().end(), [&](const Model& one) { return one.name == name; });
  return found == models().end() ? nullptr : found->make(now);
}

const std::vector<std::string>& laser_models() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Model& one : models()) all.push_back(one.name);
    return all;
  }();
  return names;
}

}  // namespace tandem::simulator

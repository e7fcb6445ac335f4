#include "gateway/protocol/json_reader.hpp"

namespace tandem::protocol {
namespace {

/// Refuses what the parser itself would accept or only notice too late: deep nesting, repeated keys, infinite numbers.
class Checker final : public nlohmann::json_sax<Json> {
 public:
  explicit Checker(std::string& reason) : reason_(reason) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t value, const string_t&) override {
    return std::isfinite(value) || refuse("a number is not finite");
  }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override {
    keys_.emplace_back();
    return enter();
  }
  bool key(string_t& name) override {
    return keys_.back().insert(name).second || refuse("key '" + name.substr(0, 40) + "' comes twice");
  }
  bool end_object() override {
    keys_.pop_back();
    --depth_;
    return true;
  }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool parse_error(std::size_t at, const std::string&, const nlohmann::detail::exception&) override {
    return refuse("not JSON at character " + std::to_string(at));
  }

 private:
  bool enter() { return ++depth_ <= kMaxDepth || refuse("nested deeper than " + std::to_string(kMaxDepth)); }
  bool refuse(const std::string& why) {
    if (reason_.empty()) reason_ = why;
    return false;
  }

  std::string& reason_;
  int depth_ = 0;
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

std::optional<Json> parse_json(std::string_view text, std::string& reason) {
  Checker checker{reason};
  if (!Json::sax_parse(text, &checker)) {
    if (reason.empty()) reason = "not JSON";
    return std::nullopt;
  }
  return Json::parse(text, nullptr, false);
}

}  // namespace tandem::protocol

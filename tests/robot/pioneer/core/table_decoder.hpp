#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tandem::pioneer {

/// A second reader of the protocol, that shares nothing with the driver: it walks the tables of the protocol's page.
///
/// Each field is one letter and a name: b u8, c i8, h u16, i i16, u u32, l i32, s text. A field behind the end is
/// absent.
class TableDecoder {
 public:
  using Fields = std::map<std::string, std::string>;

  struct Field {
    char type;
    const char* name;
  };

  /// The type and fields of the packet that is exactly `bytes`; none where frame or checksum are wrong.
  struct Decoded {
    int type = 0;
    std::vector<std::uint8_t> body;
  };
  static std::optional<Decoded> unframed(const std::vector<std::uint8_t>& bytes) {
    if (bytes.size() < 6 || bytes[0] != 0xFA || bytes[1] != 0xFB || bytes.size() != bytes[2] + 3u) return std::nullopt;
    unsigned sum = 0;
    std::size_t left = bytes[2] - 2u;
    std::size_t at = 3;
    while (left > 1) {
      sum += bytes[at] * 256u + bytes[at + 1];
      sum %= 65536u;
      at += 2;
      left -= 2;
    }
    if (left == 1) sum ^= bytes[at];
    if (sum != bytes[bytes.size() - 2] * 256u + bytes[bytes.size() - 1]) return std::nullopt;
    return Decoded{bytes[3], {bytes.begin() + 4, bytes.end() - 2}};
  }

  static Fields sip(const std::vector<std::uint8_t>& body) {
    static const std::vector<Field> kHead{{'h', "x"},       {'h', "y"},       {'i', "heading"},   {'i', "left"},
                                          {'i', "right"},   {'b', "battery"}, {'b', "stall_low"}, {'b', "stall_high"},
                                          {'i', "control"}, {'h', "flags"},   {'b', "compass"},   {'b', "sonars"}};
    static const std::vector<Field> kTail{
        {'b', "gripper"},     {'b', "analog_port"},  {'b', "analog"},    {'b', "digital_in"}, {'b', "digital_out"},
        {'h', "battery_x10"}, {'b', "charge"},       {'i', "turn_rate"}, {'h', "faults"},     {'i', "lateral"},
        {'c', "temperature"}, {'c', "charge_state"}, {'u', "time_us"},   {'u', "flags3"}};
    TableDecoder decoder{body};
    decoder.read(kHead, "");
    if (decoder.fields_.contains("sonars")) {
      const int count = std::stoi(decoder.fields_["sonars"]);
      for (int i = 0; i < count; ++i) decoder.read({{'b', "number"}, {'h', "range"}}, std::to_string(i));
    }
    decoder.read(kTail, "");
    return decoder.fields_;
  }

  static Fields config(const std::vector<std::uint8_t>& body) {
    static const std::vector<Field> kTable{{'s', "type"},         {'s', "subtype"},     {'s', "serial"},
                                           {'b', "4mot"},         {'h', "rotveltop"},   {'h', "transveltop"},
                                           {'h', "rotacctop"},    {'h', "transacctop"}, {'h', "pwmmax"},
                                           {'s', "name"},         {'b', "sipcycle"},    {'b', "hostbaud"},
                                           {'b', "aux1baud"},     {'h', "gripper"},     {'h', "frontsonar"},
                                           {'b', "rearsonar"},    {'h', "lowbattery"},  {'h', "revcount"},
                                           {'h', "watchdog"},     {'b', "altsips"},     {'h', "stallval"},
                                           {'h', "stallcount"},   {'h', "joyvel"},      {'h', "joyrotvel"},
                                           {'h', "rotvelmax"},    {'h', "transvelmax"}, {'h', "rotaccel"},
                                           {'h', "rotdecel"},     {'h', "rotkp"},       {'h', "rotkv"},
                                           {'h', "rotki"},        {'h', "transaccel"},  {'h', "transdecel"},
                                           {'h', "transkp"},      {'h', "transkv"},     {'h', "transki"},
                                           {'b', "frontbumpers"}, {'b', "rearbumpers"}, {'b', "charger"},
                                           {'b', "sonarcycle"},   {'b', "autobaud"},    {'b', "gyro"},
                                           {'i', "drift"},        {'b', "aux2baud"},    {'b', "aux3baud"},
                                           {'h', "ticksmm"},      {'h', "shutdown"},    {'s', "firmware"},
                                           {'h', "gyrocw"},       {'h', "gyroccw"},     {'b', "kindelay"},
                                           {'h', "latveltop"},    {'h', "latacctop"},   {'h', "latvelmax"},
                                           {'h', "lataccel"},     {'h', "latdecel"},    {'h', "chargethreshold"},
                                           {'b', "pdbport"},      {'h', "gyrorate"},    {'c', "hightemp"},
                                           {'h', "powerbits"},    {'b', "batterytype"}, {'h', "soclow"},
                                           {'h', "socshutdown"},  {'s', "bootloader"},  {'u', "configflags"},
                                           {'i', "gyrofw"}};
    TableDecoder decoder{body};
    decoder.read(kTable, "");
    return decoder.fields_;
  }

 private:
  explicit TableDecoder(const std::vector<std::uint8_t>& body) : body_(body) {}

  void read(const std::vector<Field>& table, const std::string& suffix) {
    for (const Field& field : table) {
      const auto text = one(field.type);
      if (!text) return;
      fields_[field.name + suffix] = *text;
    }
  }
  std::optional<std::string> one(char type) {
    if (ended_) return std::nullopt;
    if (type == 's') {
      if (at_ >= body_.size()) return end();
      std::string text;
      while (at_ < body_.size() && body_[at_] != 0) text += static_cast<char>(body_[at_++]);
      ++at_;
      return text;
    }
    const std::size_t size = type == 'b' || type == 'c' ? 1 : (type == 'u' || type == 'l' ? 4 : 2);
    if (at_ + size > body_.size()) return end();
    std::int64_t value = 0;
    for (std::size_t i = size; i-- > 0;) value = value * 256 + body_[at_ + i];
    at_ += size;
    const bool is_signed = type == 'c' || type == 'i' || type == 'l';
    const std::int64_t range = std::int64_t{1} << (8 * size);
    if (is_signed && value >= range / 2) value -= range;
    return std::to_string(value);
  }
  std::optional<std::string> end() {
    ended_ = true;
    return std::nullopt;
  }

  const std::vector<std::uint8_t>& body_;
  std::size_t at_ = 0;
  bool ended_ = false;
  Fields fields_;
};

}  // namespace tandem::pioneer

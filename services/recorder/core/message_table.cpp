#include "services/recorder/core/message_table.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

namespace tandem::recorder {
namespace {

using idl::Kind;

constexpr std::uint32_t kLongestArrayOfColumns = 16;
constexpr std::size_t kEncapsulation = 4;

template <typename Number>
std::string text_of(Number value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

bool has_columns_of_its_own(const idl::Type& type) {
  return type.array_size > 0 && type.array_size <= kLongestArrayOfColumns;
}

/// Takes values off a CDR payload, and puts them into the cells of a row.
class Row {
 public:
  Row(const idl::Types& types, mcap::ByteView payload, std::size_t columns) : types_(types), cells_(columns) {
    if (payload.size() < kEncapsulation || payload[0] != 0) return;
    const std::uint8_t kind = payload[1];
    is_little_ = (kind & 1) != 0;
    if (kind == 0x06 || kind == 0x07) alignment_ = 4;  // XCDR2
    good_ = kind <= 0x01 || alignment_ == 4;
    bytes_ = payload.subspan(kEncapsulation);
  }

  void take_struct(const std::string& name) {
    for (const idl::Field& field : types_.structs.at(name)) take(field.type);
  }

  /// All that was read; none if something was missing.
  [[nodiscard]] std::optional<std::vector<std::string>> cells() {
    if (!good_) return std::nullopt;
    return std::move(cells_);
  }

 private:
  void take(const idl::Type& type) {
    idl::Type element = type;
    element.is_sequence = false;
    element.array_size = 0;
    const std::uint32_t count = type.is_sequence ? number<std::uint32_t>() : std::max(type.array_size, 1U);
    if (type.is_sequence && type.kind == Kind::Octet) {
      put(text_of(count));
      skip(count);
      return;
    }
    const std::size_t first = column_;
    std::size_t behind = first;
    if (count == 0) behind = first + width(element);
    for (std::uint32_t i = 0; good_ && i < count; ++i) {
      if (!has_columns_of_its_own(type)) column_ = first;
      take_one(element);
      behind = column_;
    }
    column_ = behind;
  }

  void take_one(const idl::Type& type) {
    switch (type.kind) {
      case Kind::Struct:
        return take_struct(type.name);
      case Kind::Boolean:
        return put(number<std::uint8_t>() != 0 ? "true" : "false");
      case Kind::Octet:
        return put(text_of(number<std::uint8_t>()));
      case Kind::Int16:
        return put(text_of(number<std::int16_t>()));
      case Kind::Int32:
        return put(text_of(number<std::int32_t>()));
      case Kind::Int64:
        return put(text_of(number<std::int64_t>()));
      case Kind::Uint16:
        return put(text_of(number<std::uint16_t>()));
      case Kind::Uint32:
        return put(text_of(number<std::uint32_t>()));
      case Kind::Uint64:
        return put(text_of(number<std::uint64_t>()));
      case Kind::Float:
        return put(text_of(std::bit_cast<float>(number<std::uint32_t>())));
      case Kind::Double:
        return put(text_of(std::bit_cast<double>(number<std::uint64_t>())));
      case Kind::Enum:
        return put(enumerator(type.name, number<std::uint32_t>()));
      case Kind::String:
        return put(text());
    }
  }

  [[nodiscard]] std::string enumerator(const std::string& name, std::uint32_t value) const {
    const auto& names = types_.enumerators.at(name);
    return value < names.size() ? names[value] : text_of(value);
  }

  std::string text() {
    const auto length = number<std::uint32_t>();  // with the zero at its end
    const std::size_t begin = at_;
    skip(length);
    if (!good_ || length == 0) return "";
    return {reinterpret_cast<const char*>(bytes_.data()) + begin, length - 1};
  }

  template <typename Number>
  Number number() {
    constexpr std::size_t size = sizeof(Number);
    const std::size_t step = std::min(size, alignment_);
    at_ = (at_ + step - 1) / step * step;
    const std::size_t begin = at_;
    skip(size);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; good_ && i < size; ++i) {
      bits |= static_cast<std::uint64_t>(bytes_[begin + i]) << (8 * (is_little_ ? i : size - 1 - i));
    }
    return static_cast<Number>(bits);
  }

  void skip(std::size_t count) {
    if (at_ > bytes_.size() || count > bytes_.size() - at_) good_ = false;
    if (good_) at_ += count;
  }

  void put(const std::string& value) {
    std::string& cell = cells_.at(column_++);
    if (!cell.empty()) cell += ' ';
    cell += value;
  }

  [[nodiscard]] std::size_t width(const idl::Type& type) const {
    if (type.kind != Kind::Struct) return 1;
    std::size_t sum = 0;
    for (const idl::Field& field : types_.structs.at(type.name)) {
      idl::Type element = field.type;
      element.is_sequence = false;
      element.array_size = 0;
      sum += width(element) * (has_columns_of_its_own(field.type) ? field.type.array_size : 1);
    }
    return sum;
  }

  const idl::Types& types_;
  std::vector<std::string> cells_;
  mcap::ByteView bytes_;
  std::size_t at_ = 0;
  std::size_t alignment_ = 8;
  std::size_t column_ = 0;
  bool is_little_ = true;
  bool good_ = false;
};

}  // namespace

std::optional<MessageTable> MessageTable::of(idl::Types types, const std::string& type_name) {
  if (!types.structs.contains(type_name)) return std::nullopt;
  MessageTable table{std::move(types), type_name};
  for (const idl::Field& field : table.types_.structs.at(type_name)) {
    table.name_columns(field.type, field.name, field.unit);
  }
  return table;
}

void MessageTable::name_columns(const idl::Type& type, const std::string& name, const std::string& unit) {
  idl::Type element = type;
  element.is_sequence = false;
  element.array_size = 0;
  if (has_columns_of_its_own(type)) {
    for (std::uint32_t i = 0; i < type.array_size; ++i) {
      name_columns(element, name + "[" + std::to_string(i) + "]", unit);
    }
  } else if (type.kind == Kind::Struct) {
    for (const idl::Field& field : types_.structs.at(type.name)) {
      name_columns(field.type, name + "." + field.name, field.unit);
    }
  } else {
    const std::string size = type.is_sequence && type.kind == Kind::Octet ? ".size" : "";
    columns_.push_back(name + size + (unit.empty() ? "" : " " + unit));
  }
}

std::optional<std::vector<std::string>> MessageTable::row_of(mcap::ByteView payload) const {
  Row row{types_, payload, columns_.size()};
  row.take_struct(type_name_);
  return row.cells();
}

}  // namespace tandem::recorder

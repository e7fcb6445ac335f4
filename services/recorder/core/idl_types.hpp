#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The IDL text that a recording carries as the schema of its messages, understood: what `tandem export csv` reads the
/// bytes of any recording by, whichever version wrote it.
namespace tandem::idl {

enum class Kind { Boolean, Octet, Int16, Int32, Int64, Uint16, Uint32, Uint64, Float, Double, String, Enum, Struct };

/// The type of a field.
struct Type {
  Kind kind = Kind::Octet;
  std::string name;              ///< of an Enum or a Struct, with its modules: "tandem::msg::Pose"
  bool is_sequence = false;      ///< of that
  std::uint32_t array_size = 0;  ///< 0: not an array
};

struct Field {
  std::string name;
  std::string unit;  ///< "[m]" where the comment behind the field begins with it, else empty
  Type type;
};

/// The definitions of one text.
struct Types {
  std::map<std::string, std::vector<Field>> structs;            ///< by name with modules
  std::map<std::string, std::vector<std::string>> enumerators;  ///< of enums, in order from 0
};

/// Understands modules, structs, enums, typedefs, sequences, arrays of one dimension and annotations (which change
/// nothing in the bytes of @final types); unions, bit masks and constants it does not. None if `text` has something it
/// does not understand, or a name that is not defined before its use.
[[nodiscard]] std::optional<Types> parse(std::string_view text);

}  // namespace tandem::idl

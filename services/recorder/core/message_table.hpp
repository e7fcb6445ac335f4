#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/recorder/core/idl_types.hpp"
#include "services/recorder/core/mcap_records.hpp"

namespace tandem::recorder {

/// Messages of one type as rows of a table, by the type's IDL: a column for each value, whatever it is nested in.
///
/// Columns are named as in the IDL, nested names with points, with the unit where the name does not hold it:
/// `map_from_base.x [m]`. Arrays of up to 16 have a column for each element (`covariance[4]`), longer ones and
/// sequences one with all values separated by blanks; `.size` is the length of a sequence of octets, whose bytes are
/// left out.
class MessageTable {
 public:
  /// None if `type_name` is not in `types`.
  [[nodiscard]] static std::optional<MessageTable> of(idl::Types types, const std::string& type_name);

  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  /// The cells of the message in `payload` (CDR with its encapsulation header); none if it is not a whole one.
  [[nodiscard]] std::optional<std::vector<std::string>> row_of(mcap::ByteView payload) const;

 private:
  MessageTable(idl::Types types, std::string type_name) : types_(std::move(types)), type_name_(std::move(type_name)) {}
  void name_columns(const idl::Type& type, const std::string& name, const std::string& unit);

  idl::Types types_;
  std::string type_name_;
  std::vector<std::string> columns_;
};

}  // namespace tandem::recorder

#include "services/recorder/core/idl_types.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace tandem::idl {
namespace {

/// A word, a number or a sign; `unit` is "[m]" where the rest of its line is a comment that begins so.
struct Token {
  std::string text;
  std::string unit;
};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':';
}

std::string unit_in(std::string_view comment) {
  const std::size_t begin = comment.find_first_not_of("/ ");
  if (begin == std::string_view::npos || comment[begin] != '[') return "";
  const std::size_t end = comment.find(']', begin);
  return end == std::string_view::npos ? "" : std::string{comment.substr(begin, end - begin + 1)};
}

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (text.substr(i, 2) == "//") {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      if (!tokens.empty() && tokens.back().text == ";") tokens.back().unit = unit_in(text.substr(i, end - i));
      i = end;
    } else if (text.substr(i, 2) == "/*") {
      const std::size_t end = text.find("*/", i);
      i = end == std::string_view::npos ? text.size() : end + 2;
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++i;
    } else if (is_word(c)) {
      const std::size_t begin = i;
      while (i < text.size() && is_word(text[i])) ++i;
      tokens.push_back({std::string{text.substr(begin, i - begin)}, ""});
    } else {
      tokens.push_back({std::string(1, c), ""});
      ++i;
    }
  }
  return tokens;
}

/// A text in this form is no IDL that we know: ends the parse.
struct NotUnderstood {};

class Parser {
 public:
  explicit Parser(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  Types all() {
    while (at_ < tokens_.size()) definition();
    return std::move(types_);
  }

 private:
  const Token& next() {
    if (at_ >= tokens_.size()) throw NotUnderstood{};
    return tokens_[at_++];
  }
  [[nodiscard]] bool is_next(std::string_view text) const { return at_ < tokens_.size() && tokens_[at_].text == text; }
  bool take(std::string_view text) {
    const bool is = is_next(text);
    if (is) ++at_;
    return is;
  }
  const Token& expect(std::string_view text) {
    const Token& token = next();
    if (token.text != text) throw NotUnderstood{};
    return token;
  }
  void skip_annotations() {
    while (take("@")) {
      (void)next();
      if (!take("(")) continue;
      while (!take(")")) (void)next();
    }
  }

  void definition() {
    skip_annotations();
    const std::string what = next().text;
    if (what == "module") {
      modules_.push_back(next().text);
      expect("{");
      while (!take("}")) definition();
      modules_.pop_back();
    } else if (what == "struct") {
      structure();
    } else if (what == "enum") {
      enumeration();
    } else if (what == "typedef") {
      const Type base = type();
      const std::string name = next().text;
      typedefs_[scoped(name)] = with_array(base);
    } else {
      throw NotUnderstood{};
    }
    expect(";");
  }

  void structure() {
    const std::string name = scoped(next().text);
    expect("{");
    std::vector<Field> fields;
    while (!take("}")) {
      skip_annotations();
      Field field;
      const Type base = type();
      field.name = next().text;
      field.type = with_array(base);
      field.unit = expect(";").unit;
      fields.push_back(std::move(field));
    }
    types_.structs[name] = std::move(fields);
  }

  void enumeration() {
    const std::string name = scoped(next().text);
    expect("{");
    std::vector<std::string> values;
    while (!take("}")) {
      skip_annotations();
      values.push_back(next().text);
      if (!take(",") && !is_next("}")) throw NotUnderstood{};
    }
    types_.enumerators[name] = std::move(values);
  }

  Type with_array(Type type) {
    if (!take("[")) return type;
    if (type.is_sequence || type.array_size > 0) throw NotUnderstood{};
    type.array_size = number();
    expect("]");
    if (is_next("[") || type.array_size == 0) throw NotUnderstood{};
    return type;
  }

  std::uint32_t number() {
    const std::string text = next().text;
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) throw NotUnderstood{};
    return value;
  }

  Type type() {
    const std::string word = next().text;
    if (word == "sequence") {
      expect("<");
      Type element = type();
      if (element.is_sequence || element.array_size > 0) throw NotUnderstood{};
      if (take(",")) (void)number();
      expect(">");
      element.is_sequence = true;
      return element;
    }
    if (word == "string" && take("<")) {
      (void)number();
      expect(">");
    }
    if (word == "unsigned") return integer(false);
    if (word == "short" || word == "long") {
      --at_;
      return integer(true);
    }
    static const std::map<std::string, Kind> simple{
        {"boolean", Kind::Boolean}, {"octet", Kind::Octet}, {"uint8", Kind::Octet},   {"int16", Kind::Int16},
        {"uint16", Kind::Uint16},   {"int32", Kind::Int32}, {"uint32", Kind::Uint32}, {"int64", Kind::Int64},
        {"uint64", Kind::Uint64},   {"float", Kind::Float}, {"double", Kind::Double}, {"string", Kind::String}};
    const auto known = simple.find(word);
    return known == simple.end() ? named(word) : Type{known->second, "", false, 0};
  }

  Type integer(bool is_signed) {
    const std::string word = next().text;
    if (word == "short") return {is_signed ? Kind::Int16 : Kind::Uint16, "", false, 0};
    if (word != "long") throw NotUnderstood{};
    if (take("long")) return {is_signed ? Kind::Int64 : Kind::Uint64, "", false, 0};
    if (is_next("double")) throw NotUnderstood{};
    return {is_signed ? Kind::Int32 : Kind::Uint32, "", false, 0};
  }

  /// A name of our own, looked for from the inner modules outwards.
  Type named(const std::string& word) {
    for (std::size_t depth = modules_.size() + 1; depth-- > 0;) {
      const std::string name = scoped(word, depth);
      if (const auto known = typedefs_.find(name); known != typedefs_.end()) return known->second;
      if (types_.structs.contains(name)) return {Kind::Struct, name, false, 0};
      if (types_.enumerators.contains(name)) return {Kind::Enum, name, false, 0};
    }
    throw NotUnderstood{};
  }

  [[nodiscard]] std::string scoped(const std::string& word) const { return scoped(word, modules_.size()); }
  [[nodiscard]] std::string scoped(const std::string& word, std::size_t depth) const {
    std::string name;
    for (std::size_t i = 0; i < depth; ++i) name += modules_[i] + "::";
    return name + word;
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::vector<std::string> modules_;
  std::map<std::string, Type> typedefs_;
  Types types_;
};

}  // namespace

std::optional<Types> parse(std::string_view text) {
  try {
    return Parser{tokens_of(text)}.all();
  } catch (const NotUnderstood&) {
    return std::nullopt;
  }
}

}  // namespace tandem::idl

#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <burin/base/suggest.hpp>
#include <burin/params/read_context.hpp>
#include <burin/params/value.hpp>

/// How a value of a preset becomes a C++ value. A type takes part by specialising ValueType<T>:
///   static std::string name();                                            for help: "number", "length", "motif"
///   static bool read(const Value&, T&, ReadContext&);                     false after reporting why not
///   static std::string text(const T&);                                    the default, as it would be written
/// An enumeration only lists its words: `constexpr auto words(E)` returning std::array<Word<E>, n>, found by ADL.
namespace burin::params {

template <class T>
struct ValueType;

/// One word of an enumeration.
template <class E>
struct Word {
  std::string_view text;
  E value;
};

/// Reports "'what' must be <expected>, not <kind of value>".
bool report_kind(const Value& value, std::string_view expected, ReadContext& context);

/// A number or the text of a constant expression; finite. False after reporting.
bool read_number(const Value& value, double& number, ReadContext& context);

template <>
struct ValueType<double> {
  static std::string name() { return "number"; }
  static bool read(const Value& value, double& number, ReadContext& context) {
    return read_number(value, number, context);
  }
  static std::string text(const double& number);
};

template <>
struct ValueType<std::int64_t> {
  static std::string name() { return "whole number"; }
  static bool read(const Value& value, std::int64_t& number, ReadContext& context);
  static std::string text(const std::int64_t& number) { return std::to_string(number); }
};

template <>
struct ValueType<int> {
  static std::string name() { return "whole number"; }
  static bool read(const Value& value, int& number, ReadContext& context);
  static std::string text(const int& number) { return std::to_string(number); }
};

template <>
struct ValueType<bool> {
  static std::string name() { return "true or false"; }
  static bool read(const Value& value, bool& flag, ReadContext& context);
  static std::string text(const bool& flag) { return flag ? "true" : "false"; }
};

template <>
struct ValueType<std::string> {
  static std::string name() { return "text"; }
  static bool read(const Value& value, std::string& text, ReadContext& context);
  static std::string text(const std::string& text) { return '"' + text + '"'; }
};

/// A length on the page: "15mm", "0.3pt", "($w*2)mm"; a bare number is millimetres.
struct Length {
  double mm = 0.0;
  friend bool operator==(const Length&, const Length&) = default;
};

template <>
struct ValueType<Length> {
  static std::string name() { return "length"; }
  static bool read(const Value& value, Length& length, ReadContext& context);
  static std::string text(const Length& length);
};

template <class E>
concept Worded = std::is_enum_v<E> && requires(E e) {
  words(e);
};

template <Worded E>
struct ValueType<E> {
  static std::vector<std::string_view> known() {
    std::vector<std::string_view> texts;
    for (const Word<E>& word : words(E{})) texts.push_back(word.text);
    return texts;
  }
  static std::string name() {
    std::string all;
    for (const std::string_view word : known()) all += (all.empty() ? "" : " | ") + std::string(word);
    return all;
  }
  static bool read(const Value& value, E& choice, ReadContext& context) {
    const std::string* text = value.text();
    if (text == nullptr) return report_kind(value, "one of " + name(), context);
    for (const Word<E>& word : words(E{})) {
      if (word.text == *text) {
        choice = word.value;
        return true;
      }
    }
    context.report(value.where, "'" + *text + "' is none of the choices" + suggestion(*text, known()));
    return false;
  }
  static std::string text(const E& choice) {
    for (const Word<E>& word : words(E{})) {
      if (word.value == choice) return '"' + std::string(word.text) + '"';
    }
    return {};
  }
};

template <class T>
struct ValueType<std::optional<T>> {
  static std::string name() { return ValueType<T>::name(); }
  static bool read(const Value& value, std::optional<T>& target, ReadContext& context) {
    T inner{};
    if (!ValueType<T>::read(value, inner, context)) return false;
    target = std::move(inner);
    return true;
  }
  static std::string text(const std::optional<T>& value) { return value ? ValueType<T>::text(*value) : ""; }
};

template <class T>
struct ValueType<std::vector<T>> {
  static std::string name() { return "list of " + ValueType<T>::name(); }
  static bool read(const Value& value, std::vector<T>& target, ReadContext& context) {
    const Array* array = value.array();
    if (array == nullptr) return report_kind(value, "a list", context);
    target.clear();
    bool all = true;
    for (const Value& item : *array) {
      T inner{};
      if (ValueType<T>::read(item, inner, context)) {
        target.push_back(std::move(inner));
      } else {
        all = false;
      }
    }
    return all;
  }
  static std::string text(const std::vector<T>& values) {
    std::string all;
    for (const T& value : values) all += (all.empty() ? "" : ", ") + ValueType<T>::text(value);
    return '[' + all + ']';
  }
};

}  // namespace burin::params

#include "engine/core/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/core/error.h"

namespace offing {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;  // Clang 14 does not deduce it by itself

// A value as shown in a message: on one line and short, whatever the user wrote.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string line;
  for (const char c : text.substr(0, kLongest)) {
    line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  return text.size() > kLongest ? line + "…" : line;
}

std::string shown(const FieldValue& value) {
  return std::visit(
      Overloaded{
          [](bool flag) { return std::string(flag ? "true" : "false"); },
          [](double number) { return fmt::format("{}", number); },
          [](const std::string& text) { return '"' + shown(std::string_view(text)) + '"'; },
          [](const std::vector<double>& list) {
            return shown(std::string_view(fmt::format("{}", fmt::join(list, ","))));
          },
      },
      value);
}

std::string_view type_name(const FieldValue& value) {
  constexpr std::string_view kNames[] = {"true or false", "a number", "text", "a list of numbers"};
  return kNames[value.index()];
}

[[noreturn]] void refuse(std::string_view where, std::string_view key, std::string_view value,
                         std::string_view why) {
  throw InputError(fmt::format("{}: {} = {}: {}", where, key, value, why));
}

bool in_range(const Field& field, double value) {
  return std::isfinite(value) && value >= field.min && value <= field.max;
}

bool fits_int(double value) {
  return value == std::floor(value) && value >= std::numeric_limits<int>::min() &&
         value <= std::numeric_limits<int>::max();
}

std::string range_text(const Field& field) {
  return fmt::format("{} to {}{}{}", field.min, field.max, field.unit.empty() ? "" : " ",
                     field.unit);
}

std::string numbers_text(int count, const Field& field) {
  return fmt::format("{} numbers, each {}", count, range_text(field));
}

std::string wrong_type(std::string_view needed, const FieldValue& value) {
  return fmt::format("must be {}, not {}", needed, type_name(value));
}

std::string problem_of_list(const Field& field, const FieldValue& value, std::size_t count) {
  const std::string needed = numbers_text(static_cast<int>(count), field);
  const auto* list = std::get_if<std::vector<double>>(&value);
  if (!list) return wrong_type(needed, value);
  const bool fine = list->size() == count && std::all_of(list->begin(), list->end(), [&](double v) {
                      return in_range(field, v);
                    });
  return fine ? "" : "must be " + needed;
}

// What keeps the field from taking this value; empty where nothing does.
std::string problem(const Field& field, const FieldValue& value) {
  const auto* number = std::get_if<double>(&value);
  const auto* text = std::get_if<std::string>(&value);
  return std::visit(
      Overloaded{
          [&](bool*) {
            return std::holds_alternative<bool>(value) ? std::string()
                                                       : wrong_type("true or false", value);
          },
          [&](int*) {
            if (!number) return wrong_type(FieldTable::allowed(field), value);
            return in_range(field, *number) && fits_int(*number)
                       ? std::string()
                       : "must be " + FieldTable::allowed(field);
          },
          [&](double*) {
            if (!number) return wrong_type("a number, " + range_text(field), value);
            return in_range(field, *number) ? std::string() : "must be " + range_text(field);
          },
          [&](glm::dvec2*) { return problem_of_list(field, value, 2); },
          [&](glm::dvec3*) { return problem_of_list(field, value, 3); },
          [&](std::string*) {
            if (!text) return wrong_type("text", value);
            return field.check ? field.check(*text) : std::string();
          },
          [&](const Choice& choice) {
            if (!text) return wrong_type(FieldTable::allowed(field), value);
            const bool known =
                std::find(choice.names.begin(), choice.names.end(), *text) != choice.names.end();
            return known ? std::string() : "must be " + FieldTable::allowed(field);
          },
      },
      field.target);
}

// Only for values that problem() finds nothing wrong with.
void assign(const Field& field, const FieldValue& value) {
  std::visit(Overloaded{
                 [&](bool* target) { *target = std::get<bool>(value); },
                 [&](int* target) { *target = static_cast<int>(std::get<double>(value)); },
                 [&](double* target) { *target = std::get<double>(value); },
                 [&](glm::dvec2* target) {
                   const auto& list = std::get<std::vector<double>>(value);
                   *target = {list[0], list[1]};
                 },
                 [&](glm::dvec3* target) {
                   const auto& list = std::get<std::vector<double>>(value);
                   *target = {list[0], list[1], list[2]};
                 },
                 [&](std::string* target) { *target = std::get<std::string>(value); },
                 [&](const Choice& choice) {
                   const auto name = std::find(choice.names.begin(), choice.names.end(),
                                               std::get<std::string>(value));
                   *choice.index = static_cast<int>(name - choice.names.begin());
                 },
             },
             field.target);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// A whole decimal number and nothing else.
std::optional<double> parse_number(std::string_view text) {
  text = trimmed(text);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> parse_list(std::string_view text) {
  std::vector<double> list;
  while (true) {
    const std::size_t comma = text.find(',');
    const auto number = parse_number(text.substr(0, comma));
    if (!number) return std::nullopt;
    list.push_back(*number);
    if (comma == std::string_view::npos) return list;
    text.remove_prefix(comma + 1);
  }
}

template <class T>
std::optional<FieldValue> as_value(std::optional<T> value) {
  if (!value) return std::nullopt;
  return FieldValue(std::move(*value));
}

std::optional<FieldValue> parse(const Field& field, std::string_view text) {
  const auto list = [&](auto*) { return as_value(parse_list(text)); };
  return std::visit(Overloaded{
                        [&](bool*) -> std::optional<FieldValue> {
                          if (text == "true" || text == "false") return text == "true";
                          return std::nullopt;
                        },
                        [&](int*) { return as_value(parse_number(text)); },
                        [&](double*) { return as_value(parse_number(text)); },
                        [&](glm::dvec2* target) { return list(target); },
                        [&](glm::dvec3* target) { return list(target); },
                        [&](std::string*) { return as_value(std::optional(std::string(text))); },
                        [&](const Choice&) { return as_value(std::optional(std::string(text))); },
                    },
                    field.target);
}

// Levenshtein's distance: insertions, deletions and changes of one character.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

const Field& known(const FieldTable& table, std::string_view key, std::string_view where) {
  if (const Field* field = table.find(key)) return *field;
  key = key.substr(0, 200);
  const Field* nearest = nullptr;
  std::size_t least = std::max<std::size_t>(3, key.size() / 2) + 1;
  for (const Field& field : table.fields()) {
    // "wind.speed" means environment.wind.speed, however many letters are missing.
    const bool tail = field.key.size() > key.size() + 1 && !key.empty() &&
                      field.key.ends_with(key) &&
                      field.key[field.key.size() - key.size() - 1] == '.';
    const std::size_t distance = tail ? 1 : edit_distance(key, field.key);
    if (distance >= least) continue;
    least = distance;
    nearest = &field;
  }
  const std::string advice =
      nearest ? fmt::format("did you mean {}?", nearest->key) : "--list-keys names them all";
  throw InputError(fmt::format("{}: {}: no such key; {}", where, shown(key), advice));
}

}  // namespace

FieldTable& FieldTable::group(std::string_view prefix) {
  prefix_ = prefix.empty() ? "" : fmt::format("{}.", prefix);
  return *this;
}

Field& FieldTable::add(std::string_view key, std::string_view help, Range range,
                       std::string_view unit) {
  std::string full = prefix_ + std::string(key);
  if (find(full)) throw Error(fmt::format("field table: {} is there twice; rename one", full));
  Field& field = fields_.emplace_back();
  field.key = std::move(full);
  field.help = help;
  field.min = range.min;
  field.max = range.max;
  field.unit = unit;
  return field;
}

FieldTable& FieldTable::flag(std::string_view key, bool& value, std::string_view help) {
  add(key, help).target = &value;
  return *this;
}

FieldTable& FieldTable::integer(std::string_view key, int& value, Range range,
                                std::string_view help) {
  add(key, help, range).target = &value;
  return *this;
}

FieldTable& FieldTable::number(std::string_view key, double& value, Range range,
                               std::string_view unit, std::string_view help) {
  add(key, help, range, unit).target = &value;
  return *this;
}

FieldTable& FieldTable::vector(std::string_view key, glm::dvec2& value, Range range,
                               std::string_view unit, std::string_view help) {
  add(key, help, range, unit).target = &value;
  return *this;
}

FieldTable& FieldTable::vector(std::string_view key, glm::dvec3& value, Range range,
                               std::string_view unit, std::string_view help) {
  add(key, help, range, unit).target = &value;
  return *this;
}

FieldTable& FieldTable::choice(std::string_view key, int& index,
                               std::vector<std::string_view> names, std::string_view help) {
  add(key, help).target = Choice{&index, std::move(names)};
  return *this;
}

FieldTable& FieldTable::text(std::string_view key, std::string& value, std::string_view help,
                             std::function<std::string(std::string_view)> check) {
  Field& field = add(key, help);
  field.target = &value;
  field.check = std::move(check);
  return *this;
}

const Field* FieldTable::find(std::string_view key) const {
  const auto field =
      std::find_if(fields_.begin(), fields_.end(), [&](const Field& f) { return f.key == key; });
  return field == fields_.end() ? nullptr : &*field;
}

void FieldTable::check(std::string_view key, const FieldValue& value,
                       std::string_view where) const {
  const std::string why = problem(known(*this, key, where), value);
  if (!why.empty()) refuse(where, key, shown(value), why);
}

void FieldTable::set(std::string_view key, const FieldValue& value, std::string_view where) const {
  check(key, value, where);
  assign(*find(key), value);
}

void FieldTable::set_from_text(std::string_view key, std::string_view text,
                               std::string_view where) const {
  const Field& field = known(*this, key, where);
  const std::optional<FieldValue> value = parse(field, text);
  const std::string why = value ? problem(field, *value) : "must be " + allowed(field);
  if (!why.empty()) refuse(where, key, shown(text), why);
  assign(field, *value);
}

std::string FieldTable::to_text(const Field& field) {
  return std::visit(
      Overloaded{
          [](const bool* value) { return std::string(*value ? "true" : "false"); },
          [](const int* value) { return fmt::format("{}", *value); },
          [](const double* value) { return fmt::format("{}", *value); },
          [](const glm::dvec2* value) { return fmt::format("{},{}", value->x, value->y); },
          [](const glm::dvec3* value) {
            return fmt::format("{},{},{}", value->x, value->y, value->z);
          },
          [](const std::string* value) { return *value; },
          [](const Choice& choice) {
            return std::string(choice.names.at(static_cast<std::size_t>(*choice.index)));
          },
      },
      field.target);
}

std::string FieldTable::allowed(const Field& field) {
  return std::visit(Overloaded{
                        [](bool*) { return std::string("true or false"); },
                        [&](int*) { return "a whole number, " + range_text(field); },
                        [&](double*) { return range_text(field); },
                        [&](glm::dvec2*) { return numbers_text(2, field); },
                        [&](glm::dvec3*) { return numbers_text(3, field); },
                        [](std::string*) { return std::string("text"); },
                        [](const Choice& choice) {
                          const auto& names = choice.names;
                          if (names.size() == 1) return std::string(names[0]);
                          return fmt::format("{} or {}",
                                             fmt::join(names.begin(), names.end() - 1, ", "),
                                             names.back());
                        },
                    },
                    field.target);
}

}  // namespace offing

#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace offing {

/// A value as it is written in a scene file or after `--set key=`.
using FieldValue = std::variant<bool, double, std::string, std::vector<double>>;

/// An integer that stands for one of a list of names.
struct Choice {
  int* index;
  std::vector<std::string_view> names;
};

/// One editable value of a live struct. The table of a struct's fields is the only place that names
/// them: it makes the scene key, `--set`, `--list-keys` and the slider.
struct Field {
  std::string key;  ///< "environment.wind.speed"
  std::variant<bool*, int*, double*, glm::dvec2*, glm::dvec3*, std::string*, Choice> target;
  double min = 0.0, max = 0.0;  ///< numbers only, in the unit below; inclusive
  std::string unit;             ///< "m/s"; empty where there is none
  std::string help;             ///< one phrase for --list-keys and tooltips
  /// Text only: returns an empty string where the text is fine, else what is wrong ("must be …").
  std::function<std::string(std::string_view)> check;
};

/// All the fields of a scene, bound to one instance (which must outlive the table).
class FieldTable {
 public:
  /// Keys added until the next call begin with "prefix.".
  FieldTable& group(std::string_view prefix);

  struct Range {
    double min, max;
  };
  FieldTable& flag(std::string_view key, bool& value, std::string_view help);
  FieldTable& integer(std::string_view key, int& value, Range range, std::string_view help);
  FieldTable& number(std::string_view key, double& value, Range range, std::string_view unit,
                     std::string_view help);
  FieldTable& vector(std::string_view key, glm::dvec2& value, Range range, std::string_view unit,
                     std::string_view help);
  FieldTable& vector(std::string_view key, glm::dvec3& value, Range range, std::string_view unit,
                     std::string_view help);
  FieldTable& choice(std::string_view key, int& index, std::vector<std::string_view> names,
                     std::string_view help);
  FieldTable& text(std::string_view key, std::string& value, std::string_view help,
                   std::function<std::string(std::string_view)> check);

  const std::vector<Field>& fields() const { return fields_; }
  /// nullptr where there is none.
  const Field* find(std::string_view key) const;

  /// Sets one field. `where` names the source in messages ("assets/scenes/gale.toml:12" or
  /// "--set"). Throws InputError: "{where}: {key} = {value}: must be 0 to 60 m/s", or, for an
  /// unknown key, one that names the nearest known key. Nothing is changed when it throws.
  void set(std::string_view key, const FieldValue& value, std::string_view where) const;
  /// Throws where set() would; changes nothing.
  void check(std::string_view key, const FieldValue& value, std::string_view where) const;
  /// The same from text: "12.5", "true", "jonswap", "10,2,-30".
  void set_from_text(std::string_view key, std::string_view text, std::string_view where) const;

  /// The value as set_from_text() would read it.
  static std::string to_text(const Field& field);
  /// "0 to 60 m/s", "true or false", "pm, jonswap or tma", …
  static std::string allowed(const Field& field);

 private:
  Field& add(std::string_view key, std::string_view help, Range range = {0.0, 0.0},
             std::string_view unit = {});
  std::string prefix_;
  std::vector<Field> fields_;
};

}  // namespace offing

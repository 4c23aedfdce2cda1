#pragma once
#include <string_view>

#include "engine/core/fields.h"

namespace offing {

/// A slider, box or list for every field whose key begins with `prefix`, and not with `except`,
/// made from the field table alone.
void draw_fields(const FieldTable& table, std::string_view prefix, std::string_view except = "-");

}  // namespace offing

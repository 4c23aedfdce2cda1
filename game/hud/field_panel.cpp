#include "game/hud/field_panel.h"

#include <imgui.h>

#include <array>

namespace offing {
namespace {

struct Widget {
  const Field& field;
  const char* label;

  bool operator()(bool* value) const { return ImGui::Checkbox(label, value); }
  bool operator()(int* value) const {
    return ImGui::SliderInt(label, value, static_cast<int>(field.min), static_cast<int>(field.max));
  }
  bool operator()(double* value) const {
    const std::string format = field.unit.empty() ? "%.2f" : "%.2f " + field.unit;
    // A range over many decades is only usable on a logarithmic slider.
    const bool wide = field.min > 0.0 && field.max / field.min > 500.0;
    return ImGui::SliderScalar(label, ImGuiDataType_Double, value, &field.min, &field.max,
                               format.c_str(), wide ? ImGuiSliderFlags_Logarithmic : 0);
  }
  bool operator()(glm::dvec2* value) const { return drag(&value->x, 2); }
  bool operator()(glm::dvec3* value) const { return drag(&value->x, 3); }
  bool operator()(std::string*) const {
    ImGui::LabelText(label, "%s", FieldTable::to_text(field).c_str());
    return false;
  }
  bool operator()(const Choice& choice) const {
    bool changed = false;
    const std::string now(choice.names[static_cast<std::size_t>(*choice.index)]);
    if (!ImGui::BeginCombo(label, now.c_str())) return false;
    for (std::size_t i = 0; i < choice.names.size(); ++i) {
      const bool selected = static_cast<std::size_t>(*choice.index) == i;
      if (ImGui::Selectable(std::string(choice.names[i]).c_str(), selected)) {
        *choice.index = static_cast<int>(i);
        changed = true;
      }
    }
    ImGui::EndCombo();
    return changed;
  }

 private:
  bool drag(double* first, int count) const {
    return ImGui::DragScalarN(label, ImGuiDataType_Double, first, count, 0.1f, &field.min,
                              &field.max, "%.1f");
  }
};

}  // namespace

bool draw_fields(const FieldTable& table, std::string_view prefix) {
  bool changed = false;
  for (const Field& field : table.fields()) {
    if (field.key.rfind(prefix, 0) != 0) continue;
    const std::string label = field.key.substr(prefix.size()) + "##" + field.key;
    changed |= std::visit(Widget{field, label.c_str()}, field.target);
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s (%s)\n%s", field.help.c_str(), FieldTable::allowed(field).c_str(),
                        field.key.c_str());
    }
  }
  return changed;
}

}  // namespace offing

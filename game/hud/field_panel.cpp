#include "game/hud/field_panel.h"

#include <imgui.h>

#include <algorithm>
#include <string>

namespace offing {
namespace {

struct Widget {
  const Field& field;
  const char* label;

  void operator()(bool* value) const { ImGui::Checkbox(label, value); }
  void operator()(int* value) const {
    ImGui::SliderInt(label, value, static_cast<int>(field.min), static_cast<int>(field.max));
  }
  void operator()(double* value) const {
    const std::string format = field.unit.empty() ? "%.2f" : "%.2f " + field.unit;
    // A range over many decades is only usable on a logarithmic slider.
    const bool wide = field.min > 0.0 && field.max / field.min > 500.0;
    ImGui::SliderScalar(label, ImGuiDataType_Double, value, &field.min, &field.max, format.c_str(),
                        wide ? ImGuiSliderFlags_Logarithmic : 0);
  }
  void operator()(glm::dvec2* value) const { drag(&value->x, 2); }
  void operator()(glm::dvec3* value) const { drag(&value->x, 3); }
  void operator()(std::string*) const {
    ImGui::LabelText(label, "%s", FieldTable::to_text(field).c_str());
  }
  void operator()(const Choice& choice) const {
    const std::string now(choice.names[static_cast<std::size_t>(*choice.index)]);
    if (!ImGui::BeginCombo(label, now.c_str())) return;
    for (std::size_t i = 0; i < choice.names.size(); ++i) {
      const bool selected = static_cast<std::size_t>(*choice.index) == i;
      if (ImGui::Selectable(std::string(choice.names[i]).c_str(), selected)) {
        *choice.index = static_cast<int>(i);
      }
    }
    ImGui::EndCombo();
  }

 private:
  void drag(double* first, int count) const {
    ImGui::DragScalarN(label, ImGuiDataType_Double, first, count, 0.1f, &field.min, &field.max,
                       "%.1f");
  }
};

// "environment.wind.speed" → "wind speed": the first word is the panel's heading.
std::string label_of(const std::string& key) {
  std::string label = key.substr(key.find('.') + 1);
  std::replace(label.begin(), label.end(), '.', ' ');
  return label;
}

}  // namespace

void draw_fields(const FieldTable& table, std::string_view prefix, std::string_view except) {
  for (const Field& field : table.fields()) {
    if (field.key.rfind(prefix, 0) != 0 || field.key.rfind(except, 0) == 0) continue;
    const std::string label = label_of(field.key) + "##" + field.key;
    std::visit(Widget{field, label.c_str()}, field.target);
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s (%s)\n%s", field.help.c_str(), FieldTable::allowed(field).c_str(),
                        field.key.c_str());
    }
  }
}

}  // namespace offing

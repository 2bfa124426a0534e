#include "src/ui/labels.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include "parser/text/ranges.h"
#include "src/ui/kit/text.h"

namespace snell::ui {

namespace {

// Returns a label such as "Glass : uEta =     1.1000", in glman's format.
Text label_of(const Scene& scene, const Control& control) {
    Text text("{} : {} = ", scene.programs[control.program].name, control.name);
    if (control.type == ValueType::bool_) return std::move(text.append(control.value[0] != 0 ? "true" : "false"));
    const bool integral = control.type == ValueType::int_ || control.type == ValueType::uint_;
    for (std::size_t i = 0; i < control.value.size(); ++i) {
        if (i > 0) text.append(", ");
        if (integral)
            text.add("{:10.0f}", control.value[i]);
        else if (control.widget == Widget::color)
            text.add("{:8.3f}", control.value[i]);
        else
            text.add("{:10.4f}", control.value[i]);
    }
    return text;
}

}  // namespace

std::string cut_name(const std::string& label, std::size_t columns) {
    const std::size_t equals = std::min(label.find(" = "), label.size());
    const std::string value = label.substr(equals);
    const std::size_t kept = std::min(equals, columns > value.size() + 1 ? columns - value.size() - 1 : 0);
    const auto inside = [&](std::size_t at) { return at < equals && (label[at] & 0xC0) == 0x80; };
    std::size_t head = (kept + 1) / 2, tail = equals - kept / 2;
    while (head > 0 && inside(head)) --head;
    while (inside(tail)) ++tail;
    return label.substr(0, head) + "\u2026" + label.substr(tail, equals - tail) + value;
}

void value_labels(const Facts& facts, const Controls& controls, const Rect& scene, const Fonts& fonts) {
    if (!facts.scene) return;
    const auto labelled = [](const Control& c) { return c.listed && c.active && c.widget != Widget::none; };
    const float size = fonts.mono->FontSize, line = std::round(size * 1.25F), margin = std::round(size * .6F);
    const float room = (scene.width - 2 * margin) / fonts.mono->CalcTextSizeA(size, FLT_MAX, 0, "M").x;
    const auto count = static_cast<float>(ranges::count_if(controls.items, labelled));
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({scene.x, scene.y}, {scene.x + scene.width, scene.y + scene.height});
    float y = scene.y + scene.height - margin - count * line;
    for (const Control& control : controls.items) {
        if (!labelled(control)) continue;
        Text text = label_of(*facts.scene, control);
        if (const auto columns = static_cast<std::size_t>(room); text.view().size() > columns)
            text = Text(cut_name(std::string(text.view()), columns));
        const ImVec2 at(scene.x + margin, y);
        // A dark outline makes the white text visible on white pictures.
        for (const ImVec2 off : {ImVec2(1, 1), ImVec2(-1, 1), ImVec2(1, -1), ImVec2(-1, -1)})
            list.AddText(fonts.mono, size, {at.x + off.x, at.y + off.y}, IM_COL32(0, 0, 0, 190), text.c_str());
        list.AddText(fonts.mono, size, at, IM_COL32_WHITE, text.c_str());
        y += line;
    }
    list.PopClipRect();
}

}  // namespace snell::ui

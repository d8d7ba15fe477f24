// The picture before and after the last edit, by one key.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

class BeforeAfter final : public Panel {
  public:
    void drawOver(Ui& ui) override {
        if (!ui.session.showsBefore()) return;
        const char* text = "before the last edit (K: after it)";
        const float pad = 6 * ui.shared.scale;
        const ImVec2 size = ImGui::CalcTextSize(text);
        // Where the source does not cover the picture.
        const ImVec2 at(std::max(ui.frame.picture[0], ui.frame.covered) + 2 * pad,
                        ui.frame.picture[1] + 2 * pad);
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.AddRectFilled({at.x - pad, at.y - pad}, {at.x + size.x + pad, at.y + size.y + pad},
                           IM_COL32(0, 0, 0, 190), 3);
        list.AddText(at, IM_COL32_WHITE, text);
    }
    void addTo(nlohmann::ordered_json& state, const Ui& ui) const override {
        state["before"] = {{"known", ui.session.pictureBefore() != nullptr},
                           {"shown", ui.session.showsBefore()}};
    }
};

void toggleBefore(Ui& ui, Panel& /*panel*/) {
    if (ui.session.pictureBefore() == nullptr)
        ui.notice = "no edit has been made yet: there is no picture from before it";
    else
        ui.session.showBefore(!ui.session.showsBefore());
}

constexpr auto kBeforeKeys =
    std::to_array<Shortcut>({{KeyGroup::pipeline, GLFW_KEY_K, false, "K",
                              "the picture before the last edit, and after it", toggleBefore}});

}  // namespace

const PanelRow kBeforeAfterRow{
    .name = "before", .place = PanelPlace::picture, .make = make<BeforeAfter>, .keys = kBeforeKeys};

}  // namespace glibra::view

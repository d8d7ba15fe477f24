// The result of the last action for a moment on the picture, while the panel with the status line is hidden.

#include <imgui.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

constexpr double kSeconds = 4;

class NoticeOverlay final : public Panel {
  public:
    void show(Ui& ui) override {
        const double now = ImGui::GetTime();
        if (ui.notice.text != text_) {
            text_ = ui.notice.text;
            since_ = now;
        }
        isShown_ = !ui.shared.showPanel && !text_.empty() && now - since_ < kSeconds;
        if (!isShown_) return;
        ui.frame.isFollowed = true;  // until it goes
        const float gap = 8 * ui.shared.scale;
        // Not over the tabs of the source.
        const Rectangle& room = ui.frame.room;
        const float left = std::max(room[0], ui.frame.covered);
        ImGui::SetNextWindowPos({left + gap, room[1] + gap});
        ImGui::SetNextWindowBgAlpha(.9F);
        if (ImGui::Begin("##notice", nullptr,
                         ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoInputs |
                             ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
            ImGui::PushTextWrapPos(std::max(100.F, room[0] + room[2] - left - 4 * gap));
            ImGui::TextColored(asVector(ui.notice.isError ? palette().error : palette().text), "%s",
                               text_.c_str());
            ImGui::PopTextWrapPos();
            markWindow(ui, "notice/overlay");
        }
        ImGui::End();
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["noticeOverlay"] = isShown_;
    }

  private:
    std::string text_;
    double since_ = 0;
    bool isShown_ = false;
};

}  // namespace

const PanelRow kNoticeRow{.name = "notice", .place = PanelPlace::floating, .make = make<NoticeOverlay>};

}  // namespace glibra::view

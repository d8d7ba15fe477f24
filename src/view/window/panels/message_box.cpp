// What a scene asks the user when it is loaded: messages, and files that it does not name.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/format.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"

namespace glibra::view {
namespace {

struct MessageBox {
    std::uint64_t loaded = 0;  ///< Session::timesLoaded() of the texts
    std::vector<std::string> texts;
    bool isShown = false;
    std::uint64_t asked = 0;  ///< Session::timesLoaded() when the user was asked for a file last
};

/// The messages are shown again after a reload only if they have changed, so that edits are not interrupted.
void showMessages(Ui& ui, MessageBox& box) {
    constexpr const char* kTitle = "Message";
    if (ui.session.hasScene() && box.loaded != ui.session.timesLoaded()) {
        box.loaded = ui.session.timesLoaded();
        if (const auto& texts = ui.session.live().scene().messages; texts != box.texts) {
            box.texts = texts;
            box.isShown = !box.texts.empty();
        }
    }
    if (!box.isShown) return;
    if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
    if (!beginModal(kTitle)) return;
    ImGui::PushTextWrapPos(
        std::min(420 * ui.shared.scale, ImGui::GetIO().DisplaySize.x - 60 * ui.shared.scale));
    for (const std::string& each : box.texts) ImGui::TextUnformatted(each.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    if (ImGui::IsWindowAppearing()) giveKeyboardToNext();
    if (ImGui::Button("OK", {80 * ui.shared.scale, 0}) || isKeyPressed(GLFW_KEY_ENTER) ||
        isKeyPressed(GLFW_KEY_ESCAPE)) {
        box.isShown = false;
        ImGui::CloseCurrentPopup();
    }
    mark(ui, "messageBox/ok");
    ImGui::EndPopup();
}

/// Asks for the file of a model or texture that the scene does not name.
void askForMissingFile(Ui& ui, MessageBox& box) {
    const bool isPopupOpen =
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (!ui.session.hasScene() || box.isShown || isPopupOpen || ui.wanted.file || ui.shared.question ||
        box.asked == ui.session.timesLoaded())
        return;
    box.asked = ui.session.timesLoaded();
    const std::vector<scene::MissingFile>& all = ui.session.live().scene().missingFiles;
    if (all.empty()) return;
    const scene::MissingFile& missing = all.front();
    std::string endings = missing.isModel ? ".obj" : "";
    if (!missing.isModel)
        for (const image::FormatRow& each : image::formats()) endings += each.suffixes;
    askForFile(ui,
               {.title = fmt::format("A file for {} in line {}", missing.word, missing.place.line),
                .button = "Use",
                .hint = fmt::format(
                    "Line {} of {} does not name a file. 'Save values' writes your choice into the scene.",
                    missing.place.line, ui.session.path().filename().generic_string()),
                .endings = std::move(endings),
                .chosen = [place = missing.place](Ui& in, const std::filesystem::path& file) {
                    std::string problem = in.session.chooseFile(place, file);
                    in.requests.reload = problem.empty();
                    return problem;
                }});
}

class MessageBoxPanel final : public Panel {
  public:
    void show(Ui& ui) override {
        askForMissingFile(ui, box_);
        showMessages(ui, box_);
    }
    [[nodiscard]] bool blocksKeys() const override { return box_.isShown; }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["messageBox"] = box_.isShown ? box_.texts : std::vector<std::string>();
    }

  private:
    MessageBox box_;
};

}  // namespace

const PanelRow kMessageBoxRow{
    .name = "messageBox", .place = PanelPlace::floating, .make = make<MessageBoxPanel>};

}  // namespace glibra::view

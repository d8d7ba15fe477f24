// Adds the current state to a suite as a shot.

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "view/edit/example_folders.h"
#include "view/export/suite_shot.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/save_scene.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

/// The entries of the section.
struct SuiteEntries {
    std::filesystem::path scene;  ///< the scene that the proposed entries are for
    std::array<char, 1024> file{};
    std::array<char, 256> name{};
    std::string message;  ///< the result of the last click
    bool failed = false;
};

/// Proposes a suite in the scene's folder, or in one of the user's if the scene is an example, and a name
/// that the suite does not have yet.
void proposeShot(const Ui& ui, SuiteEntries& entries) {
    const Session& session = ui.session;
    if (entries.scene == session.path()) return;
    entries.scene = session.path();
    entries.message.clear();
    setField(entries.file, (ownFolder(ui) / "pictures.toml").generic_string());
    setField(entries.name, freeShotName(entries.file.data(), session));
}

void addShot(const Session& session, SuiteEntries& entries) {
    const std::filesystem::path file = entries.file.data();
    const std::string name = entries.name.data();
    Diagnostics problems = writingProblem(file);
    if (problems.empty()) problems = appendShot(file, name, session);
    entries.failed = !problems.empty();
    entries.message = entries.failed
                          ? toString(problems.front())
                          : fmt::format("added '{}' to {}; `glibra test --update` makes its golden picture",
                                        name, file.filename().generic_string());
    if (const std::string without = session.onlyOnScreen(); !entries.failed && !without.empty())
        entries.message += "; the shot is without " + without;
    if (!entries.failed) setField(entries.name, freeShotName(file, session));
}

void suitePanel(Ui& ui, SuiteEntries& entries) {
    if (!section(ui, "Suite shot", "suite", false)) return;
    proposeShot(ui, entries);
    fieldLabel("Suite");
    ImGui::InputTextWithHint("##suite", "pictures.toml", entries.file.data(), entries.file.size());
    mark(ui, "suite/file");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("A suite file for `glibra test`; it is created if it does not exist\n%s",
                          entries.file.data());
    fieldLabel("Shot");
    ImGui::InputText("##shot", entries.name.data(), entries.name.size());
    mark(ui, "suite/name");
    ImGui::BeginDisabled(entries.file[0] == 0 || entries.name[0] == 0);
    if (ImGui::Button("Add shot")) addShot(ui.session, entries);
    ImGui::EndDisabled();
    mark(ui, "suite/add");
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("Add the current values, time, view and size (%d x %d) as a shot",
                          ui.session.width(), ui.session.height());
    continueRowForButton("Copy as TOML");
    if (button(ui, "Copy as TOML", "suite/copy"))
        ImGui::SetClipboardText(shotText(ui.session, entries.name.data(),
                                         std::filesystem::path(entries.file.data()).parent_path())
                                    .c_str());
    if (!entries.message.empty()) ImGui::TextWrapped("%s", entries.message.c_str());
}

class SuitePanel final : public Panel {
  public:
    void show(Ui& ui) override { suitePanel(ui, entries_); }
    void addNow(Ui& ui) {
        if (!ui.session.hasScene()) return;
        proposeShot(ui, entries_);
        addShot(ui.session, entries_);
        ui.notice = {entries_.message, entries_.failed};
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["suiteMessage"] = entries_.message;
    }

  private:
    SuiteEntries entries_;
};

// Without a key: for the list of commands.
constexpr auto kSuiteKeys =
    std::to_array<Shortcut>({{KeyGroup::scenes, kNoKey, false, "", "add the picture to a suite, as a shot",
                              call<&SuitePanel::addNow>}});

}  // namespace

const PanelRow kSuiteRow{
    .name = "suite", .place = PanelPlace::section, .make = make<SuitePanel>, .keys = kSuiteKeys};

}  // namespace glibra::view

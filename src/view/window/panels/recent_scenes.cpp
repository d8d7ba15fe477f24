#include "view/window/panels/recent_scenes.h"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <vector>

#include "view/window/panels/ui.h"

namespace glibra::view {

std::filesystem::path recentScenes(Ui& ui, std::size_t most, const std::string& name, bool isNarrow) {
    std::vector<std::string>& recent = ui.settings.recent;
    std::filesystem::path chosen;
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < std::min(most, recent.size()); ++i) {
        const std::filesystem::path file = recent[i];
        std::error_code failure;
        const bool isGone = !std::filesystem::is_regular_file(file, failure);
        ImGui::PushID(static_cast<int>(i));
        if (isGone)
            ImGui::TextDisabled("%s", file.filename().generic_string().c_str());
        else if (ImGui::Selectable(file.filename().generic_string().c_str()))
            chosen = file;
        if (isGone)
            markPlace(ui, name + "/gone/" + std::to_string(i));
        else
            mark(ui, "{}/{}", name, i);
        tooltip(file.generic_string().c_str());
        if (isNarrow)
            ImGui::Indent();
        else
            ImGui::SameLine();
        const std::string words = isGone ? "the file is gone" : file.parent_path().generic_string();
        const float width =
            isNarrow ? ImGui::GetContentRegionAvail().x : std::max(80.F, ui.frame.room[2] * .6F);
        ImGui::TextDisabled("%s", shortened(words, width).c_str());
        markPlace(ui, name + "/folder/" + std::to_string(i));
        if (isGone) {
            besideIfRoom(ImGui::CalcTextSize("Remove").x + 2 * ImGui::GetStyle().FramePadding.x);
            if (ImGui::SmallButton("Remove")) removed = i;
            mark(ui, "{}/remove/{}", name, i);
            tooltip("Takes it out of this list");
        }
        if (isNarrow) ImGui::Unindent();
        ImGui::PopID();
    }
    if (removed) recent.erase(recent.begin() + static_cast<std::ptrdiff_t>(*removed));
    return chosen;
}

}  // namespace glibra::view

// The task of an exercise: the comment at the head of its scene, wrapped to the width of the panel.

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "view/session/comparison.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

/// The comment lines at the beginning of a scene as one text; an empty comment line separates paragraphs.
std::string headComment(std::string_view scene) {
    std::string text;
    while (scene.starts_with('#')) {
        const std::size_t end = std::min(scene.find('\n'), scene.size());
        std::string_view line = scene.substr(1, end - 1);
        while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        if (line.empty())
            text += "\n\n";
        else
            text.append(text.empty() || text.ends_with('\n') ? "" : " ").append(line);
        scene.remove_prefix(std::min(end + 1, scene.size()));
    }
    return text;
}

class TaskPanel final : public Panel {
  public:
    void show(Ui& ui) override {
        if (loaded_ != ui.session.timesLoaded() || path_ != ui.session.path()) {
            loaded_ = ui.session.timesLoaded();
            path_ = ui.session.path();
            text_ = solutionOf(path_).empty() ? std::string() : headComment(ui.session.readText(path_));
        }
        if (text_.empty() || !section(ui, "Task", "task", true)) return;
        ImGui::TextWrapped("%s", text_.c_str());
        markPlace(ui, "task/text");
    }

  private:
    std::uint64_t loaded_ = 0;
    std::filesystem::path path_;
    std::string text_;
};

}  // namespace

const PanelRow kTaskRow{.name = "task", .place = PanelPlace::section, .make = make<TaskPanel>};

}  // namespace glibra::view

// What a picture should become: another scene beside the one of the tab, as the solution of an exercise; the
// picture before and after the last edit; and the task of an exercise.

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "view/session/comparison.h"
#include "view/window/panels/texel_view.h"
#include "view/window/panels/ui.h"

namespace glibra::view {

// The window that shows another scene beside the one of the tab: the solution of an exercise beside a
// student's own picture.

namespace {

namespace fs = std::filesystem;

struct CompareWindow {
    std::unique_ptr<Comparison> comparison;  ///< null: nothing was chosen yet
    std::string problem;                     ///< why the other scene cannot be read
    std::optional<gpu::Texture> own, other;  ///< of the last pictures
    std::unique_ptr<SolutionCheck> check;    ///< null: the other scene is not the solution of the tab's
    bool isNew = false;                      ///< the textures are of earlier pictures
    bool isChecking = false;                 ///< the check has moments left
};

std::optional<gpu::Texture> uploaded(const Ui& ui, const image::Image* picture) {
    if (!picture) return std::nullopt;
    return textureOfBytes(ui.context.capabilities(), picture->width, picture->height, picture->data,
                          GL_LINEAR, GL_LINEAR);
}

void picture(Ui& ui, const char* title, const char* name, const std::optional<gpu::Texture>& texture,
             const ImVec2& size) {
    ImGui::BeginGroup();
    ImGui::TextUnformatted(title);
    if (texture)
        ImGui::Image(idOf(*texture), size);
    else
        ImGui::Dummy(size);
    mark(ui, name);
    ImGui::EndGroup();
}

/// Both pictures, as large as the window shows them side by side, and how they differ.
void sideBySide(Ui& ui, CompareWindow& window) {
    Comparison& comparison = *window.comparison;
    if (std::exchange(window.isNew, false)) {
        window.own.reset();  // before the new one needs memory
        window.own = uploaded(ui, comparison.own());
        window.other.reset();
        window.other = uploaded(ui, comparison.other());
    }
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float lines = (window.check ? 4 : 3) * ImGui::GetTextLineHeightWithSpacing();
    const float shape = static_cast<float>(ui.look.width()) / static_cast<float>(ui.look.height());
    const float width = std::max(16.F, std::min((room.x - gap) / 2, (room.y - lines) * shape));
    const ImVec2 size(width, width / shape);
    picture(ui, "yours", "compare/own", window.own, size);
    ImGui::SameLine();
    picture(ui, window.check ? "the solution" : "the other", "compare/other", window.other, size);
    if (const std::string problem = comparison.problem(); !problem.empty())
        ImGui::TextWrapped("%s", problem.c_str());
    else if (ui.session.isMoving())
        ImGui::TextDisabled("The difference is measured while the time stands still.");
    else if (const std::optional<Comparison::Score> score = comparison.score())
        ImGui::Text("FLIP %.3f, structure %.3f (0: no difference)", score->flip, score->structure);
    if (!window.check) return;
    window.isChecking = window.check->follow(ui.session);
    if (const std::string text = window.check->text(); !text.empty()) ImGui::TextWrapped("%s", text.c_str());
}

class ComparePanel final : public Panel {
  public:
    void update(Ui& ui) override {
        window_.isChecking = false;
        if (!ui.wanted.compared) return;
        const fs::path& scene = *ui.wanted.compared;
        window_ = {};
        RenderOptions options = ui.session.renderOptions();
        options.sceneText.reset();  // of the tab's scene, with the files that were chosen
        window_.comparison = std::make_unique<Comparison>(ui.context, options);
        window_.comparison->setContained(true);
        window_.problem = window_.comparison->open(scene);
        if (scene == solutionOf(ui.session.path()))
            window_.check = std::make_unique<SolutionCheck>(ui.context, ui.session.renderOptions());
        isOpen = true;
    }
    void show(Ui& ui) override {
        if (!isOpen || !window_.comparison || !ui.session.hasScene()) return;
        placeFloating(ui, 30, 60, 760, 400);
        const std::string title =
            "Compare with " + window_.comparison->path().filename().generic_string() + "###compare";
        if (ImGui::Begin(title.c_str(), &isOpen, ImGuiWindowFlags_NoCollapse)) {
            if (window_.problem.empty())
                sideBySide(ui, window_);
            else
                ImGui::TextWrapped("%s", window_.problem.c_str());
        }
        ImGui::End();
    }
    /// The picture of this frame is drawn: the other one follows it.
    void drawOver(Ui& ui) override {
        if (!isOpen || !window_.comparison) return;
        window_.isNew = window_.comparison->follow(ui.session) || window_.isNew;
        ui.frame.isFollowed = ui.frame.isFollowed || window_.comparison->isDrawing();
    }
    [[nodiscard]] bool needsFrames() const override { return window_.isNew || window_.isChecking; }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        if (!isOpen || !window_.comparison) return;
        nlohmann::ordered_json json = {{"scene", window_.comparison->path().generic_string()},
                                       {"problem", window_.problem}};
        if (const std::optional<Comparison::Score> score = window_.comparison->known())
            json["score"] = {score->flip, score->structure};
        if (window_.check) json["check"] = window_.check->text();
        state["compare"] = json;
    }
    void releaseDevice() override {
        window_.own.reset();
        window_.other.reset();
        if (window_.comparison) window_.comparison->releaseDevice();
        if (window_.check) window_.check->releaseDevice();
    }
    void restoreDevice() override {
        if (window_.comparison) window_.comparison->restoreDevice();
        if (window_.check) window_.check->restoreDevice();
    }

  private:
    CompareWindow window_;
};

// The picture before and after the last edit, by one key.

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

// The task of an exercise: the comment at the head of its scene, wrapped to the width of the panel.

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

const PanelRow kCompareRow{.name = "compare",
                           .place = PanelPlace::floating,
                           .make = make<ComparePanel>,
                           .title = "Compare###compare"};

const PanelRow kBeforeAfterRow{
    .name = "before", .place = PanelPlace::picture, .make = make<BeforeAfter>, .keys = kBeforeKeys};

const PanelRow kTaskRow{.name = "task", .place = PanelPlace::section, .make = make<TaskPanel>};

}  // namespace glibra::view

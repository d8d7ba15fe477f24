// The window that shows another scene beside the one of the tab: the solution of an exercise beside a
// student's own picture.

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "view/session/comparison.h"
#include "view/session/solution_check.h"
#include "view/window/panels/shown_texture.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
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
    const float shape = static_cast<float>(ui.session.width()) / static_cast<float>(ui.session.height());
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

}  // namespace

const PanelRow kCompareRow{.name = "compare",
                           .place = PanelPlace::floating,
                           .make = make<ComparePanel>,
                           .title = "Compare###compare"};

}  // namespace glibra::view

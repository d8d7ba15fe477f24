#include "view/window/panels/compare_window.h"

#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "view/browse/example_scenes.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

void upload(const gpu::Capabilities& capabilities, const image::Image* picture,
            std::optional<gpu::Texture>& to) {
    to.reset();
    if (!picture) return;
    Result<gpu::Texture> made =
        gpu::Texture::create(capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
                             {picture->width, picture->height, 1}, {picture->data, 4});
    to = std::move(made.value);
    if (!to) return;
    glBindTexture(GL_TEXTURE_2D, to->id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void picture(Ui& ui, const char* title, const char* name, const std::optional<gpu::Texture>& texture,
             const ImVec2& size) {
    ImGui::BeginGroup();
    ImGui::TextUnformatted(title);
    if (texture)
        ImGui::Image(std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(texture->id())), size);
    else
        ImGui::Dummy(size);
    mark(ui, name);
    ImGui::EndGroup();
}

/// Both pictures, as large as the window shows them side by side, and how they differ.
void sideBySide(Ui& ui) {
    CompareWindow& window = ui.compare;
    Comparison& comparison = *window.comparison;
    if (comparison.follow(ui.session)) {
        upload(ui.context.capabilities(), comparison.own(), window.own);
        upload(ui.context.capabilities(), comparison.other(), window.other);
        ui.needsFrames = true;  // the tab's own picture may still be drawn in this frame
    }
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float lines = 3 * ImGui::GetTextLineHeightWithSpacing();
    const float shape = static_cast<float>(ui.session.width()) / static_cast<float>(ui.session.height());
    const float width = std::max(16.F, std::min((room.x - gap) / 2, (room.y - lines) * shape));
    const ImVec2 size(width, width / shape);
    picture(ui, "yours", "compare/own", window.own, size);
    ImGui::SameLine();
    picture(ui, comparison.path() == window.solution ? "the solution" : "the other", "compare/other",
            window.other, size);
    if (const std::string problem = comparison.problem(); !problem.empty())
        ImGui::TextWrapped("%s", problem.c_str());
    else if (ui.session.isMoving())
        ImGui::TextDisabled("The difference is measured while the time stands still.");
    else if (const std::optional<Comparison::Score> score = comparison.score())
        ImGui::Text("FLIP %.3f, structure %.3f (0: no difference)", score->flip, score->structure);
}

}  // namespace

void compareWith(Ui& ui, const fs::path& scene) {
    CompareWindow& window = ui.compare;
    window.comparison = std::make_unique<Comparison>(ui.context, ui.session.renderOptions());
    window.own.reset();
    window.other.reset();
    window.problem = window.comparison->open(scene);
    window.isOpen = true;
}

const fs::path& solutionOfShown(Ui& ui) {
    CompareWindow& window = ui.compare;
    if (window.exercise != ui.session.path()) {
        window.exercise = ui.session.path();
        window.solution = solutionOf(window.exercise);
    }
    return window.solution;
}

void askCompareWith(Ui& ui) {
    ui.shared.dialog.ask({.kind = FileQuestion::Kind::open,
                          .title = "Compare with",
                          .button = "Compare",
                          .hint = "Its picture is shown beside that of this scene, with the same values.",
                          .endings = ".glib",
                          .entry = "",
                          .chosen =
                              [](Ui& chosenIn, const fs::path& scene) {
                                  compareWith(chosenIn, scene);
                                  return chosenIn.compare.problem;
                              }},
                         ui.session.path().parent_path());
}

void compareWindow(Ui& ui) {
    CompareWindow& window = ui.compare;
    if (!window.isOpen || !window.comparison || !ui.session.hasScene()) return;
    placeFloating(ui, 30, 60, 760, 400);
    const std::string title = "Compare with " + window.comparison->path().filename().string() + "###compare";
    if (ImGui::Begin(title.c_str(), &window.isOpen, ImGuiWindowFlags_NoCollapse)) {
        if (window.problem.empty())
            sideBySide(ui);
        else
            ImGui::TextWrapped("%s", window.problem.c_str());
    }
    ImGui::End();
}

}  // namespace glibra::view

// The tab "Mesh" of the window "Frame": the vertices of the chosen draw before and after its stages, as a
// table and as edges in space.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "image/file.h"
#include "view/window/panels/frame_window.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

constexpr std::size_t kRowsPerMeshPage = 200;
constexpr std::size_t kMostEdges = 20000;

/// Captures the vertices of another draw or another frame.
void captureChosen(Ui& ui, FrameWindow& window, const FrameItem& item) {
    const std::string of = fmt::format("{} {} {}", item.key, ui.session.timesLoaded(),
                                       ui.session.isMoving() ? std::uint64_t{0} : ui.session.framesDrawn());
    if (of == window.meshFor || !ui.session.canLookInto()) return;
    window.meshFor = of;
    window.mesh = captureMesh(ui.context, ui.session.live(), item.step, ui.look.width(), ui.look.height(),
                              ui.session.clock().time());
    window.meshStage = std::min(window.meshStage, window.mesh.empty() ? 0 : window.mesh.size() - 1);
    window.firstRow = 0;
}

struct Point {
    glm::dvec3 at{0.0};
    bool isThere = false;  ///< false: not finite, or behind the eye
};

/// The place of a row: as the inputs have it, or in normalised device coordinates.
Point pointOf(const MeshStage& stage, std::size_t row) {
    const MeshColumn& column = stage.columns[static_cast<std::size_t>(stage.position)];
    const double* values = stage.row(row) + column.first;
    glm::dvec3 at(0.0);
    for (int i = 0; i < std::min(3, column.components); ++i) at[i] = values[i];
    if (stage.isClip) {
        const double w = values[3];
        if (!(w > 0)) return {};
        at /= w;
    }
    return {at, std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z)};
}

/// The box of the points; that of the view volume for clip coordinates.
std::pair<glm::dvec3, glm::dvec3> boxOf(const MeshStage& stage) {
    if (stage.isClip) return {glm::dvec3(-1), glm::dvec3(1)};
    glm::dvec3 low(1e300), high(-1e300);
    for (std::size_t row = 0; row < stage.rows; ++row)
        if (const Point point = pointOf(stage, row); point.isThere) {
            low = glm::min(low, point.at);
            high = glm::max(high, point.at);
        }
    return low.x <= high.x ? std::pair(low, high) : std::pair(glm::dvec3(-1), glm::dvec3(1));
}

class MeshDrawing {
  public:
    MeshDrawing(const FrameWindow& window, const MeshStage& stage, const ImVec2& at, const ImVec2& size)
        : at_(at), size_(size) {
        const auto [low, high] = boxOf(stage);
        middle_ = (low + high) / 2.0;
        const double reach = std::max(1e-12, glm::length(high - low) / 2);
        turn_ = glm::rotate(glm::dmat4(1), glm::radians(static_cast<double>(window.tilt)), {1, 0, 0});
        turn_ = glm::rotate(turn_, glm::radians(static_cast<double>(window.turn)), {0, 1, 0});
        // Depth grows away from the eye in device coordinates.
        if (stage.isClip && !stage.isReversed) turn_ = glm::scale(turn_, {1, 1, -1});
        scale_ = std::min(size.x, size.y) / 2 / reach / static_cast<double>(window.distance) * .95;
        low_ = low;
        high_ = high;
    }

    [[nodiscard]] ImVec2 screen(const glm::dvec3& point) const {
        const glm::dvec3 turned(turn_ * glm::dvec4(point - middle_, 0));
        return {at_.x + size_.x / 2 + static_cast<float>(turned.x * scale_),
                at_.y + size_.y / 2 - static_cast<float>(turned.y * scale_)};
    }

    void box(ImDrawList& list) const {
        const auto corner = [&](int i) {
            return screen({(i & 1) != 0 ? high_.x : low_.x, (i & 2) != 0 ? high_.y : low_.y,
                           (i & 4) != 0 ? high_.z : low_.z});
        };
        for (int i = 0; i < 8; ++i)
            for (const int bit : {1, 2, 4})
                if ((i & bit) == 0)
                    list.AddLine(corner(i), corner(i | bit), ImGui::GetColorU32(ImGuiCol_TextDisabled, .5F));
    }

    void edges(ImDrawList& list, const MeshStage& stage) const {
        const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text, .8F);
        const auto corners = static_cast<std::size_t>(stage.corners);
        std::size_t drawn = 0;
        for (std::size_t first = 0; first + corners <= stage.rows && drawn < kMostEdges; first += corners) {
            std::array<Point, 3> points;
            for (std::size_t i = 0; i < corners; ++i) points.at(i) = pointOf(stage, first + i);
            if (corners == 1 && points[0].isThere) {
                const ImVec2 here = screen(points[0].at);
                list.AddRectFilled({here.x - 1, here.y - 1}, {here.x + 1, here.y + 1}, color);
                ++drawn;
            }
            for (std::size_t i = 0; corners > 1 && i < (corners == 2 ? 1 : corners); ++i) {
                const Point &a = points.at(i), &b = points.at((i + 1) % corners);
                if (!a.isThere || !b.isThere) continue;
                list.AddLine(screen(a.at), screen(b.at), color);
                ++drawn;
            }
        }
    }

  private:
    ImVec2 at_, size_;
    glm::dvec3 middle_{0.0}, low_{0.0}, high_{0.0};
    glm::dmat4 turn_{1.0};
    double scale_ = 1;
};

/// The edges in space; dragging turns them, the wheel scales.
void edges(Ui& ui, FrameWindow& window, const MeshStage& stage, float width) {
    const ImVec2 size(width, std::max(60.F, ImGui::GetContentRegionAvail().y));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("edges", size);
    mark(ui, "frame/edges");
    if (ImGui::IsItemActive()) {
        window.turn += ImGui::GetIO().MouseDelta.x * .5F;
        window.tilt = std::clamp(window.tilt + ImGui::GetIO().MouseDelta.y * .5F, -90.F, 90.F);
    }
    if (ImGui::IsItemHovered() && ImGui::GetIO().MouseWheel != 0)
        window.distance =
            std::clamp(window.distance * std::pow(1.2F, -ImGui::GetIO().MouseWheel), .01F, 10.F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(at, {at.x + size.x, at.y + size.y}, true);
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    if (stage.position >= 0) {
        const MeshDrawing drawing(window, stage, at, size);
        drawing.box(list);
        drawing.edges(list, stage);
    }
    list.PopClipRect();
}

void vertices(const FrameWindow& window, const MeshStage& stage) {
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                       ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                       ImGuiTableFlags_SizingFixedFit;
    constexpr std::size_t kMostColumns = 60;  // ImGui has 64
    const std::size_t columns = std::min(stage.columns.size(), kMostColumns);
    if (!ImGui::BeginTable("vertices", static_cast<int>(columns) + 1, kFlags)) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    ImGui::TableSetupColumn("vertex");
    for (std::size_t i = 0; i < columns; ++i) ImGui::TableSetupColumn(stage.columns[i].name.c_str());
    ImGui::TableHeadersRow();
    for (std::size_t row = window.firstRow; row < std::min(stage.rows, window.firstRow + kRowsPerMeshPage);
         ++row) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%zu", row);
        for (std::size_t i = 0; i < columns; ++i) {
            ImGui::TableNextColumn();
            std::string text;
            for (int k = 0; k < stage.columns[i].components; ++k)
                text += fmt::format("{}{:.5g}", k > 0 ? " " : "",
                                    stage.row(row)[stage.columns[i].first + static_cast<std::size_t>(k)]);
            ImGui::TextUnformatted(text.c_str());
        }
    }
    ImGui::EndTable();
}

void askExport(Ui& ui, const MeshStage& stage) {
    const auto write = [text = csvOf(stage)](Ui& in, const std::filesystem::path& file) {
        const Diagnostics problems = image::writeFileAtomically(file, std::as_bytes(std::span(text)));
        if (!problems.empty()) return problems.front().text;
        in.notice = "wrote " + file.generic_string();
        return std::string();
    };
    askForFile(ui,
               {.kind = FileQuestion::Kind::save,
                .title = "Write the vertices",
                .button = "Write",
                .hint = "A table of comma-separated values: " + stage.title + ".",
                .endings = ".csv",
                .entry = "vertices.csv",
                .chosen = write},
               ui.session.path().parent_path());
}

}  // namespace

void frameMesh(Ui& ui, FrameWindow& window) {
    const FrameItem* item = window.item();
    if (item == nullptr || item->kind != FrameItem::Kind::draw)
        return ImGui::TextDisabled("Choose a draw to see its vertices.");
    captureChosen(ui, window, *item);
    if (window.mesh.empty()) return ImGui::TextDisabled("Nothing of the draw is drawn.");
    for (std::size_t i = 0; i < window.mesh.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        if (radioButton(window.mesh[i].title.c_str(), window.meshStage == i)) {
            window.meshStage = i;
            window.firstRow = 0;
        }
        mark(ui, "frame/stage/{}", i);
    }
    const MeshStage& stage = window.mesh[window.meshStage];
    if (!stage.problem.empty()) return ImGui::TextWrapped("%s", stage.problem.c_str());
    ImGui::BeginDisabled(window.firstRow == 0);
    if (ImGui::SmallButton("< Page")) window.firstRow -= std::min(window.firstRow, kRowsPerMeshPage);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(window.firstRow + kRowsPerMeshPage >= stage.rows);
    if (ImGui::SmallButton("Page >")) window.firstRow += kRowsPerMeshPage;
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (smallButton(ui, "Export...", "frame/exportMesh")) askExport(ui, stage);
    ImGui::SameLine();
    ImGui::Text("%llu vertices%s", static_cast<unsigned long long>(stage.allRows),
                stage.allRows > stage.rows ? ", not all of them are shown" : "");
    const float width = ImGui::GetContentRegionAvail().x;
    edges(ui, window, stage, width * .45F);
    ImGui::SameLine();
    ImGui::BeginChild("table");
    vertices(window, stage);
    ImGui::EndChild();
}

}  // namespace glibra::view

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plan/buffers.h"
#include "render/check/object_content.h"
#include "render/file/buffer_file.h"
#include "scene/objects.h"
#include "view/window/panels/texel_view.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"

namespace glibra::view {
namespace {

// The window "Textures, targets, buffers": the texels of textures, targets and the picture, and the tables of
// buffers.

struct Inspector {
    /// "picture", "depth", the name of a texture or buffer, or "#2" for texture 2 of the scene, which has no
    /// name.
    std::string chosen = "picture";
    int level = 0, layer = 0;
    bool isPrevious = false;  ///< the other copy of an object with history
    bool wasOpen = false;     ///< in the last frame
    TexelView view;
    std::string readFor;  ///< what `content` or `rows` was read for
    std::optional<render::Content> content;
    std::string problem;  ///< why there is none
    // Of a buffer:
    std::uint64_t firstRow = 0;
    plan::BufferTable table;
    std::vector<std::string> head;               ///< the cells before the array
    std::vector<std::vector<std::string>> rows;  ///< the cells of the shown elements
};

constexpr std::size_t kMostTableColumns = 60;  // ImGui has 64

constexpr std::uint64_t kRowsPerPage = 100;

/// The texts of a row of cells; `first` is the number of the buffer at which it begins.
std::vector<std::string> cells(const std::vector<plan::BufferColumn>& columns,
                               const std::vector<plan::MemoryNumber>& kinds, std::span<const double> values) {
    std::vector<std::string> texts;
    for (const plan::BufferColumn& each : columns)
        texts.push_back(each.first + each.count <= values.size()
                            ? plan::cellText(std::span(kinds).subspan(each.first, each.count),
                                             values.subspan(each.first, each.count))
                            : "");
    return texts;
}

/// The members before the array, one per line.
void headTable(const Inspector& inspector) {
    if (inspector.head.empty() || !ImGui::BeginTable("head", 2, ImGuiTableFlags_RowBg)) return;
    constexpr std::size_t kMostShown = 200;
    for (std::size_t i = 0; i < std::min(inspector.head.size(), kMostShown); ++i) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(inspector.table.head[i].name.c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(inspector.head[i].c_str());
    }
    ImGui::EndTable();
    if (inspector.head.size() > kMostShown)
        ImGui::TextDisabled("and %zu more members", inspector.head.size() - kMostShown);
}

void pages(Ui& ui, Inspector& inspector) {
    const std::uint64_t elements = inspector.table.elements;
    ImGui::BeginDisabled(inspector.firstRow == 0);
    if (button(ui, "< Page", "inspector/pageBack"))
        inspector.firstRow -= std::min(inspector.firstRow, kRowsPerPage);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(inspector.firstRow + kRowsPerPage >= elements);
    if (button(ui, "Page >", "inspector/pageForward")) inspector.firstRow += kRowsPerPage;
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(110 * ui.shared.scale);
    auto first = static_cast<double>(inspector.firstRow);
    if (numberEntry("first", first, "%.0f"))
        inspector.firstRow = static_cast<std::uint64_t>(std::clamp(first, 0., static_cast<double>(elements)));
    markField(ui, "inspector/first", "first");
    ImGui::SameLine();
    ImGui::Text("of %llu elements", static_cast<unsigned long long>(elements));
}

/// Returns what is wrong; empty on success.
std::string exportBuffer(Ui& ui, const std::string& name, bool isPrevious,
                         const std::filesystem::path& file) {
    if (!ui.session.canLookInto()) return "no frame has been drawn";
    const render::LiveScene& live = ui.session.live();
    for (const scene::BufferIndex each : live.scene().buffers.indices()) {
        if (live.scene().buffers[each].name != name) continue;
        const gpu::Buffer* buffer = live.buffers().buffer({each, isPrevious});
        const plan::BufferLayout* layout = live.buffers().layout(each);
        if (buffer == nullptr || layout == nullptr) break;
        const Diagnostics problems =
            render::writeBuffer(render::contentOf(*layout, *buffer), file, image::NamedBy::user);
        if (!problems.empty()) return problems.front().text;
        ui.notice = "wrote " + file.generic_string();
        return {};
    }
    return "the scene has no buffer '" + name + "' any more";
}

/// Asks for the file of a table with all elements.
void askExport(Ui& ui, const Inspector& inspector) {
    const auto write = [name = inspector.chosen, isPrevious = inspector.isPrevious](
                           Ui& in, const std::filesystem::path& file) {
        return exportBuffer(in, name, isPrevious, file);
    };
    askForFile(ui,
               {.kind = FileQuestion::Kind::save,
                .title = "Write the buffer " + inspector.chosen,
                .button = "Write",
                .hint = ".csv is text, .npy an array of NumPy.",
                .endings = ".csv .npy",
                .entry = inspector.chosen + ".csv",
                .chosen = write},
               ui.session.path().parent_path());
}

/// Reads the shown elements of a buffer.
void readBuffer(const Ui& ui, Inspector& inspector, scene::BufferIndex index) {
    const render::DeviceBuffers& buffers = ui.session.live().buffers();
    const plan::BufferLayout& layout = *buffers.layout(index);
    const plan::MemoryPattern& pattern = layout.pattern;
    const scene::BufferView view{index, inspector.isPrevious};
    inspector.table = plan::tableOf(layout, kMostTableColumns);
    inspector.head.clear();
    inspector.rows.clear();
    const std::vector<double> head = buffers.read(view, 0, pattern.head.size());
    if (!head.empty()) inspector.head = cells(inspector.table.head, pattern.head, head);
    const std::uint64_t elements = inspector.table.elements;
    if (elements == 0) return;
    inspector.firstRow = std::min(inspector.firstRow, elements - 1);
    const std::size_t size = pattern.element.size();
    const std::vector<double> values =
        buffers.read(view, pattern.head.size() + inspector.firstRow * size, kRowsPerPage * size);
    for (std::size_t i = 0; i + size <= values.size(); i += size)
        inspector.rows.push_back(
            cells(inspector.table.columns, pattern.element, std::span(values).subspan(i, size)));
}

/// Draws the buffer's members and elements as tables.
void bufferTable(Ui& ui, Inspector& inspector) {
    if (button(ui, "Export...", "inspector/export")) askExport(ui, inspector);
    headTable(inspector);
    if (inspector.table.elements == 0) return;
    pages(ui, inspector);
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                       ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                       ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingFixedFit;
    const int columns = static_cast<int>(inspector.table.columns.size()) + 1;
    if (!ImGui::BeginTable("elements", columns, kFlags)) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    ImGui::TableSetupColumn("index");
    for (const plan::BufferColumn& each : inspector.table.columns) ImGui::TableSetupColumn(each.name.c_str());
    ImGui::TableHeadersRow();
    for (std::size_t row = 0; row < inspector.rows.size(); ++row) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%llu", static_cast<unsigned long long>(inspector.firstRow + row));
        for (const std::string& cell : inspector.rows[row]) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(cell.c_str());
        }
    }
    ImGui::EndTable();
}

/// The object that the user has chosen. Without one it is the picture.
struct Chosen {
    scene::TextureIndex texture{};
    scene::BufferIndex buffer{};
    bool isDepth = false;
};

/// What the key names now; the picture if that no longer exists.
Chosen chosenOf(Ui& ui, Inspector& inspector) {
    const render::LiveScene& live = ui.session.live();
    if (inspector.chosen == "depth") return {{}, {}, true};
    for (const scene::TextureIndex each : live.scene().textures.indices())
        if (textureKey(live.scene(), each) == inspector.chosen && live.texture(each))
            return {each, {}, false};
    for (const scene::BufferIndex each : live.scene().buffers.indices())
        if (live.scene().buffers[each].name == inspector.chosen && live.buffers().layout(each))
            return {{}, each, false};
    inspector.chosen = "picture";
    return {};
}

std::string titleOf(const Ui& ui, const Chosen& chosen) {
    const render::LiveScene& live = ui.session.live();
    if (chosen.buffer) {
        const scene::Buffer& buffer = live.scene().buffers[chosen.buffer];
        return fmt::format("{}: buffer, {} bytes, line {}", buffer.name,
                           live.buffers().layout(chosen.buffer)->bytes, buffer.place.line);
    }
    if (chosen.texture) return textureTitle(live.scene(), chosen.texture);
    return chosen.isDepth ? "picture: depth" : "picture: colour";
}

bool hasHistory(const scene::Scene& scene, const Chosen& chosen) {
    if (chosen.buffer) return scene.buffers[chosen.buffer].hasHistory;
    return chosen.texture && scene.textures[chosen.texture].hasHistory;
}

/// The values of these begin far from 0..1.
bool needsRange(const render::LiveScene& live, const Chosen& chosen) {
    const gpu::Texture* texture = chosen.texture ? live.texture(chosen.texture) : nullptr;
    return texture && (base::isInteger(texture->format()) || base::hasDepth(texture->format()));
}

Chosen choose(Ui& ui, Inspector& inspector) {
    Chosen chosen = chosenOf(ui, inspector);
    ImGui::SetNextItemWidth(-1);
    const bool isOpen =
        beginCombo(ui, "##what", titleOf(ui, chosen).c_str(), "inspector/what", ImGuiComboFlags_HeightLarge);
    if (!isOpen) return chosen;
    const auto item = [&](const std::string& key, const Chosen& each) {
        ImGui::PushID(key.c_str());
        if (ImGui::Selectable(titleOf(ui, each).c_str(), key == inspector.chosen)) {
            inspector.chosen = key;
            inspector.level = inspector.layer = 0;
            inspector.firstRow = 0;
            inspector.isPrevious = false;
            inspector.view.begin(needsRange(ui.session.live(), each));
            chosen = each;
        }
        mark(ui, "inspector/item/{}", key);
        ImGui::PopID();
    };
    const render::LiveScene& live = ui.session.live();
    item("picture", {});
    item("depth", {{}, {}, true});
    for (const scene::TextureIndex each : live.scene().textures.indices())
        if (live.texture(each)) item(textureKey(live.scene(), each), {each, {}, false});
    for (const scene::BufferIndex each : live.scene().buffers.indices())
        if (live.buffers().layout(each)) item(live.scene().buffers[each].name, {{}, each, false});
    ImGui::EndCombo();
    return chosen;
}

/// Which level, layer and copy of the object is shown.
void part(Ui& ui, Inspector& inspector, const Chosen& chosen) {
    if (hasHistory(ui.session.live().scene(), chosen)) {
        checkBox(ui, "previous copy (.prev)", "inspector/previous", inspector.isPrevious);
    }
    if (!chosen.texture) return;
    const gpu::Texture* texture = ui.session.live().completed(chosen.texture, inspector.isPrevious);
    if (!texture) return;
    const auto slider = [&](const char* label, const char* name, int& value, int count) {
        value = std::clamp(value, 0, count - 1);
        if (count < 2) return;
        ImGui::SetNextItemWidth(160 * ui.shared.scale);
        double number = value;
        labelledSlider(ui, label, name, {0, static_cast<double>(count - 1), true}, number);
        value = static_cast<int>(std::lround(number));
    };
    slider("level", "inspector/level", inspector.level, texture->levels());
    if (texture->levels() > 1 && texture->layers(inspector.level) > 1) ImGui::SameLine();
    const bool isCube = texture->shape() == gpu::TextureShape::cube;
    slider(isCube ? "face (+x -x +y -y +z -z)" : "layer", "inspector/layer", inspector.layer,
           texture->layers(inspector.level));
}

void readTexture(Ui& ui, Inspector& inspector, scene::TextureIndex index) {
    const gpu::Texture* texture = ui.session.live().completed(index, inspector.isPrevious);
    if (!texture || texture->samples() > 1) {
        inspector.problem = "The samples of this texture cannot be resolved.";
        return;
    }
    const std::optional<int> layer =
        texture->layers(inspector.level) > 1 ? std::optional(inspector.layer) : std::nullopt;
    Result<render::Content> content = render::contentOf(*texture, inspector.level, layer);
    if (!content) inspector.problem = "The driver cannot read this format.";
    inspector.content = std::move(content.value);
}

/// Reads the content again after each frame of the scene, and after another choice.
void read(Ui& ui, Inspector& inspector, const Chosen& chosen) {
    const gpu::Target* picture = ui.session.plainPicture();
    if (!picture) return;
    std::string wanted =
        fmt::format("{} {} {} {} {} {} {} {}", ui.session.path().generic_string(), ui.session.timesLoaded(),
                    ui.session.framesDrawn(), inspector.chosen, inspector.level, inspector.layer,
                    inspector.isPrevious, inspector.firstRow);
    if (wanted != inspector.readFor) {
        inspector.readFor = std::move(wanted);
        inspector.content.reset();
        inspector.view.forget();
        inspector.problem.clear();
        if (chosen.buffer)
            readBuffer(ui, inspector, chosen.buffer);
        else if (chosen.texture)
            readTexture(ui, inspector, chosen.texture);
        else
            inspector.content = contentOf(*picture, chosen.isDepth);
    }
}

/// The picture is seen already: begins with the first texture that a pass or a dispatch writes, if there is
/// one.
void beginWithHidden(const Ui& ui, Inspector& inspector) {
    if (inspector.chosen != "picture") return;
    const render::LiveScene& live = ui.session.live();
    for (const scene::TextureIndex each : live.scene().textures.indices()) {
        if (!live.texture(each)) continue;
        inspector.chosen = textureKey(live.scene(), each);
        inspector.level = inspector.layer = 0;
        inspector.view.begin(needsRange(live, {each, {}, false}));
        return;
    }
}

void inspectorWindow(Ui& ui, Inspector& inspector, bool& isOpen) {
    if (!isOpen) inspector.view.fits = true;
    if (isOpen && !inspector.wasOpen && ui.session.hasScene()) beginWithHidden(ui, inspector);
    inspector.wasOpen = isOpen;
    if (!isOpen || !ui.session.hasScene()) return;
    ui.session.keepTextures();
    // Below the tabs.
    placeFloating(ui, 20, 20 + ui.frame.room[1] / ui.shared.scale, 560, 480);
    if (ImGui::Begin(kInspectorRow.title, &isOpen, ImGuiWindowFlags_NoCollapse)) {
        const Chosen chosen = choose(ui, inspector);
        part(ui, inspector, chosen);
        read(ui, inspector, chosen);
        if (chosen.buffer)
            bufferTable(ui, inspector);
        else if (inspector.content)
            texelView(ui, inspector.view, {*inspector.content}, "inspector");
        else
            ImGui::TextDisabled("%s", inspector.problem.c_str());
    }
    ImGui::End();
}

nlohmann::ordered_json inspectorJson(const Inspector& inspector) {
    nlohmann::ordered_json columns = nlohmann::ordered_json::array();
    for (const plan::BufferColumn& each : inspector.table.columns) columns.push_back(each.name);
    nlohmann::ordered_json head = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < inspector.head.size(); ++i)
        head.push_back({inspector.table.head[i].name, inspector.head[i]});
    return {{"chosen", inspector.chosen},
            {"level", inspector.level},
            {"layer", inspector.layer},
            {"width", inspector.content ? inspector.content->width : 0},
            {"height", inspector.content ? inspector.content->height : 0},
            {"range", {inspector.view.display.low, inspector.view.display.high}},
            {"zoom", inspector.view.zoom},
            {"problem", inspector.problem},
            {"columns", columns},
            {"head", head},
            {"firstRow", inspector.firstRow},
            {"rows", inspector.rows}};
}

class InspectorWindow final : public Panel {
  public:
    void update(Ui& ui) override {
        if (!ui.wanted.inspected) return;
        isOpen = true;
        inspector_.chosen = *ui.wanted.inspected;
        inspector_.level = inspector_.layer = 0;
        if (ui.session.hasScene())
            inspector_.view.begin(needsRange(ui.session.live(), chosenOf(ui, inspector_)));
    }
    void show(Ui& ui) override { inspectorWindow(ui, inspector_, isOpen); }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["inspected"] = inspector_.view.hovered;
        if (isOpen) state["inspector"] = inspectorJson(inspector_);
    }
    void releaseDevice() override {
        inspector_.view.forget();
        inspector_.readFor.clear();
    }

  private:
    Inspector inspector_;
};

constexpr auto kInspectorKeys = std::to_array<Shortcut>(
    {{KeyGroup::pipeline, GLFW_KEY_I, false, "I", "show textures, targets and buffers", toggleOpen}});

}  // namespace

const PanelRow kInspectorRow{
    .name = "inspector",
    .place = PanelPlace::floating,
    .make = make<InspectorWindow>,
    .keys = kInspectorKeys,
    .title = "Textures, targets, buffers",
    .checkBox = "Textures",
    .help = "Show the texels of textures and targets, the picture's colour and depth, and buffers (I)"};

}  // namespace glibra::view

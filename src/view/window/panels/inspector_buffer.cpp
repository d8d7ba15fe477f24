#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <span>

#include "render/file/buffer_file.h"
#include "view/window/panels/inspector.h"
#include "view/window/panels/number_field.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

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
        render::BufferContent content{
            *layout, plan::tableOf(*layout, live.blockOf(each), std::numeric_limits<std::size_t>::max()),
            std::vector<std::byte>(buffer->size())};
        buffer->read(0, content.bytes);
        const Diagnostics problems = render::writeBuffer(content, file, image::NamedBy::user);
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

}  // namespace

void readBuffer(const Ui& ui, Inspector& inspector, scene::BufferIndex index) {
    const render::DeviceBuffers& buffers = ui.session.live().buffers();
    const plan::BufferLayout& layout = *buffers.layout(index);
    const plan::MemoryPattern& pattern = layout.pattern;
    const scene::BufferView view{index, inspector.isPrevious};
    inspector.table = plan::tableOf(layout, ui.session.live().blockOf(index), kMostTableColumns);
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

}  // namespace glibra::view

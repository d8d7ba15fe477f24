// The tab "Pixel" of the window "Frame": which draws touch a pixel, and what the chosen one has there.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "view/window/panels/frame_window.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

std::string frameOf(const Ui& ui) {
    return fmt::format("{} {}", ui.session.timesLoaded(), ui.session.framesDrawn());
}

int outputOf(const FrameWindow& window, const FrameItem& item) {
    const FrameTarget* chosen = window.targetOf(item);
    return chosen != nullptr && chosen->kind == FrameTarget::Kind::color ? chosen->output : 0;
}

/// The clicked pixel, in the layer that is shown.
TargetPixel pixelOf(const FrameWindow& window) {
    return {window.pixel->first, window.pixel->second, std::clamp(window.layer, 0, window.answer.layers - 1)};
}

std::string textOf(const TargetPixel& pixel) {
    return fmt::format("{} {} {}", pixel.x, pixel.y, pixel.layer);
}

/// Computes it again for another pixel, pass or frame.
void examine(Ui& ui, FrameWindow& window, std::size_t index) {
    const FrameItem& item = window.items[index];
    const TargetPixel pixel = pixelOf(window);
    const int output = outputOf(window, item);
    const std::string what = fmt::format(" {} {} {}", item.step.pass, textOf(pixel), output);
    const std::string of = frameOf(ui) + what;
    if (of == window.pixelFor || (ui.session.isMoving() && window.pixelFor.ends_with(what))) return;
    if (!ui.session.canLookInto()) return;
    window.pixelFor = of;
    window.history = pixelHistory(ui.context, ui.session.live(), window.items, index, ui.session.width(),
                                  ui.session.height(), ui.session.clock().time(), pixel, output);
}

std::string colorText(const PixelState& state) {
    std::string text;
    for (const double each : state.color) text += fmt::format("{}{:.3g}", text.empty() ? "" : " ", each);
    return text;
}

/// Without it the columns have more room.
bool hasStencil(const PixelHistory& history) {
    return std::ranges::any_of(history.events,
                               [](const PixelEvent& each) { return each.after.stencil.value_or(0) != 0; });
}

void eventRow(Ui& ui, FrameWindow& window, std::size_t number) {
    const PixelEvent& event = window.history.events[number];
    if (event.item >= window.items.size()) return;
    const FrameItem& item = window.items[event.item];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(number));
    const std::string copy = item.number > 0 ? fmt::format(" {}", item.number) : "";
    const std::string title = fmt::format("{}{}, line {}", item.title, copy, item.place.line);
    if (ImGui::Selectable(title.c_str(), item.key == window.chosen, ImGuiSelectableFlags_SpanAllColumns)) {
        const auto pixel = window.pixel;
        window.choose(item);
        window.pixel = pixel;  // the passes have the same targets
    }
    ImGui::PopID();
    mark(ui, "frame/event/{}", number);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(std::string(wordsOf(event.outcome)).c_str());
    ImGui::TableNextColumn();
    if (event.fragments > 0)
        ImGui::Text("%llu of %llu", static_cast<unsigned long long>(event.passed),
                    static_cast<unsigned long long>(event.fragments));
    ImGui::TableNextColumn();
    if (!event.after.color.empty()) colorSquare(event.after.color);
    ImGui::TextUnformatted(colorText(event.after).c_str());
    ImGui::TableNextColumn();
    if (event.after.depth) ImGui::Text("%.5g", *event.after.depth);
    if (hasStencil(window.history) && ImGui::TableNextColumn() && event.after.stencil)
        ImGui::Text("%d", *event.after.stencil);
}

void events(Ui& ui, FrameWindow& window) {
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit |
                                       ImGuiTableFlags_Resizable | ImGuiTableFlags_BordersInnerV;
    const bool withStencil = hasStencil(window.history);
    if (!ImGui::BeginTable(withStencil ? "events and stencil" : "events", withStencil ? 6 : 5, kFlags))
        return;
    // In a narrow window the name is cut off, which the list of the frame has, too, and no number.
    ImGui::TableSetupColumn("by", ImGuiTableColumnFlags_WidthStretch);
    for (const char* each : {"outcome", "passed", "colour after", "depth"})
        ImGui::TableSetupColumn(each, ImGuiTableColumnFlags_WidthFixed);
    if (withStencil) ImGui::TableSetupColumn("stencil");
    ImGui::TableHeadersRow();
    for (std::size_t i = 0; i < window.history.events.size(); ++i) eventRow(ui, window, i);
    ImGui::EndTable();
    if (window.history.untouched > 0)
        ImGui::TextDisabled("%zu other draws of the pass have nothing there", window.history.untouched);
}

void values(const char* title, const std::vector<ProbedValue>& all) {
    if (all.empty() || !ImGui::TreeNodeEx(title, ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (ImGui::BeginTable(title, 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
        for (const ProbedValue& each : all) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(each.name.c_str());
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", each.type.c_str());
            ImGui::TableNextColumn();
            codeText(numbersText(each));
        }
        ImGui::EndTable();
    }
    ImGui::TreePop();
}

/// The values that the chosen draw has at the pixel.
void probe(Ui& ui, FrameWindow& window, const FrameItem& item) {
    if (item.kind != FrameItem::Kind::draw) {
        ImGui::TextDisabled("Choose a draw to see the values that it has there.");
        return;
    }
    const bool isOpen = ImGui::CollapsingHeader("Probe: what the chosen draw has there");
    mark(ui, "frame/probe");
    if (!isOpen) return;
    const TargetPixel pixel = pixelOf(window);
    const std::string what = fmt::format(" {} {}", item.key, textOf(pixel));
    const std::string of = frameOf(ui) + what;
    const bool isHeld = ui.session.isMoving() && window.probedFor.ends_with(what);
    if (of != window.probedFor && !isHeld && ui.session.canLookInto()) {
        window.probedFor = of;
        window.probed = ui.session.probeDraw(item.step, pixel);
    }
    if (!window.probed) return;
    const ProbedPixel& probed = *window.probed;
    if (!probed.isDrawn) return ImGui::TextDisabled("The draw has no fragment at this pixel.");
    ImGui::Text("depth %.6g, %s%s", probed.depth, probed.isFront ? "front" : "back",
                probed.isHidden ? ", hidden" : "");
    values("Outputs", probed.outputs);
    values("Inputs", probed.inputs);
    values("Uniforms", probed.uniforms);
}

}  // namespace

void framePixel(Ui& ui, FrameWindow& window) {
    const std::optional<std::size_t> index = window.index();
    if (!index || window.items[*index].kind == FrameItem::Kind::dispatch ||
        window.items[*index].kind == FrameItem::Kind::clearObject)
        return ImGui::TextDisabled("Only passes draw pixels.");
    if (!window.pixel)
        return ImGui::TextWrapped(
            "Click a pixel above to see which draws touched it. Pixels count from the lower left corner, as "
            "gl_FragCoord does.");
    examine(ui, window, *index);
    const std::string& layer = window.answer.layerName;
    ImGui::Text("pixel %d, %d%s%s", window.pixel->first, window.pixel->second, layer.empty() ? "" : ", ",
                layer.c_str());
    mark(ui, "frame/pixel");
    if (!window.history.problem.empty()) return ImGui::TextWrapped("%s", window.history.problem.c_str());
    events(ui, window);
    if (const FrameItem* item = window.item()) probe(ui, window, *item);
}

}  // namespace glibra::view

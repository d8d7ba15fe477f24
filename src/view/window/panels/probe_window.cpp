// What a pixel has: the probe of the picture, and the tab of the window "Frame".

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "view/debug_view/pixel_probe.h"
#include "view/window/panels/frame_window.h"
#include "view/window/panels/ui.h"

namespace glibra::view {

// The pixel probe: a click on the picture shows what the fragment there has.

namespace {

struct Probe {
    std::optional<ProbedPixel> pixel;
    std::uint64_t frame = 0;  ///< Session::framesDrawn() of `pixel`
    double time = 0;          ///< seconds, of `pixel`
};

std::string pixelText(const ProbedPixel& pixel) {
    std::string text =
        fmt::format("pixel {}, {}: line {} {}\n", pixel.x, rowOf(pixel), pixel.draw.line, pixel.word);
    const auto add = [&](const char* title, const std::vector<ProbedValue>& values) {
        if (!values.empty()) text += fmt::format("{}\n", title);
        for (const ProbedValue& each : values) {
            const std::string numbers = numbersText(each);
            const bool isMatrix = numbers.find('\n') != std::string::npos;
            text += fmt::format("  {} {} ={}{}\n", each.type, each.name, isMatrix ? "\n" : " ", numbers);
        }
    };
    add("outputs", pixel.outputs);
    add("inputs", pixel.inputs);
    add("uniforms", pixel.uniforms);
    return text;
}

void table(Ui& ui, const char* title, const std::vector<ProbedValue>& values, bool areColors) {
    if (values.empty() || !ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (!ImGui::BeginTable(title, 3, ImGuiTableFlags_RowBg)) return;
    // Without these widths the columns fit only some frames after the first.
    const auto widest = [&](auto member) {
        float width = 0;
        for (const ProbedValue& each : values)
            width = std::max(width, ImGui::CalcTextSize((each.*member).c_str()).x);
        return std::ceil(width);
    };
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, widest(&ProbedValue::name));
    ImGui::TableSetupColumn("type", ImGuiTableColumnFlags_WidthFixed, widest(&ProbedValue::type));
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const ProbedValue& each : values) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(each.name.c_str());
        mark(ui, "probe/" + each.name);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", each.type.c_str());
        mark(ui, "probe/type/{}", each.name);
        ImGui::TableNextColumn();
        if (areColors && each.numbers.size() >= 3 && each.numbers.size() <= 4) colorSquare(each.numbers);
        if (each.numbers.empty())
            ImGui::TextDisabled("%s", each.why.c_str());
        else if (const std::string text = numbersText(each); text.find('\n') == std::string::npos)
            ImGui::TextWrapped("%s", text.c_str());
        else
            codeText(text);  // a matrix: its rows below each other
    }
    ImGui::EndTable();
}

void ringProbed(const Ui& ui, const ProbedPixel& pixel) {
    const float perPixel = ui.frame.picture[2] / static_cast<float>(std::max(1, ui.look.width()));
    const ImVec2 at(ui.frame.picture[0] + (static_cast<float>(pixel.x) + .5F) * perPixel,
                    ui.frame.picture[1] + (static_cast<float>(pixel.y) + .5F) * perPixel);
    ring(ui, *ImGui::GetBackgroundDrawList(), at, 6 * ui.shared.scale);
}

/// Whenever the window appears it lies over the lower part of the panel, so that it covers no pixel. Without
/// the panel it lies in the corner of the picture.
void place(const Ui& ui) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float panel = screen.x - ui.frame.room[0] - ui.frame.room[2];
    const bool isOverPanel = ui.shared.showPanel && panel > 0;
    const ImVec2 size(isOverPanel ? panel : std::min(400 * ui.shared.scale, screen.x / 2),
                      std::min(420 * ui.shared.scale, screen.y * (isOverPanel ? .7F : .4F)));
    ImGui::SetNextWindowSizeConstraints(
        {std::min(size.x, 200 * ui.shared.scale), std::min(size.y, 120 * ui.shared.scale)}, screen);
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    ImGui::SetNextWindowPos(screen, ImGuiCond_Appearing, {1, 1});
}

void probeContent(Ui& ui, const Probe& probe) {
    const ProbedPixel& pixel = *probe.pixel;
    if (!pixel.isDrawn) {
        ImGui::Text("pixel %d, %d: nothing is drawn here", pixel.x, rowOf(pixel));
        return;
    }
    ImGui::Text("pixel %d, %d, depth %.6g, %s", pixel.x, rowOf(pixel), pixel.depth,
                pixel.isFront ? "front" : "back");
    if (ui.session.isMoving()) {
        ImGui::SameLine();
        ImGui::TextDisabled("at %.2f s", probe.time);
    }
    ImGui::Text("%s in line %d%s%s", pixel.word.c_str(), pixel.draw.line,
                pixel.program.empty() ? "" : ", program ", pixel.program.c_str());
    if (pixel.draw.file == 0) {
        ImGui::SameLine();
        if (smallButton(ui, "Show", "probe/show"))
            showSource(ui, {ui.session.path().generic_string(), pixel.draw.line, 1});
    }
    ImGui::SameLine();
    if (smallButton(ui, "Copy", "probe/copy")) ImGui::SetClipboardText(pixelText(pixel).c_str());
    ImGui::BeginChild("values");
    table(ui, "Outputs", pixel.outputs, true);
    table(ui, "Inputs", pixel.inputs, false);
    table(ui, "Uniforms", pixel.uniforms, false);
    ImGui::EndChild();
}

void probeAt(Session& session, Probe& probe, int x, int y) {
    probe.pixel = session.probe(x, y);
    probe.frame = session.framesDrawn();
    probe.time = session.clock().time();
}

/// The window with the numbers, and a mark on the picture. The numbers follow the picture while time stands
/// still.
void probeWindow(Ui& ui, Probe& probe, bool& isOpen) {
    if (probe.pixel && probe.frame != ui.session.framesDrawn() && !ui.session.isMoving())
        probeAt(ui.session, probe, probe.pixel->x, probe.pixel->y);
    place(ui);
    if (ImGui::Begin(kProbeRow.title, &isOpen,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        markWindow(ui, "probeWindow");
        if (probe.pixel)
            probeContent(ui, probe);
        else
            ImGui::TextWrapped(
                "Click a pixel of the picture. Pixels count from the lower left corner, as gl_FragCoord "
                "does.");
    }
    ImGui::End();
    if (probe.pixel) ringProbed(ui, *probe.pixel);
}

nlohmann::ordered_json probeJson(const Probe& probe, bool isOpen) {
    nlohmann::ordered_json values = nlohmann::ordered_json::object();
    if (probe.pixel)
        for (const auto* list : {&probe.pixel->outputs, &probe.pixel->inputs, &probe.pixel->uniforms})
            for (const ProbedValue& each : *list) values[each.name] = each.numbers;
    return {{"on", isOpen},
            {"drawn", probe.pixel && probe.pixel->isDrawn},
            {"line", probe.pixel ? probe.pixel->draw.line : 0},
            {"x", probe.pixel ? probe.pixel->x : -1},
            {"y", probe.pixel ? rowOf(*probe.pixel) : -1},
            {"values", values}};
}

class ProbePanel final : public Panel {
  public:
    void update(Ui& ui) override {
        isOpen = isOpen && ui.session.hasScene();
        if (!isOpen) probe_.pixel.reset();
        if (isOpen && ui.wanted.probed)
            probeAt(ui.session, probe_, ui.wanted.probed->first, ui.wanted.probed->second);
    }
    void show(Ui& ui) override {
        if (isOpen && ui.session.hasScene()) probeWindow(ui, probe_, isOpen);
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["probe"] = probeJson(probe_, isOpen);
    }

  private:
    Probe probe_;
};

constexpr auto kProbeKeys =
    std::to_array<Shortcut>({{KeyGroup::pipeline, GLFW_KEY_D, false, "D",
                              "probe: click a pixel to see its inputs, outputs and uniforms", toggleOpen}});

// The tab "Pixel" of the window "Frame": which draws touch a pixel, and what the chosen one has there.

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
    window.history = pixelHistory(ui.context, ui.session.live(), window.items, index, ui.look.width(),
                                  ui.look.height(), ui.session.clock().time(), pixel, output);
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

const PanelRow kProbeRow{.name = "probe",
                         .place = PanelPlace::floating,
                         .make = make<ProbePanel>,
                         .keys = kProbeKeys,
                         .title = "Probe###pixel probe"};

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

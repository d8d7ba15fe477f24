// The window "Frame": what the frame executes, and what each of its passes, dispatches and draws leaves.

#include "view/window/panels/frame_window.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "view/edit/source_lines.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"

namespace glibra::view {
namespace {

constexpr std::size_t kUsualFolds = 60;  ///< with more items, the passes are folded at first

/// What the target shows of the pass: not the picture, and normals as colours.
std::string_view nameInFrame(DebugView kind) {
    return kind == DebugView::picture ? "what it left" : nameOf(kind);
}

bool haveOneLine(const FrameItem& a, const FrameItem& b) {
    return a.kind == b.kind && a.place.file == b.place.file && a.place.line == b.place.line;
}

/// Among the items of that kind and line.
std::size_t placeAmongEqual(std::span<const FrameItem> items, std::size_t item) {
    return static_cast<std::size_t>(
        std::count_if(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(item),
                      [&](const FrameItem& each) { return haveOneLine(each, items[item]); }));
}

/// The key of the item after the scene has been read again; empty if its line is gone.
std::string followedKey(std::span<const FrameItem> before, const FrameWindow::Texts& texts,
                        const std::string& key, const FrameWindow& now) {
    const auto found = std::ranges::find_if(before, [&](const FrameItem& each) { return each.key == key; });
    if (found == before.end()) return "";
    const auto textNow = now.texts.find(found->place.file);
    if (textNow == now.texts.end()) return "";
    FrameItem moved = *found;
    moved.place.line = movedLine(texts.at(found->place.file), textNow->second, found->place.line);
    std::size_t left = placeAmongEqual(before, static_cast<std::size_t>(found - before.begin()));
    for (const FrameItem& each : now.items)
        if (haveOneLine(each, moved) && left-- == 0) return each.key;
    return "";
}

/// Lists the frame anew, with thumbnails. The chosen item and the folded passes stay, also when their lines
/// have moved.
void listFrame(Ui& ui, FrameWindow& window, bool isOther) {
    const render::LiveScene& live = ui.session.live();
    const std::vector<FrameItem> before = std::exchange(window.items, frameItems(live.scene(), live.plan()));
    const bool isFirst = before.empty();
    if (isOther) {
        const FrameWindow::Texts texts = std::exchange(window.texts, {});
        for (const FrameItem& each : window.items)
            if (!window.texts.contains(each.place.file))
                window.texts.emplace(each.place.file, ui.session.readText(each.place.file));
        window.chosen = followedKey(before, texts, window.chosen, window);
        for (std::string& each : window.folded) each = followedKey(before, texts, each, window);
        std::erase(window.folded, "");
    }
    if (window.item() == nullptr) {
        // The last one that leaves something: the picture.
        window.chosen.clear();
        for (const FrameItem& each : window.items)
            if (each.kind == FrameItem::Kind::pass) window.chosen = each.key;
        window.target = 0;
        window.begins = false;
    }
    if (!isFirst || window.items.size() <= kUsualFolds) return;
    for (const FrameItem& each : window.items)
        if (each.kind == FrameItem::Kind::pass && each.key != window.chosen)
            window.folded.push_back(each.key);
}

void takeThumbnails(Ui& ui, FrameWindow& window) {
    const auto& made = window.answer.thumbnails;
    // Those that were not asked for stay.
    for (std::size_t i = 0; i < std::min(made.size(), window.thumbnails.size()); ++i)
        if (!made[i].rgba.empty())
            window.thumbnails[i] = textureOfTexels(ui, made[i].width, made[i].height, made[i].rgba);
}

void takeMask(Ui& ui, FrameWindow& window) {
    window.overlay.reset();
    if (!window.answer.mask) return;
    const DrawMask& mask = *window.answer.mask;
    std::vector<std::uint8_t> rgba(4 * mask.pixels.size());
    // Nearly opaque, so that they are these colours on every picture.
    constexpr std::array<std::array<std::uint8_t, 4>, 3> kColors{
        {{0, 0, 0, 0}, {60, 120, 255, 225}, {255, 150, 0, 225}}};
    for (std::size_t i = 0; i < mask.pixels.size(); ++i)
        std::copy_n(kColors.at(mask.pixels[i]).begin(), 4, rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
    window.overlay = textureOfTexels(ui, mask.width, mask.height, rgba);
}

void takeNumbers(Ui& ui, FrameWindow& window) {
    window.shownNumbers.reset();
    const FrameItem* item = window.item();
    if (window.shows == DebugView::picture || item == nullptr) return;
    if (item->kind == FrameItem::Kind::dispatch || item->kind == FrameItem::Kind::clearObject) {
        window.problem = "only passes can be shown so";
        return;
    }
    window.problem = ui.session.numbersOfPass(item->step.pass, window.shows, window.numbers, window.layer);
    if (!window.problem.empty()) return;
    render::Content content;
    content.width = window.numbers.width;
    content.height = window.numbers.height;
    content.values.assign(window.numbers.rgba.begin(), window.numbers.rgba.end());
    window.shownNumbers = std::move(content);
    window.colors = colorsOf(window.shows, window.numbers);
}

/// The items that are listed and have no thumbnail yet; empty if there are none.
std::vector<bool> missingThumbnails(const FrameWindow& window) {
    std::vector<bool> wanted(window.items.size());
    bool isHidden = false;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const FrameItem& each = window.items[i];
        if (!each.isInPass()) isHidden = window.isFolded(each.key);
        wanted[i] = !window.asked[i] && !(each.isInPass() && isHidden);
    }
    return std::ranges::find(wanted, true) == wanted.end() ? std::vector<bool>() : wanted;
}

/// Draws the frame again if it is another one, or if another item is chosen. While time runs, the list stays
/// that of the frame when it was asked for; while something is dragged, it waits.
void watch(Ui& ui, FrameWindow& window) {
    Session& session = ui.session;
    if (!session.canLookInto()) {
        window.problem = "no frame has been drawn";
        return;
    }
    const std::string scene = fmt::format("{} {}", session.path().generic_string(), session.timesLoaded());
    const std::string frame =
        fmt::format("{} {} {} {}", scene, session.framesDrawn(), ui.look.width(), ui.look.height());
    const bool isOther = !window.listedFor.starts_with(scene);
    if (!isOther && ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const bool isNew = isOther || (window.listedFor != frame && !session.isMoving());
    if (isOther) window.times = {};
    if (isNew) {
        listFrame(ui, window, isOther);
        window.listedFor = frame;
        window.thumbnails.clear();
        window.thumbnails.resize(window.items.size());
        window.asked.assign(window.items.size(), false);
        window.isDrawn.assign(window.items.size(), true);
    }
    const std::string wanted = fmt::format("{} {} {} {}", window.chosen, window.target, window.layer,
                                           static_cast<int>(window.shows));
    std::vector<bool> missing = missingThumbnails(window);
    if (!isNew && wanted == window.watchedFor && missing.empty()) return;
    window.watchedFor = wanted;
    window.time = session.clock().time();
    window.answer = watchFrame(ui.context, session.live(), window.items,
                               {ui.look.width(), ui.look.height(), window.time, missing, window.index(),
                                window.target, window.layer});
    for (std::size_t i = 0; i < missing.size(); ++i) window.asked[i] = window.asked[i] || missing[i];
    if (!missing.empty()) window.isDrawn = window.answer.isExecuted;
    window.problem = window.answer.problem;
    takeThumbnails(ui, window);
    takeMask(ui, window);
    takeNumbers(ui, window);
    window.view.forget();
    // Only now: the range follows from this content.
    if (const auto withOwnRange = std::exchange(window.begins, std::nullopt))
        window.view.begin(*withOwnRange);
}

void chooseTarget(Ui& ui, FrameWindow& window, const FrameItem& item) {
    ImGui::SetNextItemWidth(170 * ui.shared.scale);
    const std::size_t now = std::min(window.target, item.targets.size() - 1);
    const bool isOpen = beginCombo(ui, "##target", item.targets[now].name.c_str(), "frame/target");
    if (isOpen) {
        for (std::size_t i = 0; i < item.targets.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(item.targets[i].name.c_str(), i == now) && i != now) {
                window.target = i;
                window.begins = item.targets[i].kind != FrameTarget::Kind::color;
            }
            mark(ui, "frame/target/{}", i);
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    if (window.answer.layers > 1) {
        besideIfRoom(170 * ui.shared.scale);
        wordBefore("layer");
        ImGui::SetNextItemWidth(120 * ui.shared.scale);
        double layer = std::min(window.layer, window.answer.layers - 1);
        if (labelledSlider(ui, "##layer", "frame/layer",
                           {0, static_cast<double>(window.answer.layers - 1), true}, layer))
            window.layer = static_cast<int>(std::lround(layer));
    }
    besideIfRoom(190 * ui.shared.scale);
    wordBefore("Show");
    ImGui::SetNextItemWidth(150 * ui.shared.scale);
    const bool shows = beginCombo(ui, "##show", std::string(nameInFrame(window.shows)).c_str(), "frame/show");
    if (!shows) return;
    for (int i = 0; i < kDebugViewCount; ++i) {
        const auto kind = static_cast<DebugView>(i);
        const std::string name(nameInFrame(kind));
        if (choice(ui, name.c_str(), kind == window.shows, "frame/show/{}", name)) window.shows = kind;
    }
    ImGui::EndCombo();
}

void heading(Ui& ui, FrameWindow& window, const FrameItem& item) {
    if (!item.targets.empty()) {
        chooseTarget(ui, window, item);
        besideIfRoom(100 * ui.shared.scale);
    }
    checkBox(
        ui, "Highlight", "frame/highlight", window.highlights,
        "The pixels of the chosen draw: orange where it passes the tests, blue where something hides it");
    if (item.place.line > 0) {
        besideIfRoom(60 * ui.shared.scale);
        if (smallButton(ui, "Source", "frame/source")) showSource(ui, item.place);
    }
    std::string text = labelOf(item);
    if (!window.answer.layerName.empty()) text += "   " + window.answer.layerName;
    if (ui.session.isMoving()) text += fmt::format("   as at {:.2f} s", window.time);
    ImGui::TextUnformatted(text.c_str());
    const auto& mask = window.answer.mask;
    if (!mask) return;
    // The numbers with their colours, which the highlight has.
    const auto legend = [&](std::array<double, 3> color, const std::string& words) {
        besideIfRoom(ImGui::CalcTextSize(words.c_str()).x + 2 * ImGui::GetTextLineHeight());
        colorSquare(color);
        ImGui::TextUnformatted(words.c_str());
    };
    legend({1, .59, 0}, fmt::format("{} pixels", mask->passedPixels));
    legend({.24, .47, 1}, fmt::format("{} hidden", mask->hiddenPixels));
}

void target(Ui& ui, FrameWindow& window) {
    const render::Content* content = window.shownNumbers     ? &*window.shownNumbers
                                     : window.answer.content ? &*window.answer.content
                                                             : nullptr;
    if (!window.problem.empty() || content == nullptr) {
        ImGui::TextWrapped("%s", window.problem.c_str());
        const FrameItem* item = window.item();
        const FrameTarget* shown = item != nullptr ? window.targetOf(*item) : nullptr;
        if (shown != nullptr && shown->kind == FrameTarget::Kind::buffer &&
            button(ui, "Show its content", "frame/buffer"))
            ui.wanted.inspected = shown->name;
        return;
    }
    const bool isDebug = window.shownNumbers.has_value();
    TexelSource source{*content};
    if (isDebug && !window.colors.empty()) source.colors = &window.colors;
    if (isDebug && window.shows != DebugView::normals)
        source.words = [&](int x, int y) {
            const std::size_t at =
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(window.numbers.width) +
                     static_cast<std::size_t>(x));
            return wordsOf(window.shows, window.numbers.rgba.data() + at);
        };
    const bool fits = window.answer.mask && window.answer.mask->width == content->width;
    if (window.highlights && window.overlay && fits) source.overlay = &*window.overlay;
    window.view.marked = window.pixel;
    texelView(ui, window.view, source, "frame");
    if (window.view.clicked) window.pixel = window.view.clicked;
}

void tabs(Ui& ui, FrameWindow& window) {
    if (!ImGui::BeginTabBar("parts")) return;
    const auto tab = [&](const char* title, const char* name, auto draw) {
        const bool isOpen = ImGui::BeginTabItem(title);
        mark(ui, name);
        if (!isOpen) return;
        ImGui::BeginChild(title);
        draw();
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    tab("Pixel", "frame/tab/pixel", [&] { framePixel(ui, window); });
    tab("State", "frame/tab/state", [&] { frameState(ui, window); });
    tab("Try", "frame/tab/try", [&] { frameTrial(ui, window); });
    tab("Mesh", "frame/tab/mesh", [&] { frameMesh(ui, window); });
    ImGui::EndTabBar();
}

/// The border between the picture and the tabs, which is dragged.
void splitter(Ui& ui, FrameWindow& window, float whole) {
    constexpr float kLeast = .25F, kMost = .8F;
    ImGui::InvisibleButton("split", {-1, 5 * ui.shared.scale});
    markPlace(ui, "frame/split");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    if (ImGui::IsItemActive() && whole > 1)
        window.upperPart = std::clamp(window.upperPart + ImGui::GetIO().MouseDelta.y / whole, kLeast, kMost);
}

void frameWindow(Ui& ui, FrameWindow& window, bool& isOpen) {
    ui.session.keepTextures();
    watch(ui, window);
    placeFloating(ui, 10, 10, 900, 660);
    if (ImGui::Begin(kFrameRow.title, &isOpen, ImGuiWindowFlags_NoCollapse)) {
        markWindow(ui, "frameWindow");
        const ImVec2 room = ImGui::GetContentRegionAvail();
        ImGui::BeginChild("items", {std::max(150.F, room.x * .36F), 0}, true);
        frameList(ui, window);
        ImGui::EndChild();
        ImGui::SameLine();
        ImGui::BeginGroup();
        if (const FrameItem* item = window.item()) {
            heading(ui, window, *item);
            const float whole = ImGui::GetContentRegionAvail().y;
            ImGui::BeginChild("target", {0, std::max(120.F, whole * window.upperPart)});
            target(ui, window);
            ImGui::EndChild();
            splitter(ui, window, whole);
            tabs(ui, window);
        }
        ImGui::EndGroup();
    }
    ImGui::End();
}

class FramePanel final : public Panel {
  public:
    void show(Ui& ui) override {
        isOpen = isOpen && ui.session.hasScene();
        if (!isOpen) {
            if (!window_.items.empty()) window_ = {};
            return;
        }
        frameWindow(ui, window_, isOpen);
    }
    /// The chosen draw on the picture, if its pass draws that.
    void drawOver(Ui& ui) override {
        const FrameItem* item = isOpen ? window_.item() : nullptr;
        // Of a moving picture it would be the pixels of an earlier one.
        if (item == nullptr || !window_.overlay || !window_.highlights || ui.session.isMoving()) return;
        const auto& passes = ui.session.live().scene().frame.passes;
        if (item->step.pass >= passes.size() || !passes[item->step.pass].isWindow) return;
        const Rectangle& at = ui.frame.picture;
        ImGui::GetBackgroundDrawList()->AddImage(idOf(*window_.overlay), {at[0], at[1]},
                                                 {at[0] + at[2], at[1] + at[3]}, {0, 1}, {1, 0});
    }
    void addTo(nlohmann::ordered_json& state, const Ui& ui) const override {
        if (isOpen) state["frame"] = frameJson(ui, window_);
    }
    void releaseDevice() override { window_ = {}; }

  private:
    FrameWindow window_;
};

constexpr auto kFrameKeys = std::to_array<Shortcut>(
    {{KeyGroup::pipeline, GLFW_KEY_G, false, "G",
      "the frame: its passes, dispatches and draws, and what each of them left", toggleOpen}});

}  // namespace

std::optional<std::size_t> FrameWindow::index() const {
    for (std::size_t i = 0; i < items.size(); ++i)
        if (items[i].key == chosen) return i;
    return std::nullopt;
}

bool FrameWindow::isFolded(const std::string& key) const {
    return std::ranges::find(folded, key) != folded.end();
}

const FrameItem* FrameWindow::item() const {
    const auto found = index();
    return found ? &items[*found] : nullptr;
}

const FrameTarget* FrameWindow::targetOf(const FrameItem& item) const {
    return item.targets.empty() ? nullptr : &item.targets[std::min(target, item.targets.size() - 1)];
}

void FrameWindow::choose(const FrameItem& item) {
    const FrameItem* before = this->item();
    const auto nameOfTarget = [&](const FrameItem* each) {
        const FrameTarget* of = each != nullptr ? targetOf(*each) : nullptr;
        return of != nullptr ? of->name : std::string();
    };
    const std::string shown = nameOfTarget(before);
    if (before != nullptr && before->step.pass != item.step.pass) {
        target = 0;
        layer = 0;
        pixel.reset();
    }
    chosen = item.key;
    // The same target keeps its zoom and range, so that draws can be compared.
    const FrameTarget* now = targetOf(item);
    if (nameOfTarget(&item) != shown) begins = now == nullptr || now->kind != FrameTarget::Kind::color;
}

const plan::PlannedDraw* plannedDraw(const plan::FramePlan& plan, const FrameItem& item) {
    if (item.kind != FrameItem::Kind::draw) return nullptr;
    for (const plan::PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step); draw && draw->step == item.step)
                return draw;
    return nullptr;
}

const PanelRow kFrameRow{
    .name = "frame",
    .place = PanelPlace::floating,
    .make = make<FramePanel>,
    .keys = kFrameKeys,
    .title = "Frame: passes, dispatches, draws",
    .checkBox = "Frame",
    .help = "List what the frame executes, with what each of it left; pixels, state, meshes (G)"};

}  // namespace glibra::view

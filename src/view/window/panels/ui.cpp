#include "view/window/panels/ui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "view/window/panels/value_slider.h"
#include "view/window/platform/theme.h"

namespace glibra::view {

void mark(Ui& ui, std::string_view name) {
    if (!ui.shared.marksWidgets || !ImGui::IsItemVisible()) return;
    if (ui.focusedSlider != 0 && ImGui::GetItemID() == ui.focusedSlider) ui.focusedName = name;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    ui.widgets[std::string(name)] = {low.x, low.y, size.x, size.y};
}

void markField(Ui& ui, std::string_view name, std::string_view label) {
    mark(ui, name);
    const auto made = ui.widgets.find(std::string(name));
    if (made == ui.widgets.end()) return;
    const float width = ImGui::CalcTextSize(label.data(), label.data() + label.size(), true).x;
    if (width > 0) made->second[2] -= width + ImGui::GetStyle().ItemInnerSpacing.x;
}

namespace {

constexpr float kNarrowestPanel = 220, kUsualPanel = 376;
constexpr float kWidestPart = .7F;

/// The height of the status line, which stays visible while the sections scroll.
float noticeHeight(const Ui& ui) {
    if (ui.notice.text.empty()) return 0;
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::CalcTextSize(ui.notice.text.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y +
           3 * style.ItemSpacing.y;
}

/// The sections of the panel. Nothing in them moves when they begin to scroll, or when the status line comes
/// or goes: the scroll bar has its place always, and below the last section stays free what the status line
/// does not take.
void sections(Ui& ui) {
    constexpr float kLines = 3;  // of the status line
    const float notice = noticeHeight(ui);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float free = kLines * ImGui::GetTextLineHeight() + 3 * style.ItemSpacing.y - notice;
    constexpr std::array kGrabs{ImGuiCol_ScrollbarGrab, ImGuiCol_ScrollbarGrabHovered,
                                ImGuiCol_ScrollbarGrabActive};
    if (!ui.panelScrolls)
        for (const ImGuiCol each : kGrabs) ImGui::PushStyleColor(each, ImVec4(0, 0, 0, 0));
    // ImGui would limit the scrolling by the size of the last frame, which was that for another status line.
    float& height = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("height of the sections"));
    if (height > 0) ImGui::SetNextWindowContentSize({0, height + std::max(0.F, free)});
    ImGui::BeginChild("sections", {0, -notice}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar);
    if (!ui.panelScrolls) ImGui::PopStyleColor(static_cast<int>(kGrabs.size()));
    messagesPanel(ui);
    if (ui.session.hasScene()) {
        uniformsPanel(ui);
        keysPanel(ui);
        viewPanel(ui);
        timePanel(ui);
        hardcopyPanel(ui);
        suitePanel(ui);
        costPanel(ui);
    }
    height = ImGui::GetCursorPosY();
    ui.panelScrolls = ImGui::GetScrollMaxY() > 0;
    ImGui::EndChild();
    if (ui.notice.text.empty()) return;
    ImGui::Separator();
    if (ui.notice.isError) ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().error));
    ImGui::TextWrapped("%s", ui.notice.text.c_str());
    if (ui.notice.isError) ImGui::PopStyleColor();
    mark(ui, "notice");
}

/// Returns the panel's width.
float panel(Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;

    const float widest = std::max(1.F, window.x * kWidestPart);
    const float narrowest = std::min(kNarrowestPanel * ui.scale, widest);
    // The width that the user has chosen stays while a small window cannot have it.
    const float wanted = std::floor(std::clamp(panelWidth(ui), narrowest, widest));
    ImGui::SetNextWindowPos({window.x, 0}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowSize({wanted, window.y}, ImGuiCond_Always);
    ImGui::SetNextWindowSizeConstraints({narrowest, window.y}, {widest, window.y});
    // The left border resizes the panel; a grip in the corner would be at the wrong end.
    for (const ImGuiCol each : {ImGuiCol_ResizeGrip, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive})
        ImGui::PushStyleColor(each, ImVec4(0, 0, 0, 0));
    if (ImGui::Begin("Controls", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings)) {
        scenePanel(ui);
        sections(ui);
    }
    const float width = ImGui::GetWindowWidth();
    ImGui::End();
    ImGui::PopStyleColor(3);
    if (width != wanted) ui.settings.panelWidth = width;
    return width;
}

/// The largest rectangle of that shape in the middle of the room, in whole screen coordinates.
Rectangle fitted(const Rectangle& room, double shape) {
    Rectangle picture{std::floor(room[0]), std::floor(room[1]), std::floor(room[2]), std::floor(room[3])};
    const double width = picture[2], height = picture[3];
    if (width < 1 || height < 1 || !(shape > 0)) return picture;
    picture[2] = static_cast<float>(std::clamp(std::round(height * shape), 1.0, width));
    picture[3] = static_cast<float>(std::clamp(std::round(width / shape), 1.0, height));
    picture[0] += std::floor((static_cast<float>(width) - picture[2]) / 2);
    picture[1] += std::floor((static_cast<float>(height) - picture[3]) / 2);
    return picture;
}

/// Keeps the tool windows whole inside the main window.
void keepInside() {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    for (ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
        constexpr ImGuiWindowFlags kOthers = ImGuiWindowFlags_ChildWindow | ImGuiWindowFlags_Tooltip |
                                             ImGuiWindowFlags_Popup | ImGuiWindowFlags_NoMove;
        if (!each->WasActive || (each->Flags & kOthers) != 0) continue;
        const ImVec2 size(std::min(each->SizeFull.x, screen.x), std::min(each->SizeFull.y, screen.y));
        const ImVec2 at(std::clamp(each->Pos.x, 0.F, screen.x - size.x),
                        std::clamp(each->Pos.y, 0.F, screen.y - size.y));
        if (size.x != each->SizeFull.x || size.y != each->SizeFull.y) ImGui::SetWindowSize(each, size);
        if (at.x != each->Pos.x || at.y != each->Pos.y) ImGui::SetWindowPos(each, at);
    }
}

/// Stores whether a section is open, if that is not as at first.
void remember(Ui& ui, std::string_view name, bool isOpen, bool isOpenAtFirst) {
    auto& folds = ui.settings.folds;
    const auto known = folds.find(name);
    if (isOpen == isOpenAtFirst) {
        if (known != folds.end()) folds.erase(known);
    } else {
        folds.insert_or_assign(std::string(name), isOpen);
    }
}

bool wasOpen(const Ui& ui, std::string_view name, bool isOpenAtFirst) {
    const auto known = ui.settings.folds.find(name);
    return known == ui.settings.folds.end() ? isOpenAtFirst : known->second;
}

}  // namespace

bool section(Ui& ui, const char* title, std::string_view name, bool isOpenAtFirst) {
    const bool before = wasOpen(ui, name, isOpenAtFirst);
    ImGui::SetNextItemOpen(before);
    ImGui::PushFont(headingFont());
    const bool isOpen = ImGui::CollapsingHeader(title);
    ImGui::PopFont();
    mark(ui, name);
    if (isOpen != before) remember(ui, name, isOpen, isOpenAtFirst);
    return isOpen;
}

bool group(Ui& ui, const char* title, std::string_view name) {
    const bool before = wasOpen(ui, name, true);
    ImGui::SetNextItemOpen(before);
    const bool isOpen =
        ImGui::TreeNodeEx(title, ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    mark(ui, name);
    if (isOpen != before) remember(ui, name, isOpen, true);
    return isOpen;
}

float panelWidth(const Ui& ui) {
    if (ui.settings.panelWidth > 0) return ui.settings.panelWidth;
    return kUsualPanel * ui.scale;
}

double shapeOf(const Ui& ui) {
    if (ui.shared.shape) return *ui.shared.shape;
    if (!ui.session.hasScene()) return 0;
    const scene::Scene& scene = ui.session.live().scene();
    return static_cast<double>(scene.width) / std::max(1, scene.height);
}

bool lineOfText(const char* text, const ImVec2& at, float right) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, {right, at.y + size.y}, right, right, text,
                              nullptr, &size);
    return at.x + size.x <= right;
}

void placeFloating(const Ui& ui, float left, float top, float width, float height) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(width * ui.scale, screen.x), std::min(height * ui.scale, screen.y));
    ImGui::SetNextWindowSizeConstraints(
        {std::min(240 * ui.scale, screen.x), std::min(160 * ui.scale, screen.y)}, screen);
    ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowPos(
        {std::min(left * ui.scale, screen.x - size.x), std::min(top * ui.scale, screen.y - size.y)},
        ImGuiCond_FirstUseEver);
}

void showAll(Ui& ui) {
    ui.widgets.clear();
    ui.focusedName.clear();
    ui.shownTranslation.clear();
    ui.hoverText.clear();
    ui.needsFrames = false;
    shortcuts(ui);
    beginSliders(ui);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = ui.showPanel ? panel(ui) : 0;
    ui.room = {0, 0, std::max(1.F, window.x - width), std::max(1.F, window.y)};
    tabBar(ui, ui.room);
    sourcePanel(ui, ui.room);
    ui.room[2] = std::max(1.F, ui.room[2]);
    ui.room[3] = std::max(1.F, ui.room[3]);
    const bool isFilled = ui.settings.pictureShape == PictureShape::fill;
    ui.picture = fitted(ui.room, isFilled ? 0 : shapeOf(ui));
    errorBanner(ui);
    inspectorWindow(ui);
    compareWindow(ui);
    probeWindow(ui);
    referenceWindow(ui);
    noiseWindow(ui);
    exampleWindow(ui);
    verboseWindow(ui);
    missingFileDialog(ui);
    fileDialog(ui);
    messageBox(ui);
    questionDialog(ui);
    helpWindow(ui);
    endSliders(ui);
    keepInside();
    pictureInput(ui);
    debugViewUnderMouse(ui);
}

}  // namespace glibra::view

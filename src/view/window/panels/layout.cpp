#include "view/window/panels/ui.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "view/window/panels/shortcuts.h"
#include "view/window/panels/value_fields.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

constexpr float kNarrowestPanel = 220, kUsualPanel = 376;
constexpr float kWidestPart = .7F;
constexpr float kRoomOfPicture = 200;

void showAt(Ui& ui, PanelPlace place) {
    for (const PanelUse& each : ui.panels)
        if (each.row->place == place) each.panel->show(ui);
}

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
    bool& scrolls = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("sections scroll"));
    if (!scrolls)
        for (const ImGuiCol each : kGrabs) ImGui::PushStyleColor(each, ImVec4(0, 0, 0, 0));
    // ImGui would limit the scrolling by the size of the last frame, which was that for another status line.
    float& height = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("height of the sections"));
    if (height > 0) ImGui::SetNextWindowContentSize({0, height + std::max(0.F, free)});
    const bool hidesBar = !scrolls;
    ImGui::BeginChild("sections", {0, -notice}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar);
    if (hidesBar) ImGui::PopStyleColor(static_cast<int>(kGrabs.size()));
    for (const PanelUse& each : ui.panels)
        if (each.row->place == PanelPlace::section && (each.row->withoutScene || ui.session.hasScene()))
            each.panel->show(ui);
    height = ImGui::GetCursorPosY();
    scrolls = ImGui::GetScrollMaxY() > 0;
    ImGui::EndChild();
    if (ui.notice.text.empty()) return;
    ImGui::Separator();
    wrappedText(ui.notice.isError ? palette().error : palette().text, ui.notice.text.c_str());
    mark(ui, "notice");
}

/// Returns the panel's width.
float panel(Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;

    const float widest = std::max(1.F, window.x * kWidestPart);
    const float narrowest = std::min(kNarrowestPanel * ui.shared.scale, widest);
    // The width that the user has chosen stays while a small window cannot have it.
    float width = panelWidth(ui);
    // Unless somebody has chosen its width or the picture has the size that was asked for, the panel of a
    // narrow window leaves half of it to the picture.
    const bool hasSize = ui.shared.size && window.x - width >= static_cast<float>(ui.shared.size->first);
    if (!(ui.settings.panelWidth > 0) && !hasSize)
        width = std::min(width, std::max(window.x / 2, window.x - kRoomOfPicture * ui.shared.scale));
    const float wanted = std::floor(std::clamp(width, narrowest, widest));
    ImGui::SetNextWindowPos({window.x, 0}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowSize({wanted, window.y}, ImGuiCond_Always);
    ImGui::SetNextWindowSizeConstraints({narrowest, window.y}, {widest, window.y});
    // The left border resizes the panel; a grip in the corner would be at the wrong end.
    for (const ImGuiCol each : {ImGuiCol_ResizeGrip, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive})
        ImGui::PushStyleColor(each, ImVec4(0, 0, 0, 0));
    if (ImGui::Begin("Controls", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings)) {
        showAt(ui, PanelPlace::head);
        sections(ui);
    }
    width = ImGui::GetWindowWidth();
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

// The tab bar above the picture: one tab per open scene.

/// The room for the names of the tabs: all of it, or equally little for the long ones if the bar is too
/// narrow.
float roomForNames(const Ui& ui, float width) {
    constexpr float kLeast = 48;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float beside = 2 * style.FramePadding.x + style.ItemInnerSpacing.x * 2 + ImGui::GetFontSize() + 2;
    std::vector<float> names;
    for (const TabTitle& each : ui.shared.tabs) names.push_back(ImGui::CalcTextSize(each.label.c_str()).x);
    std::ranges::sort(names);
    float left = width - ImGui::GetFrameHeight() * 2 - beside * static_cast<float>(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const float share = left / static_cast<float>(names.size() - i);
        if (names[i] > share) return std::max(share, kLeast * ui.shared.scale);
        left -= names[i];
    }
    return names.empty() ? 0 : names.back() + 1;
}

void tabBar(Ui& ui) {
    Rectangle& free = ui.frame.room;
    if (ui.shared.tabs.size() < 2) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(4 * ui.shared.scale, 3 * ui.shared.scale));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    const float height = ImGui::GetFrameHeight() + 6 * ui.shared.scale;
    ImGui::SetNextWindowPos({free[0], free[1]});
    ImGui::SetNextWindowSize({free[2], height});
    const bool isOpen = ImGui::Begin(
        "Scenes", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
            ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(2);
    // A bar that is new, as after the device was lost, would choose its first tab.
    const bool isGiven = ui.shared.tabChanged || ImGui::IsWindowAppearing();
    if (isOpen && ImGui::BeginTabBar("scenes", ImGuiTabBarFlags_FittingPolicyScroll)) {
        const float room = roomForNames(ui, free[2]);
        for (std::size_t i = 0; i < ui.shared.tabs.size(); ++i) {
            const TabTitle& each = ui.shared.tabs[i];
            ImGuiTabItemFlags flags = each.isUnsaved ? ImGuiTabItemFlags_UnsavedDocument : 0;
            const bool isShown = i == ui.shared.shownTab;
            if (isGiven && isShown) flags |= ImGuiTabItemFlags_SetSelected;
            bool stays = true;
            if (each.hasError) ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().error));
            const bool isChosen = ImGui::BeginTabItem(
                fmt::format("{}###{}", shortened(each.label, room), each.id).c_str(), &stays, flags);
            if (each.hasError) ImGui::PopStyleColor();
            mark(ui, "tab/{}", i);
            if (ImGui::IsItemHovered() && !each.path.empty())
                ImGui::SetTooltip("%s", each.path.generic_string().c_str());
            if (isChosen) ImGui::EndTabItem();
            if (isChosen && !isShown && !isGiven) ui.requests.showTab = i;
            if (!stays) ui.requests.closeTab = i;
        }
        if (ImGui::TabItemButton("+", ImGuiTabItemFlags_Trailing)) openDialog(ui, true);
        mark(ui, "tab/new");
        ui.shared.tabChanged = false;
        // Dear ImGui moves a bar that is too long to the shown tab little by little. Frames are drawn for
        // events only, so the bar would stop halfway, and move on under the mouse later.
        ImGuiTabBar* bar = ImGui::GetCurrentContext()->CurrentTabBar;
        ImGui::EndTabBar();
        bar->ScrollingAnim = bar->ScrollingTarget;
    }
    ImGui::End();
    free[1] += height;
    free[3] -= height;
}

}  // namespace

float panelWidth(const Ui& ui) {
    if (ui.settings.panelWidth > 0) return ui.settings.panelWidth;
    return kUsualPanel * ui.shared.scale;
}

double shapeOf(const Ui& ui) {
    if (ui.shared.size) return static_cast<double>(ui.shared.size->first) / ui.shared.size->second;
    if (!ui.session.hasScene()) return 0;
    const scene::Scene& scene = ui.session.live().scene();
    return static_cast<double>(scene.width) / std::max(1, scene.height);
}

void showAll(Ui& ui) {
    Frame& frame = ui.frame;
    frame.widgets.clear();
    frame.focusedName.clear();
    frame.translation.clear();
    frame.hoverText.clear();
    frame.isFollowed = false;
    frame.covered = 0;
    shortcuts(ui);
    for (const PanelUse& each : ui.panels) each.panel->update(ui);
    ui.wanted = {};
    beginSliders(ui);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = ui.shared.showPanel ? panel(ui) : 0;
    frame.room = {0, 0, std::max(1.F, window.x - width), std::max(1.F, window.y)};
    showAt(ui, PanelPlace::edge);
    frame.room[2] = std::max(1.F, frame.room[2]);
    frame.room[3] = std::max(1.F, frame.room[3]);
    const bool isFilled = ui.settings.pictureShape == PictureShape::fill;
    frame.picture = fitted(frame.room, isFilled ? 0 : shapeOf(ui));
    // The source stands over the left part of the room: the picture moves to where it is seen best.
    if (ui.settings.showSource && ui.settings.sourcePlace == SourcePlace::over && ui.session.hasScene())
        frame.picture[0] = std::floor(frame.room[0] + frame.room[2]) - frame.picture[2];
    showAt(ui, PanelPlace::floating);
    endSliders(ui);
    keepInside();
    showAt(ui, PanelPlace::picture);
}

void drawOverPicture(Ui& ui) {
    for (const PanelUse& each : ui.panels) each.panel->drawOver(ui);
}

const PanelRow kTabBarRow{
    .name = "tabs", .place = PanelPlace::edge, .make = make<Drawn<tabBar>>, .isShared = true};

}  // namespace glibra::view

// The panel in which the scene and its shaders are edited.

#include "view/window/panels/source_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "glib/text.h"
#include "view/edit/external_editor.h"
#include "view/edit/source_lines.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

bool isSame(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code failure;
    return a == b || std::filesystem::absolute(a, failure).lexically_normal() ==
                         std::filesystem::absolute(b, failure).lexically_normal();
}

EditedFile& edited(Ui& ui, const std::filesystem::path& path) {
    return ui.shared.sources.try_emplace(path, path).first->second;
}

/// Updates the list of files after the scene was loaded. Files with unsaved text stay in the list even if the
/// scene does not use them any more.
void refresh(Ui& ui) {
    SourcePanel& panel = ui.source;
    if (panel.loaded != ui.session.timesLoaded()) {
        panel.loaded = ui.session.timesLoaded();
        std::vector<SourceFile> files = sourceFiles(ui.session.live());
        for (const SourceFile& old : panel.files) {
            const auto kept = ui.shared.sources.find(old.path);
            const bool isThere = std::any_of(files.begin(), files.end(),
                                             [&](const SourceFile& each) { return each.path == old.path; });
            if (!isThere && kept != ui.shared.sources.end() && kept->second.isChanged())
                files.push_back({old.path, old.label, "no longer used by the scene"});
        }
        panel.files = std::move(files);
        for (auto& [path, file] : ui.shared.sources)
            if (file.lookAtDisk() && !file.hasConflict()) ++panel.views[path].generation;
    }
    const auto isChosen = [&](const SourceFile& each) { return each.path == panel.chosen; };
    if (std::none_of(panel.files.begin(), panel.files.end(), isChosen)) {
        // People edit the last stage most, so begin with it.
        const auto shader = std::find_if(
            panel.files.rbegin(), panel.files.rend(),
            [](const SourceFile& each) { return each.role.find("shader") != std::string::npos; });
        panel.chosen = shader == panel.files.rend() ? panel.files.front().path : shader->path;
        panel.follow = true;
    }
}

void takeGoTo(Ui& ui) {
    SourcePanel& panel = ui.source;
    const auto place = std::exchange(panel.goTo, std::nullopt);
    if (!place) return;
    for (const SourceFile& each : panel.files)
        if (isSame(each.path, place->file)) {
            panel.chosen = each.path;
            panel.follow = true;
            panel.views[each.path].goTo = place->line;
            return;
        }
    ui.notice = place->file + " is not a file of this scene";
}

bool hasError(const Ui& ui, const std::filesystem::path& file) {
    return std::any_of(ui.session.diagnostics().begin(), ui.session.diagnostics().end(),
                       [&](const Diagnostic& each) {
                           return each.severity == Severity::error && isSame(each.place.file, file);
                       });
}

void fileTabs(Ui& ui) {
    SourcePanel& panel = ui.source;
    if (!ImGui::BeginTabBar("files", ImGuiTabBarFlags_FittingPolicyScroll)) return;
    for (const SourceFile& each : panel.files) {
        const auto known = ui.shared.sources.find(each.path);
        const bool isChanged = known != ui.shared.sources.end() && known->second.isChanged();
        const bool isWrong = hasError(ui, each.path);
        ImGuiTabItemFlags flags = isChanged ? ImGuiTabItemFlags_UnsavedDocument : 0;
        if (panel.follow && each.path == panel.chosen) flags |= ImGuiTabItemFlags_SetSelected;
        if (isWrong) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(.95F, .35F, .30F, 1));
        const bool isShown =
            ImGui::BeginTabItem((each.label + "###" + each.path.string()).c_str(), nullptr, flags);
        if (isWrong) ImGui::PopStyleColor();
        mark(ui, "source/file/" + each.label);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n%s", each.role.c_str(), each.path.c_str());
        if (!isShown) continue;
        if (!panel.follow) panel.chosen = each.path;
        ImGui::EndTabItem();
    }
    panel.follow = false;
    ImGui::EndTabBar();
}

void conflict(Ui& ui, EditedFile& file, CodeView& view) {
    if (!file.hasConflict()) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored({.95F, .65F, .15F, 1}, "Another program has changed this file.");
    ImGui::SameLine();
    if (ImGui::Button("Keep mine")) file.keepMine();
    mark(ui, "source/keepMine");
    ImGui::SameLine();
    if (ImGui::Button("Load theirs")) {
        file.takeDisk();
        ++view.generation;
    }
    mark(ui, "source/takeDisk");
}

void buttons(Ui& ui, EditedFile& file, CodeView& view) {
    ImGui::BeginDisabled(!file.isChanged());
    if (ImGui::Button("Save")) saveSource(ui);
    mark(ui, "source/save");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Save the file and update the picture (Ctrl+S)");
    ImGui::SameLine();
    if (ImGui::Button("Revert")) {
        file.revert();
        ++view.generation;
    }
    ImGui::EndDisabled();
    mark(ui, "source/revert");
    ImGui::SameLine();
    if (ImGui::Button("Open in editor"))
        ui.notice = openInEditor({file.path().string(), view.line, view.column});
    mark(ui, "source/editor");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Open the file at this line in your own editor, which the variable EDITOR names");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    if (file.whyReadOnly().empty())
        ImGui::TextDisabled("%d:%d%s", view.line, view.column, file.isChanged() ? "   not saved" : "");
    else
        ImGui::TextDisabled("Read only. %s", file.whyReadOnly().c_str());
}

/// The messages about the file, each with the core GLSL of its line.
void messages(Ui& ui, const std::vector<const Diagnostic*>& all, CodeView& view) {
    int index = 0;
    for (const Diagnostic* each : all) {
        const bool isError = each->severity == Severity::error;
        ImGui::PushID(index);
        ImGui::PushStyleColor(ImGuiCol_Text,
                              isError ? ImVec4(.95F, .35F, .30F, 1) : ImVec4(.90F, .65F, .15F, 1));
        const std::string text = fmt::format("{}:{}: {}", each->place.line, each->place.column, each->text);
        const ImVec2 at = ImGui::GetCursorPos();
        const ImVec2 size =
            ImGui::CalcTextSize(text.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x);
        if (ImGui::Selectable("##message", false, 0, {0, size.y})) view.goTo = each->place.line;
        mark(ui, "source/message/{}", index);
        ImGui::SetCursorPos(at);
        ImGui::TextWrapped("%s", text.c_str());
        ImGui::PopStyleColor();
        if (isError) translatedLines(ui, each->place);
        ImGui::PopID();
        ++index;
    }
}

void content(Ui& ui) {
    SourcePanel& panel = ui.source;
    EditedFile& file = edited(ui, panel.chosen);
    CodeView& view = panel.views[panel.chosen];
    buttons(ui, file, view);
    conflict(ui, file, view);
    findBar(ui, file, view);
    std::vector<const Diagnostic*> about;
    std::vector<CodeMark> marks;
    for (const Diagnostic& each : ui.session.diagnostics())
        if (each.severity != Severity::note && isSame(each.place.file, file.path())) {
            about.push_back(&each);
            marks.push_back({each.place.line, each.severity, each.text});
        }
    std::stable_sort(about.begin(), about.end(),
                     [](const Diagnostic* a, const Diagnostic* b) { return a->severity > b->severity; });
    std::stable_sort(marks.begin(), marks.end(), [](const CodeMark& a, const CodeMark& b) {
        return a.line != b.line ? a.line < b.line : a.severity > b.severity;
    });
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float below = about.empty() ? 0
                                      : std::min(ImGui::GetContentRegionAvail().y * .4F,
                                                 line * (2 * static_cast<float>(about.size()) + .5F));
    const CodeLanguage language =
        glib::sameWord(file.path().extension().string(), ".glib") ? CodeLanguage::glib : CodeLanguage::glsl;
    const FindBar& find = panel.find;
    const int cursorBefore = view.cursor;
    const bool isChanged =
        codeEditor(panel.chosen.string().c_str(), file.text(), view, {marks, find.found, find.shown},
                   language, !file.whyReadOnly().empty(), below);
    mark(ui, "source/text");
    if (isChanged)
        file.history().record(file.text());
    else if (view.cursor != cursorBefore)
        file.history().endStep();
    ui.sourceState = {panel.chosen.string(), view.line,        view.column,
                      view.isActive,         file.isChanged(), file.hasConflict()};
    if (about.empty()) return;
    ImGui::BeginChild("messages");
    ImGui::Separator();
    messages(ui, about, view);
    ImGui::EndChild();
}

}  // namespace

void translatedLines(Ui& ui, const Place& place) {
    const std::vector<glsl::EmittedLine> lines = ui.session.live().translatedLines(place);
    constexpr std::size_t kMostShown = 3;
    for (std::size_t i = 0; i < std::min(kMostShown, lines.size()); ++i) {
        ImGui::PushFont(codeFont());
        ImGui::TextDisabled("%6d > %s", lines[i].number,
                            excerpt(lines[i].text, 1, roomForCode()).text.c_str());
        ImGui::PopFont();
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip(
                "glibra translates shaders to core GLSL. This is what the driver got: line %d of the "
                "translated shader.",
                lines[i].number);
        if (ui.shownTranslation.empty()) ui.shownTranslation = lines[i].text;
    }
}

void saveSource(Ui& ui) {
    const auto found = ui.shared.sources.find(ui.source.chosen);
    if (found == ui.shared.sources.end() || !found->second.isChanged()) return;
    const std::string name = ui.source.chosen.filename().string();
    const Diagnostics problems = found->second.save();
    ui.notice = !problems.empty()             ? toString(problems.front())
                : found->second.hasConflict() ? name + " was not saved: another program has changed it"
                                              : name + " saved";
    if (problems.empty() && !found->second.hasConflict()) ui.requests.saved = ui.source.chosen;
}

void showSource(Ui& ui, const Place& place) {
    ui.settings.showSource = true;
    ui.source.goTo = place;
}

void sourcePanel(Ui& ui, Rectangle& free) {
    ui.sourceState = {};
    if (!ui.settings.showSource || !ui.session.hasScene()) return;
    refresh(ui);
    takeGoTo(ui);
    // Beside the picture if there is room for both, otherwise below it.
    const bool isBeside = free[2] >= 1100 * ui.scale;
    float& extent = isBeside ? ui.settings.sourceWidth : ui.settings.sourceHeight;
    const float room = isBeside ? free[2] : free[3];
    const float least = std::min(room * .5F, 220 * ui.scale);
    const float most = std::max(least, room * .75F);
    if (extent <= 0) extent = room * (isBeside ? .5F : .45F);
    extent = std::clamp(extent, least, most);
    const ImVec2 size = isBeside ? ImVec2(extent, free[3]) : ImVec2(free[2], extent);
    if (isBeside) {
        ImGui::SetNextWindowPos({free[0], free[1]});
        ImGui::SetNextWindowSizeConstraints({least, size.y}, {most, size.y});
    } else {
        ImGui::SetNextWindowPos({free[0], free[1] + free[3]}, ImGuiCond_Always, {0, 1});
        ImGui::SetNextWindowSizeConstraints({size.x, least}, {size.x, most});
    }
    // Two ImGui windows, since each position has its own size.
    const char* name = isBeside ? "Source" : "Source below";
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    if (ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        fileTabs(ui);
        content(ui);
        // Moving the keyboard focus to the text scrolls this window too.
        ImGui::SetScrollX(0);
        ImGui::SetScrollY(0);
    }
    extent = isBeside ? ImGui::GetWindowWidth() : ImGui::GetWindowHeight();
    ImGui::End();
    free[isBeside ? 2 : 3] -= extent;
    if (isBeside) free[0] += extent;
}

}  // namespace glibra::view

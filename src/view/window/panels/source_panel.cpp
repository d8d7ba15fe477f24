// The panel in which the scene and its shaders are edited.

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glib/text.h"
#include "view/session/comparison.h"
#include "view/window/panels/code_editor.h"
#include "view/window/panels/shortcuts.h"
#include "view/window/panels/source_header.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

EditedFile& edited(Ui& ui, const std::filesystem::path& path) {
    return ui.shared.sources.try_emplace(path, path).first->second;
}

/// Updates the list of files after the scene was loaded. Files with unsaved text stay in the list even if the
/// scene does not use them any more.
void refresh(Ui& ui, SourceState& panel) {
    if (panel.loaded != ui.session.timesLoaded()) {
        panel.loaded = ui.session.timesLoaded();
        std::vector<SourceFile> files = sourceFiles(ui.session.live());
        for (auto& [path, file] : ui.shared.sources)
            if (file.lookAtDisk() && !file.hasConflict()) ++panel.views[path].generation;
        for (const SourceFile& old : ui.files) {
            const EditedFile* kept = knownSource(ui, old.path);
            const bool isThere =
                std::ranges::any_of(files, [&](const SourceFile& each) { return each.path == old.path; });
            if (!isThere && kept && kept->isChanged())
                files.push_back({old.path, old.label,
                                 kept->isGone() ? "removed from the disk; Save writes it again"
                                                : "no longer used by the scene"});
        }
        ui.files = std::move(files);
    }
    const auto isChosen = [&](const SourceFile& each) { return each.path == panel.chosen; };
    if (std::ranges::none_of(ui.files, isChosen)) {
        panel.chosen = ui.files.front().path;  // the scene, which names the others
        panel.follow = true;
    }
}

/// Puts the cursor at a place, whose column counts bytes.
void goTo(Ui& ui, SourceState& panel, const std::filesystem::path& path, const Place& place) {
    const std::string& text = edited(ui, path).text();
    std::size_t at = 0;
    for (int line = 1; line < place.line; ++line) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos) break;
        at = end + 1;
    }
    const std::size_t end = std::min(text.find('\n', at), text.size());
    at = std::min(end, at + static_cast<std::size_t>(std::max(1, place.column)) - 1);
    panel.views[path].select = TextRange{at, at};
}

void takeGoTo(Ui& ui, SourceState& panel) {
    const auto place = std::exchange(panel.goTo, std::nullopt);
    if (!place) return;
    for (const SourceFile& each : ui.files)
        if (isSame(each.path, place->file)) {
            panel.chosen = each.path;
            panel.follow = true;
            goTo(ui, panel, each.path, *place);
            return;
        }
    ui.notice = {place->file + " is not a file of this scene", true};
}

void sourceContent(Ui& ui, SourceState& panel) {
    EditedFile& file = edited(ui, panel.chosen);
    CodeView& view = panel.views[panel.chosen];
    sourceButtons(ui, panel, file, view);
    conflict(ui, file, view);
    recovered(ui, file, view);
    findBar(ui, panel.find, file, view);
    std::vector<CodeMark> marks;
    for (const Diagnostic& each : ui.session.diagnostics())
        if (each.severity != Severity::note && isSame(each.place.file, file.path()))
            marks.push_back({each.place.line, each.place.column, each.severity, each.text});
    std::ranges::stable_sort(marks, [](const CodeMark& a, const CodeMark& b) {
        return a.line != b.line ? a.line < b.line : a.severity > b.severity;
    });
    const std::size_t messages = ui.session.diagnostics().size();
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float below = messages == 0 ? 0
                                      : std::min(ImGui::GetContentRegionAvail().y * .4F,
                                                 line * (static_cast<float>(messages) + 5));
    const CodeLanguage language = glib::sameWord(file.path().extension().generic_string(), ".glib")
                                      ? CodeLanguage::glib
                                      : CodeLanguage::glsl;
    const FindBar& find = panel.find;
    const int cursorBefore = view.cursor;
    assistKeys(panel.assist, file, view);
    const bool isChanged =
        codeEditor(panel.chosen.generic_string().c_str(), file.text(), view, {marks, find.found, find.shown},
                   language, !file.whyReadOnly().empty(), below, ui.settings.wrapsLines);
    markPlace(ui, "source/text");
    const unsigned stop = ImGui::GetID("text stop");  // the widget's own number is 0 at times
    if (tabStop(ui, stop)) view.select = view.selection;
    if (ui.sliders.focused == stop) ui.frame.focusedName = "source/text";
    ui.shared.textTakesTab = view.isActive && file.whyReadOnly().empty();
    if (isChanged && ui.notice.text == savedNotice(panel.chosen)) ui.notice = {};
    if (isChanged)
        file.history().record(file.text());
    else if (view.cursor != cursorBefore)
        file.history().endStep();
    panel.keepsKeyboard = panel.keepsKeyboard || view.isActive;
    panel.shown = {panel.chosen.generic_string(),
                   view.line,
                   view.column,
                   view.isActive,
                   file.isChanged(),
                   file.hasConflict()};
    assist(ui, panel.assist, file, view, isChanged);
    if (messages == 0) return;
    ImGui::BeginChild("messages");
    ImGui::Separator();
    messageList(ui, file.path());
    ImGui::EndChild();
}

/// Gives the session the texts that are not saved, if they are to be compiled while the user types. It does
/// so when the user pauses.
void compileWhileTyping(Ui& ui, SourceState& panel) {
    constexpr double kPause = .15;  // seconds
    std::map<std::filesystem::path, std::string> wanted;
    if (ui.settings.compilesWhileTyping)
        for (const SourceFile& each : ui.files)
            if (const EditedFile* known = knownSource(ui, each.path); known && known->isChanged())
                wanted.emplace(each.path, known->text());
    const auto& compiled = ui.session.texts();
    if (wanted == compiled) return;
    const auto isInEffect = [&](const std::filesystem::path& path, const std::string& text) {
        const EditedFile* known = knownSource(ui, path);
        return known && known->text() == text;
    };
    // Files that were saved have the compiled text already.
    const bool wereSaved =
        std::ranges::all_of(wanted,
                            [&](const auto& each) {
                                const auto same = compiled.find(each.first);
                                return same != compiled.end() && same->second == each.second;
                            }) &&
        std::ranges::all_of(compiled, [&](const auto& each) { return isInEffect(each.first, each.second); });
    if (wereSaved) return ui.session.setTexts(std::move(wanted));
    const double now = ImGui::GetTime();
    if (wanted != panel.typedTexts) {
        panel.typedTexts = std::move(wanted);
        panel.typedAt = now;
    }
    if (now - panel.typedAt < kPause) {
        ui.frame.isFollowed = true;
        return;
    }
    ui.session.setTexts(panel.typedTexts);
    ui.requests.reload = true;
    ui.frame.isFollowed = true;
}

/// A click on the picture or the panel ends typing. Tool windows may be clicked: Esc closes them.
void noticeClicks(SourceState& panel) {
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsMouseClicked(ImGuiMouseButton_Right))
        return;
    const ImGuiWindow* under = ImGui::GetCurrentContext()->HoveredWindow;
    const std::string_view owner = under ? under->RootWindow->Name : "";
    if (owner.empty() || owner == "Controls" || owner == "Scenes") panel.keepsKeyboard = false;
}

/// Gives the keyboard back to the text, if it had it before a window in front took it.
void returnToText(const Ui& ui, SourceState& panel) {
    if (!ui.settings.showSource || !panel.keepsKeyboard) return;
    CodeView& view = panel.views[panel.chosen];
    if (!view.isActive && !view.select) view.select = view.selection;
}

SourcePlace placeOf(const Ui& ui, const Rectangle& free) {
    if (ui.settings.sourcePlace != SourcePlace::automatic) return ui.settings.sourcePlace;
    constexpr float kRoomForBoth = 1100;
    return free[2] >= kRoomForBoth * ui.shared.scale ? SourcePlace::beside : SourcePlace::below;
}

void sourcePanel(Ui& ui, SourceState& panel, Rectangle& free) {
    panel.shown = {};
    ui.shared.textTakesTab = false;
    if (!ui.session.hasScene()) return;
    compileWhileTyping(ui, panel);
    noticeClicks(panel);
    if (!ui.settings.showSource) {
        panel.assist.isOpen = panel.keepsKeyboard = false;
        return;
    }
    refresh(ui, panel);
    takeGoTo(ui, panel);
    const SourcePlace place = placeOf(ui, free);
    const bool isAcross = place != SourcePlace::below;
    float& part = place == SourcePlace::beside  ? ui.settings.sourceBeside
                  : place == SourcePlace::below ? ui.settings.sourceBelow
                                                : ui.settings.sourceOver;
    const float room = isAcross ? free[2] : free[3];
    const float wanted = std::floor(room * part);
    const ImVec2 size = isAcross ? ImVec2(wanted, free[3]) : ImVec2(free[2], wanted);
    const float least = std::floor(room * kLeastSource), most = std::floor(room * kMostSource);
    if (isAcross) {
        ImGui::SetNextWindowPos({free[0], free[1]});
        ImGui::SetNextWindowSizeConstraints({least, size.y}, {most, size.y});
    } else {
        ImGui::SetNextWindowPos({free[0], free[1] + free[3]}, ImGuiCond_Always, {0, 1});
        ImGui::SetNextWindowSizeConstraints({size.x, least}, {size.x, most});
    }
    ImGui::SetNextWindowSize(size);
    // An ImGui window for each place.
    const char* name = place == SourcePlace::beside  ? "Source"
                       : place == SourcePlace::below ? "Source below"
                                                     : "Source over";
    if (place == SourcePlace::over) ImGui::SetNextWindowBgAlpha(kSourceOpacity);
    // Its border is dragged; a grip in the corner would be at the wrong end.
    constexpr std::array kGrips{ImGuiCol_ResizeGrip, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive};
    for (const ImGuiCol each : kGrips) ImGui::PushStyleColor(each, ImVec4(0, 0, 0, 0));
    if (ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse)) {
        markWindow(ui, "source");
        fileTabs(ui, panel);
        sourceContent(ui, panel);
        // Moving the keyboard focus to the text scrolls this window too.
        ImGui::SetScrollX(0);
        ImGui::SetScrollY(0);
    }
    const float extent = isAcross ? ImGui::GetWindowWidth() : ImGui::GetWindowHeight();
    ImGui::End();
    ImGui::PopStyleColor(static_cast<int>(kGrips.size()));
    // What the user has dragged; rounding changes nothing.
    if (std::abs(extent - wanted) > 1) part = std::clamp(extent / room, kLeastSource, kMostSource);
    if (place == SourcePlace::over) {
        ui.frame.covered = free[0] + extent;
        return;
    }
    free[isAcross ? 2 : 3] -= extent;
    if (isAcross) free[0] += extent;
}

class SourcePanel final : public Panel {
  public:
    void update(Ui& ui) override {
        if (ui.wanted.source) state_.goTo = ui.wanted.source;
        if (ui.wanted.keyboardForText) returnToText(ui, state_);
    }
    void show(Ui& ui) override {
        sourcePanel(ui, state_, ui.frame.room);
        referenceWindow(ui, state_.assist, chosen(ui));
    }
    bool close(Ui& ui, Closing what) override {
        return what == Closing::list ? closeAssist(state_.assist) : closeFind(state_.find, shown(ui));
    }
    void addTo(nlohmann::ordered_json& state, const Ui& ui) const override;

    // Shortcuts:
    void save(Ui& ui) { ImGui::GetIO().KeyShift ? saveSceneAs(ui) : saveSource(ui, state_.chosen); }
    void completeWord(Ui& ui) { state_.assist.isAsked = state_.assist.isAsked || active(ui).file; }
    void comment(Ui& ui) { commentLines(ui, active(ui)); }
    void indent(Ui& ui) { indentLines(state_.assist, active(ui), ImGui::GetIO().KeyShift); }
    void revert(Ui& ui) {
        if (const ShownText text = shown(ui); text.file) revertSource(*text.file, *text.view);
    }
    void openOutside(Ui& ui) {
        if (const ShownText text = shown(ui); text.file) openShown(ui, *text.file, *text.view);
    }
    void reference(Ui& ui) { showReference(ui, state_.assist, active(ui), chosen(ui)); }
    void find(Ui& ui) { search(ui, false); }
    void replace(Ui& ui) { search(ui, true); }
    void again(Ui& ui) { findAgain(state_.find, shown(ui), ImGui::GetIO().KeyShift); }
    void line(Ui& ui) { askLine(state_.find, shown(ui)); }
    void undo(Ui& ui) { undoTyping(active(ui), ImGui::GetIO().KeyShift); }
    void redo(Ui& ui) { undoTyping(active(ui), true); }

  private:
    EditedFile* chosen(Ui& ui) const { return knownSource(ui, state_.chosen); }
    ShownText shown(Ui& ui) {
        EditedFile* file = state_.shown.file.empty() ? nullptr : chosen(ui);
        return file ? ShownText{file, &state_.views[state_.chosen]} : ShownText{};
    }
    ShownText active(Ui& ui) { return state_.shown.isActive ? shown(ui) : ShownText{}; }
    void search(Ui& ui, bool replaces) {
        ui.settings.showSource = true;
        openFind(state_.find, shown(ui), replaces);
    }

    SourceState state_;
};

void SourcePanel::addTo(nlohmann::ordered_json& state, const Ui& ui) const {
    using Json = nlohmann::ordered_json;
    const ShownSource& source = state_.shown;
    const auto view = state_.views.find(state_.chosen);
    const CodeView::Corner cursor =
        view == state_.views.end() ? CodeView::Corner() : view->second.cursorOnScreen;
    state["source"] = {{"shown", !source.file.empty()},
                       {"file", source.file},
                       {"line", source.line},
                       {"column", source.column},
                       {"active", source.isActive},
                       {"changed", source.isChanged},
                       {"conflict", source.hasConflict},
                       {"translation", ui.frame.translation},
                       {"cursor", Json::array({cursor.x, cursor.top, cursor.bottom})},
                       {"live", ui.settings.compilesWhileTyping},
                       {"wraps", ui.settings.wrapsLines},
                       {"compiled", ui.session.texts().size()},
                       {"hover", ui.frame.hoverText}};
    state["sourcePlace"] = nameOfPlace(ui.settings.sourcePlace);
    const CodeAssist& assist = state_.assist;
    Json words = Json::array();
    if (assist.isOpen)
        for (std::size_t i = 0; i < std::min<std::size_t>(assist.words.size(), 20); ++i)
            words.push_back({{"word", assist.words[i].word}, {"type", assist.words[i].type}});
    state["completion"] = {{"open", assist.isOpen}, {"chosen", assist.chosen}, {"words", words}};
    Json arguments = Json::array();
    for (const SignatureParts& each : assist.hint.signatures)
        arguments.push_back({each.before + each.argument + each.after, each.argument});
    state["arguments"] = arguments;
    state["reference"] = {{"open", assist.showsReference},
                          {"word", assist.entry.word},
                          {"code", assist.entry.code},
                          {"text", assist.entry.text}};
    if (const FindBar& find = state_.find; find.isOpen)
        state["find"] = {{"words", find.words.data()},
                         {"replaces", find.replaces},
                         {"count", find.found.size()},
                         {"shown", find.shown}};
}

void switchSource(Ui& ui, Panel& /*panel*/) {
    ui.settings.showSource = !ui.settings.showSource;
}

/// With Shift the next place of the source.
void switchOrMoveSource(Ui& ui, Panel& panel) {
    if (!ImGui::GetIO().KeyShift || !ui.settings.showSource) return switchSource(ui, panel);
    constexpr int kPlaces = static_cast<int>(SourcePlace::over) + 1;
    ui.settings.sourcePlace =
        static_cast<SourcePlace>((static_cast<int>(ui.settings.sourcePlace) + 1) % kPlaces);
    ui.notice = std::string("the source stands ") + nameOfPlace(ui.settings.sourcePlace);
}

constexpr auto kSourceKeys = std::to_array<Shortcut>({
    {KeyGroup::source, GLFW_KEY_E, false, "E", "show the source: the scene and its shaders", switchSource},
    {KeyGroup::source, GLFW_KEY_E, true, "Ctrl+E, Ctrl+Shift+E",
     "show the source, also while editing text; source beside, below or over the picture", switchOrMoveSource,
     true},
    {KeyGroup::source, GLFW_KEY_S, true, "Ctrl+S, Ctrl+Shift+S",
     "save the shown source file; save the scene as another file", call<&SourcePanel::save>, true},
    {KeyGroup::source, GLFW_KEY_SPACE, true, "Ctrl+Space", "words that may stand at the cursor",
     call<&SourcePanel::completeWord>, true},
    {KeyGroup::source, GLFW_KEY_TAB, false, "Tab, Shift+Tab",
     "more blanks before the selected lines; fewer blanks before the selected lines",
     call<&SourcePanel::indent>, true},
    {KeyGroup::source, GLFW_KEY_SLASH, true, "Ctrl+/", "make the selected lines comments, or code again",
     call<&SourcePanel::comment>, true},
    {KeyGroup::source, GLFW_KEY_F1, false, "F1", "the reference: the word at the cursor",
     call<&SourcePanel::reference>, true},
    {KeyGroup::source, GLFW_KEY_F, true, "Ctrl+F", "find in the source", call<&SourcePanel::find>, true},
    {KeyGroup::source, GLFW_KEY_H, true, "Ctrl+H", "find and replace", call<&SourcePanel::replace>, true},
    {KeyGroup::source, GLFW_KEY_F3, false, "F3, Shift+F3", "next match, previous match",
     call<&SourcePanel::again>, true},
    {KeyGroup::source, GLFW_KEY_G, true, "Ctrl+G", "go to a line of the source", call<&SourcePanel::line>,
     true},
    // Without keys: for the list of commands.
    {KeyGroup::source, kNoKey, false, "", "save all files with text that is not saved",
     [](Ui& ui, Panel&) { saveAllSources(ui); }},
    {KeyGroup::source, kNoKey, false, "", "revert the shown file to the saved text",
     call<&SourcePanel::revert>},
    {KeyGroup::source, kNoKey, false, "", "open the shown file in your own editor",
     call<&SourcePanel::openOutside>},
    {KeyGroup::source, kNoKey, false, "", "live: update the picture while you type",
     [](Ui& ui, Panel&) { ui.settings.compilesWhileTyping = !ui.settings.compilesWhileTyping; }},
    {KeyGroup::source, kNoKey, false, "", "wrap long lines of the source, or scroll to their ends",
     [](Ui& ui, Panel&) { ui.settings.wrapsLines = !ui.settings.wrapsLines; }},
    // While the text has the keyboard; otherwise shortcuts.cpp undoes changes of values.
    {KeyGroup::source, GLFW_KEY_Z, true, "", "", call<&SourcePanel::undo>, true},
    {KeyGroup::source, GLFW_KEY_Y, true, "", "", call<&SourcePanel::redo>, true},
});

}  // namespace

const PanelRow kSourceRow{
    .name = "source", .place = PanelPlace::edge, .make = make<SourcePanel>, .keys = kSourceKeys};

}  // namespace glibra::view

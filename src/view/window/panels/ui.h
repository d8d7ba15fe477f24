#pragma once
// What every panel receives: the session of its tab, the settings, the sinks for requests, and the frame that
// is drawn now. Also what panels draw with.

#include <fmt/format.h>
#include <glibra/diagnostic.h>
#include <imgui.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "view/edit/message_fixes.h"
#include "view/edit/source_files.h"
#include "view/session/history.h"
#include "view/session/session.h"
#include "view/style/palette.h"
#include "view/window/panels/panel_table.h"
#include "view/window/panels/requests.h"
#include "view/window/panels/shared.h"
#include "view/window/panels/sliders.h"
#include "view/window/platform/display.h"
#include "view/window/platform/settings.h"

namespace glibra::view {

/// Left, top, width, height in screen coordinates.
using Rectangle = std::array<float, 4>;

/// The result of the last action, for the status line.
struct Notice {
    std::string text;
    bool isError = false;

    Notice() = default;
    Notice(std::string words, bool asError = false) : text(std::move(words)), isError(asError) {}
    Notice(const char* words) : text(words) {}
    Notice(const Diagnostic& each) : text(toString(each)), isError(each.severity == Severity::error) {}
};

/// The frame that is drawn now: what the user did since the last one, where things are, and what `--state`
/// reports about it.
struct Frame {
    std::vector<Display::KeyPress> pressed;
    std::vector<MousePoint> way;  ///< InputQueue::Frame::way; empty: straight to where the mouse is
    bool isDragging = false;      ///< the mouse drags the picture
    bool isFollowed = false;      ///< by another frame, because something changes by itself
    Rectangle room{};             ///< what the panels leave free
    Rectangle picture{};          ///< position of the picture in it
    float covered = 0;            ///< from here to the left the source stands over the room; 0: it does not
    std::map<std::string, Rectangle> widgets;  ///< by name
    std::string focusedName;                   ///< of the widget with the keyboard
    std::string hoverText;                     ///< about what is under the mouse
    std::string translation;                   ///< the first line of core GLSL shown for an error
};

struct Ui {
    Ui(gpu::Context& usedContext, Session& usedSession, Shared& usedShared)
        : context(usedContext), session(usedSession), shared(usedShared), settings(usedShared.settings) {}

    gpu::Context& context;
    Session& session;
    Shared& shared;  ///< by all tabs
    Settings& settings;
    Requests requests;
    Wanted wanted;
    Notice notice;
    Frame frame;
    Sliders sliders;
    History history;
    TransformMode mode = TransformMode::eye;  ///< what the mouse moves
    std::vector<SourceFile> files;            ///< the texts that the tab shows, once it has shown any
    std::vector<PanelUse> panels;
    std::set<std::string> labelled;  ///< the values that the user wants to see on the picture, by labelKey()
    /// What can be done about the messages of that loading, by their texts, as far as they were shown.
    struct Fixes {
        std::uint64_t loaded = 0;
        struct Known {
            std::vector<MessageFix> fixes;
            std::string searched;
        };
        std::map<std::string, Known> known;
        int opened = 0;  ///< the message of the list that shows all of its text and what can be done
    } fixes;
};

/// The tool window of that name, which must exist.
Panel& toolWindow(const Ui& ui, std::string_view name);

/// The last widget is one that Tab reaches (tab_stops.h). Stores its position under a name, for `--state`.
void mark(Ui& ui, std::string_view name);
/// Stores its position alone.
void markPlace(Ui& ui, std::string_view name);
void tabStop(Ui& ui);
/// The same for a field with its label beside it: stores the position of the field alone.
void markField(Ui& ui, std::string_view name, std::string_view label);
/// The same for the current ImGui window.
void markWindow(Ui& ui, std::string_view name);
/// The same as mark(); the name is only formatted if it is needed.
template <class... Arguments>
    requires(sizeof...(Arguments) > 0)
void mark(Ui& ui, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    tabStop(ui);
    if (ui.shared.marksWidgets) markPlace(ui, fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Those of ImGui, marked with that name. `help`: the tooltip; null: none.
bool button(Ui& ui, const char* label, std::string_view name, const char* help = nullptr);
bool smallButton(Ui& ui, const char* label, std::string_view name, const char* help = nullptr);
bool beginCombo(Ui& ui, const char* id, const char* shown, std::string_view name, ImGuiComboFlags flags = 0);
/// The same with an outline that is seen on the panel also when they are off. The two without a name leave
/// the mark to the caller.
bool checkBox(Ui& ui, const char* label, std::string_view name, bool& isOn, const char* help = nullptr);
bool checkBox(const char* label, bool* isOn);
bool radioButton(const char* label, bool isOn);
/// An entry of a list or menu, with the name for mark(). Returns true if it was clicked.
template <class... Arguments>
bool choice(Ui& ui, const char* words, bool isChosen, fmt::format_string<Arguments...> format,
            Arguments&&... arguments) {
    const bool isClicked = ImGui::Selectable(words, isChosen);
    mark(ui, format, std::forward<Arguments>(arguments)...);
    return isClicked;
}
/// Explains the last widget while the mouse is over it. Null: there is nothing to explain.
void tooltip(const char* text, ImGuiHoveredFlags flags = 0);
/// A tooltip whose lines are wrapped at that width. The caller has asked whether the mouse is over the
/// widget.
void wrappedTooltip(const char* text, float width);

/// The heading of a section. Returns true if the section is open; the settings remember that under its name,
/// which is also the name for mark(). The visible title may be followed by "###" and an id.
bool section(Ui& ui, const char* title, std::string_view name, bool isOpenAtFirst);
/// The same for a group inside a section.
bool group(Ui& ui, const char* title, std::string_view name);

/// Draws a label in a column that all fields of the panel share; the next field takes the rest of the row.
void fieldLabel(const char* label);

/// A word before the next field, in the same row.
void wordBefore(const char* word);
/// The next widget stands beside the last one if there is room for that width, otherwise below.
void besideIfRoom(float width);

/// Sets the initial position and size of the next window, which is never larger than the screen. The values
/// are screen coordinates at scale 1.
void placeFloating(const Ui& ui, float left, float top, float width, float height);
/// The text with two points in its middle, if it is wider than that.
std::string shortened(const std::string& text, float width);
/// Draws a line of text up to the screen coordinate `right`, where it ends with an ellipsis if it does not
/// fit.
void lineOfText(const char* text, const ImVec2& at, float right, ImU32 color);
/// ImGui::TextWrapped() in that colour.
void wrappedText(const Color& color, const char* text);
/// Text in the font of code.
void codeText(const std::string& text);
/// A square in the colour of these numbers, before the next item of the row; missing ones are 0.
void colorSquare(std::span<const double> numbers);
/// A ring around a pixel, which is seen on all colours.
void ring(const Ui& ui, ImDrawList& list, const ImVec2& middle, float radius);

/// Places the next window in the middle of the screen.
void centreNextWindow(ImGuiCond when);
/// Begins a dialog in the middle of the screen, as large as its content, that blocks all else. False: it is
/// not open; otherwise the caller ends it by ImGui::EndPopup().
bool beginModal(const char* title);

/// Puts text into a field of ImGui, as far as it has room.
template <std::size_t size>
void setField(std::array<char, size>& field, std::string_view text) {
    field[text.copy(field.data(), size - 1)] = 0;
}

/// The text of a file that a source panel has shown; null for other files.
EditedFile* knownSource(const Ui& ui, const std::filesystem::path& file);

/// Opens the source panel at that place.
void showSource(Ui& ui, const Place& place);
/// Opens the file dialog for a scene to open.
void openDialog(Ui& ui, bool inNewTab);
/// Opens the file dialog for something else. `folder`: where it begins; empty: the scene's folder.
void askForFile(Ui& ui, FileQuestion question, std::filesystem::path folder = {});

}  // namespace glibra::view

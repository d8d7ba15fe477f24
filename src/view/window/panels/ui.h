#pragma once
// What every panel receives: the session of its tab, the settings, the sinks for requests, and the frame that
// is drawn now. Also what panels draw with.

#include <fmt/format.h>
#include <glibra/diagnostic.h>
#include <imgui.h>

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "view/edit/message_fixes.h"
#include "view/edit/source_files.h"
#include "view/session/history.h"
#include "view/session/session.h"
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

/// The heading of a section. Returns true if the section is open; the settings remember that under its name,
/// which is also the name for mark(). The visible title may be followed by "###" and an id.
bool section(Ui& ui, const char* title, std::string_view name, bool isOpenAtFirst);
/// The same for a group inside a section.
bool group(Ui& ui, const char* title, std::string_view name);

/// Draws a label in a column that all fields of the panel share; the next field takes the rest of the row.
void fieldLabel(const char* label);

/// Those of ImGui, with an outline that is seen on the panel also when they are off.
bool checkBox(const char* label, bool* isOn);
bool radioButton(const char* label, bool isOn);

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
/// fit. Returns true if it fits.
bool lineOfText(const char* text, const ImVec2& at, float right);

/// Opens the source panel at that place.
void showSource(Ui& ui, const Place& place);
/// Opens the file dialog for a scene to open.
void openDialog(Ui& ui, bool inNewTab);

}  // namespace glibra::view

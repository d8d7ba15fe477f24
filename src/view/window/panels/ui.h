#pragma once
// The state that the panels of a tab share: the session, the entries of the panels, and the widgets'
// positions.

#include <fmt/format.h>
#include <glibra/diagnostic.h>
#include <imgui.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "view/debug_view/buffer_table.h"
#include "view/debug_view/texels.h"
#include "view/session/frame_cost.h"
#include "view/session/history.h"
#include "view/session/session.h"
#include "view/session/wheel.h"
#include "view/window/panels/compare_window.h"
#include "view/window/panels/hardcopy_panel.h"
#include "view/window/panels/label_overlay.h"
#include "view/window/panels/message_box.h"
#include "view/window/panels/probe_window.h"
#include "view/window/panels/shared.h"
#include "view/window/panels/source_panel.h"
#include "view/window/platform/display.h"
#include "view/window/platform/settings.h"

namespace glibra::view {

/// Left, top, width, height in screen coordinates.
using Rectangle = std::array<float, 4>;

/// What the panels request from the window's loop.
struct Requests {
    std::optional<std::filesystem::path> open;
    bool inNewTab = false;  ///< for `open`
    bool reload = false;
    bool close = false;  ///< the window
    std::optional<std::size_t> showTab, closeTab;
    std::optional<std::filesystem::path> saved;  ///< the file that the source panel has written
};

/// The entries of the section "Suite shot".
struct SuiteEntries {
    std::filesystem::path scene;  ///< the scene that the proposed entries are for
    std::array<char, 1024> file{};
    std::array<char, 256> name{};
    std::string message;  ///< the result of the last click
    bool failed = false;
};

/// What the source panel shows, for shortcuts and `--state`.
struct SourceState {
    std::string file;
    int line = 0, column = 0;
    bool isActive = false, isChanged = false, hasConflict = false;
};

/// The state of the window "Textures, targets, buffers".
struct Inspector {
    bool isOpen = false;
    /// "picture", "depth", the name of a texture or buffer, or "#2" for texture 2 of the scene, which has no
    /// name.
    std::string chosen = "picture";
    int level = 0, layer = 0;
    bool isPrevious = false;  ///< the other copy of an object with history
    bool wantsRange = false;  ///< the range of shown values follows from the next content
    bool fits = true;         ///< the zoom follows the size of the window, until the user chooses one
    float zoom = 1;
    TexelDisplay display;
    std::string readFor;  ///< what `content` or `rows` was read for
    std::optional<render::Content> content;
    std::string problem;  ///< why there is none
    std::optional<gpu::Texture> shown;
    TexelDisplay shownDisplay;
    std::string hovered;  ///< the texel under the mouse: "12, 40: 0.5 0.25 0 1"
    // Of a buffer:
    std::uint64_t firstRow = 0;
    BufferTable table;
    std::vector<std::string> head;               ///< the cells before the array
    std::vector<std::vector<std::string>> rows;  ///< the cells of the shown elements
};

/// The result of the last action, for the status line.
struct Notice {
    std::string text;
    bool isError = false;

    Notice() = default;
    Notice(std::string words, bool asError = false) : text(std::move(words)), isError(asError) {}
    Notice(const char* words) : text(words) {}
    Notice(const Diagnostic& each) : text(toString(each)), isError(each.severity == Severity::error) {}
};

/// A slider that the mouse drags.
struct SliderDrag {
    float mouse = 0;      ///< x where `position` was
    double position = 0;  ///< of the thumb, 0..1
    bool isFine = false;
};

struct Ui {
    Ui(gpu::Context& usedContext, Session& usedSession, Shared& usedShared)
        : context(usedContext), session(usedSession), shared(usedShared), settings(usedShared.settings) {}

    gpu::Context& context;
    Session& session;
    Shared& shared;
    Settings& settings;
    History history;
    SourcePanel source;
    SourceState sourceState;
    std::string shownTranslation;  ///< the first line of core GLSL shown for an error
    SuiteEntries suite;
    Requests requests;
    HardcopyEntries hardcopy;
    LabelOverlay labels;
    MessageBox messageBox;
    TransformMode mode = TransformMode::eye;
    float scale = 1;
    int lastErrors = 0;
    bool showsMessages = false;  ///< the section of messages is open
    bool needsFrames = false;    ///< something changes by itself in the next frames
    std::string banner;          ///< its text in this frame
    std::string hoverText;       ///< about the code under the mouse
    ProbeWindow probe;
    bool showPanel = true, showHelp = false, showLabels = false;
    Rectangle room{};               ///< what the panels leave free
    Rectangle picture{};            ///< position of the picture in it
    std::vector<unsigned> sliders;  ///< those drawn in this frame, for Tab; ImGui's numbers of widgets
    unsigned focusedSlider = 0;     ///< gets the keys; 0: none
    std::string focusedName;        ///< its name, for `--state`
    SliderDrag sliderDrag;
    double sliderMoves = 0;         ///< by keys of this frame, as a part of the scale
    std::optional<bool> sliderEnd;  ///< keys of this frame: to the minimum (false), to the maximum (true)
    bool sliderIsTyped = false, sliderWasClicked = false, revealsSlider = false;
    Wheel wheel;
    std::string typing;         ///< the slider that is a text field now: "uniform/Dots/uKd/0"
    bool typingBegins = false;  ///< the text field needs the keyboard focus
    double typed = 0;
    std::vector<double> valuesBeforeClick;
    int dragButton = -1;          ///< mouse button that drags the picture; -1: none
    float dragLength = 0;         ///< pixels so far
    std::vector<MousePoint> way;  ///< InputQueue::Frame::way; empty: straight to where the mouse is
    Inspector inspector;
    CompareWindow compare;
    std::string debugViewText;  ///< the debug view's numbers of the pixel under the mouse
    std::optional<FrameCost> cost;
    std::vector<Display::KeyPress> pressed;
    Notice notice;
    bool panelScrolls = false;                 ///< not all of the sections fit into the panel
    std::map<std::string, Rectangle> widgets;  ///< positions in this frame, by name
};

/// Stores the position of the last widget under a name, for `--state`; does nothing without that option.
void mark(Ui& ui, std::string_view name);
/// The same for a field with its label beside it: stores the position of the field alone.
void markField(Ui& ui, std::string_view name, std::string_view label);
/// The same as mark(); the name is only formatted if it is needed.
template <class... Arguments>
    requires(sizeof...(Arguments) > 0)
void mark(Ui& ui, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    if (ui.shared.marksWidgets) mark(ui, fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// The heading of a section. Returns true if the section is open; the settings remember that under its name,
/// which is also the name for mark(). The visible title may be followed by "###" and an id.
bool section(Ui& ui, const char* title, std::string_view name, bool isOpenAtFirst);
/// The same for a group inside a section.
bool group(Ui& ui, const char* title, std::string_view name);

// The sections of the panel, each drawn into the current ImGui window.
void scenePanel(Ui& ui);
void messagesPanel(Ui& ui);
/// The messages as a list; a click goes to the place. `file`: the shown one, whose name is left out.
void messageList(Ui& ui, const std::filesystem::path& file);
/// The first error and how many more there are, at the lower edge of the picture.
void errorBanner(Ui& ui);
void uniformsPanel(Ui& ui);
void viewPanel(Ui& ui);
void timePanel(Ui& ui);
void hardcopyPanel(Ui& ui);
/// Begins a hardcopy with the settings of that section, to the next name that is free.
void writeHardcopy(Ui& ui);
/// Writes the next frames of a running hardcopy, whether its section is open or not.
void continueHardcopy(Ui& ui);
void costPanel(Ui& ui);
void suitePanel(Ui& ui);
/// The choice of a debug view and its legend: a part of viewPanel().
void debugViewControls(Ui& ui);
/// Switches to the next debug view.
void nextDebugView(Ui& ui);
/// Shows the debug view's numbers of the pixel under the mouse.
void debugViewUnderMouse(Ui& ui);

// Floating windows and dialogs.
void inspectorWindow(Ui& ui);
void noiseWindow(Ui& ui);
/// The graph in the noise window, with points to drag.
void noiseGraph(Ui& ui, float width, float height);
void exampleWindow(Ui& ui);
void fileDialog(Ui& ui);
/// Asks the user before unsaved text or values would be lost.
void questionDialog(Ui& ui);
/// Shows the texts of MessageBox after the scene was loaded.
void messageBox(Ui& ui);
/// Asks for the file of a model or texture that the scene does not name.
void missingFileDialog(Ui& ui);
/// Lists what the scene does, if Shared::isVerbose.
void verboseWindow(Ui& ui);
/// The button "File" and its menu.
void fileMenu(Ui& ui);
/// Writes the values and the chosen files into the scene, or asks where to save a copy of an example.
void saveScene(Ui& ui);
/// Asks where to save the scene with its values, and opens the result in a tab.
void saveSceneAs(Ui& ui);

/// Sets the initial position and size of the next window, which is never larger than the screen. The values
/// are screen coordinates at scale 1.
void placeFloating(const Ui& ui, float left, float top, float width, float height);

// These draw into a part of `free`, and reduce `free` by that part.
void tabBar(Ui& ui, Rectangle& free);
void sourcePanel(Ui& ui, Rectangle& free);

/// Saves the file that the source panel shows.
void saveSource(Ui& ui);
/// Opens the source panel at that place.
void showSource(Ui& ui, const Place& place);

/// Handles the mouse over the picture.
void pictureInput(Ui& ui);
/// Draws labels and the 3D cursor over the picture.
void pictureOverlay(Ui& ui);
/// Draws the values over the picture, if they are wanted.
void labelOverlay(Ui& ui);
/// Handles the keyboard shortcuts.
void shortcuts(Ui& ui);
void helpWindow(Ui& ui);
/// The keys that the scene declares, as buttons.
void keysPanel(Ui& ui);

/// The width of the panel with the sections, in screen coordinates.
float panelWidth(const Ui& ui);
/// Draws a line of text up to the screen coordinate `right`, where it ends with an ellipsis if it does not
/// fit. Returns true if it fits.
bool lineOfText(const char* text, const ImVec2& at, float right);

/// Width / height of the picture, as the scene's window or the command line says.
double shapeOf(const Ui& ui);

/// Draws all panels and windows of one frame.
void showAll(Ui& ui);

}  // namespace glibra::view

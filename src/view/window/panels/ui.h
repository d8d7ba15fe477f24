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
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "render/live/knobs.h"
#include "view/edit/edited_file.h"
#include "view/edit/message_fixes.h"
#include "view/edit/recovery.h"
#include "view/edit/saved_scene.h"
#include "view/edit/source_files.h"
#include "view/session/history.h"
#include "view/session/session.h"
#include "view/style/palette.h"
#include "view/window/panels/panel.h"
#include "view/window/platform/display.h"
#include "view/window/platform/settings.h"

namespace glibra::view {

// What panels request: from the window's loop, and from other panels.

struct Ui;

/// What the panels request from the window's loop, which takes it after the frame.
struct Requests {
    std::optional<std::filesystem::path> open;
    bool inNewTab = false;  ///< for `open`
    bool reload = false;
    bool close = false;       ///< the window
    bool frames = false;      ///< further frames: something moves that the session does not know of
    bool fullScreen = false;  ///< on or off
    bool lecture = false;     ///< on or off
    bool reopenTab = false;   ///< that was closed last
    std::optional<std::size_t> showTab, closeTab;
    std::optional<std::filesystem::path> saved;  ///< the file that the source panel has written
};

/// What the file dialog asks for in place of a scene to open.
struct FileQuestion {
    enum class Kind { open, save, folder };
    Kind kind = Kind::open;
    std::string title{};
    std::string button{};   ///< the button that ends the dialog: "Save"
    std::string hint{};     ///< a sentence above the list; may be empty
    std::string endings{};  ///< of the files that are listed, ".png .bmp"; empty: all files
    std::string entry{};    ///< the proposed name
    /// Gets the chosen path. A file that is saved may exist only if the user has agreed to replace it.
    /// Returns the problem, with which the dialog stays open; empty on success.
    std::function<std::string(Ui&, const std::filesystem::path&)> chosen{};
};

/// The file dialog is to open.
struct FileRequest {
    std::optional<FileQuestion> question;  ///< nothing: a scene to open
    bool inNewTab = false;                 ///< the chosen scene gets its own tab
    std::filesystem::path folder;          ///< where to begin; empty: the scene's folder
};

/// What panels want from each other. Panel::update() of the next frame takes what it can do; the rest is
/// dropped. For the loop of the window it counts as an event.
struct Wanted {
    std::optional<FileRequest> file;
    std::optional<Place> source;           ///< the source panel opens there
    std::optional<std::string> inspected;  ///< the inspector opens with the texture of that key (textureKey)
    std::optional<std::pair<int, int>> probed;      ///< this pixel of the picture: right, down
    std::optional<std::filesystem::path> compared;  ///< this scene is shown beside that of the tab
    bool hardcopy = false;                          ///< written at once, to the next free name
    bool keyboardForText = false;                   ///< the text gets the keyboard back if it had it

    [[nodiscard]] bool any() const {
        return file || source || inspected || probed || compared || hardcopy || keyboardForText;
    }
};

// The state that the sliders of a tab share (value_fields.h): which one has the keyboard, and what is typed.
// The other widgets that Tab reaches (shortcuts.h) are in the same list.

/// A slider that the mouse drags.
struct SliderDrag {
    float mouse = 0;      ///< x where `position` was
    double position = 0;  ///< of the thumb, 0..1
    bool isFine = false;
};

/// A widget that Tab reaches.
struct TabStop {
    unsigned id = 0;          ///< ImGui's number
    unsigned window = 0;      ///< of the window that it belongs to, ImGui's number
    bool isValue = false;     ///< a slider, which takes the keys itself
    bool isEntry = false;     ///< a text field, which gets the keyboard at once
    bool isInValues = false;  ///< one of the values of the scene
};

struct Sliders {
    std::vector<TabStop> drawn;  ///< in this frame, in the order of Tab
    unsigned focused = 0;        ///< gets the keys; 0: none
    unsigned activated =
        0;  ///< by Enter or the space bar in this frame, for stops that are no widgets of ImGui
    SliderDrag drag;
    double moves = 0;         ///< by keys of this frame, as a part of the scale
    std::optional<bool> end;  ///< keys of this frame: to the minimum (false), to the maximum (true)
    bool isTyped = false, wasClicked = false, reveals = false;
    /// The space bar, for the stop that has the keyboard. ImGui does not see a key that goes up again within
    /// a frame.
    bool isSpacePressed = false;
    bool wantsMenu = false;        ///< the menu of the focused value, by its key
    std::string typing;            ///< the slider that is a text field now: "uniform/Dots/uKd/0"
    bool typingBegins = false;     ///< the text field needs the keyboard focus
    std::array<char, 64> typed{};  ///< an expression
    std::string typedBefore;       ///< as the field began
    unsigned typedField = 0;       ///< another field of a number that is typed into (value_fields.h); 0: none
    double valueBefore = 0;        ///< of that field
    std::vector<double> valuesBeforeClick;
};

// The state that all tabs of the window share.

/// A tab in the tab bar.
struct TabTitle {
    std::string label;
    std::filesystem::path path;
    int id = 0;  ///< does not change when other tabs are closed
    bool isUnsaved = false, hasError = false;
};

/// The changed values of a scene, as they would be saved.
struct UnsavedValues {
    std::filesystem::path scene;
    std::vector<render::Knob> knobs;
    std::vector<ChosenFile> files;
};

/// An action of the user that would lose unsaved text or values: it needs confirmation.
struct Question {
    enum class About { openScene, closeTab, quit };
    About about = About::quit;
    std::filesystem::path scene;               ///< to open
    std::size_t tab = 0;                       ///< to close
    std::vector<std::filesystem::path> files;  ///< the files with unsaved text
    std::vector<UnsavedValues> values;         ///< the scenes whose changed values would be lost
    std::string problem;                       ///< why they could not be saved
};

/// The user's answer to a question.
struct Answer {
    Question question;
    bool isConfirmed = false;
    bool inNewTab = false;  ///< the scene to open gets its own tab, so that nothing is lost
};

struct Shared {
    Settings settings;
    std::filesystem::path keptValues;  ///< the folder of ValueKeeper; empty: values are not kept
    float scale = 1;                   ///< of texts and widgets
    bool showPanel = true, showLabels = false;
    std::optional<int>
        samples;  ///< per pixel on the screen, instead of the setting, as the command line says
    /// Of pictures in pixels, instead of the scene's size, as the command line says: width and height.
    std::optional<std::pair<int, int>> size;
    std::map<std::filesystem::path, EditedFile> sources;       ///< the files that source panels have shown
    SafetyCopies copies{stateFolder()};                        ///< of those that are not saved
    std::map<std::filesystem::path, RecoveredText> recovered;  ///< offered, until the user has decided
    std::vector<TabTitle> tabs;
    std::size_t shownTab = 0;
    bool marksWidgets = false;  ///< positions of widgets are stored, for `--state`
    bool textTakesTab = false;  ///< a source has the keyboard: Tab is a letter
    bool tabChanged = false;    ///< the tab bar has to select the shown tab
    std::optional<Question> question;
    std::optional<Answer> answer;
};

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
    SceneValues& values = session.values();
    Look& look = session.look();
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

/// The last widget is one that Tab reaches (shortcuts.h). Stores its position under a name, for `--state`.
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

// What panels do for each other.

/// The messages about the scene as a list; a click goes to the place. `file`: the shown one, whose name is
/// left out.
void messageList(Ui& ui, const std::filesystem::path& file);
/// Opens the source panel at that place.
void showSource(Ui& ui, const Place& place);
/// Opens the file dialog for a scene to open.
void openDialog(Ui& ui, bool inNewTab);
/// Opens the file dialog for something else. `folder`: where it begins; empty: the scene's folder.
void askForFile(Ui& ui, FileQuestion question, std::filesystem::path folder = {});
/// Writes the values and the chosen files into the scene, or asks where to save a copy of an example.
void saveScene(Ui& ui);
/// Asks where to save the scene with its values, and opens the result in a tab.
void saveSceneAs(Ui& ui);
/// Where users keep their own scenes: beside this one, unless it is an example; else beside a recent one
/// whose folder is there.
std::filesystem::path ownFolder(const Ui& ui);
/// Asks where a new scene is to be written, and makes it.
void askEmptyScene(Ui& ui);

/// How Ui::labelled names a value.
std::string labelKey(const render::Knob& knob);
/// A menu of which values are labelled on the picture.
void labelChoice(Ui& ui, const char* id, const char* name, float width);

// Icons, drawn as lines and shapes in the colour of the text, and buttons with them.

enum class Icon {
    open,      ///< a folder
    examples,  ///< a grid of pictures
    source,    ///< < / >
    reload,    ///< a circle with an arrow
    help,      ///< ?
    play,
    pause,
    back,     ///< one frame back
    forward,  ///< one frame forward
    restart,  ///< to the begin
    step,     ///< one step forward
    undo      ///< back to the value of the scene
};

/// A square button as high as a field. The tooltip is shown while the mouse is over it. With `isOn` the icon
/// has the accent's colour.
bool iconButton(Icon icon, const char* id, const char* tooltip, bool isOn = false);
/// A button with an icon and a word; with `isShort` only the icon.
bool toolButton(Icon icon, const char* word, const char* tooltip, bool isShort);
/// How many of toolButton()s with these words must be short, from the first one on, so that all of them fit
/// side by side into that width.
std::size_t shortTools(std::span<const char* const> words, float width);

/// Continues the row if an item of that width fits into it; otherwise the next item begins a new row.
void continueRow(float width);
/// The same for a button, a check box or a radio button with that label.
void continueRowForButton(const char* label);
void continueRowForCheck(const char* label);
/// The same for iconButton().
void continueRowForIcon();
/// The same for toolButton().
void continueRowForTool(const char* word, bool isShort);

// Where the panels stand, and the order in which a frame draws them.

/// The width of the panel with the sections, in screen coordinates.
float panelWidth(const Ui& ui);
/// Width / height of the picture, as the scene's window or the command line says; 0 without a scene.
double shapeOf(const Ui& ui);

/// Draws all panels and windows of one frame.
void showAll(Ui& ui);
/// Draws what panels have to draw over the picture, after the scene was drawn.
void drawOverPicture(Ui& ui);

}  // namespace glibra::view

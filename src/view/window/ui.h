#pragma once
// What the panels share: the session, what is being done to it, and where each widget stands.

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/context.h"
#include "view/export/hardcopy_job.h"
#include "view/lens/texel_view.h"
#include "view/scene/frame_cost.h"
#include "view/scene/history.h"
#include "view/scene/session.h"
#include "view/window/display.h"
#include "view/window/panels/source_panel.h"
#include "view/window/settings.h"
#include "view/window/shared.h"

namespace glibra::view {

/// Left, top, width, height in screen coordinates.
using Rectangle = std::array<float, 4>;

/// What the panels ask of the loop.
struct Requests {
    std::optional<std::filesystem::path> open;
    bool inNewTab = false;  ///< for `open`
    bool reload = false;
    bool close = false;  ///< the window
    std::optional<std::size_t> showTab, closeTab;
    std::optional<std::filesystem::path> saved;  ///< a source that the source panel has written
};

/// The entries of the section that adds a shot to a suite.
struct SuiteEntries {
    std::filesystem::path scene;  ///< that they were proposed for
    std::array<char, 1024> file{};
    std::array<char, 256> name{};
    std::string message;  ///< how the last one went
    bool failed = false;
};

/// What the source panel shows, for tests and scripts.
struct SourceState {
    std::string file;
    int line = 0, column = 0;
    bool isActive = false, isChanged = false, hasConflict = false;
};

/// The hardcopy section's entries.
struct HardcopyEntries {
    std::array<char, 1024> file{};
    int width = 0, height = 0;  ///< 0: as on the screen
    int frames = 1;
    float framesPerSecond = 30;
    std::optional<HardcopyJob> job;  ///< that is under way
    std::string message;             ///< how the last one went
    bool failed = false;
};

/// The window that looks into textures and targets.
struct Inspector {
    bool isOpen = false;
    int chosen = -1;  ///< index of a texture of the scene; -1 the picture's colour, -2 its depth
    int slice = 0;
    float zoom = 1;
    Showing showing;
    std::uint64_t frame = 0;  ///< of the session, that `image` was read after
    int readChosen = -3, readSlice = -1;
    std::string readScene;
    TexelImage image;
    std::optional<gpu::Texture> shown;
    std::string hovered;  ///< what is under the mouse: "12, 40: 0.5 0.25 0 1"
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
    std::string shownTranslation;  ///< the first line of core GLSL under an error
    SuiteEntries suite;
    Requests requests;
    HardcopyEntries hardcopy;
    TransformMode mode = TransformMode::eye;
    float scale = 1;
    int lastErrors = 0;
    bool showPanel = true, showHelp = false, showLabels = false;
    Rectangle picture{};        ///< where the picture stands
    std::string typing;         ///< the widget that is an entry field now: "uniform/Dots/uKd/0"
    bool typingBegins = false;  ///< it has to get the keyboard
    double typed = 0;
    std::vector<double> valuesBeforeClick;
    int dragButton = -1;   ///< mouse button that drags the picture
    float dragLength = 0;  ///< pixels so far
    Inspector inspector;
    std::string lensWords;  ///< of the pixel under the mouse
    std::optional<FrameCost> cost;
    std::vector<Display::KeyPress> pressed;
    std::string notice;                        ///< what the last action did, for the status line
    std::map<std::string, Rectangle> widgets;  ///< of this frame, by name
};

/// Remembers where the widget made last stands, under a name for tests and scripts, if somebody asks for it.
void mark(Ui& ui, std::string_view name);
/// The same of a field with its label beside it: where the field alone stands.
void markField(Ui& ui, std::string_view name, std::string_view label);
/// The same; the name is only put together when it is wanted.
template <class... Arguments>
requires(sizeof...(Arguments) > 0) void mark(Ui& ui, fmt::format_string<Arguments...> format,
                                             Arguments&&... arguments) {
    if (ui.shared.marksWidgets) mark(ui, fmt::format(format, std::forward<Arguments>(arguments)...));
}

// The panels, each drawn into the current ImGui window.
void scenePanel(Ui& ui);
void messagesPanel(Ui& ui);
void uniformsPanel(Ui& ui);
void viewPanel(Ui& ui);
void timePanel(Ui& ui);
void hardcopyPanel(Ui& ui);
/// The next frames of a hardcopy that is under way, whether its panel is open or not.
void continueHardcopy(Ui& ui);
void costPanel(Ui& ui);
void suitePanel(Ui& ui);
void inspectorWindow(Ui& ui);
void noiseWindow(Ui& ui);
void noiseGraph(Ui& ui, float width, float height);
/// The choice of a lens, a part of the view panel; the next one; what it says of the pixel under the mouse.
void lensControls(Ui& ui);
void nextLens(Ui& ui);
void lensUnderMouse(Ui& ui);
void exampleWindow(Ui& ui);
void fileDialog(Ui& ui);
/// Asks before text that is not saved would be lost.
void questionDialog(Ui& ui);

/// The next window floats: at first there and of that size, and never larger than the screen. In screen
/// coordinates at a scale of 1.
void placeFloating(const Ui& ui, float left, float top, float width, float height);

// These take their part of what is left of the window.
void tabBar(Ui& ui, Rectangle& free);
void sourcePanel(Ui& ui, Rectangle& free);

/// Writes the file that the source panel shows.
void saveSource(Ui& ui);
/// Opens the source panel there.
void showSource(Ui& ui, const Place& place);
/// What became of that line in a shader that the driver refused, drawn below a message.
void translatedLines(Ui& ui, const Place& place);

/// The mouse over the picture, and what is drawn over it.
void pictureInput(Ui& ui);
void pictureOverlay(Ui& ui);
/// Keys that work wherever the mouse is, while no text is being entered.
void shortcuts(Ui& ui);
void helpWindow(Ui& ui);

/// Everything of one frame.
void showAll(Ui& ui);

}  // namespace glibra::view

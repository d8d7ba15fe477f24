#pragma once
// The window program: tabs with a session each, their panels, and a loop that waits for events, carries out
// what the panels request, and only draws what has changed.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/device_lost.h"
#include "gpu/context/context.h"
#include "view/scene/file_watch.h"
#include "view/session/frame_cost.h"
#include "view/session/history.h"
#include "view/session/session.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/display.h"
#include "view/window/platform/input.h"
#include "view/window/platform/theme.h"

namespace glibra::view {

// The open scenes, each with its own values, view, time and undo. One of them is shown; the others are
// paused.

struct Tab {
    Tab(gpu::Context& context, const RenderOptions& options, Shared& shared, const PanelSet& sharedPanels,
        int number)
        : session(context, options),
          ui(context, session, shared),
          panels(makePanels(false)),
          values(shared.keptValues),
          id(number) {
        ui.panels = panelsOf(sharedPanels, panels);
    }

    Session session;
    Ui ui;
    PanelSet panels;     ///< its own ones
    ValueKeeper values;  ///< of the session
    int id = 0;
    bool isOutdated = false;  ///< its files have changed while it was not shown
};

class Tabs {
  public:
    /// Begins with one empty tab. `context` and `shared` must outlive this.
    Tabs(gpu::Context& context, RenderOptions options, Shared& shared);

    Tab& shown() { return *tabs_[shown_]; }
    [[nodiscard]] const Tab& shown() const { return *tabs_[shown_]; }
    Tab& at(std::size_t tab) { return *tabs_[tab]; }
    [[nodiscard]] const Tab& at(std::size_t tab) const { return *tabs_[tab]; }
    [[nodiscard]] std::size_t count() const { return tabs_.size(); }
    [[nodiscard]] std::size_t shownIndex() const { return shown_; }

    /// The index of the tab with that scene; count() if there is none.
    [[nodiscard]] std::size_t find(const std::filesystem::path& scene) const;
    /// Adds an empty tab and shows it.
    void add();
    void show(std::size_t tab);
    /// Moves a tab to another place among them; what is shown stays so.
    void move(std::size_t from, std::size_t to);
    /// Closes a tab; the only tab is replaced by an empty one.
    void close(std::size_t tab);

    /// Destroys all that the tabs have on the device, and makes it again on another one (Session).
    void releaseDevice();
    void restoreDevice();

    /// The files with unsaved text that only this tab shows.
    [[nodiscard]] std::vector<std::filesystem::path> unsaved(std::size_t tab) const;
    /// The files with unsaved text of all tabs.
    [[nodiscard]] std::vector<std::filesystem::path> unsaved() const;

    /// Writes the values of all scenes that have changed; `now`: at once. Returns the seconds until the next
    /// call is due; negative: there is nothing to write.
    double keepValues(bool now);

    /// Watches all files of all scenes, and the copies of texts that are not saved.
    void watch(FileWatch& watch) const;
    /// Marks the tabs that use one of these changed files as outdated.
    void markOutdated(const std::vector<std::filesystem::path>& files);
    /// Updates the titles for the tab bar.
    void updateTitles();

  private:
    [[nodiscard]] bool uses(const Tab& tab, const std::filesystem::path& file) const;

    gpu::Context& context_;
    RenderOptions options_;
    Shared& shared_;
    PanelSet sharedPanels_ = makePanels(true);
    int nextId_ = 0;
    std::vector<std::unique_ptr<Tab>> tabs_;
    std::size_t shown_ = 0;
};

struct WindowArguments {
    std::vector<std::filesystem::path> scenes;  ///< one tab per scene
    std::vector<std::string> set;               ///< "NAME=VALUE", for the first scene
    RenderOptions options;                      ///< width and height are those of the picture
    bool paused = false;
    std::optional<int> samples;       ///< per pixel on the screen; without, as the settings say
    std::filesystem::path stateFile;  ///< JSON, written whenever the state has changed
    std::filesystem::path recordFile, replayFile;
};

/// Runs until the window is closed. Returns the errors if it cannot be opened, and those of `set`.
Diagnostics runWindow(const WindowArguments& arguments);

// The state of the window as JSON text, for programs that watch or test it (`--state`).

/// What the loop of the window measures.
struct LoopState {
    std::pair<int, int> windowSize;  ///< screen coordinates
    std::uint64_t framesPresented = 0, reloads = 0;
    double loadMilliseconds = 0;           ///< of the last reload
    double firstDrawMilliseconds = 0;      ///< of the first frame after it
    double editToPictureMilliseconds = 0;  ///< from saving a file to the picture on the screen
    double refreshRate = 0;                ///< Hz
    bool hasSwapControl = false;
    bool isWaiting = false;  ///< for events, with nothing to draw
};

/// The session, the loop, the panels and the widgets of the shown tab: one JSON object.
std::string windowJson(const Ui& ui, const LoopState& loop);

/// ImGui needs the frame of an event and some more for its consequences.
inline constexpr int kFramesAfterEvent = 3;
inline constexpr double kMilliseconds = 1000;  ///< per second

using RealClock = std::chrono::steady_clock;
inline double secondsSince(RealClock::time_point start) {
    return std::chrono::duration<double>(RealClock::now() - start).count();
}

/// True for a tab with a panel of which that is true.
inline bool isAny(const Ui& ui, bool (Panel::*is)() const) {
    return std::ranges::any_of(ui.panels, [&](const PanelUse& each) { return (each.panel->*is)(); });
}

/// A tab that was closed, as it was.
struct ClosedTab {
    std::filesystem::path scene;
    std::size_t index = 0;
    std::vector<render::Knob> knobs;  ///< that were changed
    ViewState view;
    Clock::State clock;
    std::string camera;
};

class Window {
  public:
    Window(const WindowArguments& arguments, Display& display, gpu::Context& context);
    Diagnostics run();

  private:
    Ui& ui() { return tabs_.shown().ui; }
    Session& session() { return tabs_.shown().session; }
    void openInitialScenes();
    void setSize();
    void openScene(const std::filesystem::path& path, bool inNewTab);
    void showScene(const std::filesystem::path& path);
    void closeTab(std::size_t tab);
    void closeNow(std::size_t tab);
    void reopenTab();
    void restoreTabs();
    void keepTabs();
    bool ask(std::optional<Question> question);
    void updateForShownScene();
    void reloadIfNeeded();
    void handleDropped();
    void handleRequests();
    void handleAnswer();
    void quit();
    bool hasWork();
    void waitForWork();
    void takeReplayed(FrameInput& input);
    int samplesOfFrame();
    bool isPassedOver();
    void drawFrame();
    void paint();
    void present();
    void showLoading(const std::filesystem::path& scene);
    void writeState();
    void saveSettings();
    void setLecture(bool on);
    void followScale();
    Diagnostics recover(const base::DeviceLost& lost);

    const WindowArguments& arguments_;
    Display& display_;
    gpu::Context& context_;
    Shared shared_;
    Tabs tabs_;
    std::optional<Gui> gui_;
    FileWatch watch_;
    std::optional<InputRecord> record_;
    InputReplay replay_;
    std::vector<std::string> dropped_;
    InputQueue input_;
    int framesWanted_ = kFramesAfterEvent;
    LoopState loop_;
    bool lightTheme_ = false;
    RealClock::time_point lastFrame_ = RealClock::now();
    FramePacer pacer_;
    std::optional<RealClock::time_point> changeSaved_;
    bool isReloaded_ = false;  ///< the shown scene, since the last frame
    const bool isSoftware_;    ///< the processor draws
    bool quits_ = false;       ///< the user has agreed to what is lost
    std::string writtenState_;
    std::size_t drawn_ = 0;  ///< the tab that draws now
    Diagnostics setProblems_;
    /// What a lecture changes, as it was before.
    struct BeforeLecture {
        bool isFullScreen = false, showPanel = true, showSource = false;
        SourcePlace place = SourcePlace::automatic;
        float zoom = 1;
    };
    std::optional<BeforeLecture> beforeLecture_;
    std::vector<ClosedTab> closed_;         ///< the last one last
    bool isStarted_ = false;                ///< the first scenes are open
    std::vector<std::string> earlierTabs_;  ///< of the last window, that this one does not show
    std::uint64_t watchedCopies_ = 0;       ///< SafetyCopies::timesChanged() of what is watched
    double valuesDue_ = -1;                 ///< seconds until values are to be written; negative: none are
};

}  // namespace glibra::view

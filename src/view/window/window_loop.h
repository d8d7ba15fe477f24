#pragma once
// The loop of the window: it waits for events, carries out what the panels request, and draws frames.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/device_lost.h"
#include "gpu/context/context.h"
#include "view/scene/file_watch.h"
#include "view/session/frame_cost.h"
#include "view/window/input_replay.h"
#include "view/window/platform/display.h"
#include "view/window/platform/gui.h"
#include "view/window/platform/input_queue.h"
#include "view/window/tabs.h"
#include "view/window/window_json.h"

namespace glibra::view {

struct WindowArguments;

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
    Clock clock;
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

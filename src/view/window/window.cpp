#include "view/window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>

#include "base/device_lost.h"
#include "gpu/context/context.h"
#include "gpu/context/reset.h"
#include "image/file.h"
#include "view/browse/example_scenes.h"
#include "view/edit/save_values.h"
#include "view/scene/file_watch.h"
#include "view/session/frame_pacer.h"

#include "view/window/dropped.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/display.h"
#include "view/window/platform/gui.h"
#include "view/window/platform/input_queue.h"
#include "view/window/platform/input_script.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"
#include "view/window/tabs.h"
#include "view/window/window_json.h"

namespace glibra::view {
namespace {

using RealClock = std::chrono::steady_clock;

/// ImGui needs the frame of an event and some more for its consequences.
constexpr int kFramesAfterEvent = 3;
constexpr double kMilliseconds = 1000;  ///< per second
constexpr double kLongestStep = .25;    ///< seconds by which one frame may advance the scene's time
constexpr double kReplayedSeconds = 1. / 60;

double secondsSince(RealClock::time_point start) {
    return std::chrono::duration<double>(RealClock::now() - start).count();
}

double now() {
    return std::chrono::duration<double>(RealClock::now().time_since_epoch()).count();
}

std::vector<UnsavedValues> unsavedValues(const Session& session) {
    if (!session.hasScene() || !hasChangedValues(session.knobs())) return {};
    return {{session.path(), session.knobs(), session.chosenFiles()}};
}

/// The same without those of an example, which cannot be saved into it.
std::vector<UnsavedValues> ownUnsavedValues(const Session& session) {
    return isExample(session.path()) ? std::vector<UnsavedValues>() : unsavedValues(session);
}

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
    void updateForShownScene();
    void reloadIfNeeded();
    void handleDropped();
    void handleRequests();
    void handleAnswer();
    void quit();
    bool hasWork();
    void waitForWork();
    bool nextInput(FrameInput& input);
    void record(FrameInput frame);
    int samplesOfFrame();
    bool isPassedOver();
    void drawFrame();
    void present();
    void writeState();
    void saveSettings();
    void followScale();
    Diagnostics recover(const base::DeviceLost& lost);

    const WindowArguments& arguments_;
    Display& display_;
    gpu::Context& context_;
    Shared shared_;
    Tabs tabs_;
    std::optional<Gui> gui_;
    FileWatch watch_;
    std::optional<InputRecorder> recorder_;
    std::vector<FrameInput> replay_;
    std::size_t replayed_ = 0;
    std::vector<int> replayedKeys_;
    std::vector<std::string> dropped_, recordedDrops_;
    std::pair<int, int> recordedSize_;
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
    float scale_ = 1;
    Diagnostics setProblems_;
};

Window::Window(const WindowArguments& arguments, Display& display, gpu::Context& context)
    : arguments_(arguments),
      display_(display),
      context_(context),
      tabs_(context, arguments.options, shared_),
      watch_([] { Display::wake(); }),
      pacer_(display.refreshRate(), Display::hasSwapControl()),
      isSoftware_(context.capabilities().isSoftware) {
    shared_.settings = readSettings(settingsFile());
    lightTheme_ = shared_.settings.lightTheme;
    scale_ = scaleOf(display, shared_.settings);
    tabs_.setScale(scale_);
    shared_.settings.scaleSizes(scale_);
    gui_.emplace(display, scale_, shared_.settings);
    shared_.samples = arguments.samples;
    if (arguments.options.width > 0)
        shared_.shape = static_cast<double>(arguments.options.width) / arguments.options.height;
    shared_.marksWidgets = !arguments.stateFile.empty();
    if (!arguments.recordFile.empty()) recorder_.emplace(arguments.recordFile);
    if (!arguments.replayFile.empty()) replay_ = readInput(arguments.replayFile);
}

/// Updates the title and the watched files after another scene is shown.
void Window::updateForShownScene() {
    const std::string name = session().hasScene() ? session().path().filename().string() : "";
    display_.setTitle(name.empty() ? "glibra" : name + " - glibra");
    tabs_.watch(watch_);
    framesWanted_ = kFramesAfterEvent;
}

void Window::showScene(const std::filesystem::path& path) {
    if (session().open(path)) {
        shared_.settings.addRecent(path);
        ui().history.clear();
        ui().history.record(session());
    }
    updateForShownScene();
}

void Window::openScene(const std::filesystem::path& path, bool inNewTab) {
    if (const std::size_t known = tabs_.find(path);
        known < tabs_.count() && (inNewTab || known != tabs_.shownIndex())) {
        tabs_.show(known);
        return updateForShownScene();
    }
    if (inNewTab && session().hasScene()) {
        tabs_.add();
    } else {
        std::vector<std::filesystem::path> files = tabs_.unsaved(tabs_.shownIndex());
        std::vector<UnsavedValues> values = unsavedValues(session());
        if (!files.empty() || !values.empty()) {
            shared_.question =
                Question{Question::About::openScene, path, 0, std::move(files), std::move(values), {}};
            framesWanted_ = kFramesAfterEvent;
            return;
        }
    }
    showScene(path);
}

void Window::closeTab(std::size_t tab) {
    std::vector<std::filesystem::path> files = tabs_.unsaved(tab);
    std::vector<UnsavedValues> values;
    if (tab < tabs_.count()) values = ownUnsavedValues(tabs_.at(tab).session);
    if (!files.empty() || !values.empty()) {
        shared_.question =
            Question{Question::About::closeTab, {}, tab, std::move(files), std::move(values), {}};
        framesWanted_ = kFramesAfterEvent;
        return;
    }
    tabs_.close(tab);
    updateForShownScene();
}

void Window::quit() {
    std::vector<std::filesystem::path> files = tabs_.unsaved();
    std::vector<UnsavedValues> values;
    for (std::size_t i = 0; i < tabs_.count(); ++i)
        for (UnsavedValues& each : ownUnsavedValues(tabs_.at(i).session)) values.push_back(std::move(each));
    if (files.empty() && values.empty()) return display_.close();
    display_.keepOpen();
    shared_.question = Question{Question::About::quit, {}, 0, std::move(files), std::move(values), {}};
    framesWanted_ = kFramesAfterEvent;
}

void Window::handleAnswer() {
    const auto answer = std::exchange(shared_.answer, std::nullopt);
    if (!answer || !answer->isConfirmed) return;
    switch (answer->question.about) {
        case Question::About::openScene:
            if (answer->inNewTab) tabs_.add();
            return showScene(answer->question.scene);
        case Question::About::closeTab:
            tabs_.close(answer->question.tab);
            return updateForShownScene();
        case Question::About::quit:
            quits_ = true;
            return display_.close();
    }
}

void Window::reloadIfNeeded() {
    const FileWatch::Change change = watch_.takeChanged();
    if (!change.files.empty()) tabs_.markOutdated(change.files);
    Tab& tab = tabs_.shown();
    if (!tab.isOutdated && !tab.ui.requests.reload) return;
    const bool isEdit = !change.files.empty();
    tab.isOutdated = tab.ui.requests.reload = false;
    const RealClock::time_point start = RealClock::now();
    tab.session.reload();
    loop_.loadMilliseconds = secondsSince(start) * kMilliseconds;
    ++loop_.reloads;
    isReloaded_ = true;
    if (isEdit) changeSaved_ = change.saved;
    tabs_.watch(watch_);
    framesWanted_ = kFramesAfterEvent;
}

/// Opens each dropped scene in a tab. Other files are shown where an open scene uses them.
void Window::handleDropped() {
    for (const std::filesystem::path& each : display_.takeDropped()) dropped_.push_back(each.string());
    std::string notice;
    for (const std::string& each : dropped_) {
        const Dropped dropped = takeDroppedFile(tabs_, each);
        if (dropped.isScene) openScene(each, true);
        if (dropped.tab && *dropped.tab != tabs_.shownIndex()) {
            tabs_.show(*dropped.tab);
            updateForShownScene();
        }
        notice += (notice.empty() || dropped.notice.empty() ? "" : "\n") + dropped.notice;
    }
    if (!dropped_.empty()) ui().notice = std::move(notice);
    if (recorder_) recordedDrops_.insert(recordedDrops_.end(), dropped_.begin(), dropped_.end());
    dropped_.clear();
}

void Window::handleRequests() {
    handleDropped();
    handleAnswer();
    Requests requests = std::exchange(ui().requests, {});
    // reloadIfNeeded() reads this flag.
    ui().requests.reload = requests.reload || (requests.saved && !watch_.isWorking());
    if (requests.showTab && *requests.showTab != tabs_.shownIndex()) {
        tabs_.show(*requests.showTab);
        updateForShownScene();
    }
    if (requests.open) openScene(*requests.open, requests.inNewTab);
    if (requests.closeTab) closeTab(*requests.closeTab);
    if (!quits_ && (requests.close || !display_.isOpen())) quit();
    if (shared_.examples.maker && shared_.examples.maker->hasFinished()) framesWanted_ = kFramesAfterEvent;
    if (shared_.settings.lightTheme != lightTheme_) {
        lightTheme_ = shared_.settings.lightTheme;
        applyTheme(lightTheme_, ui().scale);
        framesWanted_ = kFramesAfterEvent;
    }
}

/// Texts and widgets follow the screen's scale and the user's zoom.
void Window::followScale() {
    const float wanted = scaleOf(display_, shared_.settings);
    if (!(wanted > 0) || wanted == scale_) return;
    gui_->rescale(display_, scale_, wanted, shared_.settings);
    shared_.settings.scaleSizes(wanted / scale_);
    scale_ = wanted;
    tabs_.setScale(wanted);
    framesWanted_ = kFramesAfterEvent;
}

bool Window::hasWork() {
    for (std::size_t i = 0; i < tabs_.count(); ++i)
        if (tabs_.at(i).ui.hardcopy.job) return true;
    return framesWanted_ > 0 || ui().needsFrames || session().isMoving() || replayed_ < replay_.size();
}

void Window::waitForWork() {
    if (!hasWork()) {
        display_.takeEvents(-1);
        lastFrame_ = RealClock::now();
    } else if (replayed_ < replay_.size()) {
        display_.takeEvents(0);
    } else {
        display_.takeEvents(pacer_.secondsToNext(now()));
        // Events must not make a moving scene run faster.
        while (session().isMoving() && pacer_.secondsToNext(now()) > 0)
            std::this_thread::sleep_for(std::chrono::duration<double>(pacer_.secondsToNext(now())));
    }
    if (!display_.takeActivity()) return;
    framesWanted_ = kFramesAfterEvent;
    pacer_.setRate(display_.refreshRate());
}

bool Window::nextInput(FrameInput& input) {
    if (replayed_ >= replay_.size()) return false;
    const FrameInput& frame = replay_[replayed_++];
    input = frame;
    ImGui::GetIO().DeltaTime = static_cast<float>(kReplayedSeconds);
    ui().way = frame.way;
    if (frame.windowSize) display_.setSize(frame.windowSize->first, frame.windowSize->second);
    if (frame.open) ui().requests.open = *frame.open;
    dropped_ = frame.dropped;
    const auto isDown = [&](int left, int right) {
        return std::any_of(frame.keys.begin(), frame.keys.end(),
                           [&](int key) { return key == left || key == right; });
    };
    const bool control = isDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    const bool shift = isDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    for (const int key : frame.keys)
        if (std::find(replayedKeys_.begin(), replayedKeys_.end(), key) == replayedKeys_.end())
            ui().pressed.push_back({key, control, shift});
    replayedKeys_ = frame.keys;
    framesWanted_ = kFramesAfterEvent;
    return true;
}

void Window::record(FrameInput frame) {
    if (ui().way.size() > 1) frame.way = ui().way;
    if (const auto size = display_.size(); size != recordedSize_) frame.windowSize = recordedSize_ = size;
    frame.dropped = std::exchange(recordedDrops_, {});
    recorder_->add(frame);
}

/// Samples per pixel of this frame. A software rasteriser compiles a program once for one sample and once for
/// several, which takes twice as long; so there the first picture after an edit has one sample, and the next
/// frame is smooth again.
int Window::samplesOfFrame() {
    if (std::exchange(isReloaded_, false) && isSoftware_) return 1;
    return shared_.samples.value_or(shared_.settings.samples);
}

/// True if more input is waiting, so that this frame of a slow scene need not be drawn: the next one will be.
bool Window::isPassedOver() {
    return input_.isWaiting() && session().hasScene() && session().picture() != nullptr &&
           !session().live().readsMouse();
}

void Window::drawFrame() {
    const double passed = std::min(kLongestStep, secondsSince(lastFrame_));
    lastFrame_ = RealClock::now();
    pacer_.begin(now());
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    input_.add(display_.takeInput());
    InputQueue::Frame queued = input_.next();
    FrameInput input = inputOf(input_, queued);
    ui().pressed = std::move(queued.pressed);
    ui().way = std::move(queued.way);
    const bool isReplayed = nextInput(input);
    giveToImGui(input);
    if (recorder_) record(std::move(input));
    for (drawn_ = 0; drawn_ < tabs_.count(); ++drawn_) continueHardcopy(tabs_.at(drawn_).ui);
    drawn_ = tabs_.shownIndex();
    Ui& ui = tabs_.shown().ui;
    ui.session.advance(isReplayed ? kReplayedSeconds : passed);
    tabs_.updateTitles();
    // Outside of text fields, Tab chooses sliders (value_slider.h).
    keepTabFromFocus();
    ImGui::NewFrame();
    showAll(ui);
    if (!ImGui::IsAnyItemActive() && ui.dragButton < 0 && ui.session.hasScene())
        ui.history.record(ui.session);

    const auto [windowWidth, windowHeight] = display_.size();
    const auto [width, height] = display_.framebufferSize();
    if (windowWidth < 1 || windowHeight < 1 || width < 1 || height < 1) {
        ImGui::EndFrame();
        return;
    }
    const float perUnit = static_cast<float>(width) / static_cast<float>(windowWidth);
    ui.session.resize(static_cast<int>(ui.picture[2] * perUnit), static_cast<int>(ui.picture[3] * perUnit));
    ui.session.setSamples(samplesOfFrame());
    ui.session.setWholeShape(shared_.settings.pictureShape == PictureShape::fill ? shapeOf(ui) : 0);
    const RealClock::time_point start = RealClock::now();
    if (!isPassedOver()) ui.session.drawIfNeeded();
    if (changeSaved_) {
        // Drivers compile a program at its first draw; this measures how long that takes.
        glFinish();
        loop_.firstDrawMilliseconds = secondsSince(start) * kMilliseconds;
    }
    pictureOverlay(ui);
    present();
    framesWanted_ = input_.isWaiting() ? kFramesAfterEvent : framesWanted_ - 1;
}

void Window::present() {
    const auto [width, height] = display_.framebufferSize();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    const Color& well = palette().well;
    glClearColor(well.r, well.g, well.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const float perUnit = static_cast<float>(width) / static_cast<float>(std::max(1, display_.size().first));
    if (const gpu::Target* picture = session().picture()) {
        const int left = static_cast<int>(std::lround(ui().picture[0] * perUnit));
        const int top = height - static_cast<int>(std::lround(ui().picture[1] * perUnit));
        picture->readable().bindForReading();
        glBlitFramebuffer(0, 0, picture->width(), picture->height(), left, top - picture->height(),
                          left + picture->width(), top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    glViewport(0, 0, width, height);
    // ImGui restores the bound program afterwards, which a reload may have deleted.
    glUseProgram(0);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    display_.present();
    gpu::expectDevice();
    ++loop_.framesPresented;
    if (const auto saved = std::exchange(changeSaved_, std::nullopt)) {
        glFinish();
        loop_.editToPictureMilliseconds = secondsSince(*saved) * kMilliseconds;
    }
}

void Window::writeState() {
    if (arguments_.stateFile.empty()) return;
    loop_.windowSize = display_.size();
    loop_.refreshRate = display_.refreshRate();
    loop_.hasSwapControl = Display::hasSwapControl();
    loop_.isWaiting = !hasWork();
    std::string text = windowJson(ui(), loop_);
    if (text != writtenState_)
        image::writeFileAtomically(arguments_.stateFile, std::as_bytes(std::span(text)));
    writtenState_ = std::move(text);
}

void Window::saveSettings() {
    Settings kept = shared_.settings;
    std::tie(kept.windowWidth, kept.windowHeight) = display_.size();
    kept.layout = ImGui::SaveIniSettingsToMemory();
    kept.layoutScale = scale_;
    kept.scaleSizes(1 / scale_);
    writeSettings(kept, settingsFile());
}

void Window::openInitialScenes() {
    for (const std::filesystem::path& each : arguments_.scenes) openScene(each, true);
    tabs_.show(0);
    updateForShownScene();
    shared_.examples.isOpen = arguments_.scenes.empty() && replay_.empty();
    if (!session().hasScene()) return;
    for (const std::string& each : arguments_.set) append(setProblems_, session().setByText(each));
    Clock clock = session().clock();
    clock.setTime(arguments_.options.time);
    clock.play(!arguments_.paused);
    session().setClock(clock);
    session().setAxes(arguments_.options.axes);
    session().setView(arguments_.options.viewState);
    ui().history.clear();
    ui().history.record(session());
}

void Window::setSize() {
    const Settings& settings = shared_.settings;
    if (!session().hasScene()) return;
    const int panel = static_cast<int>(panelWidth(ui()));
    if (arguments_.options.width > 0)
        return display_.setSize(arguments_.options.width + panel, arguments_.options.height);
    const scene::Scene& scene = session().live().scene();
    const auto scaled = [&](int side) {
        return static_cast<int>(std::lround(static_cast<float>(side) * scale_));
    };
    std::pair<int, int> size(scaled(scene.width) + panel, scaled(scene.height));
    if (settings.windowWidth > 0) size = {settings.windowWidth, settings.windowHeight};
    // On a smaller screen than before, or one that is smaller than the scene, the window still fits.
    if (const auto room = Display::workArea())
        size = {std::min(size.first, room->first), std::min(size.second, room->second)};
    display_.setSize(size.first, size.second);
}

/// After the driver has reset the device: makes a new context, and in it all that was in the lost one. The
/// scene that has caused the reset is not drawn again.
Diagnostics Window::recover(const base::DeviceLost& lost) {
    shared_.settings.layout = ImGui::SaveIniSettingsToMemory();
    shared_.settings.layoutScale = scale_;
    tabs_.releaseDevice();
    gui_.reset();
    if (Diagnostics problems = display_.renew(); !problems.empty()) return problems;
    if (Diagnostics problems = context_.adoptAgain(&Display::address); !problems.empty()) return problems;
    gui_.emplace(display_, scale_, shared_.settings);
    input_ = {};
    tabs_.restoreDevice();
    Session& drawn = tabs_.at(std::min(drawn_, tabs_.count() - 1)).session;
    const bool isGuilty = lost.cause != base::ResetCause::other && drawn.hasScene();
    if (isGuilty) drawn.stop(lost);
    const std::string who = isGuilty ? "'" + drawn.path().filename().string() + "', which is stopped now,"
                                     : std::string("another program");
    ui().notice = {who + " made the graphics driver reset the device; everything else goes on", true};
    tabs_.watch(watch_);
    framesWanted_ = kFramesAfterEvent;
    return {};
}

Diagnostics Window::run() {
    openInitialScenes();
    setSize();
    while (display_.isOpen()) {
        try {
            waitForWork();
            handleRequests();
            reloadIfNeeded();
            followScale();
            if (hasWork()) drawFrame();
        } catch (const base::DeviceLost& lost) {
            if (Diagnostics problems = recover(lost); !problems.empty()) return problems;
        }
        writeState();
        if (!replay_.empty() && replayed_ >= replay_.size()) break;
    }
    saveSettings();
    return std::move(setProblems_);
}

}  // namespace

Diagnostics runWindow(const WindowArguments& arguments) {
    gpu::prepareEnvironment();
    constexpr int kFirstWidth = 980;
    constexpr int kFirstHeight = 600;
    Result<Display> display = Display::open(kFirstWidth, kFirstHeight, "glibra");
    if (!display) return std::move(display.diagnostics);
    Result<gpu::Context> context =
        gpu::adopt([](const char* function) { return Display::address(function); });
    if (!context) return std::move(context.diagnostics);
    return Window(arguments, *display, *context).run();
}

}  // namespace glibra::view

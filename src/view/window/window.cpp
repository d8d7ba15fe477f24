#include "view/window/window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <system_error>

#include "glib/text.h"
#include "gpu/context/driver_reports.h"
#include "system/interruption.h"
#include "view/debug_view/texels.h"
#include "view/edit/edited_file.h"
#include "view/edit/recovery.h"
#include "view/edit/saved_scene.h"
#include "view/edit/source_files.h"

namespace glibra::view {

namespace {

struct Dropped {
    bool isScene = false;            ///< the caller opens it
    std::optional<std::size_t> tab;  ///< the tab that shows the file now; the caller switches to it
    std::string notice;              ///< a message for the status line; may be empty
};

namespace fs = std::filesystem;

std::string showUse(Ui& ui, const FileUse& use, const std::string& name) {
    if (use.kind == FileUse::Kind::texture) {
        ui.wanted.inspected = textureKey(ui.session.live().scene(), use.texture);
        return {};
    }
    showSource(ui, use.place);
    if (use.kind == FileUse::Kind::text) return {};
    return fmt::format("{} is used in line {} of this scene", name, use.place.line);
}

/// A scene is left to the caller to open. A shader or included file is shown as text in the tab whose scene
/// uses it (the shown tab is tried first), a texture in the inspector, and a model at the line that names it.
/// A folder opens the file dialog in that folder. Any other file only gives a message.
Dropped takeDroppedFile(Tabs& tabs, const fs::path& file) {
    const std::string name = file.filename().generic_string();
    std::error_code failure;
    if (fs::is_directory(file, failure)) {
        tabs.shown().ui.wanted.file = FileRequest{std::nullopt, true, file};
        return {};
    }
    if (!fs::exists(file, failure))
        return {false, {}, fmt::format("{}: no such file", file.generic_string())};
    if (!std::ifstream(file))
        return {false, {}, fmt::format("{}: cannot read this file", file.generic_string())};
    if (glib::sameWord(file.extension().generic_string(), ".glib")) {
        if (tabs.find(file) == tabs.shownIndex()) return {false, {}, fmt::format("{} is already open", name)};
        return {true, {}, {}};
    }
    for (std::size_t i = 0; i < tabs.count(); ++i) {
        const std::size_t index = (tabs.shownIndex() + i) % tabs.count();
        Tab& tab = tabs.at(index);
        if (!tab.session.hasScene()) continue;
        const FileUse use = useOf(tab.session.live(), file);
        if (use.kind != FileUse::Kind::none) return {false, index, showUse(tab.ui, use, name)};
    }
    return {false, {}, fmt::format("{} is neither a scene (.glib) nor a file that an open scene uses", name)};
}

void addValues(std::vector<UnsavedValues>& values, const Session& session) {
    if (session.hasScene() && session.values().isChanged())
        values.push_back({session.path(), session.values().knobs(), session.chosenFiles()});
}

std::optional<Question> asked(Question question) {
    if (question.files.empty() && question.values.empty()) return std::nullopt;
    return question;
}

/// Before a scene is opened in the shown tab.
std::optional<Question> beforeOpening(const Tabs& tabs, const std::filesystem::path& scene) {
    Question question{Question::About::openScene, scene, 0, tabs.unsaved(tabs.shownIndex()), {}, {}};
    addValues(question.values, tabs.shown().session);
    return asked(std::move(question));
}

/// Before a tab is closed. The values of an example do not count, because they cannot be saved into it.
std::optional<Question> beforeClosing(const Tabs& tabs, std::size_t tab) {
    Question question{Question::About::closeTab, {}, tab, tabs.unsaved(tab), {}, {}};
    if (tab < tabs.count() && !isExample(tabs.at(tab).session.path()))
        addValues(question.values, tabs.at(tab).session);
    return asked(std::move(question));
}

/// Before all are closed: only unsaved text counts, because the tabs come back with their values.
std::optional<Question> beforeQuitting(const Tabs& tabs) {
    return asked({Question::About::quit, {}, 0, tabs.unsaved(), {}, {}});
}

}  // namespace

Window::Window(const WindowArguments& arguments, Display& display, gpu::Context& context)
    : arguments_(arguments),
      display_(display),
      context_(context),
      tabs_(context, arguments.options, shared_),
      watch_([] { Display::wake(); }),
      pacer_(display.refreshRate(), Display::hasSwapControl()),
      isSoftware_(context.capabilities().isSoftware) {
    shared_.settings = readSettings(settingsFile());
    // What is recorded begins as it is replayed.
    if (const std::filesystem::path folder = stateFolder();
        !folder.empty() && arguments.recordFile.empty() && arguments.replayFile.empty())
        shared_.keptValues = folder / "values";
    lightTheme_ = shared_.settings.lightTheme;
    shared_.scale = scaleOf(display, shared_.settings);
    shared_.settings.scaleSizes(shared_.scale);
    gui_.emplace(display, shared_.scale, shared_.settings);
    shared_.samples = arguments.samples;
    if (arguments.options.width > 0) shared_.size = {arguments.options.width, arguments.options.height};
    shared_.marksWidgets = !arguments.stateFile.empty();
    if (!arguments.recordFile.empty()) record_.emplace(arguments.recordFile);
    if (!arguments.replayFile.empty()) replay_ = InputReplay(readInput(arguments.replayFile));
}

/// Updates the title and the watched files after another scene is shown.
void Window::updateForShownScene() {
    const std::string name = session().hasScene() ? session().path().filename().generic_string() : "";
    display_.setTitle(name.empty() ? "glibra" : name + " - glibra");
    tabs_.watch(watch_);
    keepTabs();
    framesWanted_ = kFramesAfterEvent;
}

void Window::showScene(const std::filesystem::path& path) {
    showLoading(path);
    if (session().open(path)) {
        shared_.settings.addRecent(path);
        std::error_code failure;
        std::erase(earlierTabs_, std::filesystem::absolute(path, failure).generic_string());
        if (tabs_.shown().values.restore(session()))
            ui().notice = "with the values of the last time; Ctrl+R takes those of the scene";
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
        if (ask(beforeOpening(tabs_, path))) return;
    }
    showScene(path);
}

void Window::closeTab(std::size_t tab) {
    if (ask(beforeClosing(tabs_, tab))) return;
    closeNow(tab);
}

void Window::closeNow(std::size_t tab) {
    if (tab >= tabs_.count()) return;
    constexpr std::size_t kMostClosed = 50;
    if (const Session& session = tabs_.at(tab).session; session.hasScene()) {
        ClosedTab closed{session.path(),           tab,
                         session.values().knobs(), session.look().view(),
                         session.clock().state(),  session.look().camera()};
        std::erase_if(closed.knobs, [](const render::Knob& each) { return !each.isChanged(); });
        closed_.push_back(std::move(closed));
        tabs_.at(tab).values.forget(session);
        if (closed_.size() > kMostClosed) closed_.erase(closed_.begin());
    }
    tabs_.close(tab);
    updateForShownScene();
}

/// Opens the tab again that was closed last, with its values, view and time.
void Window::reopenTab() {
    if (closed_.empty()) {
        ui().notice = "no tab was closed";
        return;
    }
    const ClosedTab closed = std::move(closed_.back());
    closed_.pop_back();
    openScene(closed.scene, true);
    if (session().path() != closed.scene || !session().hasScene()) return;
    for (const render::Knob& each : closed.knobs)
        for (std::size_t i = 0; i < ui().values.knobs().size(); ++i)
            if (const render::Knob& known = ui().values.knobs()[i];
                known.title == each.title && known.tag == each.tag)
                ui().values.set(i, each.current);
    ui().look.setView(closed.view);
    session().clock().setState(closed.clock);
    ui().look.setCamera(closed.camera);
    tabs_.move(tabs_.shownIndex(), closed.index);
    keepTabs();
}

/// Opens the tabs of the last run.
void Window::restoreTabs() {
    const std::vector<std::string> files = shared_.settings.tabs;
    const int shown = shared_.settings.shownTab;
    const std::vector<std::string> recent = shared_.settings.recent;
    std::size_t wanted = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::error_code failure;
        if (!std::filesystem::exists(files[i], failure)) continue;
        openScene(files[i], true);
        if (!session().hasScene()) continue;
        ui().notice = {};
        if (static_cast<int>(i) == shown) wanted = tabs_.shownIndex();
    }
    shared_.settings.recent = recent;
    tabs_.show(wanted);
}

/// Writes the settings when other tabs are open, so that they come back even if the program is ended. Tabs of
/// the last window that this one does not show stay right of its own.
void Window::keepTabs() {
    if (!isStarted_) return;
    std::vector<std::string> files;
    int shown = 0;
    for (std::size_t i = 0; i < tabs_.count(); ++i) {
        if (!tabs_.at(i).session.hasScene()) continue;
        if (i == tabs_.shownIndex()) shown = static_cast<int>(files.size());
        std::error_code failure;
        files.push_back(std::filesystem::absolute(tabs_.at(i).session.path(), failure).generic_string());
    }
    files.insert(files.end(), earlierTabs_.begin(), earlierTabs_.end());
    if (files == shared_.settings.tabs && shown == shared_.settings.shownTab) return;
    shared_.settings.tabs = std::move(files);
    shared_.settings.shownTab = shown;
    saveSettings();
}

void Window::quit() {
    if (ask(beforeQuitting(tabs_)))
        display_.keepOpen();
    else
        display_.close();
}

/// Asks the user first, if there is something to ask.
bool Window::ask(std::optional<Question> question) {
    if (!question) return false;
    shared_.question = std::move(question);
    framesWanted_ = kFramesAfterEvent;
    return true;
}

void Window::handleAnswer() {
    const auto answer = std::exchange(shared_.answer, std::nullopt);
    if (!answer || !answer->isConfirmed) return;
    switch (answer->question.about) {
        case Question::About::openScene:
            if (answer->inNewTab)
                tabs_.add();
            else
                tabs_.shown().values.forget(session());
            return showScene(answer->question.scene);
        case Question::About::closeTab:
            return closeNow(answer->question.tab);
        case Question::About::quit:
            quits_ = true;
            return display_.close();
    }
}

void Window::reloadIfNeeded() {
    const std::uint64_t copies = shared_.copies.timesChanged();
    if (std::exchange(watchedCopies_, copies) != copies) tabs_.watch(watch_);
    const FileWatch::Change change = watch_.takeChanged();
    if (!change.files.empty()) {
        tabs_.markOutdated(change.files);
        framesWanted_ = std::max(framesWanted_, 1);  // of a copy that somebody has removed
    }
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
    for (const std::filesystem::path& each : display_.takeDropped())
        dropped_.push_back(each.generic_string());
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
    if (record_) record_->addDropped(dropped_);
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
    if (requests.reopenTab) reopenTab();
    if (requests.fullScreen) display_.setFullScreen(!display_.isFullScreen());
    if (requests.lecture) setLecture(!beforeLecture_);
    if (!quits_ && (requests.close || !display_.isOpen())) quit();
    if (requests.frames || isAny(ui(), &Panel::needsFrames)) framesWanted_ = kFramesAfterEvent;
    if (shared_.settings.lightTheme != lightTheme_) {
        lightTheme_ = shared_.settings.lightTheme;
        applyTheme(lightTheme_, shared_.scale);
        framesWanted_ = kFramesAfterEvent;
    }
}

/// Texts and widgets follow the screen's scale and the user's zoom.
void Window::followScale() {
    const float wanted = scaleOf(display_, shared_.settings);
    if (!(wanted > 0) || wanted == shared_.scale) return;
    gui_->rescale(display_, shared_.scale, wanted, shared_.settings);
    shared_.settings.scaleSizes(wanted / shared_.scale);
    shared_.scale = wanted;
    framesWanted_ = kFramesAfterEvent;
}

/// For projectors: full screen, large texts, the source over the picture, and no panel; or all as before.
void Window::setLecture(bool on) {
    constexpr float kLarge = 1.4F;
    Settings& settings = shared_.settings;
    if (on) {
        beforeLecture_ = {display_.isFullScreen(), shared_.showPanel, settings.showSource,
                          settings.sourcePlace, settings.zoom};
        settings.zoom = std::max(settings.zoom, kLarge);
        settings.sourcePlace = SourcePlace::over;
        settings.showSource = true;
        shared_.showPanel = false;
        display_.setFullScreen(true);
        ui().notice = "Lecture: Shift+F11 ends it, Ctrl+E hides the source, Ctrl+= makes texts larger";
    } else if (const auto before = std::exchange(beforeLecture_, std::nullopt)) {
        settings.zoom = before->zoom;
        settings.sourcePlace = before->place;
        settings.showSource = before->showSource;
        shared_.showPanel = before->showPanel;
        display_.setFullScreen(before->isFullScreen);
        ui().notice = {};
    }
    framesWanted_ = kFramesAfterEvent;
}

void Window::saveSettings() {
    Settings kept = shared_.settings;
    if (beforeLecture_) {
        kept.showSource = beforeLecture_->showSource;
        kept.sourcePlace = beforeLecture_->place;
        kept.zoom = beforeLecture_->zoom;
    }
    if (!display_.isFullScreen()) std::tie(kept.windowWidth, kept.windowHeight) = display_.size();
    kept.layout = ImGui::SaveIniSettingsToMemory();
    kept.layoutScale = shared_.scale;
    kept.scaleSizes(1 / shared_.scale);
    writeSettings(kept, settingsFile());
}

void Window::openInitialScenes() {
    const bool isEmpty = arguments_.scenes.empty() && replay_.isDone();
    if (!isEmpty) earlierTabs_ = shared_.settings.tabs;
    for (const std::filesystem::path& each : arguments_.scenes) openScene(each, true);
    tabs_.show(0);
    if (isEmpty) restoreTabs();
    isStarted_ = arguments_.replayFile.empty();
    updateForShownScene();
    toolWindow(ui(), "examples").isOpen = isEmpty && !session().hasScene() && shared_.settings.recent.empty();
    if (!session().hasScene()) return;
    for (const std::string& each : arguments_.set) append(setProblems_, ui().values.setByText(each));
    session().clock().setTime(arguments_.options.time);
    session().clock().play(!arguments_.paused);
    ui().look.setAxes(arguments_.options.axes);
    ui().look.setView(arguments_.options.viewState);
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
        return static_cast<int>(std::lround(static_cast<float>(side) * shared_.scale));
    };
    // A small scene's window has room for the panel.
    constexpr int kLeastRoom = 320, kLeastHeight = 560;
    std::pair<int, int> size(scaled(std::max(kLeastRoom, scene.width)) + panel,
                             scaled(std::max(kLeastHeight, scene.height)));
    if (settings.windowWidth > 0) size = {settings.windowWidth, settings.windowHeight};
    // On a smaller screen than before, or one that is smaller than the scene, the window still fits.
    if (const auto room = display_.largestSize())
        size = {std::min(size.first, room->first), std::min(size.second, room->second)};
    display_.setSize(size.first, size.second);
    display_.moveInside(size.first, size.second);
}

/// After the driver has reset the device: makes a new context, and in it all that was in the lost one. The
/// scene that has caused the reset is not drawn again.
Diagnostics Window::recover(const base::DeviceLost& lost) {
    shared_.settings.layout = ImGui::SaveIniSettingsToMemory();
    shared_.settings.layoutScale = shared_.scale;
    tabs_.releaseDevice();
    gui_.reset();
    if (Diagnostics problems = display_.renew(); !problems.empty()) return problems;
    if (Diagnostics problems = context_.adoptAgain(&Display::address); !problems.empty()) return problems;
    gui_.emplace(display_, shared_.scale, shared_.settings);
    input_ = {};
    tabs_.restoreDevice();
    Session& drawn = tabs_.at(std::min(drawn_, tabs_.count() - 1)).session;
    const bool isGuilty = lost.cause != base::ResetCause::other && drawn.hasScene();
    if (isGuilty) drawn.stop(lost);
    const std::string who = isGuilty
                                ? "'" + drawn.path().filename().generic_string() + "', which is stopped now,"
                                : std::string("another program");
    ui().notice = {who + " made the graphics driver reset the device; everything else goes on", true};
    tabs_.watch(watch_);
    framesWanted_ = kFramesAfterEvent;
    return {};
}

Diagnostics Window::run() {
    openInitialScenes();
    setSize();
    const system::EndingSignals signals([] { Display::wake(); });
    while (display_.isOpen() && system::EndingSignals::received() == 0) {
        try {
            waitForWork();
            handleRequests();
            reloadIfNeeded();
            followScale();
            if (hasWork()) drawFrame();
        } catch (const base::DeviceLost& lost) {
            if (Diagnostics problems = recover(lost); !problems.empty()) return problems;
        }
        valuesDue_ = tabs_.keepValues(false);
        writeState();
        if (!arguments_.replayFile.empty() && replay_.isDone()) break;
    }
    tabs_.keepValues(true);
    keepTabs();
    saveSettings();
    // The user has been asked about texts, unless the system has ended the window.
    if (system::EndingSignals::received() == 0) shared_.copies.forgetAll();
    return std::move(setProblems_);
}

Diagnostics runWindow(const WindowArguments& arguments) {
    gpu::prepareEnvironment();
    constexpr int kFirstWidth = 980;
    constexpr int kFirstHeight = 600;
    Result<Display> display = Display::open(kFirstWidth, kFirstHeight, "glibra");
    if (!display) return std::move(display.diagnostics);
    Result<gpu::Context> context =
        gpu::adopt([](const char* function) { return Display::address(function); });
    if (!context) return std::move(context.diagnostics);
    Diagnostics problems = Window(arguments, *display, *context).run();
    system::EndingSignals::obey();
    return problems;
}

}  // namespace glibra::view

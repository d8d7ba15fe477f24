#include "view/window/window.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

#include "gpu/context.h"
#include "image/file.h"
#include "view/file_watch.h"
#include "view/state_json.h"
#include "view/window/display.h"
#include "view/window/input_script.h"
#include "view/window/theme.h"
#include "view/window/ui.h"

namespace glibra::view {
namespace {

using RealClock = std::chrono::steady_clock;

/// ImGui needs the frame of an event and some after it, for what follows from it.
constexpr int kFramesAfterEvent = 3;
constexpr double kLongestStep = .25;  ///< seconds of the scene's time that one frame may pass over

double secondsSince(RealClock::time_point start) {
    return std::chrono::duration<double>(RealClock::now() - start).count();
}

/// ImGui with its two backends.
class Gui {
  public:
    Gui(const Display& display, float scale, bool light) {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        // A blinking cursor would be a reason to draw.
        ImGui::GetIO().ConfigInputTextCursorBlink = false;
        loadFont(scale);
        applyTheme(light, scale);
        ImGui_ImplGlfw_InitForOpenGL(display.handle(), true);
        ImGui_ImplOpenGL3_Init("#version 410 core");
    }
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
    ~Gui() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
};

class Window {
  public:
    Window(const WindowArguments& arguments, Display& display, gpu::Context& context);
    Diagnostics run();

  private:
    void openScene(const std::filesystem::path& path);
    void watchFiles();
    void takeChanges();
    void takeRequests();
    void waitForWork();
    bool nextInput();
    void drawFrame();
    void present();
    void writeState();
    void remember();

    const WindowArguments& arguments_;
    Display& display_;
    gpu::Context& context_;
    Session session_;
    Ui ui_;
    std::optional<Gui> gui_;
    FileWatch watch_;
    std::optional<InputRecorder> recorder_;
    std::vector<FrameInput> replay_;
    std::size_t replayed_ = 0;
    std::vector<int> replayedKeys_;
    int framesWanted_ = kFramesAfterEvent;
    std::uint64_t framesPresented_ = 0;
    std::uint64_t reloads_ = 0;
    bool lightTheme_ = false;
    RealClock::time_point lastFrame_ = RealClock::now();
    std::optional<RealClock::time_point> changeSaved_;
    double loadMilliseconds_ = 0, firstDrawMilliseconds_ = 0, editToPicture_ = 0;
    std::string writtenState_;
    Diagnostics setProblems_;
};

Window::Window(const WindowArguments& arguments, Display& display, gpu::Context& context)
    : arguments_(arguments),
      display_(display),
      context_(context),
      session_(context, arguments.options),
      ui_(context, session_),
      watch_([] { Display::wake(); }) {
    ui_.settings = readSettings(settingsFile());
    ui_.scale = display.contentScale();
    lightTheme_ = ui_.settings.lightTheme;
    gui_.emplace(display, ui_.scale, lightTheme_);
    if (!arguments.recordFile.empty()) recorder_.emplace(arguments.recordFile);
    if (!arguments.replayFile.empty()) replay_ = readInput(arguments.replayFile);
}

void Window::openScene(const std::filesystem::path& path) {
    const bool isFirst = !session_.hasScene();
    if (!session_.open(path)) return;
    ui_.settings.addRecent(path);
    ui_.history.clear();
    display_.setTitle(path.filename().string() + " - glibra");
    ui_.neighbours.clear();
    std::error_code failure;
    for (std::filesystem::directory_iterator
             each(path.parent_path().empty() ? "." : path.parent_path(), failure),
         end;
         !failure && each != end; each.increment(failure))
        if (each->path().extension() == ".glib")
            ui_.neighbours.push_back(each->path().lexically_normal().string());
    std::sort(ui_.neighbours.begin(), ui_.neighbours.end());
    if (isFirst) {
        for (const std::string& each : arguments_.set) append(setProblems_, session_.setByText(each));
        Clock clock = session_.clock();
        clock.setTime(arguments_.options.time);
        clock.play(!arguments_.paused);
        session_.setClock(clock);
        session_.setAxes(arguments_.options.axes);
        session_.setView(arguments_.options.viewState);
    }
    ui_.history.record(session_);
    watchFiles();
}

void Window::watchFiles() {
    if (!session_.hasScene()) return;
    std::set<std::string> missing;
    for (const scene::FileReference& each : session_.live().scene().files)
        if (each.path.empty()) missing.insert(std::filesystem::path(each.name).filename().string());
    watch_.watch(session_.live().files(), missing);
}

void Window::takeChanges() {
    const FileWatch::Change change = watch_.takeChanged();
    if (change.files.empty() && !ui_.requests.reload) return;
    ui_.requests.reload = false;
    const RealClock::time_point start = RealClock::now();
    session_.reload();
    loadMilliseconds_ = secondsSince(start) * 1000;
    ++reloads_;
    if (!change.files.empty()) changeSaved_ = change.saved;
    watchFiles();
    framesWanted_ = kFramesAfterEvent;
}

void Window::takeRequests() {
    for (const std::filesystem::path& each : display_.takeDropped()) ui_.requests.open = each;
    if (const auto path = std::exchange(ui_.requests.open, std::nullopt)) {
        openScene(*path);
        framesWanted_ = kFramesAfterEvent;
    }
    if (ui_.requests.close) display_.close();
    if (ui_.settings.lightTheme != lightTheme_) {
        lightTheme_ = ui_.settings.lightTheme;
        applyTheme(lightTheme_, ui_.scale);
        framesWanted_ = kFramesAfterEvent;
    }
}

void Window::waitForWork() {
    const bool isBusy = framesWanted_ > 0 || session_.isMoving() || replayed_ < replay_.size();
    if (!isBusy) {
        display_.takeEvents(-1);
        lastFrame_ = RealClock::now();
    } else if (replayed_ < replay_.size()) {
        display_.takeEvents(0);
    } else {
        // Where presenting does not wait for the screen, this does.
        const double rest = 1 / display_.refreshRate() - secondsSince(lastFrame_);
        display_.takeEvents(std::max(0.0, rest));
        while (session_.isMoving() && secondsSince(lastFrame_) < .95 / display_.refreshRate())
            std::this_thread::sleep_for(std::chrono::duration<double>(
                std::max(1e-4, 1 / display_.refreshRate() - secondsSince(lastFrame_))));
    }
    if (display_.takeActivity()) framesWanted_ = kFramesAfterEvent;
}

bool Window::nextInput() {
    if (replayed_ >= replay_.size()) return false;
    const FrameInput& frame = replay_[replayed_++];
    imposeInput(frame);
    if (frame.windowSize) display_.setSize(frame.windowSize->first, frame.windowSize->second);
    if (frame.open) ui_.requests.open = *frame.open;
    const bool control = ImGui::GetIO().KeyCtrl;
    for (const int key : frame.keys)
        if (std::find(replayedKeys_.begin(), replayedKeys_.end(), key) == replayedKeys_.end())
            ui_.pressed.push_back({key, control});
    replayedKeys_ = frame.keys;
    framesWanted_ = kFramesAfterEvent;
    return true;
}

void Window::drawFrame() {
    const double passed = std::min(kLongestStep, secondsSince(lastFrame_));
    lastFrame_ = RealClock::now();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ui_.pressed = display_.takePressedKeys();
    const bool isReplayed = nextInput();
    if (recorder_) recorder_->add(presentInput());
    session_.advance(isReplayed ? 1.0 / 60 : passed);
    ImGui::NewFrame();
    showAll(ui_);
    if (!ImGui::IsAnyItemActive() && ui_.dragButton < 0 && session_.hasScene()) ui_.history.record(session_);

    const auto [windowWidth, windowHeight] = display_.size();
    const auto [width, height] = display_.framebufferSize();
    if (windowWidth < 1 || windowHeight < 1 || width < 1 || height < 1) {
        ImGui::EndFrame();
        return;
    }
    const float perUnit = static_cast<float>(width) / static_cast<float>(windowWidth);
    session_.resize(static_cast<int>(ui_.picture[2] * perUnit), static_cast<int>(ui_.picture[3] * perUnit));
    const RealClock::time_point start = RealClock::now();
    session_.drawIfNeeded();
    if (changeSaved_) {
        // Drivers compile when a program is first drawn with; that is no time of ours.
        glFinish();
        firstDrawMilliseconds_ = secondsSince(start) * 1000;
    }
    pictureOverlay(ui_);
    present();
    --framesWanted_;
}

void Window::present() {
    const auto [width, height] = display_.framebufferSize();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(.1F, .1F, .1F, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (const gpu::Target* picture = session_.picture()) {
        picture->readable().bindForReading();
        glBlitFramebuffer(0, 0, picture->width(), picture->height(), 0, height - picture->height(),
                          picture->width(), height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    glViewport(0, 0, width, height);
    // ImGui puts back the program it finds, which is gone by then if a reload has deleted it.
    glUseProgram(0);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    display_.present();
    ++framesPresented_;
    if (const auto saved = std::exchange(changeSaved_, std::nullopt)) {
        glFinish();
        editToPicture_ = secondsSince(*saved) * 1000;
    }
}

void Window::writeState() {
    if (arguments_.stateFile.empty()) return;
    nlohmann::ordered_json state = stateOf(session_);
    const auto [width, height] = display_.size();
    state["window"] = {width, height};
    state["picture"] = ui_.picture;
    state["framesPresented"] = framesPresented_;
    state["reloads"] = reloads_;
    state["loadMilliseconds"] = loadMilliseconds_;
    state["firstDrawMilliseconds"] = firstDrawMilliseconds_;
    state["editToPictureMilliseconds"] = editToPicture_;
    state["mode"] = static_cast<int>(ui_.mode);
    state["typing"] = ui_.typing;
    state["notice"] = ui_.notice;
    state["hardcopyMessage"] = ui_.hardcopy.message;
    state["lightTheme"] = lightTheme_;
    state["inspected"] = ui_.inspector.hovered;
    if (ui_.noise.isOpen)
        state["noise"] = {{"command", noiseCommand(ui_.noise.noise, ui_.noise.file.data())},
                          {"point", ui_.noise.chosen},
                          {"message", ui_.noise.message}};
    state["lensWords"] = ui_.lensWords;
    if (ui_.cost)
        state["cost"] = {{"frames", ui_.cost->frames}, {"milliseconds", ui_.cost->millisecondsAFrame}};
    state["waiting"] = framesWanted_ <= 0 && !session_.isMoving() && replayed_ >= replay_.size();
    timespec cpu{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    state["cpuSeconds"] = static_cast<double>(cpu.tv_sec) + static_cast<double>(cpu.tv_nsec) * 1e-9;
    state["widgets"] = ui_.widgets;
    const std::string text = state.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    if (text != writtenState_)
        image::writeFileAtomically(arguments_.stateFile, std::as_bytes(std::span(text)));
    writtenState_ = text;
}

void Window::remember() {
    std::tie(ui_.settings.windowWidth, ui_.settings.windowHeight) = display_.size();
    writeSettings(ui_.settings, settingsFile());
}

Diagnostics Window::run() {
    if (!arguments_.scene.empty()) openScene(arguments_.scene);
    if (session_.hasScene() && arguments_.options.width == 0 && ui_.settings.windowWidth > 0) {
        display_.setSize(ui_.settings.windowWidth, ui_.settings.windowHeight);
    } else if (session_.hasScene()) {
        const int width =
            arguments_.options.width > 0 ? arguments_.options.width : session_.live().scene().width;
        const int height =
            arguments_.options.height > 0 ? arguments_.options.height : session_.live().scene().height;
        const float panel = ui_.settings.panelWidth > 0 ? ui_.settings.panelWidth : 380 * ui_.scale;
        display_.setSize(width + static_cast<int>(panel), height);
    }
    while (display_.isOpen()) {
        waitForWork();
        takeChanges();
        takeRequests();
        if (framesWanted_ > 0 || session_.isMoving() || replayed_ < replay_.size()) drawFrame();
        writeState();
        if (!replay_.empty() && replayed_ >= replay_.size()) display_.close();
    }
    remember();
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

// When a frame is drawn, and what it takes.

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <thread>
#include <utility>

#include "gpu/context/driver_reports.h"
#include "image/file.h"
#include "system/places.h"
#include "view/session/history.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/input.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"
#include "view/window/window.h"

namespace glibra::view {
namespace {

constexpr double kLongestStep = .25;  ///< seconds by which one frame may advance the scene's time
constexpr double kReplayedSeconds = 1. / 60;

double now() {
    return std::chrono::duration<double>(RealClock::now().time_since_epoch()).count();
}

using Json = nlohmann::ordered_json;

}  // namespace

bool Window::hasWork() {
    for (std::size_t i = 0; i < tabs_.count(); ++i)
        if (isAny(tabs_.at(i).ui, &Panel::isWorking)) return true;
    return framesWanted_ > 0 || ui().frame.isFollowed || session().isMoving() || session().isDrawing() ||
           !replay_.isDone();
}

void Window::waitForWork() {
    if (!hasWork()) {
        display_.takeEvents(valuesDue_);
        lastFrame_ = RealClock::now();
    } else if (!replay_.isDone()) {
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

/// The next frame of the record takes the place of what the user does.
void Window::takeReplayed(FrameInput& input) {
    input = replay_.next();
    ImGui::GetIO().DeltaTime = static_cast<float>(kReplayedSeconds);
    if (input.windowSize) display_.setSize(input.windowSize->first, input.windowSize->second);
    if (input.open) ui().requests.open = *input.open;
    ui().frame.way = input.way;
    dropped_ = input.dropped;
    const std::vector<Display::KeyPress>& pressed = replay_.pressed();
    ui().frame.pressed.insert(ui().frame.pressed.end(), pressed.begin(), pressed.end());
    framesWanted_ = kFramesAfterEvent;
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
    ui().frame.pressed = std::move(queued.pressed);
    ui().frame.way = std::move(queued.way);
    const bool isReplayed = !replay_.isDone();
    if (isReplayed) takeReplayed(input);
    giveToImGui(input);
    if (record_) record_->add(std::move(input), ui().frame.way, display_.size());
    for (drawn_ = 0; drawn_ < tabs_.count(); ++drawn_)
        for (const PanelUse& each : tabs_.at(drawn_).ui.panels) each.panel->work(tabs_.at(drawn_).ui);
    drawn_ = tabs_.shownIndex();
    Ui& ui = tabs_.shown().ui;
    ui.session.advance(isReplayed ? kReplayedSeconds : passed);
    tabs_.updateTitles();
    // In menus, lists and dialogs ImGui's keys choose; elsewhere Tab goes from widget to widget
    // (shortcuts.h).
    const bool isPopupOpen = !ImGui::GetCurrentContext()->OpenPopupStack.empty();
    if (!isPopupOpen) keepFromImGui(GLFW_KEY_TAB);
    if (isPopupOpen) keepFromImGui(GLFW_KEY_ESCAPE);
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags = isPopupOpen ? flags | ImGuiConfigFlags_NavEnableKeyboard
                        : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::NewFrame();
    showAll(ui);
    if (!ImGui::IsAnyItemActive() && !ui.frame.isDragging && ui.session.hasScene())
        ui.history.record(ui.session);

    const auto [windowWidth, windowHeight] = display_.size();
    const auto [width, height] = display_.framebufferSize();
    if (windowWidth < 1 || windowHeight < 1 || width < 1 || height < 1) {
        ImGui::EndFrame();
        return;
    }
    const float perUnit = static_cast<float>(width) / static_cast<float>(windowWidth);
    ui.look.resize(static_cast<int>(ui.frame.picture[2] * perUnit),
                   static_cast<int>(ui.frame.picture[3] * perUnit));
    ui.session.setSamples(samplesOfFrame());
    ui.look.setWholeShape(shared_.settings.pictureShape == PictureShape::fill ? shapeOf(ui) : 0);
    const RealClock::time_point start = RealClock::now();
    const std::uint64_t framesBefore = ui.session.framesDrawn();
    if (!isPassedOver()) ui.session.drawIfNeeded();
    const bool isDrawn = ui.session.framesDrawn() != framesBefore;
    if (changeSaved_ && !ui.session.isDrawing()) {
        // Drivers compile a program at its first draw; this measures how long that takes.
        glFinish();
        loop_.firstDrawMilliseconds = secondsSince(start) * kMilliseconds;
    }
    drawOverPicture(ui);
    present();
    if (isDrawn && isSoftware_) ui.session.noteDrawn(secondsSince(start));
    const bool isAsEvent = input_.isWaiting() || ui.wanted.any();
    framesWanted_ = isAsEvent ? kFramesAfterEvent : framesWanted_ - 1;
    const bool isIdle = framesWanted_ <= 0 && !ImGui::IsAnyMouseDown() && !isReplayed;
    if (isIdle && ui.session.watchLoops()) framesWanted_ = kFramesAfterEvent;
}

/// Draws the picture and what ImGui has drawn last.
void Window::paint() {
    const auto [width, height] = display_.framebufferSize();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    const Color& well = palette().well;
    glClearColor(well.r, well.g, well.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const float perUnit = static_cast<float>(width) / static_cast<float>(std::max(1, display_.size().first));
    if (const gpu::Target* picture = session().picture()) {
        const int left = static_cast<int>(std::lround(ui().frame.picture[0] * perUnit));
        const int top = height - static_cast<int>(std::lround(ui().frame.picture[1] * perUnit));
        const gpu::Target& shown = *session().shownPicture();
        // The picture from before an edit keeps its proportions if the window has another size now.
        const double scale = std::min(static_cast<double>(picture->width()) / shown.width(),
                                      static_cast<double>(picture->height()) / shown.height());
        const int wide = static_cast<int>(std::lround(shown.width() * scale));
        const int high = static_cast<int>(std::lround(shown.height() * scale));
        const int x = left + (picture->width() - wide) / 2, y = top - (picture->height() + high) / 2;
        shown.readable().bindForReading();
        glBlitFramebuffer(0, 0, shown.width(), shown.height(), x, y, x + wide, y + high, GL_COLOR_BUFFER_BIT,
                          scale == 1 ? GL_NEAREST : GL_LINEAR);
    }
    glViewport(0, 0, width, height);
    // ImGui restores the bound program afterwards, which a reload may have deleted.
    glUseProgram(0);
    if (ImDrawData* drawn = ImGui::GetDrawData()) ImGui_ImplOpenGL3_RenderDrawData(drawn);
}

/// Says that a scene is loaded, over what the window shows, until the next frame.
void Window::showLoading(const std::filesystem::path& scene) {
    const auto [width, height] = display_.size();
    if (width < 1 || height < 1) return;
    ImGui_ImplOpenGL3_NewFrame();  // makes the font's texture at first
    paint();
    const std::string text = "loading " + scene.filename().generic_string() + " ...";
    ImFont* font = ImGui::GetIO().Fonts->Fonts[0];
    const float size = font->FontSize, pad = size / 2;
    const float wide = font->CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x;
    const ImVec2 whole(static_cast<float>(width), static_cast<float>(height));
    const ImVec2 at(std::max(pad, (whole.x - wide) / 2), whole.y / 2);
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list.PushClipRect({0, 0}, whole);
    list.AddRectFilled({at.x - pad, at.y - pad}, {at.x + wide + pad, at.y + size + pad},
                       packed(palette().well));
    list.AddText(font, size, at, packed(palette().text), text.c_str());
    list.PopClipRect();
    list.PopTextureID();
    ImDrawData data;
    data.Valid = true;
    data.DisplaySize = whole;
    const auto [pixelsWide, pixelsHigh] = display_.framebufferSize();
    data.FramebufferScale = {static_cast<float>(pixelsWide) / whole.x,
                             static_cast<float>(pixelsHigh) / whole.y};
#if IMGUI_VERSION_NUM >= 18973
    data.AddDrawList(&list);
#else
    ImDrawList* lists[] = {&list};
    data.CmdLists = lists;
    data.CmdListsCount = 1;
    data.TotalIdxCount = list.IdxBuffer.Size;
    data.TotalVtxCount = list.VtxBuffer.Size;
#endif
    ImGui_ImplOpenGL3_RenderDrawData(&data);
    display_.present();
}

void Window::present() {
    ImGui::Render();
    paint();
    display_.present();
    gpu::expectDevice();
    ++loop_.framesPresented;
    if (session().isDrawing()) return;
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

std::string windowJson(const Ui& ui, const LoopState& loop) {
    Json state = stateOf(ui.session);
    state["window"] = {loop.windowSize.first, loop.windowSize.second};
    state["framesPresented"] = loop.framesPresented;
    state["reloads"] = loop.reloads;
    state["loadMilliseconds"] = loop.loadMilliseconds;
    state["firstDrawMilliseconds"] = loop.firstDrawMilliseconds;
    state["editToPictureMilliseconds"] = loop.editToPictureMilliseconds;
    state["refreshRate"] = loop.refreshRate;
    state["swapControl"] = loop.hasSwapControl;
    state["waiting"] = loop.isWaiting;
    state["cpuSeconds"] = system::processorSeconds();
    state["picture"] = ui.frame.picture;
    state["room"] = ui.frame.room;
    state["scale"] = ui.shared.scale;
    state["focused"] = ui.frame.focusedName;
    state["mode"] = static_cast<int>(ui.mode);
    state["typing"] = ui.sliders.typing;
    state["notice"] = ui.notice.text;
    state["noticeIsError"] = ui.notice.isError;
    state["lightTheme"] = ui.settings.lightTheme;
    state["question"] = ui.shared.question.has_value();
    state["takesText"] = ImGui::GetIO().WantTextInput;
    state["tabs"] = Json::array();
    for (const TabTitle& each : ui.shared.tabs)
        state["tabs"].push_back({{"label", each.label}, {"path", each.path}, {"unsaved", each.isUnsaved}});
    state["shownTab"] = ui.shared.shownTab;
    for (const PanelUse& each : ui.panels) each.panel->addTo(state, ui);
    state["widgets"] = ui.frame.widgets;
    return state.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace glibra::view

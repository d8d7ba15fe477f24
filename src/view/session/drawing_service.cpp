#include "view/session/drawing_service.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <utility>

#include "base/packed.h"
#include "gpu/context/context.h"
#include "gpu/object/readback.h"
#include "suite/options/option_words.h"
#include "system/memory.h"
#include "view/scene/window_target.h"

namespace glibra {

void eachMember(auto& packed, base::Is<ViewState::Object> auto& of) {
    packed(of.line, of.matrix, of.file, of.counter);
}
void eachMember(auto& packed, base::Is<ViewState> auto& of) {
    packed(of.scene, of.eye, of.texture, of.objects, of.background);
    packed.upTo(ProjectionMode::orthographic, of.projection);
}

}  // namespace glibra

namespace glibra::render {

/// What says which knob it is, and its value.
void eachMember(auto& packed, base::Is<Knob> auto& of) {
    packed(of.title, of.tag, of.current);
}

}  // namespace glibra::render

namespace glibra::view {

/// Without the options that have words.
void eachMember(auto& packed, base::Is<DrawnState> auto& of) {
    packed(of.scene, of.loading, of.options.texts, of.options.sceneText, of.knobs, of.view, of.camera,
           of.time);
    packed(of.axes, of.wireframe, of.mouse.x, of.mouse.y, of.mouse.isDown, of.watchesLoops);
    packed(of.width, of.height, of.samples);
}

namespace {

constexpr std::size_t kHead = sizeof(std::uint64_t);
/// The message that drawing begins, after loading; packed diagnostics are longer.
constexpr std::string_view kBegins = "begins";

/// A message is 8 bytes with the length, then the text. False, or nothing, if the other process has ended.
bool sendMessage(const system::File& channel, std::string_view text) {
    const auto length = static_cast<std::uint64_t>(text.size());
    std::string bytes(kHead, '\0');
    std::memcpy(bytes.data(), &length, kHead);
    bytes += text;
    return sendAll(channel, std::as_bytes(std::span(bytes))) == 0;
}

/// Removes the first whole message from bytes that were received; nothing if there is none.
std::optional<std::string> takeMessage(std::string& received) {
    std::uint64_t length = 0;
    if (received.size() < kHead) return std::nullopt;
    std::memcpy(&length, received.data(), kHead);
    if (received.size() - kHead < length) return std::nullopt;
    std::string text = received.substr(kHead, length);
    received.erase(0, kHead + length);
    return text;
}

std::optional<std::string> receiveMessage(const system::File& channel) {
    std::string received;
    for (;;) {
        if (std::optional<std::string> text = takeMessage(received)) return text;
        if (receive(channel, -1, nullptr, received) != system::News::bytes) return std::nullopt;
    }
}

/// How long a picture is waited for when it is asked for; most are ready then.
constexpr double kPatience = .1;
/// Loading makes meshes and compiles programs, which ends.
constexpr double kLongestLoading = 60;

double secondsSinceTime(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

constexpr int kNoContext = 4;  ///< exit status
/// Seconds after which the process ends itself, in case that nobody watches it any more.
constexpr unsigned kLongestDraw = 120;

using Words = std::vector<std::pair<std::string, std::string>>;

/// Name and text of each option that a loaded scene keeps. Values of variables are those of the knobs.
Words wordsOf(const RenderOptions& options) {
    suite::Shot shot;
    shot.options = options;
    Words words;
    for (const suite::OptionRow& row : suite::optionTable()) {
        if (!row.isKept || std::holds_alternative<suite::UniformsValue>(row.value)) continue;
        const bool isFlag = std::holds_alternative<suite::FlagValue>(row.value);
        const std::vector<std::string> given = suite::optionWords(row, shot);
        for (std::size_t i = 0; i < given.size(); i += isFlag ? 1 : 2)
            words.emplace_back(row.name, isFlag ? std::string() : given[i + 1]);
    }
    return words;
}

/// The options with those that have words.
RenderOptions optionsOf(const RenderOptions& others, const Words& words) {
    suite::Shot shot;
    shot.options = others;
    for (const auto& [name, text] : words) suite::readOptionText(suite::optionNamed(name), text, shot);
    return std::move(shot.options);
}

/// The scene that the process draws, and what it was drawn with last.
class Drawing {
  public:
    Drawing(gpu::Context& context, system::ParentEnds& window) : context_(context), window_(window) {}

    /// Draws what is asked for. Returns the diagnostics. `words`: of the options.
    Diagnostics draw(const DrawnState& order, const Words& words) {
        Diagnostics diagnostics;
        if (!live_ || order.loading != loading_) {
            render::LiveScene::Loading loaded =
                render::LiveScene::load(context_, order.scene, optionsOf(order.options, words), live_.get());
            if (!loaded.scene) return std::move(loaded.diagnostics);
            live_ = std::move(loaded.scene);
            knobs_ = live_->knobs();
            loading_ = order.loading;
        }
        for (const render::Knob& each : order.knobs) set(each);
        live_->setCamera(order.camera);
        live_->setMouse(order.mouse.x, order.mouse.y, order.mouse.isDown);
        live_->drawer().setWireframe(order.wireframe);
        if (std::exchange(samples_, order.samples) != order.samples) target_.reset();
        if (Diagnostics problems = fit(target_, context_.capabilities(), live_->scene(), order.width,
                                       order.height, gpu::TexelFormat::rgba8, order.samples);
            !target_)
            return problems;
        if (order.watchesLoops) live_->watchLoops();
        system::endAfter(kLongestDraw);
        sendMessage(window_.channel, kBegins);
        append(diagnostics, live_->draw(*target_, order.view, order.time, order.axes));
        append(diagnostics, copyPicture());
        system::endAfter(0);
        return diagnostics;
    }

  private:
    void set(const render::Knob& value) {
        for (render::Knob& each : knobs_) {
            if (each.title != value.title || each.tag != value.tag) continue;
            if (value.current == each.current || value.current.size() != each.current.size()) return;
            each.current = value.current;
            return live_->setValue(each);
        }
    }

    [[nodiscard]] Diagnostics copyPicture() {
        Result<std::vector<std::byte>> rows =
            gpu::readPixels(context_.capabilities(), target_->readable(), 0,
                            {0, 0, target_->width(), target_->height()}, {4, gpu::TexelType::u8});
        if (!rows) return std::move(rows.diagnostics);
        if (!window_.memory.map(rows->size())) return {diagnose("draw-E05", "out of memory")};
        const std::size_t row = static_cast<std::size_t>(target_->width()) * 4;
        std::byte* to = window_.memory.bytes().data();
        for (std::size_t at = rows->size(); at > 0; at -= row, to += row)
            std::memcpy(to, rows->data() + at - row, row);
        window_.memory.unmap();
        return std::move(rows.diagnostics);
    }

    gpu::Context& context_;
    system::ParentEnds& window_;
    std::unique_ptr<render::LiveScene> live_;
    std::vector<render::Knob> knobs_;
    std::uint64_t loading_ = 0;
    std::optional<gpu::Target> target_;
    int samples_ = 0;
};

}  // namespace

void DrawingProcess::end() {
    if (child_) system::end(*child_);
    child_.reset();
    received_.clear();
    isWorking_ = hasDrawn_ = false;
}

bool DrawingProcess::send(const DrawingOrder& order) {
    const std::size_t size =
        static_cast<std::size_t>(order.width) * static_cast<std::size_t>(order.height) * 4;
    if (child_->memory.bytes().size() != size && !child_->memory.resize(size)) return false;
    sent_ = order;
    isWorking_ = isLoading_ = true;
    begun_ = std::chrono::steady_clock::now();
    return sendMessage(child_->channel, order.text);
}

/// On a busy machine the process may not have had the processor.
bool DrawingProcess::isLate(double limit) const {
    constexpr double kMostWaiting = 5;
    const double passed = secondsSinceTime(begun_);
    if (isLoading_) return passed > kLongestLoading;
    return passed > limit && (passed > kMostWaiting * limit ||
                              processorSecondsOf(child_->process) - processorSeconds_ > limit / 2);
}

DrawingProcess::State DrawingProcess::wait(double seconds, double limit) {
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    for (;;) {
        while (const std::optional<std::string> text = takeMessage(received_)) {
            if (*text != kBegins) {
                std::optional<Diagnostics> found = base::unpacked<Diagnostics>(*text);
                if (!found) {
                    end();
                    return State::ended;
                }
                diagnostics_ = *std::move(found);
                seconds_ = secondsSinceTime(begun_);
                isWorking_ = false;
                hasDrawn_ = true;
                return State::drawn;
            }
            isLoading_ = false;
            begun_ = std::chrono::steady_clock::now();
            processorSeconds_ = processorSecondsOf(child_->process);
        }
        const int left = static_cast<int>(std::max(0., (seconds - secondsSinceTime(start)) * 1000));
        const system::News news = receive(child_->channel, left, nullptr, received_);
        if (news == system::News::bytes) continue;
        if (news == system::News::ended) {
            const State why = hasDrawn_ || !isLoading_ ? State::ended : State::missing;
            end();
            return why;
        }
        if (isLate(limit)) {
            end();
            return State::late;
        }
        if (left == 0) return State::working;
    }
}

DrawingProcess::State DrawingProcess::draw(const DrawingOrder& wanted, double limit) {
    if (isWorking_ && sent_.loading != wanted.loading) end();
    if (isWorking_) return wait(0, limit);
    if (!child_) child_ = system::startChild({"glibra-view", "--draw-for-window"});
    if (!child_ || !send(wanted)) {
        end();
        return State::missing;
    }
    return wait(kPatience, limit);
}

std::string orderText(const DrawnState& state) {
    return base::packed(std::pair(state, wordsOf(state.options)));
}

int serveDrawing() {
    system::ParentEnds window = system::endsOfThisChild();
    gpu::prepareEnvironment();
    Result<gpu::Context> context = gpu::openContext();
    if (!context) return kNoContext;
    Drawing drawing(*context, window);
    while (const std::optional<std::string> text = receiveMessage(window.channel)) {
        const auto order = base::unpacked<std::pair<DrawnState, Words>>(*text);
        if (!order) return kNoContext;
        if (!sendMessage(window.channel, base::packed(drawing.draw(order->first, order->second)))) break;
    }
    return 0;
}

}  // namespace glibra::view

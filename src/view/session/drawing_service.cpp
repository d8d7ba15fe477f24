#include "view/session/drawing_service.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "gpu/context/context.h"
#include "gpu/object/readback.h"
#include "suite/options/option_words.h"
#include "system/memory.h"
#include "view/scene/window_target.h"

namespace glibra::view {
namespace {

constexpr std::size_t kHead = sizeof(std::uint64_t);

}  // namespace

std::optional<std::string> takeMessage(std::string& received) {
    std::uint64_t length = 0;
    if (received.size() < kHead) return std::nullopt;
    std::memcpy(&length, received.data(), kHead);
    if (received.size() - kHead < length) return std::nullopt;
    std::string text = received.substr(kHead, length);
    received.erase(0, kHead + length);
    return text;
}

bool sendMessage(const system::File& channel, std::string_view text) {
    const auto length = static_cast<std::uint64_t>(text.size());
    std::string bytes(kHead, '\0');
    std::memcpy(bytes.data(), &length, kHead);
    bytes += text;
    return sendAll(channel, std::as_bytes(std::span(bytes))) == 0;
}

std::optional<std::string> receiveMessage(const system::File& channel) {
    std::string received;
    for (;;) {
        if (std::optional<std::string> text = takeMessage(received)) return text;
        if (receive(channel, -1, nullptr, received) != system::News::bytes) return std::nullopt;
    }
}

std::string answerText(const Diagnostics& diagnostics) {
    nlohmann::json list = nlohmann::json::array();
    for (const Diagnostic& each : diagnostics)
        list.push_back({each.id, each.text, each.place.file, each.place.line, each.place.column});
    return nlohmann::json{{"diagnostics", list}}.dump(-1, ' ', false,
                                                      nlohmann::json::error_handler_t::replace);
}

Diagnostics diagnosticsOf(const nlohmann::json& answer) {
    Diagnostics diagnostics;
    for (const nlohmann::json& each : answer.at("diagnostics"))
        diagnostics.push_back(diagnose(each[0].get<std::string>(), each[1].get<std::string>(),
                                       {each[2].get<std::string>(), each[3].get<int>(), each[4].get<int>()}));
    return diagnostics;
}

namespace {

/// How long a picture is waited for when it is asked for; most are ready then.
constexpr double kPatience = .1;
/// Loading makes meshes and compiles programs, which ends.
constexpr double kLongestLoading = 60;

double secondsSinceTime(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

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
            const nlohmann::json answer = nlohmann::json::parse(*text, nullptr, false);
            if (answer.is_object() && answer.contains("diagnostics")) {
                diagnostics_ = diagnosticsOf(answer);
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

namespace {

using Order = nlohmann::json;

constexpr int kNoContext = 4;  ///< exit status
/// Seconds after which the process ends itself, in case that nobody watches it any more.
constexpr unsigned kLongestDraw = 120;

Order jsonOf(const ViewState& view) {
    Order json{{"scene", view.scene},
               {"eye", view.eye},
               {"texture", view.texture},
               {"projection", static_cast<int>(view.projection)},
               {"objects", Order::array()}};
    for (const ViewState::Object& each : view.objects)
        json["objects"].push_back({each.line, each.file, each.counter, each.matrix});
    if (view.background) json["background"] = *view.background;
    return json;
}

ViewState viewOf(const Order& json) {
    ViewState view;
    view.scene = json.at("scene").get<Matrix>();
    view.eye = json.at("eye").get<Matrix>();
    view.texture = json.at("texture").get<Matrix>();
    view.projection = static_cast<ProjectionMode>(json.at("projection").get<int>());
    for (const Order& each : json.at("objects"))
        view.objects.emplace_back(DrawId{each[0].get<int>(), each[1].get<int>(), each[2].get<int>()},
                                  each[3].get<Matrix>());
    if (json.contains("background")) view.background = json["background"].get<std::array<double, 4>>();
    return view;
}

/// Name and text of each option that a loaded scene keeps. Values of variables are those of the knobs.
Order wordsOf(const RenderOptions& options) {
    suite::Shot shot;
    shot.options = options;
    Order words = Order::array();
    for (const suite::OptionRow& row : suite::optionTable()) {
        if (!row.isKept || std::holds_alternative<suite::UniformsValue>(row.value)) continue;
        const bool isFlag = std::holds_alternative<suite::FlagValue>(row.value);
        const std::vector<std::string> given = suite::optionWords(row, shot);
        for (std::size_t i = 0; i < given.size(); i += isFlag ? 1 : 2)
            words.push_back({row.name, isFlag ? std::string() : given[i + 1]});
    }
    return words;
}

RenderOptions optionsOf(const Order& json) {
    suite::Shot shot;
    for (const Order& each : json.at("words"))
        suite::readOptionText(suite::optionNamed(each[0].get<std::string>()), each[1].get<std::string>(),
                              shot);
    RenderOptions options = std::move(shot.options);
    for (const Order& each : json.at("texts"))
        options.texts[each[0].get<std::string>()] = each[1].get<std::string>();
    if (json.contains("text")) options.sceneText = json["text"].get<std::string>();
    return options;
}

/// The scene that the process draws, and what it was drawn with last.
class Drawing {
  public:
    Drawing(gpu::Context& context, system::ParentEnds& window) : context_(context), window_(window) {}

    /// Draws what is asked for. Returns the diagnostics.
    Diagnostics draw(const Order& order) {
        Diagnostics diagnostics;
        if (const auto loading = order.at("loading").get<std::uint64_t>(); !live_ || loading != loading_) {
            render::LiveScene::Loading loaded = render::LiveScene::load(
                context_, order.at("path").get<std::string>(), optionsOf(order.at("options")), live_.get());
            if (!loaded.scene) return std::move(loaded.diagnostics);
            live_ = std::move(loaded.scene);
            knobs_ = live_->knobs();
            loading_ = loading;
        }
        for (const Order& each : order.at("knobs")) set(each);
        live_->setCamera(order.at("camera").get<std::string>());
        const Order& mouse = order.at("mouse");
        live_->setMouse(mouse[0].get<double>(), mouse[1].get<double>(), mouse[2].get<bool>());
        live_->drawer().setWireframe(order.at("wireframe").get<bool>());
        const int width = order.at("width").get<int>(), height = order.at("height").get<int>();
        const int samples = order.at("samples").get<int>();
        if (std::exchange(samples_, samples) != samples) target_.reset();
        if (Diagnostics problems = fit(target_, context_.capabilities(), live_->scene(), width, height,
                                       gpu::TexelFormat::rgba8, samples);
            !target_)
            return problems;
        if (order.at("watchesLoops").get<bool>()) live_->watchLoops();
        system::endAfter(kLongestDraw);
        sendMessage(window_.channel, R"({"begins":true})");
        append(diagnostics, live_->draw(*target_, viewOf(order.at("view")), order.at("time").get<double>(),
                                        order.at("axes").get<bool>()));
        append(diagnostics, copyPicture());
        system::endAfter(0);
        return diagnostics;
    }

  private:
    void set(const Order& value) {
        for (render::Knob& each : knobs_) {
            if (each.title != value[0].get<std::string>() || each.tag != value[1].get<std::string>())
                continue;
            auto wanted = value[2].get<std::vector<double>>();
            if (wanted == each.current || wanted.size() != each.current.size()) return;
            each.current = std::move(wanted);
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

std::string orderText(const DrawnState& state) {
    Order texts = Order::array(), knobs = Order::array();
    for (const auto& [path, text] : state.options.texts) texts.push_back({path.generic_string(), text});
    for (const render::Knob& each : state.knobs) knobs.push_back({each.title, each.tag, each.current});
    Order options{{"words", wordsOf(state.options)}, {"texts", texts}};
    if (state.options.sceneText) options["text"] = *state.options.sceneText;
    const Order order{{"path", state.scene.generic_string()},
                      {"loading", state.loading},
                      {"options", options},
                      {"knobs", knobs},
                      {"view", jsonOf(state.view)},
                      {"camera", state.camera},
                      {"time", state.time},
                      {"axes", state.axes},
                      {"wireframe", state.wireframe},
                      {"mouse", {state.mouseX, state.mouseY, state.isMouseDown}},
                      {"width", state.width},
                      {"height", state.height},
                      {"samples", state.samples},
                      {"watchesLoops", state.watchesLoops}};
    return order.dump(-1, ' ', false, Order::error_handler_t::replace);
}

int serveDrawing() {
    system::ParentEnds window = system::endsOfThisChild();
    gpu::prepareEnvironment();
    Result<gpu::Context> context = gpu::openContext();
    if (!context) return kNoContext;
    Drawing drawing(*context, window);
    while (const std::optional<std::string> text = receiveMessage(window.channel)) {
        const Order order = Order::parse(*text, nullptr, false);
        if (!order.is_object()) return kNoContext;
        if (!sendMessage(window.channel, answerText(drawing.draw(order)))) break;
    }
    return 0;
}

}  // namespace glibra::view

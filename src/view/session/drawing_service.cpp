#include "view/session/drawing_service.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "gpu/context/context.h"
#include "gpu/object/readback.h"
#include "view/edit/external_editor.h"
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

bool sendMessage(int socket, std::string_view text) {
    const auto length = static_cast<std::uint64_t>(text.size());
    std::string bytes(kHead, '\0');
    std::memcpy(bytes.data(), &length, kHead);
    bytes += text;
    for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t sent = ::send(socket, rest.data(), rest.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        rest.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

std::optional<std::string> receiveMessage(int socket) {
    std::string received;
    for (;;) {
        if (std::optional<std::string> text = takeMessage(received)) return text;
        std::array<char, 1 << 16> bytes{};
        const ssize_t length = ::recv(socket, bytes.data(), bytes.size(), 0);
        if (length < 0 && errno == EINTR) continue;
        if (length <= 0) return std::nullopt;
        received.append(bytes.data(), static_cast<std::size_t>(length));
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

double processorSecondsOf(pid_t process) {
    clockid_t clock{};
    timespec used{};
    if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &used) != 0) return 0;
    constexpr double kSecondsPerNanosecond = 1e-9;
    return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * kSecondsPerNanosecond;
}

}  // namespace

bool DrawingProcess::start() {
    std::array<int, 2> ends{-1, -1};
    memory_ = ::memfd_create("glibra picture", MFD_CLOEXEC);
    if (memory_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
    socket_ = ends[0];
    process_ = startAgain({"glibra-view", "--draw-for-window"},
                          {{ends[1], kDrawingSocket}, {memory_, kDrawingMemory}});
    ::close(ends[1]);
    return process_ >= 0;
}

void DrawingProcess::unmap() {
    if (!pixels_.empty()) ::munmap(pixels_.data(), pixels_.size());
    pixels_ = {};
}

void DrawingProcess::end() {
    unmap();
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
    }
    for (int* each : {&socket_, &memory_})
        if (*each >= 0) ::close(std::exchange(*each, -1));
    process_ = -1;
    received_.clear();
    isWorking_ = hasDrawn_ = false;
}

bool DrawingProcess::send(const DrawingOrder& order) {
    const std::size_t size =
        static_cast<std::size_t>(order.width) * static_cast<std::size_t>(order.height) * 4;
    if (pixels_.size() != size) {
        unmap();
        if (::ftruncate(memory_, static_cast<off_t>(size)) != 0) return false;
        void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, memory_, 0);
        if (memory == MAP_FAILED) return false;
        pixels_ = {static_cast<std::byte*>(memory), size};
    }
    sent_ = order;
    isWorking_ = isLoading_ = true;
    begun_ = std::chrono::steady_clock::now();
    return sendMessage(socket_, order.text);
}

/// On a busy machine the process may not have had the processor.
bool DrawingProcess::isLate(double limit) const {
    constexpr double kMostWaiting = 5;
    const double passed = secondsSinceTime(begun_);
    if (isLoading_) return passed > kLongestLoading;
    return passed > limit &&
           (passed > kMostWaiting * limit || processorSecondsOf(process_) - processorSeconds_ > limit / 2);
}

DrawingProcess::State DrawingProcess::wait(double seconds, double limit) {
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    for (;;) {
        while (const std::optional<std::string> text = takeMessage(received_)) {
            const nlohmann::json answer = nlohmann::json::parse(*text, nullptr, false);
            if (answer.is_object() && answer.contains("diagnostics")) {
                diagnostics_ = diagnosticsOf(answer);
                isWorking_ = false;
                hasDrawn_ = true;
                return State::drawn;
            }
            isLoading_ = false;
            begun_ = std::chrono::steady_clock::now();
            processorSeconds_ = processorSecondsOf(process_);
        }
        const int left = static_cast<int>(std::max(0., (seconds - secondsSinceTime(start)) * 1000));
        pollfd wanted{socket_, POLLIN, 0};
        if (::poll(&wanted, 1, left) > 0) {
            std::array<char, 1 << 12> bytes{};
            const ssize_t length = ::recv(socket_, bytes.data(), bytes.size(), 0);
            if (length > 0) {
                received_.append(bytes.data(), static_cast<std::size_t>(length));
                continue;
            }
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
    if ((process_ < 0 && !start()) || !send(wanted)) {
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

RenderOptions optionsOf(const Order& json) {
    RenderOptions options;
    options.view = json.at("glman").get<bool>() ? ViewPolicy::glman : ViewPolicy::automatic;
    options.shim = json.at("shim").get<bool>();
    for (const Order& each : json.at("roots")) options.libraryRoots.emplace_back(each.get<std::string>());
    for (const Order& each : json.at("texts"))
        options.texts[each[0].get<std::string>()] = each[1].get<std::string>();
    if (json.contains("text")) options.sceneText = json["text"].get<std::string>();
    return options;
}

/// The scene that the process draws, and what it was drawn with last.
class Drawing {
  public:
    explicit Drawing(gpu::Context& context) : context_(context) {}

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
        if (Diagnostics problems =
                fit(target_, context_.capabilities(), width, height, gpu::TexelFormat::rgba8, samples);
            !target_)
            return problems;
        if (order.at("watchesLoops").get<bool>()) live_->watchLoops();
        ::alarm(kLongestDraw);
        sendMessage(kDrawingSocket, R"({"begins":true})");
        append(diagnostics, live_->draw(*target_, viewOf(order.at("view")), order.at("time").get<double>(),
                                        order.at("axes").get<bool>()));
        append(diagnostics, copyPicture());
        ::alarm(0);
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

    [[nodiscard]] Diagnostics copyPicture() const {
        Result<std::vector<std::byte>> rows =
            gpu::readPixels(context_.capabilities(), target_->readable(), 0,
                            {0, 0, target_->width(), target_->height()}, {4, gpu::TexelType::u8});
        if (!rows) return std::move(rows.diagnostics);
        void* const memory =
            ::mmap(nullptr, rows->size(), PROT_READ | PROT_WRITE, MAP_SHARED, kDrawingMemory, 0);
        if (memory == MAP_FAILED) return {diagnose("draw-E05", "out of memory")};
        const std::size_t row = static_cast<std::size_t>(target_->width()) * 4;
        auto* to = static_cast<std::byte*>(memory);
        for (std::size_t at = rows->size(); at > 0; at -= row, to += row)
            std::memcpy(to, rows->data() + at - row, row);
        ::munmap(memory, rows->size());
        return std::move(rows.diagnostics);
    }

    gpu::Context& context_;
    std::unique_ptr<render::LiveScene> live_;
    std::vector<render::Knob> knobs_;
    std::uint64_t loading_ = 0;
    std::optional<gpu::Target> target_;
    int samples_ = 0;
};

}  // namespace

std::string orderText(const DrawnState& state) {
    Order texts = Order::array(), knobs = Order::array(), roots = Order::array();
    for (const auto& [path, text] : state.options.texts) texts.push_back({path.string(), text});
    for (const std::filesystem::path& each : state.options.libraryRoots) roots.push_back(each.string());
    for (const render::Knob& each : state.knobs) knobs.push_back({each.title, each.tag, each.current});
    Order options{{"glman", state.options.view == ViewPolicy::glman},
                  {"shim", state.options.shim},
                  {"roots", roots},
                  {"texts", texts}};
    if (state.options.sceneText) options["text"] = *state.options.sceneText;
    const Order order{
        {"path", state.scene.string()}, {"loading", state.loading},
        {"options", options},           {"knobs", knobs},
        {"view", jsonOf(state.view)},   {"camera", state.camera},
        {"time", state.time},           {"axes", state.axes},
        {"wireframe", state.wireframe}, {"mouse", {state.mouseX, state.mouseY, state.isMouseDown}},
        {"width", state.width},         {"height", state.height},
        {"samples", state.samples},     {"watchesLoops", state.watchesLoops}};
    return order.dump(-1, ' ', false, Order::error_handler_t::replace);
}

int serveDrawing() {
    // The process belongs to the window, also while it draws and does not read the socket.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
    gpu::prepareEnvironment();
    Result<gpu::Context> context = gpu::openContext();
    if (!context) return kNoContext;
    Drawing drawing(*context);
    while (const std::optional<std::string> text = receiveMessage(kDrawingSocket)) {
        const Order order = Order::parse(*text, nullptr, false);
        if (!order.is_object()) return kNoContext;
        if (!sendMessage(kDrawingSocket, answerText(drawing.draw(order)))) break;
    }
    return 0;
}

}  // namespace glibra::view

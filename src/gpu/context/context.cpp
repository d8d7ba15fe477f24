#include "gpu/context/context.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/text.h"
#include "gpu/context/call_counter.h"
#include "gpu/context/es_functions.h"
#include "gpu/context/fork.h"
#include "system/places.h"

namespace glibra::gpu {

struct Context::State {
    DebugLog log;  // outlives the context, which calls back into it
    std::unique_ptr<Backend> backend;
    Capabilities capabilities;
    std::string howOpened;
    std::vector<std::string> failedWays;

    std::thread::id thread = std::this_thread::get_id();

    State();
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    /// Prepares the current context, which `backend` has adopted.
    Diagnostics useAdopted();
    ~State();
};

namespace {

/// A context that another library made and owns.
class AdoptedBackend final : public Backend {
  public:
    explicit AdoptedBackend(std::function<void*(const char*)> loader) : loader_(std::move(loader)) {}
    bool makeCurrent() override { return AdoptedBackend::isCurrent(); }
    [[nodiscard]] bool isCurrent() const override {
        return !adopted_ || adopted_->currentHandle() == adopted_->handle;
    }
    void* address(const char* function) override { return loader_ ? loader_(function) : nullptr; }
    [[nodiscard]] Driver driver() const override { return Driver::automatic; }
    [[nodiscard]] std::string description() const override { return "context of a window"; }

  private:
    std::function<void*(const char*)> loader_;
    std::optional<CurrentContext> adopted_ = currentContext();  ///< nothing: no library that is known has it
};

/// The table of GL functions is one for the process. A second context of the same driver, on whatever thread,
/// has the same functions, so that the table is not written while another thread draws.
struct Table {
    std::mutex mutex;
    std::string driver;                     ///< that the functions are of; empty: there are none yet
    std::vector<std::thread::id> contexts;  ///< the threads of those that exist

    [[nodiscard]] bool isUsedElsewhere() const {
        const std::thread::id here = std::this_thread::get_id();
        return std::ranges::any_of(contexts, [&](std::thread::id each) { return each != here; });
    }
};
Table table;

/// GL_VERSION of the current context.
std::string versionOf(Backend& backend) {
    const auto string = reinterpret_cast<PFNGLGETSTRINGPROC>(backend.address("glGetString"));
    const GLubyte* words = string != nullptr ? string(GL_VERSION) : nullptr;
    return words != nullptr ? reinterpret_cast<const char*>(words) : "no context";
}

/// What tells the driver of the current context from others. Drivers below one dispatching library share the
/// addresses of functions, but not the words.
std::string identityOf(Backend& backend) {
    const auto string = reinterpret_cast<PFNGLGETSTRINGPROC>(backend.address("glGetString"));
    if (string == nullptr) return {};
    std::string identity = std::to_string(reinterpret_cast<std::uintptr_t>(backend.address("glDrawArrays")));
    for (const GLenum each : std::array<GLenum, 3>{GL_VENDOR, GL_RENDERER, GL_VERSION})
        if (const GLubyte* words = string(each))
            identity += std::string(" ") + reinterpret_cast<const char*>(words);
    return identity;
}

/// Fills glad's table of functions from the current context, and has it watched by `log`. Returns why that
/// cannot be done, or nothing.
std::string loadFunctions(Backend& backend, DebugLog& log) {
    const std::lock_guard<std::mutex> lock(table.mutex);
    const std::string driver = identityOf(backend);
    if (driver.empty() || driver != table.driver || isCounting()) {
        if (driver != table.driver && table.isUsedElsewhere())
            return "another thread draws with another driver";
        leaveEs();
        const bool isLoaded =
            backend.driver() == Driver::gles
                ? loadEsFunctions([&](const char* function) { return backend.address(function); })
                : loadCoreFunctions(backend);
        if (!isCounting()) gladUninstallGLDebug();  // glad installs its wrappers by itself
        table.driver = isLoaded ? driver : std::string();
        if (!isLoaded) return "no OpenGL 4.1" + (driver.empty() ? "" : "; it is " + versionOf(backend));
    }
    watchDevice(log.places());
    return {};
}

/// What a user can do who has no driver of this kind.
std::string adviceFor(Driver driver) {
    if (driver == Driver::osmesa)
        return ". Mesa has no OSMesa from version 25.1 on; --driver egl draws the same pictures";
    return fmt::format(". {}", adviceWithoutDriver());
}

}  // namespace

Context::State::State() {
    noteDriver();
    const std::lock_guard<std::mutex> lock(table.mutex);
    table.contexts.push_back(thread);
}

Context::State::~State() {
    unwatchDevice(log.places());
    // An adopted context continues to exist.
    if (backend && backend->driver() == Driver::automatic && backend->isCurrent()) log.detach();
    backend.reset();
    const std::lock_guard<std::mutex> lock(table.mutex);
    table.contexts.erase(std::ranges::find(table.contexts, thread));
}

void prepareEnvironment(const ContextOptions& options) {
    // A value that the user has set is kept.
    if (options.floatFiltering) system::setVariable("GALLIVM_PERF", "no_aos_sampling", system::Replace::no);
}

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

void setInitialState() {
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glDisable(GL_DITHER);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

const Capabilities& Context::capabilities() const {
    return state_->capabilities;
}
DebugLog& Context::debugLog() const {
    return state_->log;
}
Driver Context::driver() const {
    return state_->backend->driver();
}
const std::string& Context::howOpened() const {
    return state_->howOpened;
}
const std::vector<std::string>& Context::failedWays() const {
    return state_->failedWays;
}

bool Context::isCurrent() const {
    return state_->backend->isCurrent();
}
bool Context::makeCurrent() {
    return state_->backend->makeCurrent() && loadFunctions(*state_->backend, state_->log).empty();
}

Diagnostics Context::adoptAgain(const std::function<void*(const char*)>& loader) {
    state_->backend = std::make_unique<AdoptedBackend>(loader);
    return state_->useAdopted();
}

Result<Context> openContext(const ContextOptions& options) {
    prepareEnvironment(options);
    std::vector<std::string> failures;
    for (const ContextWay& way : contextWays()) {
        const bool isAsked = options.driver == way.driver;
        if (!isAsked && (options.driver != Driver::automatic || way.driver == Driver::gles)) continue;
        Attempt attempt = way.open(options);
        if (auto* phrases = std::get_if<std::vector<std::string>>(&attempt)) {
            failures.insert(failures.end(), phrases->begin(), phrases->end());
            continue;
        }
        auto& backend = std::get<std::unique_ptr<Backend>>(attempt);
        auto state = std::make_unique<Context::State>();
        if (const std::string why = loadFunctions(*backend, state->log); !why.empty()) {
            failures.push_back(backend->description() + ": " + why);
            continue;
        }
        state->capabilities = readCapabilities(backend->driver() == Driver::osmesa);
        state->howOpened = backend->description();
        state->failedWays = std::move(failures);
        state->backend = std::move(backend);
        state->log.attach(state->capabilities.debugOutput);
        setInitialState();
        return Context(std::move(state));
    }
    if (failures.empty()) failures.push_back(fmt::format("{}: not on this system", word(options.driver)));
    return diagnose("gpu-E01",
                    fmt::format("no usable OpenGL driver (4.1 core or later is needed); tried: {}{}",
                                fmt::join(failures, "; "), adviceFor(options.driver)));
}

Diagnostics Context::State::useAdopted() {
    if (const std::string why = loadFunctions(*backend, log); !why.empty())
        return {diagnose("gpu-E01",
                         "no usable OpenGL driver (4.1 core or later is needed); the adopted "
                         "context: " +
                             why)};
    capabilities = readCapabilities(false);
    howOpened = backend->description();
    log.attach(capabilities.debugOutput);
    setInitialState();
    return {};
}

Result<Context> adopt(const std::function<void*(const char*)>& loader) {
    auto state = std::make_unique<Context::State>();
    state->backend = std::make_unique<AdoptedBackend>(loader);
    if (Diagnostics problems = state->useAdopted(); !problems.empty()) return problems;
    return Context(std::move(state));
}

namespace {

namespace fs = std::filesystem;

/// True if the variable holds what Mesa reads as yes, in upper or lower case.
bool mesaMustUseSoftware() {
    const char* value = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    const std::string word = base::lower(value ? value : "");
    constexpr std::array<std::string_view, 4> kYes{"1", "true", "y", "yes"};
    return std::ranges::find(kYes, word) != kYes.end();
}

}  // namespace

bool mayUseHardware(Driver driver, const fs::path& devices) {
    if (driver == Driver::osmesa) return false;
    const system::GraphicsCard card = system::graphicsCard(devices);
    if (card == system::GraphicsCard::ownDriver) return true;
    return card == system::GraphicsCard::mesa && !mesaMustUseSoftware();
}

int usualWorkers(Driver driver, std::size_t pieces, int processors, const fs::path& devices) {
    if (processors <= 1 || !mayUseHardware(driver, devices)) return std::max(1, processors);
    // n workers take n contexts and pieces / n scenes, which is least where both take as long.
    constexpr double kScenesPerContext = 4;
    constexpr double kMost = 4;  // as measured: 131 scenes take 3.0 s with 1, 1.03 with 4, 1.57 with 16
    const double best = std::round(std::sqrt(static_cast<double>(pieces) / kScenesPerContext));
    return static_cast<int>(std::clamp(best, 1., std::min<double>(kMost, processors)));
}

namespace {

std::string toText(const InfoEntry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) return *text;
    if (const auto* number = std::get_if<std::int64_t>(&entry.value)) return std::to_string(*number);
    if (const auto* truth = std::get_if<bool>(&entry.value)) return *truth ? "yes" : "no";
    return fmt::format("{:g}", std::get<double>(entry.value));
}

}  // namespace

std::vector<InfoEntry> describe(const Context& context) {
    const Capabilities& driver = context.capabilities();
    std::vector<InfoEntry> entries;
    const auto add = [&](std::string key, std::string label, auto value) {
        if (!label.empty()) entries.push_back({std::move(key), std::move(label), std::move(value)});
    };

    add("driver", "driver option", std::string(word(context.driver())));
    add("context", "opened as", context.howOpened());
    if (const auto& ways = context.failedWays(); !ways.empty())
        add("failed", "tried before", fmt::format("{}", fmt::join(ways, "; ")));
    add("vendor", "vendor", driver.vendor);
    add("renderer", "renderer", driver.renderer);
    add("family", "family", driver.family);
    add("version", "OpenGL", driver.version);
    add("shadingLanguage", "GLSL", driver.shadingLanguage);
    add("glslVersion", "shaders compiled as #version", driver.glslVersion);

#define GLIBRA_LIMIT(type, member, initial, since, name, words) add(#member, words, driver.member);
#define GLIBRA_COMPUTE_LIMIT(...)
#define GLIBRA_AXIS_LIMIT(...)
#include "gpu/context/limits.def"
    add("compute", "compute stages", driver.compute);
#define GLIBRA_LIMIT(...)
#define GLIBRA_COMPUTE_LIMIT(type, member, initial, since, name, words) \
    if (driver.compute) add(#member, words, driver.member);
#define GLIBRA_AXIS_LIMIT(member, since, name, words)                                  \
    for (std::size_t axis = 0; driver.compute && axis < 3; ++axis)                     \
        add(std::string(#member) + "XYZ"[axis], std::string(words ", ") + "xyz"[axis], \
            driver.member.at(axis));
#include "gpu/context/limits.def"
    add("wideLines", "lines wider than 1 pixel", driver.wideLines);
    add("maxLineWidth", "widest line, pixels", driver.maxLineWidth);
    add("maxPointSize", "largest point, pixels", driver.maxPointSize);
    add("debugOutput", "reports errors by callback", driver.debugOutput);
    add("parallelCompile", "compiles in its own threads", driver.parallelCompile);
    add("extensions", "extensions", static_cast<std::int64_t>(driver.extensions.size()));
    return entries;
}

std::string toText(const std::vector<InfoEntry>& entries) {
    std::size_t widest = 0;
    for (const InfoEntry& each : entries) widest = std::max(widest, each.label.size());
    std::string text;
    for (const InfoEntry& each : entries)
        text += each.label + ":" + std::string(widest - each.label.size() + 1, ' ') + toText(each) + "\n";
    return text;
}

}  // namespace glibra::gpu

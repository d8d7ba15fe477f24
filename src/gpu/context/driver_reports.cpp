#include "gpu/context/driver_reports.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/device_lost.h"
#include "gpu/context/call_counter.h"

namespace glibra::gpu {
namespace {

Severity severityOf(GLenum type, GLenum level) {
    if (type == GL_DEBUG_TYPE_ERROR || level == GL_DEBUG_SEVERITY_HIGH) return Severity::error;
    return level == GL_DEBUG_SEVERITY_MEDIUM ? Severity::warning : Severity::note;
}

// Debug output is synchronous, so the driver calls this on our own thread, inside the faulty call. No
// exception may pass through the driver's frames.
void GLAD_API_PTR receive(GLenum source, GLenum type, GLuint id, GLenum level, GLsizei length,
                          const GLchar* text, const void* log) noexcept {
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    DebugMessage message;
    message.severity = severityOf(type, level);
    if (text)
        message.text = length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length));
    while (!message.text.empty() && message.text.back() == '\n') message.text.pop_back();
    message.outOfMemory =
        type == GL_DEBUG_TYPE_ERROR &&
        (id == GL_OUT_OF_MEMORY || message.text.find("GL_OUT_OF_MEMORY") != std::string::npos);
    static_cast<DebugLog*>(const_cast<void*>(log))->add(std::move(message));
}

}  // namespace

void DebugLog::attach(bool hasDebugOutput) {
    callsBack_ = hasDebugOutput && glDebugMessageCallback && glDebugMessageControl;
    if (!callsBack_) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(receive, this);
    // Some drivers send a notification for every buffer; none of them concerns a scene's author.
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
}

void DebugLog::detach() {
    if (!callsBack_) return;
    glDebugMessageCallback(nullptr, nullptr);
    glDisable(GL_DEBUG_OUTPUT);
    callsBack_ = false;
}

void DebugLog::add(DebugMessage message) {
    if (messages_.size() >= kMost) return;
    message.place = places_.current();
    messages_.push_back(std::move(message));
}

void DebugLog::check(std::string_view what) {
    if (callsBack_) return;
    const GLenum code = takeError();
    if (code == GL_NO_ERROR) return;
    DebugMessage message;
    message.severity = Severity::error;
    message.text = errorName(code) + " in " + std::string(what);
    message.outOfMemory = code == GL_OUT_OF_MEMORY;
    add(std::move(message));
}

std::vector<DebugMessage> DebugLog::take() {
    return std::exchange(messages_, {});
}

Diagnostics DebugLog::takeDiagnostics() {
    expectDevice();
    // A driver that cannot tell of a reset makes calls fail. Errors of other kinds have called back.
    if (resetIsOnlyAnError()) callsBack_ ? clearErrors() : check("a call");
    Diagnostics diagnostics;
    for (DebugMessage& each : take()) {
        if (each.severity != Severity::error) continue;
        if (each.outOfMemory)
            diagnostics.push_back(
                diagnose("draw-E05", "out of memory on the graphics device", std::move(each.place)));
        else
            diagnostics.push_back(diagnose("gpu-E02", "OpenGL error: " + each.text, std::move(each.place)));
    }
    return diagnostics;
}

bool DebugLog::hasError() const {
    return std::ranges::any_of(messages_,
                               [](const DebugMessage& each) { return each.severity == Severity::error; });
}

namespace {

/// There is one for each thread, which has one context at a time.
struct Watched {
    WorkPlaces* places = nullptr;
    GLenum (*status)() = nullptr;           ///< null: the driver cannot tell
    std::optional<base::ResetCause> cause;  ///< of the reset; a driver may tell it only once
    int notWaiting = 0;                     ///< NothingFinished that live
};
thread_local Watched watched;

base::ResetCause causeOf(GLenum status) {
    if (status == GL_GUILTY_CONTEXT_RESET) return base::ResetCause::own;
    return status == GL_INNOCENT_CONTEXT_RESET ? base::ResetCause::other : base::ResetCause::unknown;
}

void refuse(base::ResetCause cause) {
    watched.cause = cause;
    // While an exception ends this work, nobody sees what else is read.
    if (std::uncaught_exceptions() > 0) return;
    base::DeviceLost lost;
    lost.cause = cause;
    if (watched.places != nullptr) {
        WorkPlaces::Unfinished unfinished = watched.places->unfinished();
        lost.place = std::move(unfinished.first);
        lost.lastLine = unfinished.lastLine;
    }
    throw lost;
}

/// What of the work before it has ended when a function returns.
enum class Waits { no, forAll };

void endCall(Waits waits) {
    expectDevice();
    if (waits == Waits::forAll && watched.notWaiting == 0 && watched.places != nullptr)
        watched.places->finish();
}

/// A function of the table that asks for a reset before it returns.
template <auto& kFunction, Waits kWaits, class = std::remove_cvref_t<decltype(kFunction)>>
struct Guarded;

template <auto& kFunction, Waits kWaits, class Returned, class... Arguments>
struct Guarded<kFunction, kWaits, Returned (*)(Arguments...)> {
    using Function = Returned (*)(Arguments...);
    static inline Function own = nullptr;  ///< the driver's

    static Returned call(Arguments... arguments) {
        if constexpr (std::is_void_v<Returned>) {
            own(arguments...);
            endCall(kWaits);
        } else {
            Returned value = own(arguments...);
            endCall(kWaits);
            return value;
        }
    }
    static void install() {
        if (kFunction == nullptr || kFunction == call) return;
        own = kFunction;
        kFunction = call;
    }
};

using GetError = GLenum (*)();
GetError ownGetError = nullptr;

/// A device that is lost may make any call fail; a lack of memory, above all, is reported then.
GLenum guardedGetError() {
    const GLenum code = ownGetError();
    if (code != GL_NO_ERROR) expectDevice();
    if (code == GL_CONTEXT_LOST) refuse(base::ResetCause::unknown);
    return code;
}

void guardFunctions() {
    Guarded<glad_glReadPixels, Waits::forAll>::install();
    Guarded<glad_glReadnPixels, Waits::forAll>::install();
    Guarded<glad_glGetTexImage, Waits::forAll>::install();
    Guarded<glad_glGetnTexImage, Waits::forAll>::install();
    Guarded<glad_glGetTextureImage, Waits::forAll>::install();
    Guarded<glad_glGetTextureSubImage, Waits::forAll>::install();
    Guarded<glad_glGetBufferSubData, Waits::forAll>::install();
    Guarded<glad_glGetNamedBufferSubData, Waits::forAll>::install();
    Guarded<glad_glMapBuffer, Waits::forAll>::install();
    Guarded<glad_glMapBufferRange, Waits::forAll>::install();
    Guarded<glad_glMapNamedBuffer, Waits::forAll>::install();
    Guarded<glad_glMapNamedBufferRange, Waits::forAll>::install();
    Guarded<glad_glUnmapBuffer, Waits::no>::install();
    Guarded<glad_glGetQueryObjectiv, Waits::no>::install();
    Guarded<glad_glGetQueryObjectuiv, Waits::no>::install();
    Guarded<glad_glGetQueryObjecti64v, Waits::no>::install();
    Guarded<glad_glGetQueryObjectui64v, Waits::no>::install();
    Guarded<glad_glGetUniformfv, Waits::no>::install();
    Guarded<glad_glGetUniformdv, Waits::no>::install();
    Guarded<glad_glGetUniformiv, Waits::no>::install();
    Guarded<glad_glGetUniformuiv, Waits::no>::install();
    Guarded<glad_glGetShaderInfoLog, Waits::no>::install();
    Guarded<glad_glGetProgramInfoLog, Waits::no>::install();
    Guarded<glad_glCheckFramebufferStatus, Waits::no>::install();
    Guarded<glad_glClientWaitSync, Waits::no>::install();
    Guarded<glad_glFinish, Waits::forAll>::install();
    if (glad_glGetError != guardedGetError) {
        ownGetError = glad_glGetError;
        glad_glGetError = guardedGetError;
    }
    if (!isCounting()) gladUninstallGLDebug();  // what is called are copies of the table
}

}  // namespace

void watchDevice(WorkPlaces& places) {
    watched = {&places, glad_glGetGraphicsResetStatus, std::nullopt, 0};
    if (watched.status == nullptr) watched.status = glad_glGetGraphicsResetStatusARB;
    guardFunctions();
}

void unwatchDevice(const WorkPlaces& places) {
    if (watched.places == &places) watched = {};
}

bool resetIsOnlyAnError() {
    return watched.places != nullptr && watched.status == nullptr;
}

NothingFinished::NothingFinished() {
    ++watched.notWaiting;
}

NothingFinished::~NothingFinished() {
    --watched.notWaiting;
}

void expectDevice() {
    if (watched.cause) return refuse(*watched.cause);
    const GLenum status = watched.status != nullptr ? watched.status() : GL_NO_ERROR;
    if (status != GL_NO_ERROR) refuse(causeOf(status));
}

}  // namespace glibra::gpu

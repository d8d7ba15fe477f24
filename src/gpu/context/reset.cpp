#include "gpu/context/reset.h"

#include <exception>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/device_lost.h"
#include "gpu/context/call_counter.h"

namespace glibra::gpu {
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

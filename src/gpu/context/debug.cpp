#include "gpu/context/debug.h"

#include <algorithm>
#include <utility>

#include "gpu/context/errors.h"
#include "gpu/context/reset.h"

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

}  // namespace glibra::gpu

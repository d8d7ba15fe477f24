#include "glib/message_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "glib/text.h"

namespace glibra::glib {

void MessageLog::report(const char* id, std::string text, Position position) {
    const bool isError = severityOf(id) == Severity::error;
    ++count_;
    if (isError) ++errors_;
    const bool kept = kept_.size() < kMostMessages;
    if (!kept && (!isError || firstCutError_)) return;
    Diagnostic message = diagnose(id, std::move(text), {path_, position.line, position.column});
    if (kept) {
        if (isError) ++keptErrors_;
        kept_.push_back(std::move(message));
    } else {
        firstCutError_ = std::move(message);
    }
}

Diagnostics MessageLog::take() {
    const auto byPlace = [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    };
    std::stable_sort(kept_.begin(), kept_.end(), byPlace);
    if (keptErrors_ == 0 && firstCutError_) {
        kept_.back() = std::move(*firstCutError_);
        keptErrors_ = 1;
    }
    if (count_ > kept_.size()) {
        std::string text = fmt::format("{} not shown", counted(count_ - kept_.size(), "more message"));
        const std::size_t cutErrors = errors_ - keptErrors_;
        if (cutErrors > 0) text += fmt::format(", {} of them", counted(cutErrors, "error"));
        const Place last = kept_.back().place;
        kept_.push_back({Severity::note, "", std::move(text), last});
    }
    return std::move(kept_);
}

}  // namespace glibra::glib

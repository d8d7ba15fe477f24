#pragma once
// Collects the messages of one translation, up to a limit.

#include <glibra/diagnostic.h>

#include <set>
#include <string>
#include <utility>

namespace glibra::glsl {

class Report {
  public:
    void report(std::string id, std::string text, Place place) {
        report(diagnose(std::move(id), std::move(text), std::move(place)));
    }
    void report(Diagnostic diagnostic) {
        const bool isError = diagnostic.severity == Severity::error;
        // A source can contain a million mistakes of one kind. The first error is always kept.
        if (diagnostics_.size() < kMost || (isError && !failed_))
            diagnostics_.push_back(std::move(diagnostic));
        failed_ = failed_ || isError;
    }
    /// Reports it only the first time for this `key`.
    void reportOnce(const std::string& key, std::string id, std::string text, Place place) {
        if (seen_.insert(id + key).second) report(std::move(id), std::move(text), std::move(place));
    }
    [[nodiscard]] bool failed() const { return failed_; }
    Diagnostics take() { return std::move(diagnostics_); }

  private:
    static constexpr std::size_t kMost = 1000;
    Diagnostics diagnostics_;
    std::set<std::string> seen_;
    bool failed_ = false;
};

}  // namespace glibra::glsl

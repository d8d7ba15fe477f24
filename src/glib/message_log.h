#pragma once
// Where the parser's stages put their messages: in memory bounded by the catalogue's rule of 100 messages a
// file.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <optional>
#include <string>

#include "glib/script.h"

namespace glibra::glib {

/// At most so many messages of one file are kept (language, 10).
inline constexpr std::size_t kMostMessages = 100;

class MessageLog {
  public:
    explicit MessageLog(std::string path) : path_(std::move(path)) {}

    void error(const char* id, std::string text, Position position) {
        add(Severity::error, id, std::move(text), position);
    }
    void warning(const char* id, std::string text, Position position) {
        add(Severity::warning, id, std::move(text), position);
    }

    /// True if a further error would only be counted, so that its text need not be made.
    [[nodiscard]] bool isFull() const { return kept_.size() >= kMostMessages && firstCutError_; }

    /// Errors reported so far, kept or not.
    [[nodiscard]] std::size_t errorCount() const { return errors_; }

    /// The messages in the order of their places. If some were not kept, the first error among them takes the
    /// place of the last warning where no other error is left, and a note without id tells how many are
    /// missing.
    Diagnostics take();

  private:
    void add(Severity severity, const char* id, std::string text, Position position);

    std::string path_;
    Diagnostics kept_;
    std::optional<Diagnostic> firstCutError_;
    std::size_t errors_ = 0;
    std::size_t keptErrors_ = 0;
    std::size_t count_ = 0;
};

}  // namespace glibra::glib

#pragma once
// The messages of glibra: the catalogue of all, and those about one scene file.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glib/script.h"

namespace glibra::glib {

// All messages of glibra, one row per id (language, 10). The families are: glib scene text and statements,
// expr expressions, draw drawing, memory buffers with what writes them, glsl shaders, file assets, gpu the
// graphics driver, library the C++ library, check the Expect statements of a scene, suite suites of shots,
// result their results, bench run time against error, page live pages, view the window. The letter is the
// severity: E error, W warning, N note. An id has one meaning, which never changes. The rows stand in
// messages.txt.

struct CatalogueRow {
    std::string_view id;       ///< for example "glib-W04"
    std::string_view meaning;  ///< a sentence that is true of all texts of the message
    std::string_view example;  ///< a possible text of the message, without place and severity

    [[nodiscard]] constexpr Severity severity() const { return severityOf(id); }
};

/// All rows, by family; in a family errors, then warnings, then notes, each with rising numbers.
std::span<const CatalogueRow> diagnosticCatalogue();

/// Returns the row of an id; null if there is none.
const CatalogueRow* findDiagnostic(std::string_view id);

// Collects the messages about one scene file. At most 100 are kept, so memory is bounded.

struct Expectation {
    enum class Kind { word, number, value, expression, color, components, list, other };
    Kind kind = Kind::other;
    std::string text;    ///< as messages say it
    std::string name{};  ///< the word itself, for a key or one of several words; else empty

    /// True if an argument that begins with this word may be it.
    [[nodiscard]] bool mayBegin(std::string_view word) const;
};

/// The largest number of messages that are kept for one file (language, 10).
inline constexpr std::size_t kMostMessages = 100;

class MessageLog {
  public:
    explicit MessageLog(std::string path) : path_(std::move(path)) {}

    void report(const char* id, std::string text, Position position);
    void report(Diagnostic message);
    /// Reports that a statement ends too early: `missing` is what it could have gone on with.
    void report(const char* id, std::string text, Position position, std::vector<Expectation> missing);
    /// Keeps a message that the scene asks for, such as those of Verbose, beside the 100.
    void keep(Diagnostic message) { kept_.push_back(std::move(message)); }

    /// True if a further error would only be counted, so its text is not needed.
    [[nodiscard]] bool isFull() const { return counted_ >= kMostMessages && firstCutError_; }

    /// The last message that was kept; null if there is none.
    [[nodiscard]] Diagnostic* last() { return kept_.empty() ? nullptr : &kept_.back(); }

    /// What the statement of the last message could have gone on with where it ends too early; else empty.
    [[nodiscard]] const std::vector<Expectation>& lastMissing() const { return missing_; }

    /// Errors reported so far, kept or not.
    [[nodiscard]] std::size_t errorCount() const { return errors_; }

    /// Returns the messages in the order of their places. If some were not kept, a note without id gives
    /// their number; and if no kept message is an error but one of the others is, the first such error
    /// replaces the last kept warning.
    Diagnostics take();

  private:
    std::string path_;
    Diagnostics kept_;
    std::vector<Expectation> missing_;  ///< of the last message
    std::optional<Diagnostic> firstCutError_;
    std::size_t counted_ = 0;  ///< those of kept_ that the limit counts
    std::size_t errors_ = 0;
    std::size_t keptErrors_ = 0;
    std::size_t count_ = 0;
};

}  // namespace glibra::glib

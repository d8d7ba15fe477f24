#pragma once
// A message about a scene: a text with a place, a severity and an id. An id never changes its meaning.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glibra {

enum class Severity { note, warning, error };

/// A place in a file. Lines and columns count from 1; a column is a byte, and a tab is one column.
struct Place {
    std::string file;
    int line = 1;
    int column = 1;

    friend bool operator==(const Place&, const Place&) = default;
};

/// One message. `id` is the id in the catalogue without brackets, for example "glib-W04".
struct Diagnostic {
    Severity severity = Severity::error;
    std::string id;
    std::string text;
    Place place;
    // For code that reacts to messages, which must not read the text. Both are empty where nothing needs
    // them.
    std::string subject = {};     ///< the name that the text is about: a uniform, an input, a file
    std::string suggestion = {};  ///< the name that the text proposes in its place
};

using Diagnostics = std::vector<Diagnostic>;

/// The severity of an id: the letter after the dash, E, W or N.
constexpr Severity severityOf(std::string_view id) {
    const std::size_t dash = id.find('-');
    const char letter = dash + 1 < id.size() ? id[dash + 1] : 'E';
    return letter == 'W' ? Severity::warning : letter == 'N' ? Severity::note : Severity::error;
}

/// Makes a message; the id decides its severity.
inline Diagnostic diagnose(std::string id, std::string text, Place place = {}) {
    const Severity severity = severityOf(id);
    return {severity, std::move(id), std::move(text), std::move(place)};
}

/// The same message with the name that it is about, and the one that it proposes in its place.
inline Diagnostic about(Diagnostic message, std::string subject, std::string suggestion = {}) {
    message.subject = std::move(subject);
    message.suggestion = std::move(suggestion);
    return message;
}

/// Makes a message that has no id, such as "7 more messages not shown".
inline Diagnostic withoutId(Severity severity, std::string text, Place place = {}) {
    return {severity, {}, std::move(text), std::move(place)};
}

/// True if any message is an error.
inline bool hasError(const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics)
        if (each.severity == Severity::error) return true;
    return false;
}

/// Moves all of `more` to the end of `diagnostics`.
inline void append(Diagnostics& diagnostics, Diagnostics more) {
    for (Diagnostic& each : more) diagnostics.push_back(std::move(each));
}

/// "error", "warning" or "note".
inline const char* name(Severity severity) {
    switch (severity) {
        case Severity::note:
            return "note";
        case Severity::warning:
            return "warning";
        case Severity::error:
            break;
    }
    return "error";
}

/// Returns `file:line:col: severity: text [id]` without a line end. The place is omitted if it has no file.
inline std::string toString(const Diagnostic& diagnostic) {
    std::string line;
    if (!diagnostic.place.file.empty())
        line = diagnostic.place.file + ":" + std::to_string(diagnostic.place.line) + ":" +
               std::to_string(diagnostic.place.column) + ": ";
    line += name(diagnostic.severity);
    line += ": " + diagnostic.text;
    if (!diagnostic.id.empty()) line += " [" + diagnostic.id + "]";
    return line;
}

}  // namespace glibra

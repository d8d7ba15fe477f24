#pragma once
// All messages of glibra, one row per id (language, 10). The families are: glib scene text and statements,
// expr expressions, draw drawing, memory buffers with what writes them, glsl shaders, file assets, gpu the
// graphics driver, library the C++ library, check the Expect statements of a scene, suite suites of shots,
// result their results, bench run time against error, page live pages, view the window. The letter is the
// severity: E error, W warning, N note. An id has one meaning, which never changes. The rows stand in
// messages.txt.

#include <glibra/diagnostic.h>

#include <span>
#include <string_view>

namespace glibra::glib {

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

}  // namespace glibra::glib

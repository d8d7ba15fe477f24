#pragma once
// Every message glibra knows, one row an id, of all families (language, section 10): glib scene text and
// statements, draw drawing, glsl shaders, file assets, gpu the graphics driver, suite suites of shots,
// result what became of them, bench run time against error, view the window. Ids never change meaning.

#include <glibra/diagnostic.h>

#include <span>
#include <string_view>

namespace glibra::glib {

struct CatalogueRow {
    std::string_view id;  ///< for example "glib-W04"
    Severity severity = Severity::error;
    std::string_view example;  ///< a text as it may be printed, without place and severity
};

/// In the order of families, errors before warnings before notes, rising numbers.
std::span<const CatalogueRow> diagnosticCatalogue();

/// The row of an id; null if there is none.
const CatalogueRow* findDiagnostic(std::string_view id);

}  // namespace glibra::glib

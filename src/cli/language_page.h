#pragma once
// The parts of the documentation that are generated from the program's tables.

#include <optional>
#include <string>
#include <string_view>

namespace glibra::cli {

/// The content of one section, as Markdown that ends with a line end. Sections: commands, primitives,
/// formats, supplied, diagnostics, options (of a picture). Nothing for another name.
std::optional<std::string> generatedSection(std::string_view name);

/// All sections, each between its two marker lines:
///
///     <!-- generated: commands -->
///     ...
///     <!-- end -->
std::string generatedSections();

struct RefreshedPage {
    std::string text;
    std::string problem;  ///< what is wrong with the markers, with the line; empty if nothing is
};

/// A page with the content of all its generated sections replaced by the present one. A page needs only the
/// sections that it wants; everything outside the markers stays as it is.
RefreshedPage refreshed(std::string_view page);

}  // namespace glibra::cli

#include "glib/diagnostic_catalogue.h"

#include <algorithm>
#include <vector>

#include "base/lines.h"
#include "embedded/messages.h"

namespace glibra::glib {
namespace {

std::vector<CatalogueRow> rowsOf(std::string_view text) {
    constexpr std::string_view kBeforeExample = "    ";
    std::vector<CatalogueRow> rows;
    while (!text.empty()) {
        const std::string_view line = base::nextLine(text);
        if (line.starts_with(kBeforeExample))
            rows.back().example = line.substr(kBeforeExample.size());
        else if (!line.empty() && line.front() != '#')
            rows.push_back({line.substr(0, line.find(' ')), line.substr(line.find(' ') + 1), {}});
    }
    return rows;
}

}  // namespace

std::span<const CatalogueRow> diagnosticCatalogue() {
    static const std::vector<CatalogueRow> kRows = rowsOf(messages::messages_txt());
    return kRows;
}

const CatalogueRow* findDiagnostic(std::string_view id) {
    for (const CatalogueRow& row : diagnosticCatalogue())
        if (row.id == id) return &row;
    return nullptr;
}

}  // namespace glibra::glib

#include "glib/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/text.h"
#include "embedded/messages.h"
#include "glib/text.h"

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

namespace {

bool beginsNumber(std::string_view word) {
    const std::size_t at = word.find_first_not_of("+-.");
    return at < 3 && isDigit(word[at]);
}

}  // namespace

bool Expectation::mayBegin(std::string_view word) const {
    if (beginsNumber(word) || word.starts_with('('))
        return kind == Kind::number || kind == Kind::value || kind == Kind::expression;
    if (word.starts_with('{')) return kind == Kind::color || kind == Kind::components || kind == Kind::value;
    if (word.starts_with('[')) return kind == Kind::list || kind == Kind::components || kind == Kind::value;
    if (word.starts_with('<')) return kind == Kind::value;
    return !word.empty() && word == name;
}

void MessageLog::report(const char* id, std::string text, Position position) {
    report(diagnose(id, std::move(text), {path_, position.line, position.column}));
}

void MessageLog::report(Diagnostic message) {
    const bool isError = message.severity == Severity::error;
    ++count_;
    missing_.clear();
    if (isError) ++errors_;
    if (counted_ < kMostMessages) {
        ++counted_;
        if (isError) ++keptErrors_;
        kept_.push_back(std::move(message));
    } else if (isError && !firstCutError_) {
        firstCutError_ = std::move(message);
    }
}

void MessageLog::report(const char* id, std::string text, Position position,
                        std::vector<Expectation> missing) {
    report(id, std::move(text), position);
    missing_ = std::move(missing);
}

Diagnostics MessageLog::take() {
    const auto byPlace = [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    };
    std::ranges::stable_sort(kept_, byPlace);
    if (keptErrors_ == 0 && firstCutError_) {
        const auto last = std::find_if(kept_.rbegin(), kept_.rend(), [](const Diagnostic& each) {
            return each.severity == Severity::warning;
        });
        (last != kept_.rend() ? *last : kept_.back()) = std::move(*firstCutError_);
        keptErrors_ = 1;
    }
    if (count_ > counted_) {
        std::string text = fmt::format("{} not shown", base::counted(count_ - counted_, "more message"));
        const std::size_t cutErrors = errors_ - keptErrors_;
        if (cutErrors > 0) text += fmt::format(", {} of them", base::counted(cutErrors, "error"));
        const Place last = kept_.back().place;
        kept_.push_back({Severity::note, "", std::move(text), last});
    }
    return std::move(kept_);
}

}  // namespace glibra::glib

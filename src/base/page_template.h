#pragma once
// Texts that are made by filling a template: pages, manual pages, completions of shells, grammars of editors.
//
//   {{name}}                  the text of that name, escaped; nothing if there is none
//   {{{name}}}                the text as it is
//   {{#name}}...{{/name}}     once for each row of that name; or once if its text is not empty
//   {{?name}}...{{/?name}}    once, if it has rows or a text
//   {{^name}}...{{/name}}     if it has neither
//   {{=name}}...{{/name}}     a part, which is left out here
//   {{>name}}                 that part
//
// What stands in rows is looked up in the row first, then around it; {{^first}} leaves out what the first row
// does not have, as a comma. A block holds no block of the same kind and name. A line with nothing but a tag
// of a block or a part is not a line of the text. Texts that are put in are not searched for tags.

#include <fmt/format.h>

#include <concepts>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"

namespace glibra::base {

struct Field;
using Fields = std::vector<Field>;

/// A name of a template, and its text or rows.
struct Field {
    Field(std::string_view fieldName, std::string value) : name(fieldName), text(std::move(value)) {}
    Field(std::string_view fieldName, std::string_view value) : name(fieldName), text(value) {}
    Field(std::string_view fieldName, const char* value) : name(fieldName), text(value) {}
    /// Of a condition: a text, or none.
    Field(std::string_view fieldName, bool value) : name(fieldName), text(value ? "true" : "") {}
    Field(std::string_view fieldName, std::integral auto value)
        : name(fieldName), text(std::to_string(value)) {}
    Field(std::string_view fieldName, double value) : name(fieldName), text(fmt::format("{:g}", value)) {}
    Field(std::string_view fieldName, std::vector<Fields> value) : name(fieldName), rows(std::move(value)) {}
    /// Rows whose text is {{.}}.
    Field(std::string_view fieldName, std::span<const std::string> value);

    std::string_view name;
    std::string text{};
    std::vector<Fields> rows{};
};

inline void append(Fields& fields, const Fields& more) {
    fields.insert(fields.end(), more.begin(), more.end());
}

/// The fields that `fieldsOf` makes of each value of a range, or of an optional value.
template <class Values, class FieldsOf>
std::vector<Fields> rowsOf(Values&& values, const FieldsOf& fieldsOf) {
    std::vector<Fields> rows;
    if constexpr (requires { values.has_value(); }) {
        if (values) rows.push_back(fieldsOf(*values));
    } else {
        for (const auto& each : values) rows.push_back(fieldsOf(each));
    }
    return rows;
}

/// Rows of titles and texts, without those whose text is empty.
std::vector<Fields> titledRows(std::initializer_list<std::pair<const char*, std::string>> texts);

/// How many of `count` are left out if `most` are shown: "12", or nothing.
inline std::string leftOut(std::size_t count, std::size_t most) {
    return count > most ? std::to_string(count - most) : std::string();
}

/// Returns the template with its tags replaced. `escape` is applied to each {{name}}.
std::string filled(std::string_view page, const Fields& fields,
                   std::string (*escape)(std::string_view) = escapeXml);

}  // namespace glibra::base

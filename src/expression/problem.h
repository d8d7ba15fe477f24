#pragma once
// What is wrong with an expression, and where. Every problem is an error with an id of the family expr:
//
//   expr-E01  the text is not an expression          expr-E05  too long or too deeply nested
//   expr-E02  unknown name, function or field        expr-E06  the value cannot be computed
//   expr-E03  wrong type                             expr-E07  a name has no value here
//   expr-E04  wrong number of arguments              expr-E08  a name or value is something else
//   expr-E09  a function of the scene calls itself, or one that is declared after it

#include <glibra/diagnostic.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace glibra::expression {

/// Bytes [begin, end) of the expression's text.
struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    friend bool operator==(const Range&, const Range&) = default;
};

/// A message with the place of the first byte that it is about, and all bytes that it is about.
struct Problem {
    Diagnostic message;
    Range range;
};

/// A value, or the problem that prevented it.
template <class T>
struct Checked {
    std::optional<T> value;
    Problem problem;

    Checked(T good) : value(std::move(good)) {}
    Checked(Problem bad) : problem(std::move(bad)) {}

    explicit operator bool() const { return value.has_value(); }
    T& operator*() { return *value; }
    const T& operator*() const { return *value; }
    T* operator->() { return &*value; }
    const T* operator->() const { return &*value; }
};

/// The place of a byte of `text`, whose first byte is at `origin`. Lines end as in scenes: LF, CR LF or CR.
Place placeAt(std::string_view text, std::size_t offset, const Place& origin);

/// The bytes of a range in single quotes. A long text is cut in its middle.
std::string quoted(std::string_view text, Range range);

}  // namespace glibra::expression

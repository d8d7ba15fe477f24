#pragma once
// Private to this room: the values of the arguments of modern statements.

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/expression.h"
#include "glib/value.h"

namespace glibra::scene {

struct Interpreter;

/// The expressions of a script, each read once.
struct ExpressionCache {
    struct Entry {
        std::optional<expression::Expression>
            expression;                  ///< nothing if it is wrong, which has been reported
        bool isProblemReported = false;  ///< a problem of its evaluation
    };
    std::map<const glib::Value*, Entry> entries;
};

/// Evaluates an expression where it stands. Nothing with the problem reported, once for each expression.
std::optional<expression::Value> evaluate(Interpreter&, const glib::Value& value,
                                          const expression::Wanted& wanted = {});

/// One number; an expression must be a number.
std::optional<double> numberOf(Interpreter&, const glib::Value& value);
/// A condition: `true`, a number other than 0, or an expression that is a boolean or a number.
std::optional<bool> truthOf(Interpreter&, const glib::Value& value);

/// The numbers of several values in order. A vector or matrix gives as many as it has components. Nothing if
/// an expression has no value; a word or a text among the values is skipped by the parser and never arrives
/// here.
std::optional<std::vector<double>> numbersOf(Interpreter&, std::span<const glib::Value> values);

/// Like numbersOf, for `count` numbers. Reports glib-E04 for fewer, glib-W07 never: more are an error
/// (glib-E24).
std::optional<std::vector<double>> numbersOf(Interpreter&, std::span<const glib::Value> values,
                                             std::size_t count, std::string_view what);

}  // namespace glibra::scene

#pragma once
// The parts of a draw's state that can be tried with another value, as the words of the statement `State`
// (language, 12.6).

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/raster_state.h"

namespace glibra::view {

/// A key of `State` with its words.
struct StateChoice {
    std::string_view key;
    std::vector<std::string_view> words;
    /// The index of the word that the state has; words.size(): it has none of them.
    std::size_t (*wordOf)(const base::RasterState&);
    /// Gives the state the word of that index.
    void (*choose)(base::RasterState&, std::size_t);
};

/// In the order of the language's table. `blend` and `write` are those of all colour targets.
std::span<const StateChoice> stateChoices();

/// The statement that makes the state `to` of the state `from`, "State depth less  offset 2 4"; empty if
/// these parts are equal.
std::string stateStatement(const base::RasterState& from, const base::RasterState& to);

}  // namespace glibra::view

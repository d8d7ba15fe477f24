#pragma once
// What is wrong with a text that is not TOML, in words for those who wrote it.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::suite {

/// What toml++ said is wrong at that offset of the text, without its preamble; and what to write instead,
/// where it is one of the mistakes that people make.
std::string syntaxMessage(std::string_view said, std::string_view text, std::size_t offset);

/// The offset of the first key with more parts ("a.b.c") than anybody needs, if there is one. The parser
/// makes a table of each part and is done with them by recursion, which a key of 100,000 parts would not
/// survive.
std::optional<std::size_t> endlessKey(std::string_view text);

}  // namespace glibra::suite

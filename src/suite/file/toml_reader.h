#pragma once
// A TOML file read with the place of every mistake: syntax, types and ranges.

#include <glibra/diagnostic.h>
#include <toml++/toml.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::suite {

/// One "key = value" with its places.
struct TomlEntry {
    std::string key;
    Place keyPlace;
    const toml::node* value = nullptr;
};

/// Reads values of one file and keeps what is wrong with them. Functions that return an optional have
/// reported why there is none; `name` is what messages call the value.
class TomlReader {
  public:
    TomlReader(std::string path, std::string_view text);

    /// The whole file; nothing (and suite-E01) if it is not TOML. Valid as long as the reader.
    const toml::table* root();

    /// Keys and values of a table in the order of the file.
    [[nodiscard]] std::vector<TomlEntry> entries(const toml::table& table) const;

    [[nodiscard]] Place placeOf(const toml::node& node) const { return place(node.source().begin); }

    std::optional<bool> truth(const toml::node& node, std::string_view name);
    /// low <= value <= high, a whole number or not.
    std::optional<double> number(const toml::node& node, std::string_view name, double low, double high);
    std::optional<int> whole(const toml::node& node, std::string_view name, int low, int high);
    /// Not empty.
    std::optional<std::string> text(const toml::node& node, std::string_view name);
    /// One text or a list of them; a list is not empty.
    std::optional<std::vector<std::string>> texts(const toml::node& node, std::string_view name);
    const toml::table* table(const toml::node& node, std::string_view name);

    /// suite-E02, with the nearest of the keys there are.
    void unknownKey(const TomlEntry& entry, std::string_view where, std::span<const std::string_view> keys);
    /// suite-E03: "name: `wanted` is wanted, not 'x'".
    void wrongType(const toml::node& node, std::string_view name, std::string_view wanted);
    void error(const char* id, std::string text, Place place);

    [[nodiscard]] std::size_t errorCount() const { return count_; }
    [[nodiscard]] bool hasErrors() const { return count_ > 0; }
    /// All messages in the order of their places, at most 100 and a note that counts the rest.
    Diagnostics take();

  private:
    [[nodiscard]] Place place(const toml::source_position& position) const;
    [[nodiscard]] std::size_t charactersBefore(std::size_t offset) const;

    std::string path_;
    std::string_view text_;
    std::vector<std::size_t> lines_;   // offsets of their first bytes
    std::vector<std::size_t> blocks_;  // characters before every block of bytes
    std::optional<toml::table> root_;
    Diagnostics problems_;
    std::size_t count_ = 0;
};

/// "the text 'big'", "the number 3", "a list", as messages name what stands there.
std::string described(const toml::node& node);

}  // namespace glibra::suite

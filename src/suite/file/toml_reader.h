#pragma once
// Reads a TOML file and reports every mistake with its place: syntax, types and ranges.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace glibra::suite {

/// Where something begins, in characters of UTF-8 (TomlReader::placeOf counts bytes); line 0: nowhere.
struct TomlPosition {
    std::uint32_t line = 0, column = 0;
    friend auto operator<=>(const TomlPosition&, const TomlPosition&) = default;
};

struct TomlValue;
struct TomlEntry;
struct TomlDate {};  ///< a date or a time, which suites do not use
using TomlList = std::vector<TomlValue>;
using TomlTable = std::vector<TomlEntry>;  ///< in the order of the file

/// A value of the file.
struct TomlValue {
    std::variant<TomlDate, bool, std::int64_t, double, std::string, TomlList, TomlTable> content;
    TomlPosition position;

    /// The content, or null if it has another type.
    template <class T>
    [[nodiscard]] const T* as() const {
        return std::get_if<T>(&content);
    }
};

/// One "key = value".
struct TomlEntry {
    std::string key;
    TomlPosition position;  ///< of the key
    TomlValue value;
};

/// Reads values of one file and keeps what is wrong with them. Functions that return an optional or a pointer
/// have reported why there is nothing; `name` is what messages call the value.
class TomlReader {
  public:
    TomlReader(std::string path, std::string_view text);

    /// The table that is the whole file; null (and suite-E01) if it is not TOML. Valid as long as the reader.
    const TomlTable* root();

    [[nodiscard]] Place placeOf(const TomlPosition& position) const;
    [[nodiscard]] Place placeOf(const TomlValue& value) const { return placeOf(value.position); }

    std::optional<bool> truth(const TomlValue& value, std::string_view name);
    /// low <= value <= high, a whole number or not.
    std::optional<double> number(const TomlValue& value, std::string_view name, double low, double high);
    std::optional<int> whole(const TomlValue& value, std::string_view name, int low, int high);
    /// Not empty.
    std::optional<std::string> text(const TomlValue& value, std::string_view name);
    /// One text or a list of them; a list is not empty.
    std::optional<std::vector<std::string>> texts(const TomlValue& value, std::string_view name);
    const TomlTable* table(const TomlValue& value, std::string_view name);

    /// suite-E02, with the nearest of the known keys.
    void unknownKey(const TomlEntry& entry, std::string_view where, std::span<const std::string_view> keys);
    /// suite-E03: "NAME: expected EXPECTED, found the text 'x'".
    void wrongType(const TomlValue& value, std::string_view name, std::string_view expected);
    void report(const char* id, const std::string& text, Place place);
    void report(const char* id, const std::string& text, const TomlPosition& position) {
        report(id, text, placeOf(position));
    }
    void report(const char* id, const std::string& text, const TomlValue& value) {
        report(id, text, placeOf(value));
    }

    [[nodiscard]] std::size_t errorCount() const { return count_; }
    [[nodiscard]] bool hasErrors() const { return count_ > 0; }
    /// Returns all messages in the order of their places: at most 100, and a note with the number of the
    /// others.
    Diagnostics take();

  private:
    [[nodiscard]] std::size_t charactersBefore(std::size_t offset) const;

    std::string path_;
    std::string_view text_;
    std::vector<std::size_t> lines_;   // offsets of their first bytes
    std::vector<std::size_t> blocks_;  // characters before every block of bytes
    std::optional<TomlValue> root_;
    Diagnostics problems_;
    std::size_t count_ = 0;
};

/// True if the table has the key.
bool hasKey(const TomlTable& table, std::string_view key);

/// "the text 'big'", "the number 3", "a list", as messages name a value.
std::string described(const TomlValue& value);

}  // namespace glibra::suite

#pragma once
// The messages about one model file. Their number is limited however damaged the file is.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace glibra::geometry {

/// Returns a text of the file in a form that a message can show: at most 40 bytes, control bytes replaced.
std::string shown(std::string_view text);

/// Returns the last part of a path.
std::string_view fileName(std::string_view path);

class FileRemarks {
  public:
    explicit FileRemarks(std::string path) : path_(std::move(path)) {}

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] Place place(int line, int column) const { return {path_, line, column}; }

    /// Adds a warning at that place. From the 101st warning with the same id on they are only counted.
    void warn(std::string_view id, std::string_view text, int line, int column);

    /// Counts a statement that is ignored; finish() gives one file-W04 per word.
    void ignored(std::string_view word, int line, int column);

    /// Returns all messages in the order of the file, then one per id whose messages were only counted.
    [[nodiscard]] Diagnostics finish() &&;

  private:
    struct Ignored {
        std::size_t count = 0;
        int line = 1, column = 1;
    };
    std::string path_;
    Diagnostics warnings_;
    std::map<std::string, std::size_t, std::less<>> warningCounts_;  // by id
    std::map<std::string, Ignored, std::less<>> ignored_;            // by word, at most a hundred
    std::size_t otherIgnored_ = 0;
};

}  // namespace glibra::geometry

#pragma once
// The messages about one model file, limited in number however damaged the file is.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace glibra::geometry {

/// A text of the file as it may be shown in a message: at most 40 bytes, control bytes replaced.
std::string shown(std::string_view text);

/// The last part of a path.
std::string_view fileName(std::string_view path);

/// 1234567 as 1,234,567.
std::string grouped(unsigned long long number);

class FileRemarks {
  public:
    explicit FileRemarks(std::string path) : path_(std::move(path)) {}

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] Place place(int line, int column) const { return {path_, line, column}; }

    /// A warning at that place. From the 101st of an id on they are only counted.
    void warn(std::string_view id, std::string_view text, int line, int column);

    /// Counts a statement that is ignored; there will be one file-W04 a word.
    void ignored(std::string_view word, int line, int column);

    /// All of them in the order of the file, then the numbers of those that were only counted.
    [[nodiscard]] Diagnostics finish() &&;

  private:
    struct Ignored {
        std::size_t count = 0;
        int line = 1, column = 1;
    };
    std::string path_;
    Diagnostics warnings_;
    std::map<std::string, std::size_t, std::less<>> warningCounts_;  // by id
    std::map<std::string, Ignored, std::less<>> ignored_;            // by word, a hundred at most
    std::size_t otherIgnored_ = 0;
};

}  // namespace glibra::geometry

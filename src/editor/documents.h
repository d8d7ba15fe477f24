#pragma once
// The texts that an editor has opened, with the names that it gives to their files.

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "editor/completion.h"
#include "editor/text_range.h"

namespace glibra::editor {

struct TextPosition {
    std::size_t line = 0;
    std::size_t unit = 0;  ///< of UTF-16, in the line
    friend bool operator==(const TextPosition&, const TextPosition&) = default;
};

class TextLines {
  public:
    /// The text must outlive the object.
    explicit TextLines(std::string_view text);

    [[nodiscard]] std::size_t count() const { return begins_.size(); }
    /// Without its line end; empty beyond the last line.
    [[nodiscard]] TextRange line(std::size_t index) const;
    /// The place of a byte; the end of the text for bytes beyond it.
    [[nodiscard]] TextPosition position(std::size_t byte) const;
    /// The byte at a place; the end of its line, or of the text, for places beyond it.
    [[nodiscard]] std::size_t byte(TextPosition position) const;

  private:
    std::string_view text_;
    std::vector<std::size_t> begins_;
    std::vector<bool> isPlain_;  ///< for each line: all characters are one byte and one unit
};

/// The file of a URI: "file:///a%20b.glib" is /a b.glib. Another URI, as of a text without a name, is a file
/// of the current folder that need not exist.
std::filesystem::path fileOf(std::string_view uri);
std::string uriOf(const std::filesystem::path& file);

struct Document {
    std::string uri;
    std::filesystem::path file;
    std::string text;
    long long version = 0;
    CodeLanguage language = CodeLanguage::glib;
};

class Documents {
  public:
    /// The parameters of textDocument/didOpen, didChange and didClose (LSP 3.17). They throw json::exception
    /// if the parameters are not as they should be.
    const Document& open(const nlohmann::json& parameters);
    const Document* change(const nlohmann::json& parameters);
    void close(const std::string& uri);

    [[nodiscard]] const Document* find(const std::string& uri) const;
    [[nodiscard]] const Document* findFile(const std::filesystem::path& file) const;
    [[nodiscard]] const std::map<std::string, Document>& all() const { return documents_; }
    /// The text of a file as the editor has it, or else as it is saved; empty if it cannot be read.
    [[nodiscard]] std::string textOf(const std::filesystem::path& file) const;
    /// The URI of a file as the editor writes it.
    [[nodiscard]] std::string uriOf(const std::filesystem::path& file) const;

  private:
    std::map<std::string, Document> documents_;
};

TextPosition positionIn(const nlohmann::json& position);
nlohmann::json toJson(const TextPosition& position);
nlohmann::json toJson(const TextLines& lines, const TextRange& range);

}  // namespace glibra::editor

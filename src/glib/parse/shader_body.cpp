#include "glib/parse/shader_body.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/suggest.h"
#include "glib/modern/statement_table.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::string_view kEndPrefix = "End";

bool isStageRow(const StatementRow* row) {
    return row != nullptr && row->takesBody;
}

const StatementRow* anyRowOf(std::string_view word) {
    const StatementRow* row = modernFormOf(word);
    return row != nullptr ? row : findStatement(word);
}

std::vector<std::string_view> wordsOfLine(std::string_view line) {
    std::vector<std::string_view> words;
    constexpr std::size_t kMostWords = 4;
    while (words.size() < kMostWords) {
        line = trimmed(line);
        if (line.empty()) break;
        const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

/// True for the end word of any block or stage: EndVertex, EndPass.
bool isEndWord(std::string_view word) {
    if (word.size() <= kEndPrefix.size() || !sameWord(word.substr(0, kEndPrefix.size()), kEndPrefix))
        return false;
    if (isStageRow(anyRowOf(word.substr(kEndPrefix.size())))) return true;
    const StatementRow* row = findStatement(word);
    return row != nullptr && row->role == BlockRole::closes;
}

/// True for `EndFragmnet`: a line of a single word that is nearly the end word.
bool isNearly(std::string_view word, std::string_view end) {
    if (word.size() < kEndPrefix.size() || !sameWord(word.substr(0, kEndPrefix.size()), kEndPrefix))
        return false;
    const std::array<std::string_view, 1> only{end};
    return isIdentifier(word) && !base::nearestName(word, only).empty();
}

/// True for a line that GLSL does not have: `Fragment inline`, `Vertex a.vert`, `Program Lit uTint {1 0 0}`.
bool statesAnother(const std::vector<std::string_view>& words) {
    if (words.size() < 2) return false;
    const StatementRow* row = anyRowOf(words[0]);
    if (row == nullptr) return false;
    if (row->id == CommandId::glslText)
        return words.size() == 3 && isIdentifier(words[1]) && sameWord(words[2], "inline");
    if (isStageRow(row)) {
        if (words.size() > 2) return false;
        if (sameWord(words[1], "inline")) return true;
        return row->name == words[0] && words[1].find('.') != std::string_view::npos &&
               words[1].find_first_of(";()[]{}=,") == std::string_view::npos;
    }
    return row->id == CommandId::program && row->name == words[0] && isIdentifier(words[1]) &&
           (words.size() == 2 || isIdentifier(words[2].substr(0, words[2].find_first_of(".["))));
}

/// Follows comments from line to line: true if the line begins outside of one.
class CommentState {
  public:
    bool beginsOutside(std::string_view line) {
        const bool wasOutside = !isInside_;
        for (std::size_t at = 0; at + 1 < line.size(); ++at) {
            const std::string_view two = line.substr(at, 2);
            if (isInside_ ? two == "*/" : two == "/*") {
                isInside_ = !isInside_;
                ++at;
            } else if (!isInside_ && two == "//") {
                break;
            }
        }
        return wasOutside;
    }

  private:
    bool isInside_ = false;
};

}  // namespace

std::string_view trimmed(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return line.substr(begin, line.find_last_not_of(kBlanks) + 1 - begin);
}

bool endsShader(std::string_view line) {
    std::string_view word = line.substr(0, line.find_first_of(" \t"));
    const bool isEnd = word.starts_with(kEndPrefix) && word.size() == line.size();
    if (isEnd) word.remove_prefix(kEndPrefix.size());
    const StatementRow* row = anyRowOf(word);
    if (row == nullptr || row->name != word) return false;
    return isStageRow(row) || (row->id == CommandId::program && !isEnd);
}

ShaderBody readShaderBody(std::string_view text, LineSplitter& lines, std::string_view stage) {
    const std::string endWord = std::string(kEndPrefix) + std::string(stage);
    ShaderBody body{.before = lines};
    CommentState comments;
    bool isFirst = true;
    for (LineSplitter before = lines;; before = lines) {
        const std::optional<LineRange> line = lines.next();
        if (!line) return body;
        if (std::exchange(isFirst, false)) {
            body.first = line->begin;
            body.firstLine = line->number;
        }
        body.line = *line;
        body.before = before;
        body.last = line->begin;
        const std::string_view whole = text.substr(line->begin, line->end - line->begin);
        body.words = trimmed(whole);
        if (sameWord(body.words, endWord)) {
            body.end = ShaderBody::End::itsWord;
            return body;
        }
        const bool isOutside = comments.beginsOutside(whole);
        if (!isOutside || body.words.empty() || !isLetter(body.words.front())) continue;
        const std::vector<std::string_view> words = wordsOfLine(body.words);
        if (words.size() == 1 && (isEndWord(words[0]) || isNearly(words[0], endWord)))
            body.end = ShaderBody::End::otherWord;
        else if (statesAnother(words))
            body.end = ShaderBody::End::otherStatement;
        if (body.end != ShaderBody::End::missing) return body;
    }
}

}  // namespace glibra::glib

#include "render/load/hidden_text.h"

#include <algorithm>
#include <cstddef>
#include <deque>

#include "base/text.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::render {
namespace {

/// Shorter words are parts of too many others. The preprocessor can join them with other words, which then
/// tell little.
constexpr std::size_t kShortestPart = 4;

bool isWordByte(char c) {
    return base::isOfName(c) || static_cast<unsigned char>(c) >= 0x80;
}

/// Calls `visit` with each longest run of bytes of words, and each run of other bytes.
template <class Visit>
void visitRuns(std::string_view text, Visit&& visit) {
    for (std::size_t begin = 0; begin < text.size();) {
        const bool isWord = isWordByte(text[begin]);
        std::size_t end = begin;
        while (end < text.size() && isWordByte(text[end]) == isWord) ++end;
        visit(text.substr(begin, end - begin), isWord);
        begin = end;
    }
}

/// Calls `visit` with each word of the source outside of comments.
template <class Visit>
void visitWords(std::string_view source, Visit&& visit) {
    const std::string text = glsl::normalizeLines(source);
    std::deque<std::string> storage;
    for (const glsl::Token& token : glsl::lex(text, storage))
        if (token.kind != glsl::TokenKind::comment)
            visitRuns(token.text, [&](std::string_view run, bool isWord) {
                if (isWord) visit(run);
            });
}

}  // namespace

void HiddenWords::addShown(std::string_view source) {
    visitWords(source, [this](std::string_view word) { shown_.emplace(word); });
}

void HiddenWords::addHidden(std::string_view source) {
    visitWords(source, [this](std::string_view word) {
        hidden_.emplace(word);
        // Compilers end a number where its letters are wrong, and go on with a word.
        const auto letter = std::ranges::find_if_not(word, base::isDigit);
        const auto digits = static_cast<std::size_t>(letter - word.begin());
        if (digits == 0 || digits == word.size()) return;
        hidden_.emplace(word.substr(0, digits));
        hidden_.emplace(word.substr(digits));
    });
}

bool HiddenWords::mayBeHidden(std::string_view word) const {
    if (shown_.contains(word) || glsl::keywordSince(word) != 0) return false;
    if (hidden_.contains(word)) return true;
    return std::ranges::any_of(hidden_, [&](const std::string& each) {
        return each.size() >= kShortestPart && word.find(each) != std::string_view::npos;
    });
}

std::string HiddenWords::removedFrom(std::string_view message) const {
    std::string text;
    visitRuns(message, [&](std::string_view run, bool isWord) {
        text += isWord && mayBeHidden(run) ? std::string_view("...") : run;
    });
    return text;
}

}  // namespace glibra::render

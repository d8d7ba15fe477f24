#include "source/syntax.h"

#include <algorithm>
#include <array>

#include "glib/statement_table.h"
#include "glib/text.h"

namespace glibra::source {
namespace {

constexpr std::array<std::string_view, 34> kKeywords{
    "if",        "else",    "for",        "while",         "do",
    "return",    "break",   "continue",   "discard",       "const",
    "uniform",   "in",      "out",        "inout",         "attribute",
    "varying",   "layout",  "flat",       "smooth",        "centroid",
    "invariant", "precise", "struct",     "switch",        "case",
    "default",   "true",    "false",      "noperspective", "patch",
    "buffer",    "shared",  "subroutine", "precision"};

bool isType(std::string_view word) {
    if (word == "void" || word == "float" || word == "int" || word == "uint" || word == "bool" ||
        word == "double")
        return true;
    for (const std::string_view start : {"vec", "ivec", "uvec", "bvec", "dvec", "mat", "dmat", "sampler",
                                         "isampler", "usampler", "image", "iimage", "uimage"})
        if (word.starts_with(start) && word.size() > start.size() && glib::isDigit(word[start.size()]))
            return true;
    return word == "samplerCube" || word == "samplerCubeShadow" || word == "imageCube";
}

SyntaxKind kindOf(std::string_view word, CodeLanguage language, bool isFirst) {
    if (language == CodeLanguage::glib)
        return isFirst && (glib::findCommand(word) || glib::findStatement(word) || stageOfEndWord(word))
                   ? SyntaxKind::keyword
                   : SyntaxKind::plain;
    if (std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end()) return SyntaxKind::keyword;
    if (isType(word)) return SyntaxKind::type;
    if (word.starts_with("gl_")) return SyntaxKind::builtin;
    return SyntaxKind::plain;
}

class Scanner {
  public:
    Scanner(std::string_view line, CodeLanguage language) : line_(line), language_(language) {}

    std::vector<SyntaxPiece> scan(bool& inComment) {
        if (inComment) comment(0, inComment);
        while (at_ < line_.size()) step(inComment);
        return std::move(pieces_);
    }

  private:
    void add(std::size_t end, SyntaxKind kind) {
        if (kind != SyntaxKind::plain) pieces_.push_back({at_, end, kind});
        at_ = end;
    }

    void comment(std::size_t searchFrom, bool& inComment) {
        const std::size_t end = line_.find("*/", searchFrom);
        inComment = end == std::string_view::npos;
        add(inComment ? line_.size() : end + 2, SyntaxKind::comment);
    }

    std::size_t endOf(auto belongs) const {
        std::size_t end = at_;
        while (end < line_.size() && belongs(line_[end])) ++end;
        return end;
    }

    void step(bool& inComment) {
        const std::string_view rest = line_.substr(at_);
        const char c = rest.front();
        if (language_ == CodeLanguage::glib && c == '#') return add(line_.size(), SyntaxKind::comment);
        if (language_ == CodeLanguage::glsl && rest.starts_with("//"))
            return add(line_.size(), SyntaxKind::comment);
        if (language_ == CodeLanguage::glsl && rest.starts_with("/*")) return comment(at_ + 2, inComment);
        const bool isFirst = line_.find_first_not_of(" \t") == at_;
        if (c == '#' && isFirst) {
            const std::size_t end = std::min(line_.find("//", at_), line_.size());
            return add(end, SyntaxKind::directive);
        }
        const bool isNumber =
            glib::isDigit(c) || ((c == '.' || (c == '-' && language_ == CodeLanguage::glib)) &&
                                 rest.size() > 1 && (glib::isDigit(rest[1]) || rest[1] == '.'));
        if (isNumber) {
            ++at_;
            const std::size_t end = endOf([](char each) { return glib::isOfName(each) || each == '.'; });
            --at_;
            return add(end, SyntaxKind::number);
        }
        if (glib::beginsName(c)) {
            const std::size_t end = endOf(glib::isOfName);
            return add(end, kindOf(line_.substr(at_, end - at_), language_, isFirst));
        }
        ++at_;
    }

    std::string_view line_;
    CodeLanguage language_;
    std::size_t at_ = 0;
    std::vector<SyntaxPiece> pieces_;
};

}  // namespace

std::vector<SyntaxPiece> syntaxOf(std::string_view line, CodeLanguage language, bool& inComment) {
    return Scanner(line, language).scan(inComment);
}

std::vector<SyntaxPiece> SyntaxReader::next(std::string_view line) {
    if (language_ == CodeLanguage::glsl) return syntaxOf(line, language_, inComment_);
    if (shaders_.next(line)) return syntaxOf(line, CodeLanguage::glsl, inComment_);
    inComment_ = false;
    return syntaxOf(line, CodeLanguage::glib, inComment_);
}

}  // namespace glibra::source

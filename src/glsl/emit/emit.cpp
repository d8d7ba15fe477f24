#include "glsl/emit/emit.h"

#include <utility>

#include "glsl/read/source.h"

namespace glibra::glsl {
namespace {

class Emitter {
  public:
    explicit Emitter(Unit& unit) : unit_(unit) {
        stage_.stage = unit.stage;
        stage_.path = unit.path;
        stage_.lineMap.files = unit.files;
    }

    void own(const std::string& line) {
        stage_.source += line + "\n";
        stage_.lineMap.lines.push_back({});
        stage_.lineMap.columns.emplace_back();
        lineStart_ = stage_.source.size();
    }

    /// Emits the user's tokens with their edits.
    void text() {
        bool directive = false;
        int joinedLines = 0;
        bool lineKnown = false;
        LineOrigin origin;
        const auto endLine = [&] {
            stage_.source += '\n';
            stage_.lineMap.lines.push_back(origin);
            stage_.lineMap.columns.push_back(std::exchange(shifts_, {}));
            lineStart_ = stage_.source.size();
            if (origin.file >= 0) ++origin.line;
            lineKnown = false;
        };
        for (std::uint32_t i = 0; i < unit_.tokens.size(); ++i) {
            const Token& token = unit_.tokens[i];
            if (!lineKnown) {
                origin = token.synthetic ? LineOrigin{} : LineOrigin{token.file, token.line};
                lineKnown = true;
            }
            directive = token.kind == TokenKind::newline ? false : (directive || token.directive);
            if (token.kind == TokenKind::splice) {
                // In code a line end serves as a blank. A directive stays on one line, and empty lines follow
                // it.
                if (directive) {
                    stage_.source += ' ';
                    ++joinedLines;
                } else {
                    endLine();
                }
            } else if (token.kind == TokenKind::newline) {
                endLine();
                for (; joinedLines > 0; --joinedLines) {
                    lineKnown = true;
                    endLine();
                }
            } else {
                append(i, token, endLine);
            }
        }
        if (lineKnown || joinedLines > 0) endLine();
    }

    TranslatedStage take() { return std::move(stage_); }

  private:
    template <class EndLine>
    void append(std::uint32_t index, const Token& token, const EndLine& endLine) {
        const Edit* edit = unit_.edits.find(index);
        if (edit) {
            glue(edit->before);
            stage_.source += edit->before;
        }
        const std::string_view text = edit && edit->replaced ? std::string_view(edit->text) : token.text;
        if (token.kind == TokenKind::comment) {
            comment(text, token.directive, endLine);
        } else {
            glue(text);
            if (!text.empty() && !token.synthetic) column(token);
            stage_.source += text;
        }
        if (edit) {
            glue(edit->after);
            stage_.source += edit->after;
        }
    }

    void column(const Token& token) {
        const auto emitted = static_cast<int>(stage_.source.size() - lineStart_) + 1;
        const ColumnShift known = shifts_.empty() ? ColumnShift{} : shifts_.back();
        if (token.column - emitted != known.user - known.emitted) shifts_.push_back({emitted, token.column});
    }

    /// Adds a blank between two words that an edit made adjacent.
    void glue(std::string_view next) {
        const auto wordPart = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        };
        if (!next.empty() && !stage_.source.empty() && wordPart(stage_.source.back()) &&
            wordPart(next.front()))
            stage_.source += ' ';
    }

    template <class EndLine>
    void comment(std::string_view text, bool directive, const EndLine& endLine) {
        for (const char c : text) {
            if (c != '\n') {
                stage_.source += c;
                continue;
            }
            // For Mesa the text after a comment of several lines is on the comment's first line, so it
            // becomes several comments. On a preprocessor line that would end the directive.
            if (!directive) stage_.source += "*/";
            endLine();
            if (!directive) stage_.source += "/*";
        }
    }

    Unit& unit_;
    TranslatedStage stage_;
    std::vector<ColumnShift> shifts_;  ///< of the current line
    std::size_t lineStart_ = 0;
};

}  // namespace

TranslatedStage emit(Unit& unit) {
    const Target& target = unit.request->target;
    Emitter emitter(unit);
    emitter.own("#version " + std::to_string(target.version) + " core");
    if (target.lineDirectiveTakesFileName) emitter.own("#extension GL_ARB_shading_language_include : enable");
    for (const std::string& each : unit.extensions) emitter.own(each);
    const auto ownLines = [&](const std::vector<std::string>& lines) {
        if (lines.empty()) return;
        emitter.own("#line " + std::to_string(kOwnLines));
        for (const std::string& each : lines) emitter.own(each);
    };
    ownLines(unit.prologue);
    emitter.own(lineDirective(unit, 0, 1, target.version));
    emitter.text();
    if (!unit.mainEnd.empty() && unit.isDeclared("main")) {
        std::vector<std::string> lines = {"void main() {", "    glibra_main();"};
        for (const std::string& each : unit.mainEnd) lines.push_back("    " + each);
        lines.emplace_back("}");
        ownLines(lines);
    }
    return emitter.take();
}

TranslatedStage emitAsIs(Unit& unit) {
    Emitter emitter(unit);
    const Dialect& dialect = unit.dialect;
    if (dialect.given) {
        std::string line = "#version " + std::to_string(dialect.version);
        if (!dialect.profile.empty()) line += " " + dialect.profile;
        emitter.own(line);
    }
    if (unit.request->target.lineDirectiveTakesFileName)
        emitter.own("#extension GL_ARB_shading_language_include : enable");
    emitter.own(lineDirective(unit, 0, 1, dialect.given ? dialect.version : 110));
    emitter.text();
    return emitter.take();
}

}  // namespace glibra::glsl

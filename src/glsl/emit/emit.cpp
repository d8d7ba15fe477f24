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

    /// Emits the preprocessed text with its edits.
    void text() { emitTokens(unit_.tokens, &unit_.edits); }
    /// Emits the text as the user wrote it.
    void written() { emitTokens(unit_.written, nullptr); }

    TranslatedStage take() { return std::move(stage_); }

  private:
    void emitTokens(const std::vector<Token>& tokens, const Edits* edits) {
        bool directive = false;
        int joinedLines = 0;
        bool lineKnown = false;
        const auto endLine = [&] {
            stage_.source += '\n';
            stage_.lineMap.lines.push_back(origin_);
            stage_.lineMap.columns.push_back(std::exchange(shifts_, {}));
            lineStart_ = stage_.source.size();
            if (origin_.file >= 0) ++origin_.line;
            lineKnown = false;
        };
        for (std::uint32_t i = 0; i < tokens.size(); ++i) {
            const Token& token = tokens[i];
            if (!lineKnown) {
                // Inside a call the lines go on, whatever its tokens come from.
                if (!token.expanded || origin_.file < 0)
                    origin_ = token.synthetic ? LineOrigin{} : LineOrigin{token.file, token.line};
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
                append(edits ? edits->find(i) : nullptr, token, endLine);
            }
        }
        if (lineKnown || joinedLines > 0) endLine();
    }

    template <class EndLine>
    void append(const Edit* edit, const Token& token, const EndLine& endLine) {
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
        const ColumnShift known = shifts_.empty() ? ColumnShift{1, 1, origin_} : shifts_.back();
        const LineOrigin line{token.file, token.line};
        const int macro = macroOf(token);
        if (token.column - emitted != known.user - known.emitted || macro != known.macro ||
            line.line != known.line.line || line.file != known.line.file)
            shifts_.push_back({emitted, token.column, line, macro});
    }

    /// The index into LineMap::macros for a token from the text of a macro; -1 for others.
    int macroOf(const Token& token) {
        if (token.body == kNone) return -1;
        macros_.resize(unit_.macroTexts.size(), -1);
        int& index = macros_[token.body];
        if (index < 0) {
            index = static_cast<int>(stage_.lineMap.macros.size());
            const BodyPlace& place = unit_.macroTexts[token.body];
            stage_.lineMap.macros.push_back(
                {std::string(place.macro), {place.file, place.line}, place.column});
        }
        return index;
    }

    /// Adds a blank between two tokens that an edit made adjacent.
    void glue(std::string_view next) {
        if (!next.empty() && !stage_.source.empty() && growTogether(stage_.source.back(), next.front()))
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
    LineOrigin origin_;                ///< of the current line
    std::vector<ColumnShift> shifts_;  ///< of the current line
    std::vector<int> macros_;          ///< from StageText::macroTexts to LineMap::macros
    std::size_t lineStart_ = 0;
};

}  // namespace

TranslatedStage emit(Unit& unit) {
    const Target& target = unit.request->target;
    Emitter emitter(unit);
    emitter.own("#version " + std::to_string(target.version) + (target.isEs ? " es" : " core"));
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
    emitter.written();
    return emitter.take();
}

}  // namespace glibra::glsl

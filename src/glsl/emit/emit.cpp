#include "glsl/emit/emit.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
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

// ---- Emitted texts

std::vector<EmittedLine> emittedLines(const TranslatedStage& stage, const Place& place) {
    const LineMap& map = stage.lineMap;
    const auto file = std::ranges::find(map.files, place.file);
    if (file == map.files.end()) return {};
    const auto index = static_cast<int>(file - map.files.begin());
    std::vector<EmittedLine> lines;
    std::string_view rest = stage.source;
    for (std::size_t i = 0; i < map.lines.size() && !rest.empty(); ++i) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view text = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const bool isThere = map.lines[i].file == index && map.lines[i].line == place.line;
        const bool isBlank = text.find_first_not_of(" \t\r") == std::string_view::npos;
        if (isThere && !isBlank && !text.starts_with("#line"))
            lines.push_back({static_cast<int>(i) + 1, std::string(text)});
    }
    return lines;
}

std::vector<std::string_view> textLines(std::string_view text) {
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::string withSource(std::string_view directive, int before) {
    std::string text;
    std::ranges::copy_if(directive, std::back_inserter(text), [](char c) { return c != '"'; });
    const std::size_t lineAt = text.find(' ') + 1, sourceAt = text.find(' ', lineAt) + 1;
    if (lineAt == 0 || sourceAt == 0) return text;
    int line = 0, source = 0;
    std::from_chars(text.data() + lineAt, text.data() + text.size(), line);
    std::from_chars(text.data() + sourceAt, text.data() + text.size(), source);
    source += before;
    return fmt::format("#line {} {}", source * kLinesOfSource + line % kLinesOfSource, source);
}

namespace {

/// Length of the #version line, with which a translated source begins; 0 if it has none.
std::size_t versionLength(std::string_view source) {
    if (!source.starts_with("#version")) return 0;
    return std::min(source.find('\n'), source.size() - 1) + 1;
}

}  // namespace

std::string wrappedMain(const TranslatedStage& stage, const MainWrapper& wrapper) {
    const std::size_t version = versionLength(stage.source);
    std::string text = stage.source.substr(0, version);
    text += "#define main glibra_sceneMain\n";
    text.append(stage.source, version);
    text += "\n#undef main\n";
    text += wrapper.declarations;
    text += "void main() {\n";
    text += wrapper.before;
    text += "    glibra_sceneMain();\n";
    text += wrapper.after;
    text += "}\n";
    return text;
}

std::string versionLine(const TranslatedStage& stage) {
    const std::size_t version = versionLength(stage.source);
    return version == 0 ? "#version 410 core\n" : stage.source.substr(0, version);
}

}  // namespace glibra::glsl

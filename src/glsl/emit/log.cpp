#include "glsl/emit/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/text.h"
#include "glsl/emit/emit.h"
#include "glsl/emit/log_advice.h"
#include "glsl/emit/log_line.h"
#include "glsl/read/source.h"
#include "glsl/read/token.h"

namespace glibra::glsl {
namespace {

// ---- Shaders that stand under the word of another stage: the text of a geometry stage after Vertex

struct OtherStage {
    std::string text;  ///< of a message
    UserPlace place;   ///< of the word
};

/// A word of one stage alone (GLSL 4.60, 7.1 and 8), and the word of the scene language for that stage.
struct StageWord {
    std::string_view word;
    Stage stage;
    std::string_view command;
};
constexpr std::array kStageWords = std::to_array<StageWord>({
    {"EmitVertex", Stage::geometry, "Geometry"},
    {"EndPrimitive", Stage::geometry, "Geometry"},
    {"gl_out", Stage::tessControl, "TessControl"},
    {"gl_TessCoord", Stage::tessEvaluation, "TessEvaluation"},
    {"gl_GlobalInvocationID", Stage::compute, "Compute"},
    {"gl_LocalInvocationID", Stage::compute, "Compute"},
    {"gl_WorkGroupID", Stage::compute, "Compute"},
    {"gl_FragCoord", Stage::fragment, "Fragment"},
    {"gl_FragDepth", Stage::fragment, "Fragment"},
    {"gl_FrontFacing", Stage::fragment, "Fragment"},
    {"discard", Stage::fragment, "Fragment"},
    {"gl_VertexID", Stage::vertex, "Vertex"},
});

/// For a stage that does not compile: its first word that only another stage can have, such as EmitVertex in
/// a vertex stage. Nothing if there is no such word.
std::optional<OtherStage> findOtherStage(const TranslatedStage& stage) {
    if (stage.isMerged) return std::nullopt;
    std::deque<std::string> storage;
    for (const Token& token : lex(stage.source, storage)) {
        if (token.kind != TokenKind::word) continue;
        const auto* const word = std::ranges::find(kStageWords, token.text, &StageWord::word);
        if (word == kStageWords.end() || word->stage == stage.stage) continue;
        return OtherStage{
            fmt::format("'{}' belongs to a {} stage, but this is a {} stage; if the whole text is one, "
                        "write '{}' before it",
                        word->word, stageName(word->stage), stageName(stage.stage), word->command),
            userPlace(stage, {static_cast<std::size_t>(token.line) - 1, token.column})};
    }
    return std::nullopt;
}

// ---- Lines of a log

std::string userName(const TranslatedProgram& program, const std::string& emitted) {
    if (const auto found = program.userNames.find(emitted); found != program.userNames.end())
        return found->second;
    if (emitted == "glibra_main") return "main";
    return "gl_" + emitted.substr(7);
}

/// The text with every glibra_ name as the user wrote it.
std::string inUserNames(const TranslatedProgram& program, std::string_view text) {
    std::string result;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t found = text.find("glibra_", at);
        result += text.substr(at, found - at);
        if (found == std::string_view::npos) break;
        std::size_t end = found;
        while (end < text.size() && base::isOfName(text[end])) ++end;
        const bool whole = found == 0 || !base::isOfName(text[found - 1]);
        const std::string name(text.substr(found, end - found));
        result += whole ? userName(program, name) : name;
        at = end;
    }
    return result;
}

/// The file that an #include did not find, if that is what the text says.
std::string missingInclude(std::string_view text) {
    const std::size_t at = text.find(kMissingInclude);
    if (at == std::string_view::npos) return {};
    const std::string_view name = text.substr(at + std::string_view(kMissingInclude).size());
    return std::string(name.substr(0, name.rfind('\'')));
}

/// The file that a log line gives by its name or number; the stage's own if it is unknown.
const std::string& fileOf(const TranslatedStage& stage, const std::string& source) {
    const std::vector<std::string>& files = stage.lineMap.files;
    const auto named = std::ranges::find_if(files, [&](std::string path) {
        for (char& c : path)
            if (c == '"' || c == '\n' || c == '\\') c = c == '\\' ? '/' : '_';
        return path == source;
    });
    if (named != files.end()) return *named;
    std::size_t number = 0;
    const auto [end, failure] = std::from_chars(source.data(), source.data() + source.size(), number);
    const bool whole = failure == std::errc{} && end == source.data() + source.size();
    return whole && number < files.size() ? files[number] : stage.path;
}

/// The file of the next #error line that the driver's message is about; null for other messages. Mesa's
/// preprocessor gives the line in its file, but the number of another file.
class ErrorLines {
  public:
    explicit ErrorLines(const TranslatedStage& stage) {
        std::string_view rest = stage.source;
        for (const LineOrigin& origin : stage.lineMap.lines) {
            const std::string_view text = rest.substr(0, rest.find('\n'));
            rest.remove_prefix(std::min(text.size() + 1, rest.size()));
            if (origin.file >= 0 && text.starts_with("#error"))
                lines_.push_back(
                    {text, origin.line, &stage.lineMap.files[static_cast<std::size_t>(origin.file)]});
        }
    }

    const std::string* fileOf(const LogLine& line) {
        const auto found = std::find_if(lines_.begin() + next_, lines_.end(), [&](const Line& each) {
            return each.number == line.line && each.text.ends_with(line.text);
        });
        if (found == lines_.end()) return nullptr;
        next_ = found - lines_.begin() + 1;
        return found->file;
    }

  private:
    struct Line {
        std::string_view text;
        int number = 0;
        const std::string* file = nullptr;
    };
    std::vector<Line> lines_;
    std::ptrdiff_t next_ = 0;  ///< after the last one that was found
};

int lineOf(const TranslatedStage& stage, const std::string& file, int line) {
    // Drivers report "unexpected end of file" one line after the last.
    int last = 0;
    for (const LineOrigin& each : stage.lineMap.lines)
        if (each.file >= 0 && stage.lineMap.files[static_cast<std::size_t>(each.file)] == file)
            last = std::max(last, each.line);
    return last > 0 ? std::min(line, last) : line;
}

Place placeOf(const TranslatedStage& stage, const LineOrigin& line, int column) {
    return {stage.lineMap.files[static_cast<std::size_t>(line.file)], std::max(1, line.line), column};
}

/// The first column of a word in a line; 0 if it is not there. NVIDIA and browsers give no columns.
int columnOf(std::string_view word, std::string_view line) {
    for (std::size_t at = line.find(word); !word.empty() && at != std::string_view::npos;
         at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !base::isOfName(line[at - 1]) || !base::isOfName(word.front());
        if (begins && (end == line.size() || !base::isOfName(line[end]) || !base::isOfName(word.back())))
            return static_cast<int>(at) + 1;
    }
    return 0;
}

/// The line of a log, with the source that its number tells (kLinesOfSource).
std::optional<LogLine> readLine(std::string_view text, const TranslatedStage& stage) {
    std::optional<LogLine> line = parseLogLine(text, stage.lineMap.files);
    if (line && line->line >= kLinesOfSource && line->line < kOwnLines &&
        stage.source.starts_with("#version 300 es")) {
        line->source = std::to_string(line->line / kLinesOfSource);
        line->line %= kLinesOfSource;
    }
    return line;
}

std::vector<std::string_view> linesOf(std::string_view log) {
    std::vector<std::string_view> lines;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        std::string_view line = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\0'))
            line.remove_suffix(1);
        if (!line.empty()) lines.push_back(line);
    }
    return lines;
}

/// Mesa lists the overloads of a function that is called wrongly, each as a separate error.
constexpr std::string_view kCandidates = "; candidates are:";

bool isCandidate(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    const std::size_t open = text.find('(');
    if (first == std::string_view::npos || open == std::string_view::npos || !text.ends_with(')'))
        return false;
    // "vec4 texture(sampler2D, vec2)": exactly two words before the bracket.
    const std::string_view head = text.substr(first, open - first);
    return std::ranges::count(head, ' ') == 1;
}

/// Leaves out what only follows from an error before it.
class Consequences {
  public:
    explicit Consequences(const TranslatedStage& stage) : source_(stage.source) {}

    /// True for a name that an earlier error says to be undeclared, and for expressions on the line of such a
    /// name or in its statement, whose type is therefore not known. Remembers errors about undeclared names.
    bool contain(const LogLine& line, const std::optional<EmittedPlace>& place) {
        if (const std::string_view name = undeclaredName(line.text); !name.empty()) {
            lines_.emplace(line.source, line.line);
            if (place && places_.size() < kMostPlaces) places_.push_back(offsetOf(*place));
            return !names_.emplace(name).second;
        }
        // Mesa repeats in these words what it has said about a call before.
        const bool isFirst = reported_.emplace(line.source, line.line).second;
        if (!isFirst && line.text == "type mismatch") return true;
        return isConsequence(line.text) &&
               (lines_.contains({line.source, line.line}) || (place && isInStatement(offsetOf(*place))));
    }

  private:
    static constexpr std::size_t kMostPlaces = 32;
    static constexpr std::size_t kLongestStatement = 10'000;

    [[nodiscard]] std::size_t offsetOf(const EmittedPlace& place) const {
        std::size_t start = 0;
        for (std::size_t line = 0; line < place.line; ++line) start = source_.find('\n', start) + 1;
        return std::min(start + static_cast<std::size_t>(std::max(place.column, 1)) - 1, source_.size());
    }
    [[nodiscard]] bool isInStatement(std::size_t place) const {
        return std::ranges::any_of(places_, [&](std::size_t each) {
            const auto [first, last] = std::minmax(place, each);
            return last - first < kLongestStatement &&
                   source_.substr(first, last - first).find_first_of(";{}") == std::string_view::npos;
        });
    }

    std::string_view source_;
    std::vector<std::size_t> places_;  ///< of undeclared names, in the source
    std::set<std::string> names_;
    std::set<std::pair<std::string, int>> lines_, reported_;
};

Diagnostic programNote(const TranslatedProgram& program, std::string id) {
    return {Severity::note, std::move(id), "in Program '" + program.name + "'", program.place};
}

}  // namespace

Diagnostics explainCompileLog(const TranslatedProgram& program, const TranslatedStage& stage,
                              std::string_view log) {
    Diagnostics result;
    std::string rest;
    bool failed = false;
    bool isUnderstood = false;
    bool candidates = false;
    LogAdvice advice(program, stage);
    Consequences consequences(stage);
    ErrorLines errorLines(stage);
    for (const std::string_view each : linesOf(log)) {
        const std::optional<LogLine> line = readLine(each, stage);
        if (line && candidates && isCandidate(line->text)) continue;
        candidates = line && line->text.ends_with(kCandidates);
        if (!line) {
            if (!isLogSummary(each)) rest += (rest.empty() ? "" : " ") + inUserNames(program, each);
            continue;
        }
        isUnderstood = true;
        if (line->line >= kOwnLines) continue;
        const std::string* const ofError = errorLines.fileOf(*line);
        const std::string& file = ofError != nullptr ? *ofError : fileOf(stage, line->source);
        std::optional<EmittedPlace> emitted = emittedPlace(stage, *line, file);
        if (emitted && emitted->column == 0)
            emitted->column = columnOf(quotedWord(line->text), lineOfText(stage.source, emitted->line));
        if (consequences.contain(*line, emitted)) continue;
        const UserPlace user = emitted ? userPlace(stage, *emitted) : UserPlace{};
        const Place place =
            emitted ? placeOf(stage, user.line, user.column)
                    : Place{file, std::max(1, lineOf(stage, file, line->line)), std::max(1, line->column)};
        std::string text = inUserNames(program, line->text);
        if (candidates) text.resize(text.size() - kCandidates.size());
        if (line->isWarning) continue;
        result.push_back(about(diagnose("glsl-E01", text, place), missingInclude(line->text)));
        advice.addTo(*line, result.back());
        if (user.macro)
            result.push_back({Severity::note, "glsl-E01", "in the text of macro '" + user.macro->name + "'",
                              placeOf(stage, user.macro->line, user.macro->column)});
        failed = true;
    }
    if (!rest.empty() && !isUnderstood) {
        result.push_back(diagnose("glsl-E01", rest, {stage.path, stage.firstLine, 1}));
        failed = true;
    }
    if (failed)
        if (const std::optional<OtherStage> other = findOtherStage(stage))
            result = {
                diagnose("glsl-E01", other->text, placeOf(stage, other->place.line, other->place.column))};
    if (failed) result.push_back(programNote(program, "glsl-E01"));
    return result;
}

Diagnostics explainLinkLog(const TranslatedProgram& program, std::string_view log,
                           const Place& programPlace) {
    Diagnostics result;
    const TranslatedStage* stage = nullptr;
    const auto places = [&](std::string_view text) {
        std::string words;
        for (const auto& [name, declared] : program.interfaceNames) {
            std::size_t at = text.find(name);
            for (; at != std::string_view::npos; at = text.find(name, at + 1)) {
                const auto quote = [&](std::size_t i) {
                    return i < text.size() && (text[i] == '\'' || text[i] == '`' || text[i] == '"');
                };
                if (at > 0 && quote(at - 1) && quote(at + name.size())) break;
            }
            if (at == std::string_view::npos) continue;
            for (const Place& each : declared)
                words += (words.empty() ? " (" : ", ") + each.file + ":" + std::to_string(each.line);
        }
        return words.empty() ? words : words + ")";
    };
    for (const std::string_view each : linesOf(log)) {
        if (const TranslatedStage* named = stageOfHeading(program, each)) {
            stage = named;
            continue;
        }
        if (isLogSummary(each)) continue;
        const std::optional<LogLine> line = stage ? readLine(each, *stage) : std::nullopt;
        if (line && line->line < kOwnLines) {
            const std::string& file = fileOf(*stage, line->source);
            const Place place{file, std::max(1, lineOf(*stage, file, line->line)), 1};
            const std::string text = inUserNames(program, line->text);
            if (!line->isWarning) result.push_back(diagnose("glsl-E02", text, place));
            continue;
        }
        std::string_view text = line ? std::string_view(line->text) : each;
        const bool isWarning = stripSeverity(text);
        const std::string told = inUserNames(program, text);
        const auto lacking = std::ranges::find_if(program.stages, [&](const TranslatedStage& one) {
            return told.starts_with(fmt::format("{} shader lacks `main'", stageName(one.stage)));
        });
        if (lacking != program.stages.end()) {
            result.push_back(diagnose(
                "glsl-E02", fmt::format("the {} shader has no function 'main'", stageName(lacking->stage)),
                {lacking->path, lacking->firstLine, 1}));
            continue;
        }
        const std::string whole = told + places(told);
        if (!isWarning) result.push_back(diagnose("glsl-E02", whole, programPlace));
    }
    if (result.empty())
        result.push_back(
            diagnose("glsl-E02", "the driver could not link the program and gives no reason", programPlace));
    return result;
}

}  // namespace glibra::glsl

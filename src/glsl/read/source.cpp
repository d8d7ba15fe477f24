#include "glsl/read/source.h"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <set>
#include <utility>

#include "base/files.h"
#include "base/suggest.h"
#include "base/text.h"
#include "glsl/read/extensions.h"
#include "glsl/read/preprocessor.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

constexpr std::size_t kMostSourceBytes = 4U << 20;  // language, 11
constexpr std::size_t kDeepestInclude = 32;
constexpr std::size_t kMostFiles = 256;
constexpr long long kMostLines = 50'000'000;

constexpr std::array<std::string_view, 14> kDirectives{"define", "undef",  "if",    "ifdef",   "ifndef",
                                                       "else",   "elif",   "endif", "version", "extension",
                                                       "line",   "pragma", "error", "include"};

/// A file that is being read.
struct Frame {
    std::vector<Token> tokens;
    std::size_t at = 0;
    std::size_t file = 0;      ///< index into the files of the stage
    std::int32_t shift = 0;    ///< from the lines of the file to those that #line directives count
    long long fileNumber = 0;  ///< __FILE__
    std::vector<Token> after;  ///< what follows in the text of the including file
    std::string id{};          ///< of an included file
};

class SourceReader {
  public:
    SourceReader(StageText& stage, Report& report)
        : stage_(stage),
          report_(report),
          preprocessor_(stage, [this](const char* id, std::string text, const Token& at) {
              complain(id, std::move(text), at);
          }) {}

    void run(const StageSource& source) {
        stage_.storage.push_back(normalizeLines(source.text));
        const std::string& text = stage_.storage.back();
        bytes_ = text.size();
        if (bytes_ > kMostSourceBytes) return tooLarge(source.path);
        std::vector<Token> tokens = lex(text, stage_.storage);
        findVersion(tokens);
        if (continuesComments(stage_.dialect)) tokens = lex(text, stage_.storage, true);
        stage_.tokens.reserve(tokens.size());
        frames_.emplace_back().tokens = std::move(tokens);
        for (const Constant& each : stage_.constants) preprocessor_.expander().defineConstant(each, {}, {});
        preprocessor_.expander().run([this] { return nextLine(); });
        if (!hasOpenComment_) preprocessor_.finish();
        if (preprocessor_.expander().isExhausted())
            report_.report("glsl-E11", "the macros expand to more than 2,000,000 tokens", stage_.start());
        stage_.edits.resize(stage_.tokens.size());
        collectView();
        if (!stage_.dialect.given && shim())
            report_.report(
                "glsl-W01",
                "no #version, treated as " + std::to_string(stage_.dialect.version) + " compatibility",
                stage_.start());
    }

  private:
    [[nodiscard]] bool shim() const { return stage_.request->shim; }
    [[nodiscard]] Place placeOf(const Token& token) const {
        return {stage_.files[token.file], token.line, token.column};
    }
    /// Without the translation the driver reads the directives, and reports what is wrong with them.
    void complain(const char* id, std::string text, const Token& at) {
        if (shim()) report_.report(id, std::move(text), placeOf(at));
    }

    void tooLarge(const std::string& path) {
        report_.report("file-E09", "'" + path + "' with its includes is larger than 4 MiB", stage_.start());
    }

    void collectView() {
        stage_.view.reserve(stage_.tokens.size() / 2);
        for (std::uint32_t i = 0; i < stage_.tokens.size(); ++i) {
            const Token& token = stage_.tokens[i];
            if (!isSignificant(token.kind) || token.directive || token.synthetic) continue;
            ViewToken view;
            view.text = token.text;
            view.raw = i;
            view.kind = token.kind;
            stage_.view.push_back(view);
        }
    }

    /// The first #version of the stage's own file decides, wherever it stands. It is read before all other
    /// directives, because conditions before it may use __VERSION__.
    void findVersion(std::span<const Token> tokens) {
        bool first = true;
        bool lineStart = true;
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const Token& token = tokens[i];
            if (token.kind == TokenKind::newline) lineStart = true;
            if (!isSignificant(token.kind)) continue;
            if (lineStart && token.text == "#") {
                std::vector<std::string_view> words;
                for (std::size_t k = i + 1; k < tokens.size() && tokens[k].kind != TokenKind::newline; ++k)
                    if (isSignificant(tokens[k].kind)) words.push_back(tokens[k].text);
                if (!words.empty() && words[0] == "version") {
                    setVersion(std::span(words).subspan(1), {stage_.path, token.line, token.column}, first);
                    return;
                }
            }
            lineStart = false;
            first = false;
        }
    }

    void setVersion(std::span<const std::string_view> words, const Place& place, bool atTop) {
        stage_.dialect = readVersion(words, place, stage_.request->target.version, report_);
        if (!atTop) report_.report("glsl-W02", "#version moved to the top", place);
    }

    bool nextLine() {
        if (frames_.empty()) return false;
        Frame& frame = frames_.back();
        if (frame.at == frame.tokens.size()) {
            const std::vector<Token> after = std::move(frame.after);
            frames_.pop_back();
            if (!including_.empty()) including_.pop_back();
            for (const Token& each : after) add(each);
            return true;
        }
        std::vector<Token> tokens;
        bool ended = false;
        while (frame.at < frame.tokens.size() && !ended) {
            Token& token = tokens.emplace_back(frame.tokens[frame.at++]);
            ended = token.kind == TokenKind::newline;
            token.line += frame.shift;
            token.file = static_cast<std::uint16_t>(frame.file);
        }
        preprocessor_.expander().setFileNumber(frame.fileNumber);
        addLine(tokens);
        return true;
    }

    void addLine(std::span<const Token> tokens) {
        SourceLine line;
        line.tokens = tokens;
        for (const auto& token : tokens) {
            if (isSignificant(token.kind)) line.significant.push_back(&token);
            if (token.kind == TokenKind::comment) checkComment(token);
        }
        if (line.word(0) == "#") {
            directive(line);
        } else if (preprocessor_.active()) {
            for (const Token& each : tokens) add(each);
        } else {
            addLineEnds(tokens);
        }
    }

    void checkComment(const Token& comment) {
        if (comment.text.starts_with("/*")) {
            hasOpenComment_ = comment.text.size() < 4 || !comment.text.ends_with("*/");
            if (hasOpenComment_)
                complain("glsl-E16", "this comment has no end; write '*/' after it", comment);
        } else if (comment.droppedBackslash) {
            complain("glsl-W08", "backslash at the end of a comment dropped", comment);
        } else if (comment.continuedComment) {
            complain("glsl-W26", "the backslash at the end of this comment makes the next line part of it",
                     comment);
        }
    }

    void add(const Token& token) {
        preprocessor_.expander().add(token);
        if (!shim()) stage_.written.push_back(token);
    }
    /// Adds the line ends alone.
    void addLineEnds(std::span<const Token> tokens) {
        for (const Token& each : tokens) {
            Token end = each;
            end.kind = TokenKind::newline;
            end.text = "\n";
            if (each.kind == TokenKind::newline || each.kind == TokenKind::splice) {
                add(end);
            } else if (each.kind == TokenKind::comment) {
                for (auto k = std::ranges::count(each.text, '\n'); k > 0; --k, ++end.line) add(end);
            }
        }
    }
    /// Adds a line that stays a directive, or that the translator writes.
    void addDirective(std::string text, const Token& place, bool isOwn) {
        Token token = place;
        token.text = stage_.storage.emplace_back(std::move(text));
        token.kind = TokenKind::other;
        token.directive = true;
        token.synthetic = isOwn;
        add(token);
    }

    void directive(const SourceLine& line) {
        const std::string_view name = line.word(1);
        if (name == "include") return include(line);
        const bool isLineNumber = name == "line" && preprocessor_.active();
        if (!shim() && !isLineNumber) addAsWritten(name, line);
        const bool isPerformed = preprocessor_.perform(name, line);
        if (!isPerformed && preprocessor_.active() && !name.empty()) {
            if (name == "version") {
                version(line);
            } else if (name == "extension") {
                extension(line);
            } else if (name == "line") {
                return lineNumber(line);
            } else if (name == "pragma" || name == "error") {
                return passOn(line);
            } else {
                const std::string nearest = base::nearestName(name, kDirectives);
                complain("glsl-E14",
                         "there is no directive '#" + std::string(name) + "'" +
                             (nearest.empty() ? "" : "; did you mean '#" + nearest + "'?"),
                         line.token(1));
            }
        }
        addBlankLine(line);
    }

    void addBlankLine(const SourceLine& line) {
        if (shim())
            addLineEnds(line.tokens);
        else
            for (const Token& each : line.tokens)
                if (each.kind == TokenKind::newline) preprocessor_.expander().add(each);
    }

    /// The directives that the driver reads without the translation.
    void addAsWritten(std::string_view name, const SourceLine& line) {
        const bool isOwn = name == "version" || (name == "pragma" && line.word(2) == "once");
        for (const Token& each : line.tokens) {
            if (isOwn && isSignificant(each.kind)) continue;
            Token token = each;
            token.directive = each.kind != TokenKind::newline;
            stage_.written.push_back(token);
        }
    }

    /// Passes #pragma and #error on to the driver, in one line.
    void passOn(const SourceLine& line) {
        if (line.word(1) == "pragma" && line.word(2) == "once") {
            const std::string& id = frames_.empty() ? std::string() : frames_.back().id;
            once_.insert(id.empty() ? stage_.files[line.token(0).file] : id);
            return addBlankLine(line);
        }
        // GLSL ES 1.00 takes it in the fragment stage, too, where inputs follow the outputs of the stage
        // before.
        const bool isInvariant = line.word(1) == "pragma" && line.word(2) == "STDGL" &&
                                 line.word(3) == "invariant" && stage_.stage == Stage::fragment &&
                                 stage_.dialect.es && stage_.dialect.written == 100;
        if (!shim() || isInvariant) return addBlankLine(line);
        addDirective(line.joined(), line.token(0), false);
        addLineEnds(line.tokens);
    }

    void version(const SourceLine& line) {
        const Place place = placeOf(line.token(0));
        if (!stage_.dialect.given) {
            std::vector<std::string_view> words;
            for (std::size_t i = 2; i < line.significant.size(); ++i)
                words.push_back(line.significant[i]->text);
            setVersion(words, place, false);
        } else if (!(stage_.dialect.place == place)) {
            report_.report("glsl-W02", "a second #version is ignored", place);
        }
    }

    void extension(const SourceLine& line) {
        if (!shim()) return;
        if (line.significant.size() < 3)
            return complain("glsl-E14", "expected '#extension NAME : BEHAVIOUR'", line.token(0));
        const std::string name(line.significant[2]->text);
        const std::string_view behaviour = line.significant.size() > 4 ? line.significant[4]->text : "enable";
        const Place place = placeOf(line.token(0));
        const Target& target = stage_.request->target;
        const bool has = target.hasExtension && target.hasExtension(name);
        if (name == "all") {
            if (behaviour == "warn" || behaviour == "disable") stage_.passExtension(name, behaviour);
        } else if (isInCore(name, target.version)) {
            stage_.enabled.insert(name);
        } else if (has) {
            stage_.passExtension(name, behaviour);
            stage_.enabled.insert(name);
        } else if (const Extension* const row = findExtension(name)) {
            const std::string needs = "extension " + name + " needs GLSL " + dotted(row->since) +
                                      ", this driver has " + dotted(target.version);
            if (behaviour == "require")
                report_.report("glsl-E03", needs, place);
            else
                report_.report("glsl-W06", needs + "; ignored", place);
        } else if (behaviour == "require") {
            report_.report("glsl-E03",
                           "extension " + name +
                               " is required, but the driver does not have it; ask for it with 'enable' and "
                               "put what needs it into '#ifdef " +
                               name + "'",
                           place);
        } else {
            report_.report("glsl-W06", "extension " + name + " is unknown, ignored", place);
        }
    }

    void lineNumber(const SourceLine& line) {
        const std::vector<Piece> words = preprocessor_.expanded(line, 2);
        const Token& last = line.tokens.back();
        Frame& frame = frames_.back();
        long long number = 0;
        long long file = frame.fileNumber;
        const bool isNumber = !words.empty() && readInteger(words[0].token.text, number);
        // Some sources name a file here.
        const bool hasFile = words.size() > 1 && words[1].token.kind == TokenKind::number;
        if (!isNumber || (hasFile && (words.size() > 2 || !readInteger(words[1].token.text, file))) ||
            (words.size() > 1 && !hasFile && words[1].token.kind != TokenKind::other))
            complain("glsl-E14", "expected '#line NUMBER' or '#line NUMBER NUMBER'", line.token(0));
        else if (number > kMostLines)
            complain("glsl-E14", "#line: at most " + std::to_string(kMostLines) + " is possible",
                     line.token(2));
        if (!isNumber || number > kMostLines) {
            if (!shim()) addAsWritten("line", line);
            return addBlankLine(line);
        }
        // Places count from 1, so "#line 0" counts as "#line 1".
        const long long next = std::max(1LL, lineAfterDirective(stage_.dialect, number));
        frame.fileNumber = file;
        const std::size_t ended = last.kind == TokenKind::newline ? 1 : 0;
        addLineEnds(line.tokens.first(line.tokens.size() - ended));
        addDirective(lineDirective(stage_, frame.file, next, emittedVersion()), last, true);
        if (ended != 0) add(last);
        frame.shift += static_cast<std::int32_t>(next) - (last.line + 1);
    }

    /// The version whose meaning #line has for the driver.
    [[nodiscard]] int emittedVersion() const {
        return shim() ? stage_.request->target.version : stage_.dialect.version;
    }

    void include(const SourceLine& line) {
        const Token& hash = line.token(0);
        const auto end = [&] { addLineEnds(line.tokens); };
        if (!preprocessor_.active()) return end();
        const auto refuse = [&](std::string text) {
            addDirective("#error " + std::move(text), hash, false);
            end();
        };
        const std::string name = line.includedName();
        if (name.empty()) return refuse("#include needs a file name");
        if (base::sameWord(fileName(name), "gstap.h")) return end();
        std::optional<IncludedFile> found;
        if (const IncludeReader& reader = stage_.request->include)
            found = reader(name, stage_.files[hash.file]);
        if (!found) return refuse(kMissingInclude + name + "'");
        if (found->id.empty()) found->id = found->path;
        if (!isSourceText(found->path, found->text, report_)) return end();
        if (once_.contains(found->id)) return end();
        if (std::ranges::find(including_, found->id) != including_.end() || found->id == stage_.path) {
            std::string names = stage_.path;
            for (const std::string& each : including_) names += ", " + each;
            report_.report("glsl-E04", "#include cycle: " + names + ", " + found->id, placeOf(hash));
            return end();
        }
        bytes_ += found->text.size();
        if (bytes_ > kMostSourceBytes) {
            tooLarge(stage_.path);
            return end();
        }
        if (including_.size() >= kDeepestInclude || ++included_ > kMostFiles) {
            report_.reportOnce("limit", "file-E09",
                               "'" + found->path + "': more than " +
                                   (including_.size() >= kDeepestInclude ? "32 includes inside each other"
                                                                         : "256 included files"),
                               placeOf(hash));
            return end();
        }
        enter(std::move(*found), line);
    }

    void enter(IncludedFile found, const SourceLine& line) {
        auto at = std::ranges::find(stage_.files, found.path);
        const auto index = static_cast<std::size_t>(at - stage_.files.begin());
        if (at == stage_.files.end()) stage_.files.push_back(found.path);
        stage_.storage.push_back(normalizeLines(found.text));
        const std::string& text = stage_.storage.back();
        Frame frame;
        frame.tokens = lex(text, stage_.storage, continuesComments(stage_.dialect));
        frame.file = index;
        frame.fileNumber = static_cast<long long>(index);
        const Token& last = line.tokens.back();
        addDirective(lineDirective(stage_, index, 1, emittedVersion()), last, true);
        Token end = last;
        end.text = "\n";
        end.kind = TokenKind::newline;
        end.synthetic = true;
        add(end);
        const auto after = [&](std::string_view text2, TokenKind kind) {
            Token& token = frame.after.emplace_back(last);
            token.text = text2;
            token.kind = kind;
            token.synthetic = true;
            token.directive = kind != TokenKind::newline;
        };
        if (!text.empty() && text.back() != '\n') after("\n", TokenKind::newline);
        after(stage_.storage.emplace_back(
                  lineDirective(stage_, last.file, static_cast<long long>(last.line) + 1, emittedVersion())),
              TokenKind::other);
        if (last.kind == TokenKind::newline) frame.after.push_back(last);
        frame.id = found.id;
        including_.push_back(std::move(found.id));
        frames_.push_back(std::move(frame));
    }

    StageText& stage_;
    Report& report_;
    Preprocessor preprocessor_;
    std::deque<Frame> frames_;            ///< files that include each other at the current line
    std::vector<std::string> including_;  ///< paths of all but the first
    std::set<std::string> once_;
    bool hasOpenComment_ = false;  ///< it may hide an #endif
    std::size_t bytes_ = 0;
    std::size_t included_ = 0;
};

}  // namespace

bool isSourceText(const std::string& path, const std::string& text, Report& report) {
    if (!base::isNoText(text)) return true;
    report.report("file-E08", "'" + fileName(path) + "' " + base::notThe("a shader", text), {path, 1, 1});
    return false;
}

void readSource(const StageSource& source, StageText& stage, Report& report) {
    stage.path = source.path;
    stage.stage = source.stage;
    stage.files = {source.path};
    const bool isOfScene =
        std::ranges::any_of(stage.request->stages, [&](const StageSource& each) { return &each == &source; });
    if (isOfScene && stage.request->shim) stage.constants = stage.request->constants;
    if (source.stage == Stage::compute) stage.dialect.version = stage.dialect.written = kFirstWithCompute;
    SourceReader(stage, report).run(source);
}

std::string lineDirective(const StageText& stage, std::size_t file, long long line, int emittedVersion) {
    const std::string text = "#line " + std::to_string(emittedVersion <= 150 ? line - 1 : line) + " ";
    // A quoted number, because Mesa accepts few characters in a quoted name and drops an unquoted number from
    // some messages.
    return stage.request->target.lineDirectiveTakesFileName ? text + '"' + std::to_string(file) + '"'
                                                            : text + std::to_string(file);
}

}  // namespace glibra::glsl

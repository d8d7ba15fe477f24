#include "glsl/read/source.h"

#include <algorithm>

#include "glsl/read/extensions.h"
#include "glsl/read/preprocessor.h"
#include "glsl/read/version.h"

namespace glibra::glsl {
namespace {

constexpr std::size_t kMostSourceBytes = 4U << 20;  // language, 11
constexpr int kDeepestInclude = 32;
constexpr std::size_t kMostFiles = 256;

/// The last part of a path, in lower case.
std::string lowerName(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\");
    std::string name(slash == std::string_view::npos ? path : path.substr(slash + 1));
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return name;
}

class SourceReader {
  public:
    SourceReader(StageText& stage, Report& report) : stage_(stage), report_(report), preprocessor_(stage) {}

    void run(const StageSource& source) {
        stage_.storage.push_back(normalizeLines(source.text));
        const std::string& text = stage_.storage.back();
        const std::vector<Token> tokens = lex(text, stage_.storage);
        bytes_ = text.size();
        if (bytes_ > kMostSourceBytes) return tooLarge(source.path);
        findVersion(tokens);
        addFile(tokens, 0);
        preprocessor_.flush();
        if (preprocessor_.isExhausted())
            report_.report("glsl-E11", "the macros expand to more than 2,000,000 tokens", stage_.start());
        stage_.edits.resize(stage_.tokens.size());
        for (const std::uint32_t each : blanked_) stage_.edits.remove(each);
        for (auto& [token, text2] : replaced_) stage_.edits.replace(token, std::move(text2));
        if (!stage_.dialect.given && stage_.request->shim)
            report_.report(
                "glsl-W01",
                "no #version, treated as " + std::to_string(stage_.dialect.version) + " compatibility",
                stage_.start());
    }

  private:
    [[nodiscard]] bool shim() const { return stage_.request->shim; }
    [[nodiscard]] Place placeOf(const Token& token) const {
        return {stage_.files[file_], token.line + shift_, token.column};
    }

    void tooLarge(const std::string& path) {
        report_.report("file-E09", "'" + path + "' with its includes is larger than 4 MiB", stage_.start());
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

    void addFile(std::span<const Token> tokens, std::size_t file) {
        const auto saved = std::pair(file_, shift_);
        file_ = file;
        shift_ = 0;
        std::size_t i = 0;
        while (i < tokens.size()) {
            std::size_t end = i;
            while (end < tokens.size() && tokens[end].kind != TokenKind::newline) ++end;
            if (end < tokens.size()) ++end;
            addLine(tokens.subspan(i, end - i));
            i = end;
        }
        std::tie(file_, shift_) = saved;
    }

    void addLine(std::span<const Token> tokens) {
        SourceLine line;
        line.tokens = tokens;
        for (const Token& each : tokens)
            if (isSignificant(each.kind)) line.significant.push_back(&each);
        const bool directive = line.word(0) == "#";
        if (!directive) {
            push(tokens, false);
            return;
        }
        const std::string_view name = line.word(1);
        if (name == "include") {
            include(line);
            return;
        }
        line.first = static_cast<std::uint32_t>(stage_.tokens.size());
        push(tokens, true);
        perform(name, line);
    }

    void push(std::span<const Token> tokens, bool directive) {
        for (const Token& each : tokens) {
            Token token = each;
            token.line += shift_;
            token.file = static_cast<std::uint16_t>(file_);
            token.active = preprocessor_.active();
            token.directive = directive && each.kind != TokenKind::newline;
            if (each.droppedBackslash && shim())
                report_.report("glsl-W08", "backslash at the end of a comment dropped", placeOf(each));
            const auto index = static_cast<std::uint32_t>(stage_.tokens.size());
            stage_.tokens.push_back(token);
            if (!directive && token.active && isSignificant(token.kind)) {
                ViewToken view;
                view.text = token.text;
                view.raw = view.site = index;
                view.kind = token.kind;
                preprocessor_.text(view);
            }
        }
    }

    void blank(const SourceLine& line) {
        for (std::size_t i = 0; i < line.tokens.size(); ++i)
            if (isSignificant(line.tokens[i].kind))
                blanked_.push_back(line.first + static_cast<std::uint32_t>(i));
    }
    /// Puts `text` in place of the directive.
    void replace(const SourceLine& line, std::string text) {
        blank(line);
        for (std::size_t i = 0; i < line.tokens.size(); ++i)
            if (isSignificant(line.tokens[i].kind)) {
                replaced_.emplace_back(line.first + static_cast<std::uint32_t>(i), std::move(text));
                return;
            }
    }

    void perform(std::string_view name, const SourceLine& line) {
        if (preprocessor_.perform(name, line)) return;
        if (!preprocessor_.active()) {
            if (name == "extension" || name == "version") blank(line);
        } else if (name == "version") {
            version(line);
        } else if (name == "extension") {
            extension(line);
        } else if (name == "line") {
            lineNumber(line);
        } else if (name == "pragma" && line.word(2) == "once") {
            once_.insert(stage_.files[file_]);
            blank(line);
        }
    }

    void version(const SourceLine& line) {
        const Place place = placeOf(*line.significant[0]);
        blank(line);
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
        if (!shim() || line.significant.size() < 3) return;
        const std::string name(line.significant[2]->text);
        const std::string_view behaviour = line.significant.size() > 4 ? line.significant[4]->text : "enable";
        const Place place = placeOf(*line.significant[0]);
        blank(line);
        const Target& target = stage_.request->target;
        const bool has = target.hasExtension && target.hasExtension(name);
        const auto pass = [&] {
            const std::string passed = "#extension " + name + " : " + std::string(behaviour);
            if (std::find(stage_.extensions.begin(), stage_.extensions.end(), passed) ==
                stage_.extensions.end())
                stage_.extensions.push_back(passed);
        };
        if (name == "all") {
            if (behaviour == "warn" || behaviour == "disable") pass();
        } else if (isInCore(name, target.version)) {
            stage_.enabled.insert(name);
        } else if (has) {
            pass();
            stage_.enabled.insert(name);
        } else if (const Extension* const row = findExtension(name)) {
            const std::string needs = "extension " + name + " needs GLSL " +
                                      std::to_string(row->since).insert(1, ".") + ", this driver has " +
                                      std::to_string(target.version).insert(1, ".");
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
        long long number = 0;
        if (!preprocessor_.number(line, 2, number) || number < 0 || number > 1'000'000) return;
        // Places count from 1, so "#line 0" counts as "#line 1".
        const long long next = std::max(1LL, stage_.dialect.version <= 150 ? number + 1 : number);
        const std::int32_t physical = line.significant[0]->line;
        replace(line, lineDirective(stage_, file_, next,
                                    shim() ? stage_.request->target.version : stage_.dialect.version));
        shift_ = static_cast<std::int32_t>(next) - (physical + 1);
    }

    void synthetic(std::string text, TokenKind kind) {
        stage_.storage.push_back(std::move(text));
        Token token;
        token.text = stage_.storage.back();
        token.kind = kind;
        token.synthetic = true;
        token.directive = kind != TokenKind::newline;
        token.active = preprocessor_.active();
        token.file = static_cast<std::uint16_t>(file_);
        stage_.tokens.push_back(token);
    }

    void include(const SourceLine& line) {
        const Token& hash = *line.significant[0];
        const Place place = placeOf(hash);
        const Token& last = line.tokens.back();
        const bool ended = last.kind == TokenKind::newline;
        const auto end = [&] {
            if (ended) push(line.tokens.last(1), true);
        };
        if (!preprocessor_.active()) return end();
        const std::string name = includeName(line);
        if (name.empty()) {
            synthetic("#error #include needs a file name", TokenKind::other);
            return end();
        }
        if (lowerName(name) == "gstap.h") return end();
        const IncludeReader& reader = stage_.request->include;
        std::optional<IncludedFile> found = reader ? reader(name, stage_.files[file_]) : std::nullopt;
        if (!found) {
            synthetic("#error cannot find the included file '" + name + "'", TokenKind::other);
            return end();
        }
        if (once_.contains(found->path)) return end();
        if (std::find(stack_.begin(), stack_.end(), found->path) != stack_.end() ||
            found->path == stage_.path) {
            std::string names = stage_.path;
            for (const std::string& each : stack_) names += ", " + each;
            report_.report("glsl-E04", "#include cycle: " + names + ", " + found->path, place);
            return end();
        }
        bytes_ += found->text.size();
        if (bytes_ > kMostSourceBytes) {
            tooLarge(stage_.path);
            return end();
        }
        if (stack_.size() >= kDeepestInclude || ++included_ > kMostFiles) {
            report_.reportOnce("limit", "file-E09",
                               "'" + found->path + "': more than " +
                                   (stack_.size() >= kDeepestInclude ? "32 includes inside each other"
                                                                     : "256 included files"),
                               place);
            return end();
        }
        enter(std::move(*found), hash.line);
        end();
    }

    void enter(IncludedFile found, std::int32_t physicalLine) {
        const int version = shim() ? stage_.request->target.version : stage_.dialect.version;
        auto at = std::find(stage_.files.begin(), stage_.files.end(), found.path);
        const auto index = static_cast<std::size_t>(at - stage_.files.begin());
        if (at == stage_.files.end()) stage_.files.push_back(found.path);
        stage_.storage.push_back(normalizeLines(found.text));
        const std::string& text = stage_.storage.back();
        const std::vector<Token> tokens = lex(text, stage_.storage);
        synthetic(lineDirective(stage_, index, 1, version), TokenKind::other);
        synthetic("\n", TokenKind::newline);
        stack_.push_back(std::move(found.path));
        addFile(tokens, index);
        stack_.pop_back();
        if (!text.empty() && text.back() != '\n') synthetic("\n", TokenKind::newline);
        synthetic(lineDirective(stage_, file_, physicalLine + shift_ + 1, version), TokenKind::other);
    }

    /// The text between the quotes or angle brackets of an #include.
    static std::string includeName(const SourceLine& line) {
        if (line.significant.size() < 3) return {};
        const Token& open = *line.significant[2];
        const char* const begin = open.text.data();
        // The tokens of a line are adjacent in the text, and the last one ends the line.
        const Token& last = line.tokens.back();
        const char* const end = last.text.data() + (last.kind == TokenKind::newline ? 0 : last.text.size());
        if (end <= begin) return {};
        const std::string_view rest(begin, static_cast<std::size_t>(end - begin));
        const char closer = rest.front() == '<' ? '>' : '"';
        if (rest.front() != '<' && rest.front() != '"') return {};
        const std::size_t close = rest.find(closer, 1);
        return close == std::string_view::npos ? std::string{} : std::string(rest.substr(1, close - 1));
    }

    StageText& stage_;
    Report& report_;
    Preprocessor preprocessor_;
    std::vector<std::string> stack_;  ///< files that include each other at the current line
    std::set<std::string> once_;
    std::vector<std::uint32_t> blanked_;
    std::vector<std::pair<std::uint32_t, std::string>> replaced_;
    std::size_t bytes_ = 0;
    std::size_t included_ = 0;
    std::size_t file_ = 0;
    std::int32_t shift_ = 0;
};

}  // namespace

void readSource(const StageSource& source, StageText& stage, Report& report) {
    stage.path = source.path;
    stage.stage = source.stage;
    stage.files = {source.path};
    if (source.stage == Stage::compute) stage.dialect.version = stage.dialect.written = kFirstWithCompute;
    SourceReader(stage, report).run(source);
}

std::string lineDirective(const StageText& stage, std::size_t file, long long line, int emittedVersion) {
    std::string text = "#line " + std::to_string(emittedVersion <= 150 ? line - 1 : line) + " ";
    // A quoted number, because Mesa accepts few characters in a quoted name and drops an unquoted number from
    // some messages.
    return stage.request->target.lineDirectiveTakesFileName ? text + '"' + std::to_string(file) + '"'
                                                            : text + std::to_string(file);
}

}  // namespace glibra::glsl

#include "editor/completion.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "base/texel_format.h"
#include "base/text.h"
#include "editor/declared_names.h"
#include "editor/glsl_reference.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/statement_table.h"
#include "glib/syntax.h"
#include "glib/text.h"
#include "glsl/read/words.h"
#include "scene/shader_names.h"
#include "source/inline_shaders.h"

namespace glibra::editor {
namespace {

using base::isOfName;

constexpr std::size_t kMost = 200;
constexpr int kDefaultVersion = 110;

std::string_view firstWord(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const auto* const end = std::ranges::find_if_not(line, isOfName);
    return line.substr(0, static_cast<std::size_t>(end - line.begin()));
}

/// True if a comment or a quoted text is open at the byte.
bool isInComment(std::string_view text, std::size_t byte, CodeLanguage language) {
    const std::string_view line = lineBefore(text, byte);
    if (language == CodeLanguage::glib) {
        bool isQuoted = false;
        for (const char c : line) {
            if (c == '"') isQuoted = !isQuoted;
            if (c == '#' && !isQuoted) return true;
        }
        return isQuoted;
    }
    if (line.find("//") != std::string_view::npos) return true;
    const std::string_view before = text.substr(0, byte);
    const std::size_t open = before.rfind("/*");
    return open != std::string_view::npos && before.find("*/", open) == std::string_view::npos;
}

/// Collects words in the order of their importance, each once.
class Collector {
  public:
    explicit Collector(std::string_view prefix) : prefix_(glib::lower(prefix)), exact_(prefix) {}

    void add(std::string_view word, std::string type, std::string what = {}) {
        if (word.empty() || glib::lower(word.substr(0, prefix_.size())) != prefix_) return;
        if (!seen_.insert(std::string(word)).second) return;
        group_.push_back({std::string(word), std::move(type), std::move(what)});
    }
    /// What is added from now on comes after what was added before.
    void nextGroup() {
        std::ranges::stable_sort(group_, [&](const Completion& a, const Completion& b) {
            const bool isExactA = a.word.starts_with(exact_), isExactB = b.word.starts_with(exact_);
            return isExactA != isExactB ? isExactA : glib::lower(a.word) < glib::lower(b.word);
        });
        std::move(group_.begin(), group_.end(), std::back_inserter(all_));
        group_.clear();
    }
    std::vector<Completion> take() {
        nextGroup();
        if (all_.size() == 1 && all_.front().word == exact_) all_.clear();
        if (all_.size() > kMost) all_.resize(kMost);
        return std::move(all_);
    }

  private:
    std::string prefix_, exact_;
    std::set<std::string> seen_;
    std::vector<Completion> group_, all_;
};

void addGlsl(Collector& words, std::string_view text, const TextRange& typed,
             const std::optional<glsl::Stage>& stage, const std::vector<KnownName>& names) {
    const int version = std::max(versionOf(text), kDefaultVersion);
    // The typed word is no declaration of its own.
    std::string rest(text);
    std::fill(rest.begin() + static_cast<std::ptrdiff_t>(typed.begin),
              rest.begin() + static_cast<std::ptrdiff_t>(typed.end), ' ');
    for (const DeclaredName& each : declaredNames(rest))
        words.add(each.name, each.isFunction ? each.declaration : each.type,
                  "line " + std::to_string(each.line) + (each.isInterface ? ": " + each.declaration : ""));
    words.nextGroup();
    for (const KnownName& each : names)
        if (each.in == CodeLanguage::glsl) words.add(each.name, each.type, each.what);
    for (const scene::ShaderName& each : scene::shaderNames()) {
        if (each.isInput && stage && *stage != glsl::Stage::vertex) continue;
        for (const std::string& name : each.names) words.add(name, std::string(each.type), each.meaning);
    }
    words.nextGroup();
    for (const GlslRow& each : glslTable())
        if (version >= each.since && version < each.until && (!stage || isIn(each, *stage)))
            words.add(each.name, std::string(each.signature), std::string(each.summary));
    words.nextGroup();
    for (const std::string_view each : glsl::keywords())
        if (glsl::keywordSince(each) <= version && (!stage || isKeywordIn(each, *stage)))
            words.add(each, glsl::isTypeWord(each) ? "type" : "keyword");
}

void addStatementWords(Collector& words, std::string_view name) {
    const glib::StatementRow* command = glib::findCommand(name);
    const glib::StatementRow* statement = command ? glib::modernFormOf(name) : glib::findStatement(name);
    if (command)
        for (const std::string& each : glib::wordsOf(*command)) words.add(each, "word");
    if (statement)
        for (const std::string& each : glib::wordsOf(*statement))
            words.add(each, "word of " + std::string(statement->name));
    if (statement && hasNode(*statement, [](const glib::SyntaxNode& each) {
            return each.type == glib::ValueType::word && each.text == "format";
        }))
        for (const base::TexelFormatRow& each : base::texelFormats()) words.add(each.name, "format");
}

/// True for a classic command that takes numbers alone. A name stands only in the parentheses of an
/// expression.
bool takesNumbersOnly(std::string_view name) {
    const glib::StatementRow* command = glib::findCommand(name);
    return command && formOf(*command) == glib::ArgumentForm::numbers && !glib::modernFormOf(name);
}

/// The names that statements of the text declare: `Texture2D glow`, `Let size`.
void addDeclaredNames(Collector& words, std::string_view text, std::size_t cursor) {
    int line = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view whole = text.substr(begin, end - begin);
        const std::string_view word = firstWord(whole);
        ++line;
        if (!word.empty() && (cursor < begin || cursor > end)) {
            const glib::StatementRow* row = glib::findStatement(word);
            if (!row) row = glib::modernFormOf(word);
            const bool declares = row && (row->declaresName || glib::sameWord(word, "Program") ||
                                          glib::sameWord(word, "Group"));
            const std::string_view name =
                firstWord(whole.substr(static_cast<std::size_t>(word.data() + word.size() - whole.data())));
            if (declares && !name.empty() && !base::isDigit(name.front()))
                words.add(name, std::string(row->name), "line " + std::to_string(line));
        }
        begin = end + 1;
    }
}

void addGlib(Collector& words, std::string_view text, const TextRange& typed,
             const std::vector<KnownName>& names) {
    const std::string_view before = statementBefore(text, typed.begin);
    const std::string_view statement = firstWord(before);
    if (statement.empty()) {
        for (const glib::StatementRow& each : glib::commandTable())
            for (const std::string_view name : each.names())
                words.add(name, "command", std::string(each.summary));
        for (const glib::StatementRow& each : glib::statementTable())
            words.add(each.name, "statement", std::string(each.summary));
        return;
    }
    const auto open = std::ranges::count(before, '(');
    const bool isExpression = open > std::ranges::count(before, ')');
    if (!isExpression) {
        addStatementWords(words, statement);
        words.nextGroup();
    }
    if (!isExpression && takesNumbersOnly(statement)) return;
    addDeclaredNames(words, text, typed.begin);
    for (const KnownName& each : names)
        if (each.in == CodeLanguage::glib) words.add(each.name, each.type, each.what);
    words.nextGroup();
    if (!isExpression) return;
    for (const expression::NameRow& each : expression::sceneNames())
        words.add(each.path, expression::name(each.type), std::string(each.summary));
    for (const expression::FunctionRow& each : expression::functionTable())
        words.add(each.name(), std::string(each.prototype), std::string(each.summary));
}

}  // namespace

std::optional<glsl::Stage> stageOfFile(const std::filesystem::path& file) {
    using glsl::Stage;
    struct Suffixes {
        Stage stage;
        std::string_view usual, brief;
    };
    static constexpr Suffixes kSuffixes[] = {
        {Stage::vertex, ".vert", ".vs"},          {Stage::tessControl, ".tesc", ".tcs"},
        {Stage::tessEvaluation, ".tese", ".tes"}, {Stage::geometry, ".geom", ".gs"},
        {Stage::fragment, ".frag", ".fs"},        {Stage::compute, ".comp", ".cs"}};
    std::filesystem::path suffix = file.extension();
    if (glib::sameWord(suffix.generic_string(), ".glsl")) suffix = file.stem().extension();  // "a.frag.glsl"
    for (const Suffixes& each : kSuffixes)
        if (glib::sameWord(suffix.generic_string(), each.usual) ||
            glib::sameWord(suffix.generic_string(), each.brief))
            return each.stage;
    return std::nullopt;
}

TextRange wordAt(std::string_view text, std::size_t byte) {
    byte = std::min(byte, text.size());
    TextRange word{byte, byte};
    while (word.begin > 0 && isOfName(text[word.begin - 1])) --word.begin;
    while (word.end < text.size() && isOfName(text[word.end])) ++word.end;
    return word;
}

TextRange nameNear(std::string_view text, std::size_t byte) {
    byte = std::min(byte, text.size());
    for (TextRange word = wordAt(text, byte);; word = wordAt(text, word.begin - 1)) {
        const bool isName = word.begin < word.end && !base::isDigit(text[word.begin]);
        if (isName) return word;
        if (word.begin == 0 || text[word.begin - 1] == '\n') return {byte, byte};
    }
}

TextRange wordBefore(std::string_view text, std::size_t byte) {
    return {wordAt(text, byte).begin, std::min(byte, text.size())};
}

std::string_view lineBefore(std::string_view text, std::size_t byte) {
    const std::size_t begin = byte == 0 ? 0 : text.rfind('\n', byte - 1) + 1;
    return text.substr(begin, byte - begin);
}

std::string_view statementBefore(std::string_view text, std::size_t byte) {
    std::size_t begin = byte - lineBefore(text, byte).size();
    while (begin >= 2) {
        const std::size_t last = text.find_last_not_of(" \t\r", begin - 2);
        if (last == std::string_view::npos || text[last] != '\\') break;
        begin = last - lineBefore(text, last).size();
    }
    return text.substr(begin, byte - begin);
}

LanguageAt languageAt(std::string_view text, std::size_t byte, const CodeContext& context) {
    const LanguageAt whole{context.language, context.stage, {0, text.size()}};
    if (context.language == CodeLanguage::glsl) return whole;
    source::InlineShaders shaders;
    LanguageAt found = whole;
    bool isInShader = false;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::optional<glsl::Stage> stage = shaders.next(text.substr(begin, end - begin));
        if (stage) {
            if (found.language == CodeLanguage::glib)
                found = {CodeLanguage::glsl, stage, {begin, text.size()}};
            isInShader = isInShader || byte <= end;
        } else if (isInShader) {
            found.part.end = begin;
            return found;
        } else {
            found = whole;
            if (byte <= end) return whole;
        }
        begin = end + 1;
    }
    return found;
}

std::vector<Completion> completionsAt(std::string_view text, std::size_t cursor, const CodeContext& context) {
    cursor = std::min(cursor, text.size());
    const TextRange typed = wordBefore(text, cursor);
    const bool isNumber = typed.begin < typed.end && base::isDigit(text[typed.begin]);
    const LanguageAt at = languageAt(text, cursor, context);
    if (isNumber || isInComment(text, cursor, at.language)) return {};
    if (typed.begin > 0 && text[typed.begin - 1] == '.') return {};
    Collector words(text.substr(typed.begin, typed.end - typed.begin));
    if (at.language == CodeLanguage::glib) {
        addGlib(words, text, typed, context.names);
        return words.take();
    }
    if (context.language == CodeLanguage::glib && at.stage) {
        words.add(source::endWordOf(*at.stage), "statement", "ends the shader");
        words.nextGroup();
    }
    const std::string_view part = text.substr(at.part.begin, at.part.end - at.part.begin);
    addGlsl(words, part, {typed.begin - at.part.begin, typed.end - at.part.begin}, at.stage, context.names);
    return words.take();
}

}  // namespace glibra::editor

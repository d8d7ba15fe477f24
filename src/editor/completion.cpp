#include "editor/completion.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

#include "base/texel_format.h"
#include "base/text.h"
#include "editor/declared_names.h"
#include "editor/glsl_reference.h"
#include "editor/scene_places.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/lexer.h"
#include "glib/messages.h"
#include "glib/parse/statement.h"
#include "glib/statement_table.h"
#include "glib/syntax.h"
#include "glib/text.h"
#include "glsl/read/words.h"
#include "scene/shader_names.h"
#include "scene/statement_words.h"
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

bool isShaderFile(const std::filesystem::path& file) {
    return stageOfFile(file) || glib::sameWord(file.extension().generic_string(), ".glsl");
}

/// True if a comment or a quoted text is open at the byte.
bool isInComment(std::string_view text, std::size_t byte, CodeLanguage language) {
    const std::string_view line = lineBefore(text, byte);
    if (language == CodeLanguage::glib) {
        bool isQuoted = false;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (line[i] == '"') isQuoted = !isQuoted;
            if ((line[i] == '#' || line.substr(i, 2) == "//") && !isQuoted) return true;
        }
        return isQuoted || glib::sameWord(firstWord(line), "MessageBox");
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
    /// A group of its own.
    void addInOrder(std::string_view word, std::string type, std::string what) {
        add(word, std::move(type), std::move(what));
        nextGroup();
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

/// A folder of files that a text may name: those that `fits` accepts, and the folders in it.
void addFiles(Collector& words, const std::vector<std::filesystem::path>& folders, std::string_view typed,
              const std::function<bool(const std::filesystem::path&)>& fits) {
    constexpr int kMostEntries = 5000;  // that are looked at
    namespace fs = std::filesystem;
    const std::string inside(typed.substr(0, typed.rfind('/') + 1));
    int count = 0;
    for (const fs::path& folder : folders) {
        std::error_code failure;
        for (fs::directory_iterator each(folder / inside, failure), end; each != end && !failure;
             each.increment(failure)) {
            if (++count > kMostEntries) return;
            const std::string name = each->path().filename().generic_string();
            std::error_code unknown;
            const bool isFolder = each->is_directory(unknown);
            if (name.starts_with('.') || (!isFolder && !fits(each->path()))) continue;
            words.add(inside + name + (isFolder ? "/" : ""), isFolder ? "folder" : "file",
                      folder.filename().generic_string());
        }
    }
}

/// What stands before the cursor in its line, from the last blank, quote or bracket on.
std::string_view fileBefore(std::string_view line) {
    const std::size_t at = line.find_last_of("\"' \t<");
    return at == std::string_view::npos ? line : line.substr(at + 1);
}

/// A line of the preprocessor; `line` is what stands before the cursor. False if it is none.
bool addDirective(Collector& words, std::string_view line, std::string_view text,
                  const CodeContext& context) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string_view::npos || line[hash] != '#') return false;
    const std::string_view rest = line.substr(hash + 1);
    const std::size_t first = std::min(rest.find_first_not_of(" \t"), rest.size());
    const std::string_view name = firstWord(rest);
    if (first + name.size() == rest.size()) {
        for (const std::string_view each : {"version", "include", "define", "undef", "if", "ifdef", "ifndef",
                                            "elif", "else", "endif", "extension", "line", "pragma", "error"})
            words.add(each, "directive");
        return true;
    }
    if (name == "version") {
        const bool hasNumber = rest.find_first_of("0123456789") < rest.size() - fileBefore(line).size();
        if (hasNumber)
            for (const std::string_view each : {"core", "compatibility", "es"}) words.add(each, "profile");
        else
            for (const std::string_view each :
                 {"330", "410", "430", "450", "460", "120", "110", "130", "140", "150", "400", "420", "440",
                  "330 core", "300 es", "310 es", "320 es"})
                words.addInOrder(each, "version", {});
        return true;
    }
    if (name == "include" && rest.find_first_of("\"<") != std::string_view::npos)
        addFiles(words, context.folders, fileBefore(line),
                 [](const std::filesystem::path& each) { return isShaderFile(each); });
    static constexpr std::string_view kConditions[] = {"if", "ifdef", "ifndef", "elif", "undef"};
    if (std::ranges::find(kConditions, name) != std::end(kConditions)) {
        for (const DeclaredName& each : declaredNames(text))
            if (each.type == "macro") words.add(each.name, "macro", each.declaration);
        for (const std::string_view each : {"defined", "GL_ES", "__VERSION__"}) words.add(each, "macro");
    }
    return name != "define";
}

/// Where a name of a shader stands: what may be there.
enum class Spot { any, type, newName };
Spot spotOf(std::string_view before, const std::vector<DeclaredName>& names) {
    std::size_t end = before.find_last_not_of(" \t\r\n");
    if (end == std::string_view::npos || end + 1 == before.size()) return Spot::any;
    const TextRange range = wordAt(before, ++end);
    const std::string_view word = before.substr(range.begin, range.end - range.begin);
    if (glsl::isQualifierWord(word)) return Spot::type;
    const bool isStructure = std::ranges::any_of(
        names, [&](const DeclaredName& each) { return each.type == "struct" && each.name == word; });
    return glsl::isTypeWord(word) || isStructure || word == "struct" ? Spot::newName : Spot::any;
}

/// The only words that may stand behind this part of a shader: in the brackets of layout and after precision.
std::vector<std::string_view> onlyWordsAfter(std::string_view before) {
    before = before.substr(0, before.find_last_not_of(" \t\r\n") + 1);
    const auto lastWord = [](std::string_view part) {
        const TextRange range = wordAt(part, part.size());
        return part.substr(range.begin, range.end - range.begin);
    };
    if (lastWord(before) == "precision") return {"highp", "mediump", "lowp"};
    const std::size_t open = before.rfind('(');
    if (open == std::string_view::npos || open == 0 || !(before.ends_with('(') || before.ends_with(',')) ||
        before.find_last_of(");{}") + 1 > open + 1 ||
        lastWord(before.substr(0, before.find_last_not_of(" \t", open - 1) + 1)) != "layout")
        return {};
    std::string_view rest =
        "location binding std140 std430 local_size_x local_size_y local_size_z triangles points "
        "lines line_strip triangle_strip max_vertices invocations vertices quads isolines offset "
        "align index component row_major column_major shared early_fragment_tests rgba8 rgba16f "
        "rgba32f r32f r32i r32ui ccw cw equal_spacing";
    std::vector<std::string_view> words;
    while (!rest.empty()) words.push_back(base::nextWord(rest));
    return words;
}

void addGlsl(Collector& words, std::string_view text, const TextRange& typed,
             const std::optional<glsl::Stage>& stage, const std::vector<KnownName>& names) {
    if (const auto only = onlyWordsAfter(text.substr(0, typed.begin)); !only.empty()) {
        for (const std::string_view each : only) words.add(each, "layout");
        return;
    }
    const int version = std::max(versionOf(text), kDefaultVersion);
    // The typed word is no declaration of its own.
    std::string rest(text);
    std::fill(rest.begin() + static_cast<std::ptrdiff_t>(typed.begin),
              rest.begin() + static_cast<std::ptrdiff_t>(typed.end), ' ');
    std::vector<DeclaredName> declared = declaredNames(rest);
    const Spot place = spotOf(text.substr(0, typed.begin), declared);
    if (place == Spot::newName) return;
    std::erase_if(declared, [&](const DeclaredName& each) {
        const bool isSeen =
            each.place.begin <= typed.begin && typed.begin <= each.scopeEnd.value_or(rest.size());
        return each.isMember || (each.scopeEnd && !isSeen) ||
               (place == Spot::type && each.type != "struct" && each.type != "macro");
    });
    std::ranges::stable_partition(declared,
                                  [](const DeclaredName& each) { return each.scopeEnd.has_value(); });
    for (const DeclaredName& each : declared)
        words.add(each.name, each.isFunction ? each.declaration : each.type,
                  "line " + std::to_string(each.line) + (each.isInterface ? ": " + each.declaration : ""));
    words.nextGroup();
    if (place == Spot::type) {
        for (const std::string_view each : glsl::keywords())
            if (glsl::keywordSince(each) <= version &&
                (glsl::isTypeWord(each) || glsl::isQualifierWord(each)))
                words.add(each, glsl::isTypeWord(each) ? "type" : "keyword");
        return;
    }
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

/// True if nothing but a name and numbers stand between the statement and the word at the cursor, as the size
/// of a texture.
bool isAfterSize(std::string_view before) {
    const std::string_view statement = firstWord(before);
    before.remove_suffix(fileBefore(before).size());
    const auto begin = static_cast<std::size_t>(statement.data() + statement.size() - before.data());
    if (begin >= before.size()) return false;
    const std::string_view rest = before.substr(begin);
    const std::string_view name = firstWord(rest);
    if (name.empty() || base::isDigit(name.front())) return false;
    const auto end = static_cast<std::size_t>(name.data() + name.size() - rest.data());
    const std::string_view size = rest.substr(end);
    return size.find_first_of("0123456789") != std::string_view::npos &&
           size.find_first_not_of("0123456789. \t") == std::string_view::npos;
}

bool hasFormat(std::string_view name) {
    const glib::StatementRow* const statement =
        glib::findCommand(name) ? glib::modernFormOf(name) : glib::findStatement(name);
    return statement && hasNode(*statement, [](const glib::SyntaxNode& each) {
               return each.type == glib::ValueType::word && each.text == "format";
           });
}

/// The words that a value may be which its syntax does not list.
std::vector<std::string_view> wordsOfValue(const glib::SyntaxNode& value) {
    if (value.type == glib::ValueType::truth) return {"on", "off"};
    if (value.type == glib::ValueType::key) return {std::begin(scene::kKeyNames), std::end(scene::kKeyNames)};
    std::vector<std::string_view> words;
    if (value.type != glib::ValueType::word) return words;
    if (value.text == "type") return scene::bufferTypes();
    if (value.text == "shape") return scene::meshShapes();
    if (value.text == "role") return {scene::kAttributeRoles.begin(), scene::kAttributeRoles.end()};
    if (value.text == "preset") std::ranges::copy(scene::materialNames(), std::back_inserter(words));
    if (value.text == "format")
        std::ranges::transform(base::texelFormats(), std::back_inserter(words), &base::TexelFormatRow::name);
    if (value.text == "id")
        std::ranges::transform(glib::diagnosticCatalogue(), std::back_inserter(words),
                               &glib::CatalogueRow::id);
    return words;
}

/// A value that follows a key is proposed behind that key alone.
void addValueWords(Collector& words, std::string_view before) {
    const std::string_view name = firstWord(before);
    before = before.substr(0, before.find_last_not_of(" \t") + 1);
    const TextRange last = wordBefore(before, before.size());
    const std::string_view key = before.substr(last.begin, last.end - last.begin);
    for (const glib::StatementRow* row :
         {glib::findCommand(name), glib::modernFormOf(name), glib::findStatement(name)}) {
        std::string_view needed;
        const auto add = [&](const glib::SyntaxNode& each) {
            if (needed.empty() || glib::sameWord(needed, key))
                for (const std::string_view word : wordsOfValue(each)) words.add(word, each.text);
            needed = each.kind == glib::SyntaxNode::Kind::key ? each.text : std::string_view();
            return false;
        };
        if (row) (void)hasNode(*row, add);
    }
}

void addStatementWords(Collector& words, std::string_view name) {
    const glib::StatementRow* command = glib::findCommand(name);
    const glib::StatementRow* statement = command ? glib::modernFormOf(name) : glib::findStatement(name);
    if (command)
        for (const std::string& each : glib::wordsOf(*command)) words.add(each, "word");
    if (statement)
        for (const std::string& each : glib::wordsOf(*statement))
            words.add(each, "word of " + std::string(statement->name));
}

/// True for a classic command that takes numbers alone. A name stands only in the parentheses of an
/// expression.
bool takesNumbersOnly(std::string_view name) {
    const glib::StatementRow* command = glib::findCommand(name);
    return command && takesNumbers(*command) && !glib::modernFormOf(name);
}

/// Where a name of a scene is typed.
struct Nameable {
    std::string_view statement;
    std::string_view last;  ///< the word before it
    bool isExpression = false;

    /// `kind`: the statement that declares the name, or its type.
    [[nodiscard]] bool takes(const KnownName& name) const {
        const bool isProgram = name.type == "Program", isGroup = name.type == "Group";
        const bool isFirst = last == statement;
        if (isExpression && !isProgram && !isGroup)
            return name.type == "variable" || name.type.find('(') != std::string::npos ||
                   glib::findStatement(name.type) || glib::modernFormOf(name.type);
        if (isExpression) return false;
        if (is("Include") || is("Let")) return false;
        if (is("Use") || (is("Dispatch") && isFirst) || glib::sameWord(last, "with")) return isProgram;
        if (is("Draw") && isFirst) return isGroup;
        return !isProgram && !isGroup && (!name.isStageVariable || is("Attribute"));
    }

  private:
    [[nodiscard]] bool is(std::string_view word) const { return glib::sameWord(statement, word); }
};

/// The names that statements of the text declare: `Texture2D glow`, `Let size`; in an expression also the
/// counters and parameters around it; after `Draw ball` the parameters. `before`: the statement at the
/// cursor.
void addDeclaredNames(Collector& words, std::string_view text, std::string_view before,
                      const Nameable& nameable) {
    const auto begin = static_cast<std::size_t>(before.data() - text.data());
    std::vector<std::vector<std::string_view>> blocks;
    for (const glib::Statement& each : glib::statementsOf(text)) {
        const glib::StatementRow* row = each.modern ? each.modern : each.row;
        const std::vector<glib::Token>& tokens = each.arguments;
        const bool isBefore = each.word.begin < begin;
        if (!row || (!isBefore && each.word.begin <= begin + before.size())) continue;
        if (row->role == glib::BlockRole::closes && isBefore && !blocks.empty()) blocks.pop_back();
        const bool isGroup = row->id == glib::CommandId::group;
        std::vector<std::string_view> names;
        for (std::size_t i = 1; i < tokens.size();
             i = isGroup && i + 1 < tokens.size() ? glib::valueEnd(tokens, i + 1) : i + 1)
            if (isGroup || glib::sameWord(tokens[i - 1].text, "as")) names.push_back(tokens[i].text);
        if (row->id == glib::CommandId::repeat && names.empty()) names.emplace_back("i");
        const bool isDrawn = isGroup && !tokens.empty() && tokens.front().text == nameable.last &&
                             glib::sameWord(nameable.statement, "Draw");
        for (const std::string_view name : isDrawn ? names : std::vector<std::string_view>())
            words.add(name, "parameter");
        if (row->role == glib::BlockRole::opens && isBefore) blocks.push_back(std::move(names));
        const bool declares = row->declaresName || isGroup || row->id == glib::CommandId::program;
        if (!declares || tokens.empty() || !tokens.front().isWord()) continue;
        const KnownName name{
            std::string(tokens.front().text), std::string(row->name), {}, {}, CodeLanguage::glib};
        if (nameable.takes(name))
            words.add(name.name, name.type, "line " + std::to_string(each.word.position.line));
    }
    for (const auto& names : nameable.isExpression ? blocks : std::vector<std::vector<std::string_view>>())
        for (const std::string_view name : names) words.add(name, "number");
}

/// The words of the choice that an expression compares: `(mode == `.
void addChoices(Collector& words, std::string_view text, std::string_view before) {
    before = base::trimmed(before);
    if (!before.ends_with("==") && !before.ends_with("!=")) return;
    before = base::trimmed(before.substr(0, before.size() - 2));
    const TextRange name = wordBefore(before, before.size());
    for (const glib::Statement& each : glib::statementsOf(text))
        if (glib::sameWord(each.word.text, "Let") && each.arguments.size() > 2 &&
            each.arguments[0].text == before.substr(name.begin) && each.arguments[1].text == "<")
            for (const glib::Token& word : each.arguments)
                if (word.kind == glib::TokenKind::word && &word != &each.arguments[0])
                    words.add(word.text, "word of " + std::string(each.arguments[0].text));
}

/// The name that a point follows, perhaps with parts between them: `sky.face(+x).`
std::string_view nameBefore(std::string_view text, std::size_t point) {
    for (;;) {
        std::size_t end = point;
        if (end > 0 && (text[end - 1] == ')' || text[end - 1] == ']')) {
            int depth = 0;
            do {
                const char c = text[--end];
                if (c == '\n') return {};
                depth += c == ')' || c == ']' ? 1 : c == '(' || c == '[' ? -1 : 0;
            } while (depth > 0 && end > 0);
        }
        const TextRange word = wordBefore(text, end);
        if (word.begin == word.end) return {};
        if (word.begin == 0 || text[word.begin - 1] != '.')
            return text.substr(word.begin, word.end - word.begin);
        point = word.begin - 1;
    }
}

/// The word of the statement that declares the name; empty if none does.
std::string declaringStatement(std::string_view text, std::string_view name) {
    for (const Declaration& each : declarationsOf(text))
        if (each.name == name && !each.isBlock) return each.word;
    return {};
}

/// The parts and fields that may follow the name before a point.
void addParts(Collector& words, std::string_view text, std::size_t point) {
    const std::string_view name = nameBefore(text, point);
    if (name.empty() || base::isDigit(name.front())) return;
    if (const glib::StatementRow* row = glib::findStatement(firstWord(statementBefore(text, point))))
        (void)hasNode(*row, [&](const glib::SyntaxNode& each) {
            if (each.kind == glib::SyntaxNode::Kind::key && glib::sameWord(each.text, name))
                for (const std::string& word : each.words) words.add(word, each.text);
            return false;
        });
    const std::string statement = glib::lower(declaringStatement(text, name));
    const bool isCamera = statement == "camera" || name == "camera" || name == "eye";
    const bool isCube = statement == "cubemap";
    const bool isTexture = isCube || statement.starts_with("texture") || name == "window";
    for (const expression::PartRow& each : expression::partTable()) {
        const std::string_view owner = each.form.substr(0, each.form.find('.'));
        const bool isObject = statement == "buffer" || (isTexture && name != "window");
        const bool fits = owner == "TEXTURE"    ? isTexture && isObject
                          : owner == "CUBE"     ? isCube
                          : owner == "BUFFER"   ? statement == "buffer"
                          : owner == "MESH"     ? statement == "mesh"
                          : each.word == "prev" ? isCamera || isObject
                                                : false;
        if (fits) words.add(each.word, std::string(each.form), std::string(each.summary));
    }
    words.nextGroup();
    if (isCamera)
        for (const expression::NameRow& each : expression::cameraFields())
            words.add(each.path, expression::name(each.type), std::string(each.summary));
    if (isTexture)
        for (const char* each : {"r", "g", "b", "a"}) words.addInOrder(each, "component", {});
}

/// The files that the statement may name: shaders of its stage, scenes after Include, else what is neither.
bool fits(std::string_view statement, const std::filesystem::path& file) {
    const std::optional<glsl::Stage> stage = source::stageOfEndWord("End" + std::string(statement));
    if (stage) return isShaderFile(file) && stageOfFile(file).value_or(*stage) == *stage;
    const bool isScene = glib::sameWord(file.extension().generic_string(), ".glib");
    if (glib::sameWord(statement, "Include")) return isScene;
    return !isScene && !isShaderFile(file);
}

void addGlib(Collector& words, std::string_view text, const TextRange& typed, const CodeContext& context) {
    const std::vector<KnownName>& names = context.names;
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
        addValueWords(words, before);
        if (hasFormat(statement) && isAfterSize(before)) return;
        addStatementWords(words, statement);
        words.nextGroup();
    }
    if (!isExpression && takesNumbersOnly(statement)) return;
    const std::string_view code = before.substr(0, before.find_last_not_of(" \t") + 1);
    const Nameable nameable{statement, code.substr(wordBefore(code, code.size()).begin), isExpression};
    if (isExpression) addChoices(words, text, before);
    addDeclaredNames(words, text, before, nameable);
    for (const KnownName& each : names)
        if (each.in == CodeLanguage::glib && nameable.takes(each)) words.add(each.name, each.type, each.what);
    if (glib::sameWord(nameable.last, "from")) words.add("eye", "Camera");
    if (nameable.last == statement &&
        (glib::sameWord(statement, "Pass") || glib::sameWord(statement, "Fill")))
        words.add("window", "the picture");
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

std::vector<LanguageAt> shadersIn(std::string_view scene) {
    source::InlineShaders shaders;
    std::vector<LanguageAt> found;
    bool isInShader = false;
    glib::LineSplitter lines(scene);
    while (const std::optional<glib::LineRange> line = lines.next()) {
        const std::optional<glsl::Stage> stage =
            shaders.next(scene.substr(line->begin, line->end - line->begin));
        if (stage && !isInShader)
            found.push_back({CodeLanguage::glsl, stage, {line->begin, scene.size()}});
        else if (!stage && isInShader)
            found.back().part.end = line->begin;
        isInShader = stage.has_value();
    }
    return found;
}

LanguageAt languageAt(std::string_view text, std::size_t byte, const CodeContext& context) {
    if (context.language == CodeLanguage::glib)
        for (const LanguageAt& each : shadersIn(text)) {
            const bool isLast = each.part.end == text.size();
            if (each.part.begin <= byte && (byte < each.part.end || isLast)) return each;
        }
    return {context.language, context.stage, {0, text.size()}};
}

namespace {

/// The file that is typed after a statement that takes one; nothing if there is none.
std::optional<std::string_view> typedFile(std::string_view before) {
    const std::string_view statement = firstWord(before);
    const glib::StatementRow* const rows[] = {glib::modernFormOf(statement), glib::findCommand(statement),
                                              glib::findStatement(statement)};
    const bool takes =
        std::ranges::any_of(rows, [](const glib::StatementRow* each) { return each && takesFile(*each); });
    if (!takes || before.find('#') != std::string_view::npos || before.find("//") != std::string_view::npos ||
        (hasFormat(statement) && isAfterSize(before)))
        return std::nullopt;
    const std::string_view file = fileBefore(before);
    const bool isAfterStatement = file.data() > statement.data() + statement.size();
    return isAfterStatement && !base::isDigit(file.empty() ? ' ' : file.front()) ? std::optional(file)
                                                                                 : std::nullopt;
}

std::vector<Completion> wordsAt(std::string_view text, std::size_t cursor, const CodeContext& context) {
    TextRange typed = wordBefore(text, cursor);
    const LanguageAt at = languageAt(text, cursor, context);
    while (at.language == CodeLanguage::glib &&
           typed.begin > 0 &&  // of names of programs, which may have any bytes
           (isOfName(text[typed.begin - 1]) || static_cast<unsigned char>(text[typed.begin - 1]) >= 0x80))
        --typed.begin;
    const bool isNumber = typed.begin < typed.end && base::isDigit(text[typed.begin]);
    const auto from = [](std::vector<Completion> words, std::size_t begin) {
        for (Completion& each : words) each.begin = begin;
        return words;
    };
    if (at.language == CodeLanguage::glib) {
        const std::string_view statement = statementBefore(text, cursor);
        const std::optional<std::string_view> file = typedFile(statement);
        const std::size_t begin = cursor - file.value_or(std::string_view{}).size();
        if (file) {
            Collector files(*file);
            addFiles(files, context.folders, *file,
                     [&](const std::filesystem::path& each) { return fits(firstWord(statement), each); });
            std::vector<Completion> found = from(files.take(), begin);
            if (begin < typed.begin || isInComment(text, cursor, at.language)) return found;
            Collector words(text.substr(typed.begin, typed.end - typed.begin));
            const glib::StatementRow* const command = glib::findCommand(firstWord(statement));
            if (command && argumentsOf(*command).size() == 1)
                addStatementWords(words, firstWord(statement));
            else
                addGlib(words, text, typed, context);
            std::vector<Completion> others = from(words.take(), typed.begin);
            std::ranges::move(others, std::back_inserter(found));
            return found;
        }
        if (isNumber || isInComment(text, cursor, at.language)) return {};
        Collector words(text.substr(typed.begin, typed.end - typed.begin));
        if (typed.begin > 0 && text[typed.begin - 1] == '.')
            addParts(words, text, typed.begin - 1);
        else
            addGlib(words, text, typed, context);
        return from(words.take(), typed.begin);
    }
    const std::string_view part = text.substr(at.part.begin, at.part.end - at.part.begin);
    const std::string_view line = lineBefore(text, cursor);
    if (const std::string_view file = fileBefore(line); !isInComment(text, cursor, at.language)) {
        const bool isInclude = line.find("include") != std::string_view::npos;
        Collector words(isInclude ? file : text.substr(typed.begin, typed.end - typed.begin));
        if (addDirective(words, line, part, context))
            return from(words.take(), isInclude ? cursor - file.size() : typed.begin);
    }
    if (isNumber || isInComment(text, cursor, at.language)) return {};
    Collector words(text.substr(typed.begin, typed.end - typed.begin));
    if (typed.begin > at.part.begin && text[typed.begin - 1] == '.') {
        // Names that other files declare are declared here.
        std::string whole;
        for (const KnownName& each : context.names)
            if (each.in == CodeLanguage::glsl && glsl::isTypeWord(each.type) &&
                std::ranges::all_of(each.name, isOfName))
                whole += each.type + " " + each.name + ";";
        whole += '\n';  // the text may begin with a directive
        const std::size_t before = whole.size();
        whole += part;
        for (const DeclaredName& each :
             membersAt(whole, before + typed.begin - 1 - at.part.begin, before + typed.end - at.part.begin))
            words.addInOrder(each.name, each.type, each.declaration);
        return from(words.take(), typed.begin);
    }
    if (context.language == CodeLanguage::glib && at.stage) {
        words.add(source::endWordOf(*at.stage), "statement", "ends the shader");
        words.nextGroup();
    }
    addGlsl(words, part, {typed.begin - at.part.begin, typed.end - at.part.begin}, at.stage, context.names);
    return from(words.take(), typed.begin);
}

}  // namespace

std::vector<Completion> completionsAt(std::string_view text, std::size_t cursor, const CodeContext& context) {
    return wordsAt(text, std::min(cursor, text.size()), context);
}

}  // namespace glibra::editor

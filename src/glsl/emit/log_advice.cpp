#include "glsl/emit/log_advice.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/suggest.h"
#include "base/utf8.h"
#include "glsl/facts/stage_variables.h"
#include "glsl/parse/types.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

/// What core GLSL has instead of words of HLSL, Cg, C and extensions of old GLSL, which have blanks around
/// each.
struct ForeignWords {
    std::string_view core, words;
};
constexpr auto kForeignWords = std::to_array<ForeignWords>({
    {"fract", " frac "},
    {"clamp(x, 0.0, 1.0)", " saturate "},
    {"mix", " lerp "},
    {"inversesqrt", " rsqrt "},
    {"1.0 / x", " rcp "},
    {"dFdx", " ddx "},
    {"dFdy", " ddy "},
    {"mod", " fmod "},
    {"atan", " atan2 "},
    {"a * b", " mul "},
    {"a * b + c", " mad "},
    {"if (x < 0.0) discard", " clip "},
    {"log2(x) * 0.30103", " log10 "},
    {"abs", " fabs "},
    {"min", " fmin "},
    {"max", " fmax "},
    {"sqrt", " sqrtf "},
    {"pow", " powf "},
    {"sin", " sinf "},
    {"cos", " cosf "},
    {"floor", " floorf "},
    {"texture", " tex1D tex2D tex3D texCUBE tex2Dbias "},
    {"textureLod", " tex2Dlod texture1DLod texture2DLod texture3DLod textureCubeLod texture2DLodEXT "},
    {"textureProj", " tex2Dproj "},
    {"textureGrad", " tex2Dgrad "},
    {"float", " float1 half fixed string "},
    {"vec2", " float2 half2 "},
    {"vec3", " float3 half3 fixed3 "},
    {"vec4", " float4 half4 fixed4 "},
    {"ivec2", " int2 "},
    {"ivec3", " int3 "},
    {"ivec4", " int4 "},
    {"uvec2", " uint2 "},
    {"uvec3", " uint3 "},
    {"uvec4", " uint4 "},
    {"bvec2", " bool2 "},
    {"bvec3", " bool3 "},
    {"bvec4", " bool4 "},
    {"mat2", " float2x2 "},
    {"mat3", " float3x3 "},
    {"mat4", " float4x4 "},
    {"sampler2D", " Texture2D "},
    {"sampler3D", " Texture3D "},
    {"samplerCube", " TextureCube "},
});

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// The word as the user wrote it.
std::string userWord(const TranslatedProgram& program, std::string_view emitted) {
    std::string word(emitted);
    if (!word.starts_with("glibra_")) return word;
    const auto found = program.userNames.find(word);
    return found != program.userNames.end() ? found->second : "gl_" + word.substr(7);
}

/// True if the text has the driver's name of a token: "NEW_IDENTIFIER".
bool hasJargon(std::string_view text) {
    constexpr std::size_t kLeast = 4;  // "EOF", "GL" and "C0000" are none
    std::size_t run = 0;
    bool isQuoted = false;  // words of the shader are
    for (const char each : text) {
        if (each == '"' || each == '\'') isQuoted = !isQuoted;
        if (isQuoted) continue;
        run = (each >= 'A' && each <= 'Z') || each == '_' ? run + 1 : 0;
        if (run == kLeast) return true;
    }
    return false;
}

/// The driver's names of tokens, which are no GLSL ("BASIC_TYPE_TOK"), give way to the token itself.
std::string readableSyntaxError(std::string_view driver, std::string_view token) {
    std::string text = "syntax error";
    if (!token.empty()) text += " at '" + std::string(token) + "'";
    constexpr std::string_view kExpecting = "expecting ";
    const std::size_t at = driver.find(kExpecting);
    if (at == std::string_view::npos) return text;
    const std::string_view expected = driver.substr(at + kExpecting.size());
    const bool isJargon = expected.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") != std::string_view::npos;
    return isJargon ? text : text + ", expected " + std::string(expected.substr(0, expected.find(" at ")));
}

}  // namespace

/// The tokens of an emitted source that the grammar sees, except those of directives.
class LogAdvice::Source {
  public:
    explicit Source(const TranslatedStage& stage) : stage_(stage) {
        for (const Token& each : lex(stage.source, storage_)) {
            // lex() does not know directives: a line that begins with # is one.
            if (each.text == "#" && (tokens_.empty() || tokens_.back().line < each.line))
                directive_ = each.line;
            if (isSignificant(each.kind) && each.line != directive_) tokens_.push_back(each);
        }
        matches_ = matchBrackets(tokens_, static_cast<std::uint32_t>(tokens_.size()));
    }

    [[nodiscard]] std::size_t size() const { return tokens_.size(); }
    [[nodiscard]] const Token& operator[](std::size_t at) const { return tokens_[at]; }
    [[nodiscard]] std::string_view text(std::size_t at) const {
        return at < tokens_.size() ? tokens_[at].text : std::string_view{};
    }
    [[nodiscard]] bool isWord(std::size_t at) const {
        return at < tokens_.size() && tokens_[at].kind == TokenKind::word;
    }
    /// The first token at or after the place; size() if there is none.
    [[nodiscard]] std::size_t find(const EmittedPlace& place) const {
        const auto line = static_cast<std::int32_t>(place.line) + 1;
        const auto found = std::ranges::find_if(tokens_, [&](const Token& each) {
            return each.line > line ||
                   (each.line == line &&
                    each.column + static_cast<std::int32_t>(each.text.size()) > place.column);
        });
        return static_cast<std::size_t>(found - tokens_.begin());
    }

    /// The first such word on a line; size() if there is none.
    [[nodiscard]] std::size_t findWord(std::size_t line, std::string_view word) const {
        const auto found = std::ranges::find_if(tokens_, [&](const Token& each) {
            return each.line == static_cast<std::int32_t>(line) + 1 && each.text == word;
        });
        return static_cast<std::size_t>(found - tokens_.begin());
    }

    /// The user's place of a column of a token; nothing if the translator wrote its line.
    [[nodiscard]] std::optional<Place> userPlace(const Token& token, int column) const {
        const auto line = static_cast<std::size_t>(token.line - 1);
        if (line >= stage_.lineMap.lines.size()) return std::nullopt;
        if (stage_.lineMap.lines[line].file < 0) return std::nullopt;
        const UserPlace user = glsl::userPlace(stage_, EmittedPlace{line, column});
        return Place{stage_.lineMap.files[static_cast<std::size_t>(user.line.file)], user.line.line,
                     user.column};
    }

    /// True if a statement cannot go on after the token without an operator: a name, a number, a closing
    /// bracket.
    [[nodiscard]] bool endsAnOperand(std::size_t at) const {
        const Token& token = tokens_[at];
        if (token.kind == TokenKind::number || token.text == "]") return true;
        if (token.kind == TokenKind::word)
            return (!isStatementWord(token.text) || token.text == "break" || token.text == "continue" ||
                    token.text == "discard" || token.text == "return") &&
                   !isTypeWord(token.text) && !isQualifierWord(token.text);
        const std::size_t open = matches_[at];
        if (open == size() || open == 0) return false;
        const std::string_view before = text(open - 1);
        if (token.text == ")")
            return before != "if" && before != "for" && before != "while" && before != "switch";
        // struct S { ... } and uniform Block { ... } need a semicolon, the braces of statements do not.
        return token.text == "}" && isWord(open - 1) && open >= 2 &&
               (text(open - 2) == "struct" || isQualifierWord(text(open - 2)));
    }

    /// True if the token begins a statement or a declaration, or ends a block.
    [[nodiscard]] bool beginsAStatement(std::size_t at) const { return isWord(at) || text(at) == "}"; }

    /// True if the token stands between parentheses that a statement or declaration does not go on in: all
    /// but those of `for`.
    [[nodiscard]] bool isInParentheses(std::size_t at) const {
        int closed = 0;
        for (std::size_t i = at; i-- > 0;) {
            if (text(i) == ")") ++closed;
            if (text(i) == "(" && closed-- == 0) return i == 0 || text(i - 1) != "for";
            if (closed == 0 && (text(i) == ";" || text(i) == "{" || text(i) == "}")) return false;
        }
        return false;
    }

    /// True if the word stands where a declaration may begin.
    [[nodiscard]] bool isAtTheStart(std::size_t at) const {
        if (at == 0) return true;
        const std::string_view before = text(at - 1);
        return before == ";" || before == "{" || before == "}" || before == "(" || before == "," ||
               isQualifierWord(before);
    }

  private:
    const TranslatedStage& stage_;
    std::deque<std::string> storage_;
    std::vector<Token> tokens_;
    std::vector<std::uint32_t> matches_;  ///< the partners of brackets; size() if there is none
    std::int32_t directive_ = 0;
};

LogAdvice::LogAdvice(const TranslatedProgram& program, const TranslatedStage& stage)
    : program_(program), stage_(stage) {}
LogAdvice::~LogAdvice() = default;

const LogAdvice::Source& LogAdvice::source() {
    if (!source_) source_ = std::make_unique<const Source>(stage_);
    return *source_;
}

std::string LogAdvice::inputFor(std::string_view word) const {
    std::string declaration;
    for (const TranslatedStage& stage : program_.stages) {
        if (stage.stage == stage_.stage) return declaration;
        for (const StageVariable& each : stageVariables(stage, program_.userNames))
            if (each.isOutput && each.name == word && each.elements == 0)
                declaration = "in " + each.type + " " + each.name + ";";
    }
    return declaration;
}

std::string LogAdvice::suggestionFor(std::string_view word, bool isType) {
    const auto* const foreign = std::ranges::find_if(
        kForeignWords, [&](const ForeignWords& each) { return listed(each.words, word); });
    if (foreign != kForeignWords.end()) return "; did you mean '" + std::string(foreign->core) + "'?";
    if (!isType)
        if (const std::string declaration = inputFor(word); !declaration.empty())
            return "; declare '" + declaration + "' in this stage";
    constexpr std::size_t kMostNames = 10'000;
    const Source& source = this->source();
    std::set<std::string> names;
    for (std::size_t i = 0; i + 1 < source.size() && names.size() < kMostNames; ++i) {
        // "vec3 color;", "float glow(", "Light light": the name in a declaration comes after a word.
        if (!source.isWord(i) || !source.isWord(i + 1) || isStatementWord(source.text(i))) continue;
        const std::string name(source.text(i + 1));
        if (keywordSince(name) > 0 || (isType && source.text(i) != "struct")) continue;
        const auto user = program_.userNames.find(name);
        if (user != program_.userNames.end())
            names.insert(user->second);
        else if (!name.starts_with("glibra_"))
            names.insert(name);
    }
    std::vector<std::string_view> candidates(names.begin(), names.end());
    if (isType) {
        for (const std::string_view each : keywords())
            if (isTypeWord(each)) candidates.push_back(each);
    } else {
        for (const std::string_view each : coreFunctions()) candidates.push_back(each);
    }
    return base::suggestion(word, candidates);
}

void LogAdvice::explainSyntaxError(const LogLine& line, Diagnostic& message) {
    const bool endsEarly =
        contains(line.text, "unexpected end of file") || contains(line.text, "unexpected $end");
    if (endsEarly) message.text = "syntax error: the file ends too early; is a '}' missing?";
    if (!endsEarly && hasJargon(line.text)) message.text = readableSyntaxError(line.text, {});
    const Source& source = this->source();
    const std::optional<EmittedPlace> place = emittedPlace(stage_, line, message.place.file);
    if (!place) return;
    // Without a column the token is the one that the message quotes: "at token \"vec3\"".
    const std::size_t at =
        place->column > 0 ? source.find(*place) : source.findWord(place->line, quotedWord(line.text));
    // Compilers take a character that GLSL does not have for the end of the file, or leave it out.
    const std::string_view text = lineOfText(stage_.source, place->line);
    const std::size_t column = static_cast<std::size_t>(std::max(1, place->column)) - 1;
    if (column < text.size() && base::firstCharacter(text.substr(column)).code >= 0x80) {
        message.text = "syntax error: GLSL has no character " + base::visibleCharacter(text.substr(column)) +
                       " outside comments";
        return;
    }
    if (endsEarly || at == 0 || at == source.size()) return;
    const Token& before = source[at - 1];
    if (before.line == source[at].line && before.kind == TokenKind::word && source.isWord(at) &&
        source.isAtTheStart(at - 1) && keywordSince(before.text) == 0 && keywordSince(source.text(at)) == 0) {
        message.text = "unknown type '" + std::string(before.text) + "'" + suggestionFor(before.text, true);
        if (const auto user = source.userPlace(before, before.column)) message.place = *user;
        return;
    }
    if (source.endsAnOperand(at - 1) && source.beginsAStatement(at)) {
        if (const std::optional<Place> user = source.userPlace(before, before.column)) {
            const std::string word = userWord(program_, before.text);
            const char* what =
                source.isInParentheses(at) ? "missing ',' or ')' after '" : "missing ';' after '";
            message.text = what + word + "'";
            message.place = {user->file, user->line, user->column + static_cast<int>(word.size())};
            return;
        }
    }
    message.text = readableSyntaxError(line.text, userWord(program_, source.text(at)));
}

void LogAdvice::nameTypes(const LogLine& line, Diagnostic& message) const {
    // The driver may point to any part of the expression; of several on one line the nearest is meant.
    const TypeMismatch* nearest = nullptr;
    const auto distance = [&](const TypeMismatch& each) {
        return std::abs(each.place.column - message.place.column);
    };
    const bool isReturn = contains(line.text, "return");
    for (const TypeMismatch& each : stage_.mismatches) {
        const bool fits = each.place.file == message.place.file && each.place.line == message.place.line &&
                          isReturn == each.text.starts_with("the value");
        if (fits && (nearest == nullptr || distance(each) < distance(*nearest))) nearest = &each;
    }
    if (nearest != nullptr) message.text += ": " + nearest->text;
}

void LogAdvice::addTo(const LogLine& line, Diagnostic& message) {
    constexpr int kMostMessages = 32;
    if (++messages_ > kMostMessages) return;
    if (isSyntaxError(line.text)) {
        explainSyntaxError(line, message);
    } else if (const std::string word(undeclaredName(message.text)); !word.empty()) {
        if (keywordSince(word) == 0) message.text += suggestionFor(word, false);
    } else if (isAboutTypes(line.text)) {
        nameTypes(line, message);
    }
}

}  // namespace glibra::glsl

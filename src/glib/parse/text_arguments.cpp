// Commands whose arguments are not only numbers: files, units, textures, topologies, switches (language, 3.3
// to 3.5).

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/suggest.h"
#include "base/text.h"
#include "glib/lexer.h"
#include "glib/limits.h"
#include "glib/number.h"
#include "glib/parse/arguments.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

constexpr std::size_t kCubeFaces = 6;

bool isCompleteNumberToken(const Token& token) {
    return token.kind == TokenKind::number && isCompleteNumber(token.text);
}

void setText(Command& command, const Token& token) {
    command.text = token.text;
    command.textPosition = token.position;
}

const TextureFormat* findFormat(const Token& token) {
    if (token.kind != TokenKind::word) return nullptr;
    const auto formats = textureFormats();
    const auto found = std::ranges::find_if(
        formats, [&](const TextureFormat& format) { return sameWord(format.name, token.text); });
    return found == formats.end() ? nullptr : &*found;
}

void checkTextureBytes(const Command& command, const TextureFormat& format, MessageLog& log) {
    double bytes = format.bytes;
    for (std::size_t i = 1; i < command.numbers.size(); ++i) bytes *= command.numbers[i];
    if (bytes > kLargestTexture)
        log.report("glib-E15",
                   fmt::format("{} needs {} bytes; the limit is {}", command.word,
                               base::groupedText(static_cast<long long>(bytes)),
                               base::groupedText(static_cast<long long>(kLargestTexture))),
                   command.position);
}

/// Reads an empty texture: sizes and perhaps a format.
void readSizes(const Statement& statement, std::span<const Token> tokens, std::size_t sizes,
               const TextureFormat* format, Command& command, MessageLog& log) {
    const CommandRow& row = *statement.row;
    const std::size_t most = row.arguments.size() - 1;
    const std::size_t least = row.id == CommandId::texture ? 1 : most;
    if (sizes < least) {
        command.lacksFile = true;
        log.report("glib-E04",
                   fmt::format("{} needs a file name or {} after the unit, found {}", row.name(),
                               base::counted(least, "size"), sizes),
                   command.position);
        return;
    }
    const std::size_t used = std::min(sizes, most);
    const std::size_t errors = log.errorCount();
    for (std::size_t i = 1; i <= used; ++i) {
        Argument argument = row.arguments[i];
        if (row.id == CommandId::texture && sizes < 3) argument.most = kLargestTextureSide;
        command.numbers.push_back(readArgument(argument, i, tokens[i], row.name(), log));
    }
    command.text = format ? format->name : textureFormats().front().name;
    command.textPosition = format ? tokens[sizes + 1].position : command.position;
    reportSurplus(statement, tokens.first(sizes + 1), used + 1, log);
    if (log.errorCount() == errors)
        checkTextureBytes(command, format ? *format : textureFormats().front(), log);
}

}  // namespace

void readFile(const Statement& statement, Command& command, MessageLog& log) {
    const std::vector<Token> tokens = plainArguments(statement, log);
    if (!tokens.empty()) setText(command, tokens.front());
    reportSurplus(statement, tokens, 1, log);
}

void readCubeMap(const Statement& statement, Command& command, MessageLog& log) {
    const CommandRow& row = *statement.row;
    const std::vector<Token> tokens = plainArguments(statement, log);
    const std::size_t files = tokens.empty() ? 0 : tokens.size() - 1;
    if (files < kCubeFaces) {
        log.report("glib-E04",
                   fmt::format("CubeMap needs a unit and {} files, found {}", kCubeFaces,
                               base::counted(files, "file")),
                   command.position);
        return;
    }
    command.numbers.push_back(readArgument(row.arguments.front(), 0, tokens.front(), row.name(), log));
    command.givenNumbers = 1;
    for (std::size_t i = 1; i <= kCubeFaces; ++i) command.files.emplace_back(tokens[i].text);
    command.textPosition = tokens[1].position;
    reportSurplus(statement, tokens, kCubeFaces + 1, log);
}

void readUnits(const Statement& statement, Command& command, MessageLog& log) {
    const CommandRow& row = *statement.row;
    const std::vector<Token> tokens = plainArguments(statement, log);
    if (tokens.size() > kMostTargets) {
        log.report("glib-E15",
                   fmt::format("{}: {} targets; the limit is {}", row.name(), tokens.size(), kMostTargets),
                   tokens[kMostTargets].position);
        return;
    }
    for (std::size_t i = 0; i < tokens.size(); ++i)
        command.numbers.push_back(readArgument(row.arguments.front(), i, tokens[i], row.name(), log));
    command.givenNumbers = tokens.size();
}

void readTexture(const Statement& statement, Command& command, MessageLog& log) {
    const CommandRow& row = *statement.row;
    const std::vector<Token> tokens = plainArguments(statement, log);
    if (tokens.empty()) {
        log.report("glib-E04", fmt::format("{} needs a unit and a file name or sizes", row.name()),
                   command.position);
        return;
    }
    command.numbers.push_back(readArgument(row.arguments.front(), 0, tokens.front(), row.name(), log));

    std::size_t sizes = 0;
    while (sizes + 1 < tokens.size() && isCompleteNumberToken(tokens[sizes + 1])) ++sizes;
    const std::size_t rest = tokens.size() - 1 - sizes;
    const TextureFormat* format = rest == 1 ? findFormat(tokens.back()) : nullptr;
    if (rest == 0 || format) {
        readSizes(statement, tokens, sizes, format, command, log);
    } else if (rest == 1 && sizes >= 2 && tokens.back().kind == TokenKind::word) {
        // A size stands before the word, so the word is not a file name: it was meant as a format.
        log.report("glib-E16",
                   fmt::format("{}: {} is not one of the formats RGBA8, RGBA16F, RGBA32F, R32F", row.name(),
                               inQuotes(tokens.back().text)),
                   tokens.back().position);
    } else {
        setText(command, tokens[1]);
        reportSurplus(statement, tokens, 2, log);
    }
    command.givenNumbers = command.numbers.size();
}

void readTopology(const Statement& statement, Command& command, MessageLog& log) {
    const CommandRow& row = *statement.row;
    const std::vector<Token> tokens = plainArguments(statement, log);
    if (tokens.empty()) {
        log.report("glib-E04", fmt::format("{} needs a topology word", row.name()), command.position);
        return;
    }
    constexpr std::string_view kPrefix = "gl_";
    std::string_view word = tokens.front().text;
    if (sameWord(word.substr(0, kPrefix.size()), kPrefix)) word.remove_prefix(kPrefix.size());
    if (row.id == CommandId::geometryOutput && sameWord(word, "triangles_strip")) word = "triangle_strip";
    const auto found =
        std::ranges::find_if(row.words, [&](std::string_view each) { return sameWord(each, word); });
    if (found == row.words.end()) {
        const std::string nearest = base::nearestName(word, row.words);
        log.report("glib-E08",
                   fmt::format("unknown topology {}{}", inQuotes(tokens.front().text),
                               nearest.empty() ? std::string() : "; did you mean " + inQuotes(nearest) + "?"),
                   tokens.front().position);
    } else {
        command.text = *found;
        command.textPosition = tokens.front().position;
    }
    reportSurplus(statement, tokens, 1, log);
}

void readSwitch(const Statement& statement, Command& command, MessageLog& log) {
    const std::vector<Token> tokens = plainArguments(statement, log);
    reportSurplus(statement, tokens, 1, log);
    command.numbers = {1};
    if (tokens.empty()) return;
    const Token& token = tokens.front();
    setText(command, token);
    command.givenNumbers = 1;
    if (token.kind == TokenKind::number) {
        const double value = readNumber(token, log).value;
        command.numbers = {value};
        if (value == 0 || value == 1) return;
    } else if (token.truth()) {
        command.numbers = {*token.truth() ? 1. : 0.};
        return;
    } else if (sameWord(token.text, "on") || sameWord(token.text, "off")) {
        command.numbers = {sameWord(token.text, "on") ? 1. : 0.};
        return;
    }
    log.report("glib-E16",
               fmt::format("{}: {} is not one of on, off, 1, 0, true, false", statement.row->name(),
                           inQuotes(token.text)),
               token.position);
}

// ---- The name and the tags of a Program statement (language, 5.1 and 5.2).

namespace {

UniformForm formOf(std::string_view bracket) {
    if (bracket == "<") return UniformForm::range;
    return bracket == "{" ? UniformForm::color : UniformForm::list;
}

/// Returns the last part of a path without its suffix.
std::string_view stem(std::string_view path) {
    const std::size_t folder = path.find_last_of("/\\");
    if (folder != std::string_view::npos) path.remove_prefix(folder + 1);
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos || dot == 0 ? path : path.substr(0, dot);
}

class ProgramReader {
  public:
    ProgramReader(const Statement& statement, Command& command, MessageLog& log)
        : statement_(statement), tokens_(statement.arguments), command_(command), log_(log) {}

    void read(std::string_view fragmentFile) {
        readName(fragmentFile);
        while (at_ < tokens_.size() && !tooManyTags()) {
            if (!tokens_[at_].isWord()) {
                skipValue();
            } else if (isFollowedByValue(at_)) {
                readPair();
            } else {
                reportNoValue(tokens_[at_]);
                ++at_;
            }
        }
    }

  private:
    /// True for a word, and for a number with letters after it (`3DNoise`).
    static bool canBeName(const Token& token) {
        return token.isWord() || (token.kind == TokenKind::number && !isCompleteNumber(token.text));
    }
    bool isFollowedByValue(std::size_t at) const {
        return at + 1 < tokens_.size() && tokens_[at + 1].beginsValue();
    }

    void readName(std::string_view fragmentFile) {
        if (tokens_.empty() || !canBeName(tokens_[0]) || isFollowedByValue(0)) {
            const std::string_view name = stem(fragmentFile);
            command_.text = name.empty() ? "unnamed" : name;
            command_.textPosition = command_.position;
            log_.report("glib-W14", fmt::format("program name missing; {} used", inQuotes(command_.text)),
                        command_.position);
            return;
        }
        command_.text = tokens_[0].text;
        command_.textPosition = tokens_[0].position;
        for (at_ = 1; at_ < tokens_.size() && canBeName(tokens_[at_]); ++at_) {
            if (isFollowedByValue(at_) || tokens_[at_].position.line != statement_.word.position.line) break;
            command_.text += ' ';
            command_.text += tokens_[at_].text;
        }
        if (at_ > 1)
            log_.report("glib-W16", fmt::format("program name {} has several words", inQuotes(command_.text)),
                        command_.textPosition);
    }

    bool tooManyTags() {
        if (command_.uniforms.size() < kMostTags || !tokens_[at_].isWord()) return false;
        log_.report("glib-E15",
                    fmt::format("Program {} has more than {} tags", inQuotes(command_.text), kMostTags),
                    tokens_[at_].position);
        return true;
    }

    void skipValue() {
        const Token& token = tokens_[at_];
        const std::size_t next = valueEnd(tokens_, at_);
        std::string text;
        for (std::size_t i = at_; i < next && text.size() < kLongestShown; ++i) {
            if (i > at_) text += ' ';
            text += tokens_[i].text;
        }
        log_.report(
            "glib-W18",
            fmt::format("value {} has no tag, skipped", text.size() < kLongestShown ? text : inQuotes(text)),
            token.position);
        at_ = next;
    }

    void reportNoValue(const Token& tag) {
        log_.report("glib-W17", fmt::format("tag {} has no value; it is skipped", inQuotes(tag.text)),
                    tag.position);
    }

    void readPair() {
        const Token& tag = tokens_[at_];
        const Token& value = tokens_[at_ + 1];
        UniformSpec spec{std::string(tag.text), UniformForm::number, {}, tag.position, value.position};
        if (value.kind == TokenKind::number) {
            spec.values.push_back(readNumber(value, log_).value);
            at_ += 2;
        } else {
            if (!readGroup(spec, at_ + 1)) return;
            if (spec.values.empty()) return reportNoValue(tag);
        }
        add(std::move(spec));
    }

    /// Returns false if the group is refused.
    bool readGroup(UniformSpec& spec, std::size_t open) {
        const BracketGroup group = groupAt(tokens_, open);
        const Token& bracket = tokens_[open];
        at_ = group.next;
        if (bracket.text == "(") log_.report("glib-W10", "'(' read as '['", bracket.position);
        reportGroupEnd(tokens_, open, group, log_);
        const std::size_t count = group.last - group.first;
        spec.form = formOf(bracket.text);
        if (count > kMostBracketValues) {
            log_.report("glib-E15",
                        fmt::format("{}: {} values in brackets; the limit is {}", spec.tag,
                                    base::groupedText(count), base::groupedText(kMostBracketValues)),
                        bracket.position);
            return false;
        }
        if (spec.form == UniformForm::range && count == 1 && tokens_[group.first].truth()) {
            spec.form = UniformForm::truth;
            spec.values = {*tokens_[group.first].truth() ? 1. : 0.};
            return true;
        }
        std::vector<std::string> written;
        for (std::size_t i = group.first; i < group.last; ++i) {
            const ReadNumber number = readValue(tokens_[i]);
            spec.values.push_back(number.value);
            if (written.size() < 2) written.emplace_back(number.text);
        }
        reportCount(spec, written);
        return true;
    }

    /// Reads a number of a group; `true` among numbers is 1.
    ReadNumber readValue(const Token& token) {
        if (token.truth() != true) return readNumber(token, log_);
        log_.report("glib-W05", fmt::format("{} is not a number, 1 used", inQuotes(token.text)),
                    token.position);
        return {1, "1"};
    }

    /// Reports glib-W15 where it does not depend on the declared type.
    void reportCount(const UniformSpec& spec, std::span<const std::string> written) {
        const std::size_t count = spec.values.size();
        const auto report = [&](std::string_view brackets, const std::string& reading) {
            log_.report(
                "glib-W15",
                fmt::format("{}: {} in {}; {}", spec.tag, base::counted(count, "value"), brackets, reading),
                spec.valuePosition);
        };
        if (spec.form == UniformForm::range) {
            if (count == 1)
                report("< >", fmt::format("read as minimum {}, current {}, maximum {}",
                                          spec.values[0] < 0 ? written[0] : "0", written[0],
                                          spec.values[0] > 1 ? written[0] : "1"));
            if (count == 2)
                report("< >", fmt::format("read as minimum {}, current {}, maximum {}", written[0],
                                          written[1], written[spec.values[1] > spec.values[0] ? 1 : 0]));
            if (count > 3) report("< >", "the surplus is ignored");
        }
        if (spec.form == UniformForm::color) {
            if (count == 1 || count == 2) report("{ }", "missing components are 0, alpha 1");
            if (count > 4) report("{ }", "the surplus is ignored");
        }
    }

    void add(UniformSpec spec) {
        const auto [entry, isNew] = indexOfTag_.try_emplace(spec.tag, command_.uniforms.size());
        if (isNew) {
            command_.uniforms.push_back(std::move(spec));
            return;
        }
        log_.report("glib-W19", fmt::format("tag {} given twice, the last one counts", inQuotes(spec.tag)),
                    spec.tagPosition);
        command_.uniforms[entry->second] = std::move(spec);
    }

    static constexpr std::size_t kLongestShown = 60;

    const Statement& statement_;
    std::span<const Token> tokens_;
    Command& command_;
    MessageLog& log_;
    std::size_t at_ = 0;
    std::unordered_map<std::string, std::size_t> indexOfTag_;
};

bool hasComputedSubscript(const KeyedValues& tag) {
    return std::ranges::any_of(tag.path, [](const NamePart& part) {
        return std::ranges::any_of(part.index,
                                   [](const Value& index) { return index.kind != Value::Kind::number; });
    });
}

/// The tag as a UniformSpec; nothing if its value is not made of plain numbers, or if it has parts. With
/// `takesParts` only parts whose subscripts are computed are refused.
std::optional<UniformSpec> uniformOf(const KeyedValues& tag, bool takesParts) {
    const Value& value = tag.values.front();
    UniformSpec spec{tag.key, UniformForm::number, {}, tag.position, value.position};
    const bool isPlain =
        std::ranges::all_of(value.items, [](const Value& each) { return each.kind == Value::Kind::number; });
    if ((takesParts ? hasComputedSubscript(tag) : !tag.path.empty()) || !isPlain || !value.count.empty())
        return std::nullopt;
    switch (value.kind) {
        case Value::Kind::number:
            break;
        case Value::Kind::truth:
            spec.form = UniformForm::truth;
            break;
        case Value::Kind::range:
            spec.form = UniformForm::range;
            break;
        case Value::Kind::color:
            spec.form = UniformForm::color;
            break;
        case Value::Kind::list:
            spec.form = UniformForm::list;
            break;
        default:
            return std::nullopt;
    }
    if (value.items.empty()) spec.values.push_back(value.number);
    for (const Value& each : value.items) spec.values.push_back(each.number);
    return spec;
}

}  // namespace

void takeUniforms(Command& command, bool takesParts) {
    std::vector<KeyedValues> rest;
    for (KeyedValues& tag : command.tags) {
        if (std::optional<UniformSpec> spec = uniformOf(tag, takesParts))
            command.uniforms.push_back(std::move(*spec));
        else
            rest.push_back(std::move(tag));
    }
    command.tags = std::move(rest);
}

bool hasSubscriptedTag(std::span<const Token> tokens) {
    for (std::size_t i = 0; i + 4 < tokens.size(); ++i) {
        const bool isSubscript = tokens[i].kind == TokenKind::word && tokens[i + 1].text == "[" &&
                                 tokens[i + 1].begin == tokens[i].end &&
                                 tokens[i + 2].kind == TokenKind::number && tokens[i + 3].text == "]";
        const Token& next = tokens[i + 4];
        const bool isMember = next.begin == tokens[i + 3].end && next.isWord() && next.text.starts_with('.');
        if (isSubscript && (isMember || next.beginsValue())) return true;
    }
    return false;
}

void readProgram(const Statement& statement, std::string_view fragmentFile, Command& command,
                 MessageLog& log) {
    ProgramReader(statement, command, log).read(fragmentFile);
}

}  // namespace glibra::glib

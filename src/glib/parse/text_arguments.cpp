// Commands whose arguments are not only numbers: files, units, textures, topologies, switches (language, 3.3
// to 3.5).

#include <fmt/format.h>

#include <algorithm>

#include "base/suggest.h"
#include "base/text.h"
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

}  // namespace glibra::glib

// The name and the tags of a Program statement (language, 5.1 and 5.2).

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/text.h"
#include "glib/lexer.h"
#include "glib/limits.h"
#include "glib/number.h"
#include "glib/parse/arguments.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

UniformForm formOfBracket(std::string_view bracket) {
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
            const std::string_view file = stem(fragmentFile);
            name_ = file.empty() ? "unnamed" : file;
            command_.values.push_back(wordOf(name_, command_.position));
            log_.report("glib-W14", fmt::format("program name missing; {} used", inQuotes(name_)),
                        command_.position);
            return;
        }
        name_ = tokens_[0].text;
        for (at_ = 1; at_ < tokens_.size() && canBeName(tokens_[at_]); ++at_) {
            if (isFollowedByValue(at_) || tokens_[at_].position.line != statement_.word.position.line) break;
            name_ += ' ';
            name_ += tokens_[at_].text;
        }
        if (at_ > 1)
            log_.report("glib-W16", fmt::format("program name {} has several words", inQuotes(name_)),
                        tokens_[0].position);
        command_.values.push_back(wordOf(name_, tokens_[0].position));
    }

    bool tooManyTags() {
        if (command_.uniforms.size() < kMostTags || !tokens_[at_].isWord()) return false;
        log_.report("glib-E15", fmt::format("Program {} has more than {} tags", inQuotes(name_), kMostTags),
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
        spec.form = formOfBracket(bracket.text);
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
    std::string name_;
    std::size_t at_ = 0;
    std::unordered_map<std::string, std::size_t> indexOfTag_;
};

bool hasComputedSubscript(const KeyedValues& tag) {
    return std::ranges::any_of(tag.path, [](const NamePart& part) {
        return std::ranges::any_of(part.index,
                                   [](const Value& index) { return index.kind != Value::Kind::number; });
    });
}

/// The tag as a UniformSpec; nothing if its value is not made of plain numbers, or a subscript is computed.
std::optional<UniformSpec> uniformOf(const KeyedValues& tag) {
    const Value& value = tag.values.front();
    UniformSpec spec{tag.key, UniformForm::number, {}, tag.position, value.position};
    const bool isPlain =
        std::ranges::all_of(value.items, [](const Value& each) { return each.kind == Value::Kind::number; });
    if (hasComputedSubscript(tag) || !isPlain || !value.count.empty()) return std::nullopt;
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

void takeUniforms(Command& command) {
    std::vector<KeyedValues> rest;
    const auto root = [](const KeyedValues& tag) -> std::string_view {
        return tag.path.empty() ? tag.key : tag.path.front().name;
    };
    for (KeyedValues& tag : command.tags) {
        // An element of an array whose other values are computed has to be given after them.
        const bool isLater = !tag.path.empty() && std::ranges::find(rest, root(tag), root) != rest.end();
        if (std::optional<UniformSpec> spec = isLater ? std::nullopt : uniformOf(tag))
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

// Numbers: single tokens, single arguments, the numeric commands as a whole, and groups of points.

#include "glib/parse/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/number.h"
#include "base/text.h"
#include "glib/lexer.h"
#include "glib/limits.h"
#include "glib/modern/pieces.h"
#include "glib/number.h"

namespace glibra::glib {
namespace {

std::string grouped(double value) {
    constexpr double kExact = 1e15;
    return std::abs(value) < kExact && value == std::trunc(value)
               ? base::groupedText(static_cast<long long>(value))
               : numberText(value);
}

/// A number that has been read and is being checked by the rule of its argument.
struct Candidate {
    const Argument& argument;
    std::size_t index;
    std::string_view command;
    double value;
    std::string_view text;
    Position position;
};

void refuseOutside(const Candidate& c, const char* id, MessageLog& log) {
    log.report(id,
               fmt::format("{}: {} {} is not between {} and {}", c.command, c.argument.name, c.text,
                           numberText(c.argument.least), numberText(c.argument.most)),
               c.position);
}

void refuseLimit(const Candidate& c, MessageLog& log) {
    log.report("glib-E15",
               fmt::format("{}: {} {}; the limit is {}", c.command, grouped(c.value), c.argument.name,
                           grouped(c.argument.most)),
               c.position);
}

double absolute(const Candidate& c, MessageLog& log) {
    if (c.value >= 0) return c.value;
    log.report("glib-W28",
               fmt::format("{}: {} {} read as {}", c.command, c.argument.name, c.text, numberText(-c.value)),
               c.position);
    return -c.value;
}

double applySize(const Candidate& c, MessageLog& log) {
    if (c.value == 0)
        log.report("glib-W42", fmt::format("{}: {} 0 draws nothing", c.command, c.argument.name), c.position);
    return absolute(c, log);
}

double applyCount(const Candidate& c, MessageLog& log) {
    if (c.value > c.argument.most) refuseLimit(c, log);
    if (c.value >= c.argument.least) return c.value;
    log.report("glib-W28",
               fmt::format("{}: {} {} raised to {}", c.command, numberText(c.value), c.argument.name,
                           numberText(c.argument.least)),
               c.position);
    return c.argument.least;
}

double applyPositive(const Candidate& c, MessageLog& log) {
    if (c.value <= 0)
        log.report("glib-E05", fmt::format("{}: {} {} is not above 0", c.command, c.argument.name, c.text),
                   c.position);
    else if (c.value < c.argument.least || c.value > c.argument.most)
        log.report("glib-E15",
                   fmt::format("{}: {} {}; the limits are {} and {}", c.command, c.argument.name, c.text,
                               numberText(c.argument.least), numberText(c.argument.most)),
                   c.position);
    return c.value;
}

double applyTexels(const Candidate& c, MessageLog& log) {
    if (c.value == 0) refuseOutside(c, "glib-E05", log);
    const double texels = absolute(c, log);
    if (texels > c.argument.most) refuseLimit(c, log);
    return texels;
}

double applyRule(const Candidate& c, MessageLog& log) {
    const double least = c.argument.least;
    const double most = c.argument.most;
    switch (c.argument.rule) {
        case ArgumentRule::any:
            break;
        case ArgumentRule::size:
            return applySize(c, log);
        case ArgumentRule::count:
            return applyCount(c, log);
        case ArgumentRule::positive:
            return applyPositive(c, log);
        case ArgumentRule::texels:
            return applyTexels(c, log);
        case ArgumentRule::within:
            if (c.value < least || c.value > most) refuseOutside(c, "glib-E05", log);
            break;
        case ArgumentRule::between:
            if (c.value <= least || c.value >= most) refuseOutside(c, "glib-E05", log);
            break;
        case ArgumentRule::component:
            if (c.value < 0 || c.value > 1)
                log.report("glib-W26", fmt::format("{}: component {} outside 0..1, kept", c.command, c.index),
                           c.position);
            break;
        case ArgumentRule::unit:
            if (c.value < least || c.value > most)
                log.report("glib-E12",
                           fmt::format("texture unit {} is not between 0 and {}", c.text, numberText(most)),
                           c.position);
            break;
    }
    return c.value;
}

void reportSurplusOf(std::string_view command, std::size_t count, Position first, MessageLog& log) {
    log.report("glib-W07", fmt::format("{}: {} ignored", command, base::counted(count, "surplus argument")),
               first);
}

/// Cuts a number where an integer is wanted, and applies the rule.
double checkArgument(Candidate c, bool reportsCut, MessageLog& log) {
    if (c.argument.type == ArgumentType::integer) {
        const auto [whole, isCut] = base::wholeNumber(c.value);
        if (isCut && reportsCut)
            log.report("glib-W27", fmt::format("{} is cut to {}", c.text, numberText(whole)), c.position);
        c.value = whole;
    }
    return applyRule(c, log);
}

/// Fills in the numbers that the file leaves out. Returns false if one is missing that has no default.
bool fillMissing(const CommandRow& row, Command& command) {
    for (std::size_t i = command.numbers.size(); i < row.arguments.size(); ++i) {
        const Argument& argument = row.arguments[i];
        if (argument.optional) return true;
        if (argument.filler && (command.givenNumbers > 0 || !argument.byDefault))
            command.numbers.push_back(*argument.filler);
        else if (argument.byDefault)
            command.numbers.push_back(*argument.byDefault);
        else
            return false;
    }
    return true;
}

void reportFiller(const CommandRow& row, const Command& command, MessageLog& log) {
    const std::size_t given = command.givenNumbers;
    if (given >= row.arguments.size()) return;
    const Argument& missing = row.arguments[given];
    if (!missing.filler || (given == 0 && missing.byDefault)) return;
    log.report("glib-W06",
               fmt::format("{}: {}, missing ones are {}", row.name(), base::counted(given, "number"),
                           numberText(*missing.filler)),
               command.position);
}

void reportMissing(const CommandRow& row, const Command& command, MessageLog& log) {
    std::size_t needed = 0;
    for (std::size_t i = 0; i < row.arguments.size(); ++i)
        if (const Argument& argument = row.arguments[i];
            !argument.byDefault && !argument.filler && !argument.optional)
            needed = i + 1;
    log.report(
        "glib-E04",
        fmt::format("{} needs {}{}, found {}", row.name(), needed < row.arguments.size() ? "at least " : "",
                    base::counted(needed, "number"), command.givenNumbers),
        command.position, {{Expectation::Kind::number, "a number"}});
}

}  // namespace

std::vector<Token> plainArguments(const Statement& statement, MessageLog& log) {
    std::vector<Token> plain;
    plain.reserve(statement.arguments.size());
    std::vector<const Token*> open;
    bool reported = false;
    for (const Token& token : statement.arguments) {
        const bool opens = token.kind == TokenKind::open;
        if (!opens && token.kind != TokenKind::close) {
            plain.push_back(token);
            continue;
        }
        if (!reported)
            log.report("glib-W10",
                       fmt::format("brackets around the arguments of {} ignored", statement.row->name()),
                       token.position);
        reported = true;
        if (opens) {
            open.push_back(&token);
        } else if (!open.empty()) {
            if (!bracketsMatch(open.back()->text, token.text))
                log.report("glib-W08", fmt::format("'{}' closed by '{}'", open.back()->text, token.text),
                           token.position);
            open.pop_back();
        }
    }
    for (const Token* token : open)
        log.report("glib-W09",
                   fmt::format("'{}' not closed; closed at the end of the statement", token->text),
                   token->position);
    return plain;
}

/// For `Texture name ...`.
static constexpr std::string_view kNamedTextureHint = "; a texture with a name is declared by Texture2D NAME";

double readArgument(const Argument& argument, std::size_t index, const Token& token, std::string_view command,
                    MessageLog& log) {
    const std::size_t errors = log.errorCount();
    const ReadNumber number =
        readNumber(token, log, command == "Texture" && index == 0 ? kNamedTextureHint : std::string_view());
    if (log.errorCount() > errors) return 0;
    return checkArgument({argument, index, command, number.value, number.text, token.position}, true, log);
}

void reportSurplus(const Statement& statement, std::span<const Token> tokens, std::size_t used,
                   MessageLog& log) {
    if (tokens.size() > used)
        reportSurplusOf(statement.row->name(), tokens.size() - used, tokens[used].position, log);
}

namespace {

/// Fills in what is left out of the numbers, and checks all of them together. `places` are the places of all
/// numbers that the file states, with the surplus ones.
void finishNumbers(const CommandRow& row, Command& command, std::span<const Position> places,
                   MessageLog& log) {
    const std::size_t given = command.givenNumbers = command.numbers.size();
    if (given == 1 && row.loneNumber != LoneNumber::first) {
        command.numbers.resize(3, command.numbers.front());
        if (row.loneNumber == LoneNumber::grey)
            log.report("glib-W06", fmt::format("{}: 1 number, read as grey", row.name()), command.position);
    } else {
        reportFiller(row, command, log);
    }
    if (!fillMissing(row, command)) return reportMissing(row, command, log);
    if (places.size() > given) reportSurplusOf(row.name(), places.size() - given, places[given], log);
    if (row.together != nullptr) row.together(command, places.first(given), log);
}

/// Keeps numbers and expressions as they are written.
void keepForLater(std::span<const Token> tokens, Command& command, MessageLog& log) {
    if (tokens.size() > kMostValues) {
        log.report("glib-E15",
                   fmt::format("more than {} values in a statement", base::groupedText(kMostValues)),
                   command.position);
        return;
    }
    command.isEvaluatedLater = true;
    for (const Token& token : tokens) {
        if (token.kind == TokenKind::expression) {
            std::optional<std::vector<Piece>> pieces = readPieces({&token, 1}, log);
            if (!pieces) return;
            command.values.push_back(std::move(pieces->front().value));
            continue;
        }
        Value value;
        value.number = readNumber(token, log).value;
        value.position = token.position;
        value.begin = token.begin;
        value.end = token.end;
        command.values.push_back(std::move(value));
    }
}

}  // namespace

void readNumbers(const Statement& statement, Command& command, MessageLog& log) {
    const CommandRow& row = *statement.row;
    const std::vector<Token> tokens = plainArguments(statement, log);
    if (std::ranges::any_of(tokens, [](const Token& token) { return token.kind == TokenKind::expression; }))
        return keepForLater(tokens, command, log);
    const std::size_t given = std::min(tokens.size(), row.arguments.size());
    std::vector<Position> places;
    places.reserve(tokens.size());
    command.numbers.reserve(row.arguments.size());
    for (const Token& token : tokens) places.push_back(token.position);
    for (std::size_t i = 0; i < given; ++i)
        command.numbers.push_back(readArgument(row.arguments[i], i, tokens[i], row.name(), log));
    finishNumbers(row, command, places, log);
}

void evaluateNumbers(const CommandRow& row, Command& command, std::span<const EvaluatedNumber> numbers,
                     MessageLog& log) {
    const std::size_t given = std::min(numbers.size(), row.arguments.size());
    std::vector<Position> places;
    places.reserve(numbers.size());
    command.numbers.clear();
    for (const EvaluatedNumber& each : numbers) places.push_back(each.position);
    for (std::size_t i = 0; i < given; ++i) {
        const EvaluatedNumber& number = numbers[i];
        const std::string text = numberText(number.value);
        double value = 0;
        if (std::isfinite(base::toFloat(number.value)))
            value = checkArgument({row.arguments[i], i, row.name(), number.value, text, number.position},
                                  number.reportsCut, log);
        else
            log.report("glib-E31",
                       fmt::format("{}: {} {} is not finite as a 32-bit float", row.name(),
                                   row.arguments[i].name, text),
                       number.position);
        command.numbers.push_back(value);
    }
    finishNumbers(row, command, places, log);
}

// ---- Groups of points: [x y z] [x y z] ... and the same numbers without brackets (language, 1.6 and 4.6).

namespace {

constexpr std::size_t kLeast = 3;  // numbers per group
constexpr std::size_t kMost = 4;

class GroupReader {
  public:
    GroupReader(const Statement& statement, Command& command, MessageLog& log)
        : tokens_(statement.arguments), command_(command), log_(log) {}

    void read() {
        for (std::size_t at = 0; at < tokens_.size();) {
            const Token& token = tokens_[at];
            if (token.kind == TokenKind::open) {
                readGroup(at);
                at = groupAt(tokens_, at).next;
                continue;
            }
            ++at;
            if (token.kind == TokenKind::close)
                log_.report("glib-W10",
                            fmt::format("bracket around the arguments of {} ignored", command_.word),
                            token.position);
            else
                addBare(token);
        }
        finishBare();
    }

  private:
    void readGroup(std::size_t open) {
        finishBare();
        const BracketGroup group = groupAt(tokens_, open);
        const Token& bracket = tokens_[open];
        if (bracket.text != "[")
            log_.report("glib-W10", fmt::format("'{}' read as '['", bracket.text), bracket.position);
        reportGroupEnd(tokens_, open, group, log_);
        PointGroup points{{}, bracket.position};
        for (std::size_t i = group.first; i < group.last && points.values.size() < kMost; ++i)
            points.values.push_back(readNumber(tokens_[i], log_).value);
        const std::size_t count = group.last - group.first;
        if (count > kMost)
            log_.report("glib-W07",
                        fmt::format("{}: {} ignored", command_.word,
                                    base::counted(count - kMost, "surplus argument")),
                        tokens_[group.first + kMost].position);
        add(std::move(points));
    }

    /// Numbers without brackets are taken three at a time.
    void addBare(const Token& token) {
        if (bare_.values.empty()) bare_.position = token.position;
        bare_.values.push_back(readNumber(token, log_).value);
        if (bare_.values.size() == kLeast) finishBare();
    }
    void finishBare() {
        if (!bare_.values.empty()) add(std::move(bare_));
        bare_ = {};
    }

    void add(PointGroup points) {
        if (points.values.size() < kLeast)
            log_.report(
                "glib-E04",
                fmt::format("{}: a point needs 3 numbers, found {}", command_.word, points.values.size()),
                points.position, {{Expectation::Kind::number, "a number"}});
        command_.points.push_back(std::move(points));
    }

    std::span<const Token> tokens_;
    Command& command_;
    MessageLog& log_;
    PointGroup bare_;
};

}  // namespace

void readPointGroups(const Statement& statement, Command& command, MessageLog& log) {
    GroupReader(statement, command, log).read();
    const auto multiple = static_cast<std::size_t>(statement.row->groupMultiple);
    const std::size_t count = command.points.size();
    if (count == 0 || count % multiple != 0)
        log.report(
            "glib-E04",
            fmt::format("{} needs a multiple of {} points, found {}", statement.row->name(), multiple, count),
            command.position);
}

}  // namespace glibra::glib

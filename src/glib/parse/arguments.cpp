// The arguments of classic statements: numbers, files, units, textures, words, and groups of points
// (language, 1.5 to 1.7 and 3).

#include "glib/parse/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/number.h"
#include "base/suggest.h"
#include "base/text.h"
#include "glib/limits.h"
#include "glib/number.h"
#include "glib/parse/pieces.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

// ---- The rules of single numbers.

std::string grouped(double value) {
    constexpr double kExact = 1e15;
    return std::abs(value) < kExact && value == std::trunc(value)
               ? base::groupedText(static_cast<long long>(value))
               : numberText(value);
}

/// A number that has been read and is being checked by the rule of its argument.
struct Candidate {
    const SyntaxNode& argument;
    std::size_t index;
    std::string_view command;
    double value;
    std::string_view text;
    Position position;
};

/// Cuts a number where an integer is wanted, and applies the rule. Reports glib-W26, W27, W28, W42, E05, E12,
/// E15.
double checkNumber(Candidate c, bool reportsCut, MessageLog& log) {
    const double low = c.argument.low, high = c.argument.high;
    const auto report = [&](const char* id, const std::string& what) {
        log.report(id, fmt::format("{}: {}", c.command, what), c.position);
    };
    const auto refuse = [&](const std::string& why) {
        report("glib-E05", fmt::format("{} {} is not {}", c.argument.text, c.text, why));
    };
    const auto isOutside = [&] { return c.value < low || c.value > high; };
    const auto between = [&] { return fmt::format("between {} and {}", numberText(low), numberText(high)); };
    const auto refuseLimit = [&] {
        if (c.value <= high) return;
        report("glib-E15",
               fmt::format("{} {}; the limit is {}", grouped(c.value), c.argument.text, grouped(high)));
    };
    const auto makePositive = [&] {
        if (c.value >= 0) return;
        c.value = -c.value;
        report("glib-W28", fmt::format("{} {} read as {}", c.argument.text, c.text, numberText(c.value)));
    };
    const ValueType type = c.argument.type;
    if (type == ValueType::integer || type == ValueType::count || type == ValueType::texels ||
        type == ValueType::unit) {
        const auto [whole, isCut] = base::wholeNumber(c.value);
        if (isCut && reportsCut)
            log.report("glib-W27", fmt::format("{} is cut to {}", c.text, numberText(whole)), c.position);
        c.value = whole;
    }
    switch (type) {
        case ValueType::size:
            if (c.value == 0) report("glib-W42", fmt::format("{} 0 draws nothing", c.argument.text));
            makePositive();
            break;
        case ValueType::count:
            refuseLimit();
            if (c.value >= low) break;
            report("glib-W28",
                   fmt::format("{} {} raised to {}", numberText(c.value), c.argument.text, numberText(low)));
            return low;
        case ValueType::positive:
            if (c.value <= 0)
                refuse("above 0");
            else if (isOutside())
                report("glib-E15", fmt::format("{} {}; the limits are {} and {}", c.argument.text, c.text,
                                               numberText(low), numberText(high)));
            break;
        case ValueType::texels:
            if (c.value == 0) refuse(between());
            makePositive();
            refuseLimit();
            break;
        case ValueType::integer:
            if (isOutside()) refuse(between());
            break;
        case ValueType::between:
            if (c.value <= low || c.value >= high) refuse(between());
            break;
        case ValueType::component:
            if (c.value < 0 || c.value > 1)
                report("glib-W26", fmt::format("component {} outside 0..1, kept", c.index));
            break;
        case ValueType::unit:
            if (isOutside())
                log.report("glib-E12", fmt::format("texture unit {} is not {}", c.text, between()),
                           c.position);
            break;
        default:
            break;
    }
    return c.value;
}

// ---- The numbers of a statement together.

void reportSurplus(std::string_view command, std::size_t count, Position first, MessageLog& log) {
    log.report("glib-W07", fmt::format("{}: {} ignored", command, base::counted(count, "surplus argument")),
               first);
}

/// Fills in what is left out of the numbers, and checks all of them together. `places` are the places of all
/// numbers that the file states, with the surplus ones.
void finishNumbers(const StatementRow& row, Command& command, std::span<const Position> places,
                   MessageLog& log) {
    const std::span<const SyntaxNode* const> arguments = argumentsOf(row);
    const std::size_t given = command.givenNumbers = command.numbers.size();
    // The number that fills a gap, which is not reported if it is the default.
    const auto fillerOf = [&](const SyntaxNode& argument) {
        return argument.filler && (given > 0 || !argument.byDefault) ? argument.filler : std::nullopt;
    };
    if (given == 1 && row.loneNumber != LoneNumber::first) {
        command.numbers.resize(3, command.numbers.front());
        if (row.loneNumber == LoneNumber::grey)
            log.report("glib-W06", fmt::format("{}: 1 number, read as grey", row.name), command.position);
    } else if (given < arguments.size()) {
        if (const auto filler = fillerOf(*arguments[given]))
            log.report("glib-W06",
                       fmt::format("{}: {}, missing ones are {}", row.name, base::counted(given, "number"),
                                   numberText(*filler)),
                       command.position);
    }
    for (std::size_t i = command.numbers.size(); i < arguments.size(); ++i) {
        const SyntaxNode& argument = *arguments[i];
        if (argument.isSkippable) break;
        const auto filler = fillerOf(argument);
        if (!filler && !argument.byDefault) {
            const auto isNeeded = [](const SyntaxNode* each) {
                return !each->byDefault && !each->filler && !each->isSkippable;
            };
            const auto last = std::find_if(arguments.rbegin(), arguments.rend(), isNeeded);
            log.report("glib-E04",
                       fmt::format(
                           "{} needs {}{}, found {}", row.name, last != arguments.rbegin() ? "at least " : "",
                           base::counted(static_cast<std::size_t>(arguments.rend() - last), "number"), given),
                       command.position, {{Expectation::Kind::number, "a number"}});
            return;
        }
        command.numbers.push_back(filler ? *filler : *argument.byDefault);
    }
    if (places.size() > given) reportSurplus(row.name, places.size() - given, places[given], log);
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

// ---- Groups of points: [x y z] [x y z] ... and the same numbers without brackets (language, 1.6 and 4.6).

constexpr std::size_t kLeast = 3;  // numbers per group
constexpr std::size_t kMost = 4;

class GroupReader {
    struct Point {
        std::vector<double> values;
        Position position;
    };

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
        Point points{{}, bracket.position};
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

    void add(Point points) {
        if (points.values.size() < kLeast)
            log_.report(
                "glib-E04",
                fmt::format("{}: a point needs 3 numbers, found {}", command_.word, points.values.size()),
                points.position, {{Expectation::Kind::number, "a number"}});
        points.values.resize(kMost, 1);
        command_.numbers.insert(command_.numbers.end(), points.values.begin(), points.values.end());
    }

    std::span<const Token> tokens_;
    Command& command_;
    MessageLog& log_;
    Point bare_;
};

// ---- Statements.

class ArgumentReader {
  public:
    ArgumentReader(const Statement& statement, Command& command, MessageLog& log)
        : row_(*statement.row),
          arguments_(argumentsOf(row_)),
          statement_(statement),
          command_(command),
          log_(log) {}

    /// By the type of the last argument.
    void read() {
        const ValueType last = lastTypeOf(row_);
        if (last == ValueType::points) return readPointGroups();
        if (last == ValueType::line) {
            command_.values.push_back(wordOf(statement_.message, statement_.messagePosition));
            return;
        }
        takePlainArguments();
        switch (last) {
            case ValueType::file:
                return readFiles();
            case ValueType::unit:
                return readUnits();
            case ValueType::texels:
                return readTexture();
            case ValueType::oneOf:
                return readTopology();
            case ValueType::truth:
                return readSwitch();
            default:
                return readNumbers();
        }
    }

  private:
    /// Takes the tokens without brackets, which have no meaning around plain arguments. Reports glib-W10,
    /// W08, W09.
    void takePlainArguments() {
        tokens_.reserve(statement_.arguments.size());
        std::vector<const Token*> open;
        bool reported = false;
        for (const Token& token : statement_.arguments) {
            const bool opens = token.kind == TokenKind::open;
            if (!opens && token.kind != TokenKind::close) {
                tokens_.push_back(token);
                continue;
            }
            if (!std::exchange(reported, true))
                log_.report("glib-W10", fmt::format("brackets around the arguments of {} ignored", row_.name),
                            token.position);
            if (opens) {
                open.push_back(&token);
            } else if (!open.empty()) {
                if (!bracketsMatch(open.back()->text, token.text))
                    log_.report("glib-W08", fmt::format("'{}' closed by '{}'", open.back()->text, token.text),
                                token.position);
                open.pop_back();
            }
        }
        for (const Token* token : open)
            log_.report("glib-W09",
                        fmt::format("'{}' not closed; closed at the end of the statement", token->text),
                        token->position);
    }

    void takeWord(const Token& token) { command_.values.push_back(wordOf(token.text, token.position)); }

    void ignoreFrom(std::size_t used) {
        if (tokens_.size() > used)
            reportSurplus(row_.name, tokens_.size() - used, tokens_[used].position, log_);
    }

    void lacks(const std::string& what) {
        log_.report("glib-E04", fmt::format("{} needs {}", row_.name, what), command_.position);
    }

    /// Reads a token as a number and checks it by the rule of the argument.
    void takeNumber(const SyntaxNode& argument, std::size_t index) {
        const Token& token = tokens_[index];
        const std::size_t errors = log_.errorCount();
        const bool mayBeName = row_.id == CommandId::texture && index == 0;  // `Texture name ...`
        const ReadNumber number =
            readNumber(token, log_, mayBeName ? "; a texture with a name is declared by Texture2D NAME" : "");
        const bool isRead = log_.errorCount() == errors;
        command_.numbers.push_back(
            isRead ? checkNumber({argument, index, row_.name, number.value, number.text, token.position},
                                 true, log_)
                   : 0);
        command_.givenNumbers = command_.numbers.size();
    }
    void takeNumber(std::size_t index) { takeNumber(*arguments_[index], index); }

    void readNumbers() {
        const auto isExpression = [](const Token& token) { return token.kind == TokenKind::expression; };
        if (std::ranges::any_of(tokens_, isExpression)) return keepForLater(tokens_, command_, log_);
        const std::size_t most = arguments_.size();
        std::vector<Position> places;
        places.reserve(tokens_.size());
        command_.numbers.reserve(most);
        for (const Token& token : tokens_) places.push_back(token.position);
        for (std::size_t i = 0; i < std::min(tokens_.size(), most); ++i) takeNumber(i);
        finishNumbers(row_, command_, places, log_);
    }

    /// A file or none, or a unit and the faces of a cube.
    void readFiles() {
        const std::size_t most = arguments_.back()->most, first = arguments_.size() - 1;
        const std::size_t files = tokens_.size() - std::min(tokens_.size(), first);
        if (first > 0 && files < most)
            return lacks(fmt::format("a unit and {} files, found {}", most, base::counted(files, "file")));
        if (first > 0) takeNumber(0);
        for (std::size_t i = first; i < std::min(first + most, tokens_.size()); ++i) takeWord(tokens_[i]);
        ignoreFrom(first + most);
    }

    void readUnits() {
        if (tokens_.size() > kMostTargets) {
            log_.report(
                "glib-E15",
                fmt::format("{}: {} targets; the limit is {}", row_.name, tokens_.size(), kMostTargets),
                tokens_[kMostTargets].position);
            return;
        }
        for (std::size_t i = 0; i < tokens_.size(); ++i) takeNumber(*arguments_.front(), i);
    }

    void readTexture() {
        if (tokens_.empty()) return lacks("a unit and a file name or sizes");
        takeNumber(0);
        const auto isCompleteNumberToken = [](const Token& token) {
            return token.kind == TokenKind::number && isCompleteNumber(token.text);
        };
        std::size_t sizes = 0;
        while (sizes + 1 < tokens_.size() && isCompleteNumberToken(tokens_[sizes + 1])) ++sizes;
        const Token& last = tokens_.back();
        const std::size_t rest = tokens_.size() - 1 - sizes;
        const auto formats = textureFormats();
        const auto format =
            rest == 1 && last.kind == TokenKind::word
                ? std::ranges::find_if(formats,
                                       [&](const auto& each) { return sameWord(each.name, last.text); })
                : formats.end();
        if (rest == 0 || format != formats.end()) {
            readSizes(sizes, rest == 0 ? formats.front() : *format);
        } else if (rest == 1 && sizes >= 2 && last.kind == TokenKind::word) {
            // A size stands before the word, so the word is not a file name: it was meant as a format.
            log_.report("glib-E16",
                        fmt::format("{}: {} is not one of the formats RGBA8, RGBA16F, RGBA32F, R32F",
                                    row_.name, inQuotes(last.text)),
                        last.position);
        } else {
            takeWord(tokens_[1]);
            ignoreFrom(2);
        }
    }

    /// Reads an empty texture: sizes and perhaps a format.
    void readSizes(std::size_t sizes, const TextureFormat& format) {
        const bool isAny = row_.id == CommandId::texture;
        const std::size_t most = arguments_.size() - 1, least = isAny ? 1 : most;
        if (sizes < least) {
            command_.lacksFile = true;
            return lacks(fmt::format("a file name or {} after the unit, found {}",
                                     base::counted(least, "size"), sizes));
        }
        const std::size_t errors = log_.errorCount();
        for (std::size_t i = 1; i <= std::min(sizes, most); ++i) {
            SyntaxNode argument = *arguments_[i];
            if (isAny && sizes < 3) argument.high = kLargestTextureSide;
            takeNumber(argument, i);
        }
        const bool isStated = tokens_.size() > sizes + 1;
        command_.values.push_back(
            wordOf(format.name, isStated ? tokens_.back().position : command_.position));
        if (sizes > most) reportSurplus(row_.name, sizes - most, tokens_[most + 1].position, log_);
        double bytes = format.bytes;
        for (std::size_t i = 1; i < command_.numbers.size(); ++i) bytes *= command_.numbers[i];
        if (log_.errorCount() == errors && bytes > kLargestTexture)
            log_.report("glib-E15",
                        fmt::format("{} needs {} bytes; the limit is {}", command_.word, grouped(bytes),
                                    grouped(kLargestTexture)),
                        command_.position);
    }

    void readTopology() {
        if (tokens_.empty()) return lacks("a topology word");
        constexpr std::string_view kPrefix = "gl_";
        const Token& token = tokens_.front();
        std::string_view word = token.text;
        if (sameWord(word.substr(0, kPrefix.size()), kPrefix)) word.remove_prefix(kPrefix.size());
        if (row_.id == CommandId::geometryOutput && sameWord(word, "triangles_strip"))
            word = "triangle_strip";
        const std::vector<std::string>& known = arguments_.front()->words;
        if (isAmong(word, known)) {
            command_.values.push_back(wordOf(lower(word), token.position));
        } else {
            const std::vector<std::string_view> words(known.begin(), known.end());
            log_.report(
                "glib-E08",
                fmt::format("unknown topology {}{}", inQuotes(token.text), base::suggestion(word, words)),
                token.position);
        }
        ignoreFrom(1);
    }

    void readSwitch() {
        ignoreFrom(1);
        command_.numbers = {1};
        if (tokens_.empty()) return;
        const Token& token = tokens_.front();
        takeWord(token);
        command_.givenNumbers = 1;
        double& value = command_.numbers.front();
        if (token.kind == TokenKind::number)
            value = readNumber(token, log_).value;
        else if (token.truth() || sameWord(token.text, "on") || sameWord(token.text, "off"))
            value = token.truth() == true || sameWord(token.text, "on") ? 1 : 0;
        else
            value = -1;
        if (value == 0 || value == 1) return;
        log_.report(
            "glib-E16",
            fmt::format("{}: {} is not one of on, off, 1, 0, true, false", row_.name, inQuotes(token.text)),
            token.position);
    }

    void readPointGroups() {
        GroupReader(statement_, command_, log_).read();
        const std::size_t multiple = arguments_.front()->most, count = command_.numbers.size() / kMost;
        if (count == 0 || count % multiple != 0)
            lacks(fmt::format("a multiple of {} points, found {}", multiple, count));
    }

    const StatementRow& row_;
    std::span<const SyntaxNode* const> arguments_;
    const Statement& statement_;
    Command& command_;
    MessageLog& log_;
    std::vector<Token> tokens_;
};

}  // namespace

void readArguments(const Statement& statement, Command& command, MessageLog& log) {
    ArgumentReader(statement, command, log).read();
}

void evaluateNumbers(const StatementRow& row, Command& command, std::span<const EvaluatedNumber> numbers,
                     MessageLog& log) {
    const std::span<const SyntaxNode* const> arguments = argumentsOf(row);
    std::vector<Position> places;
    places.reserve(numbers.size());
    command.numbers.clear();
    for (const EvaluatedNumber& each : numbers) places.push_back(each.position);
    for (std::size_t i = 0; i < std::min(numbers.size(), arguments.size()); ++i) {
        const EvaluatedNumber& number = numbers[i];
        const std::string text = numberText(number.value);
        double value = 0;
        if (std::isfinite(base::toFloat(number.value)))
            value = checkNumber({*arguments[i], i, row.name, number.value, text, number.position},
                                number.reportsCut, log);
        else
            log.report(
                "glib-E31",
                fmt::format("{}: {} {} is not finite as a 32-bit float", row.name, arguments[i]->text, text),
                number.position);
        command.numbers.push_back(value);
    }
    finishNumbers(row, command, places, log);
}

}  // namespace glibra::glib

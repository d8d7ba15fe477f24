// Groups of points: LinesAdjacency [x y z] [x y z] ... and the same numbers without brackets (language, 1.6
// and 4.6).

#include <fmt/format.h>

#include "base/text.h"
#include "glib/bracket_group.h"
#include "glib/limits.h"
#include "glib/parse/arguments.h"

namespace glibra::glib {
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

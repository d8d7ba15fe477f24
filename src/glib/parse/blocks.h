#pragma once
// The nesting of blocks: Group, Repeat, When, Pass, Once, Step.

#include <cstddef>
#include <string>
#include <vector>

#include "glib/messages.h"
#include "glib/script.h"
#include "glib/statement_table.h"

namespace glibra::glib {

/// Follows the statements of a script in order.
class BlockStack {
  public:
    explicit BlockStack(MessageLog& log) : log_(log) {}

    /// Reports glib-E23 if the statement may not stand here; once the block around it is closed, because if
    /// its end is missing, that is the mistake.
    void checkPlace(const StatementRow& row, const Command& command);

    /// Opens, divides or ends a block by a statement at `position`. A faulty statement is not among the
    /// commands, but it opens and ends blocks all the same; any other one is the last command. Sets the
    /// partners among the commands, and removes those of a block with a faulty opener, divider or end.
    /// Reports glib-E15, E21 and E22.
    void follow(const StatementRow& row, Position position, bool isFaulty, std::vector<Command>& commands);

    /// Reports the blocks that are still open (glib-E22), and removes their commands.
    void finish(std::vector<Command>& commands);

  private:
    /// A statement that may not stand in a block.
    struct Misplaced {
        std::string_view word;
        Position position;
        std::string text;
    };
    struct Block {
        const StatementRow* row = nullptr;
        Position position;
        std::size_t index = 0;  ///< of the opener among the commands
        std::size_t divider = Command::kNoPartner;
        bool isFaulty = false;  ///< its commands are removed at its end
        bool isDivided = false;
        std::vector<Misplaced> misplaced{};
    };

    void open(const StatementRow& row, Position position, bool isFaulty, std::vector<Command>& commands);
    bool unwindTo(const StatementRow& row, Position position);
    void divide(const StatementRow& row, Position position, bool isFaulty, std::vector<Command>& commands);
    void close(bool isFaulty, std::vector<Command>& commands);
    void reportOpen(const Block& block, const std::string& before);

    MessageLog& log_;
    std::vector<Block> blocks_;
    std::vector<CommandId> unwound_;  ///< openers that were reported as not closed; their ends may follow
    std::size_t tooDeep_ = 0;         ///< open blocks beyond the limit, which are not kept
};

}  // namespace glibra::glib

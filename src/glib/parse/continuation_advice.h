#pragma once
// Statements that go on in the next line without a backslash (language, 1.3): one message says so.

#include <string_view>

#include "glib/message_log.h"
#include "glib/parse/statement.h"

namespace glibra::glib {

/// Follows the statements of a script in order.
class ContinuationAdvice {
  public:
    /// Remembers the statement as the one that the next line may go on with.
    void follow(const Statement& statement);

    /// Adds advice to the last message, which is about the statement: if it ends too early and the next line
    /// begins with what is missing, whose statements are then skipped; or if it begins with a key of the
    /// statement on the line before.
    void advise(std::string_view text, const Statement& statement, MessageLog& log);

    /// True for a statement on a line that belongs to an earlier one, which has been reported.
    [[nodiscard]] bool isSkipped(const Statement& statement);

    /// Reports glib-E01 with advice for an unknown word or a value at the beginning of a line that the
    /// statement before it can go on with. True if that is so; of several such lines only the first is
    /// reported.
    bool report(const Statement& statement, MessageLog& log);

  private:
    std::string name_;                   ///< of the statement before, for messages
    const StatementRow* row_ = nullptr;  ///< its row, if it has a modern form
    bool isClassic_ = false;
    int firstLine_ = 0, lastLine_ = 0;
    int skippedLine_ = 0;
    bool isReported_ = false;  ///< the line before has been reported by report()
};

}  // namespace glibra::glib

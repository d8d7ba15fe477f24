// From the text of a scene to its commands.

#include <fmt/format.h>

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "glib/arguments.h"
#include "glib/command_table.h"
#include "glib/limits.h"
#include "glib/message_log.h"
#include "glib/number.h"
#include "glib/script.h"
#include "glib/statement.h"
#include "glib/text.h"
#include "glib/uniforms.h"

namespace glibra::glib {
namespace {

bool belongsToList(CommandId id) {
    return id == CommandId::glVertex || id == CommandId::glNormal || id == CommandId::glColor ||
           id == CommandId::glTexCoord || id == CommandId::glEnd;
}

class Parser {
  public:
    Parser(std::string_view text, MessageLog& log) : reader_(text, log), log_(log) {}

    std::vector<Command> parse() {
        std::size_t statements = 0;
        while (const std::optional<Statement> statement = reader_.next()) {
            if (++statements > kMostStatements) {
                log_.report("glib-E15",
                            fmt::format("more than {} statements",
                                        groupedText(static_cast<long long>(kMostStatements))),
                            statement->word.position);
                break;
            }
            if (!statement->row) {
                reportUnknown(statement->word);
                continue;
            }
            if (!statement->refused) keep(*statement);
        }
        return std::move(commands_);
    }

  private:
    void reportUnknown(const Token& word) {
        const bool suggests = word.kind == TokenKind::word && !log_.isFull();
        const std::string_view nearest = suggests ? nearestCommand(word.text) : std::string_view();
        std::string text = "unknown command " + inQuotes(word.text);
        if (!nearest.empty()) text += fmt::format("; did you mean '{}'?", nearest);
        log_.report("glib-E01", std::move(text), word.position);
    }

    void keep(const Statement& statement) {
        Command command;
        command.id = statement.row->id;
        command.word = statement.word.text;
        command.position = command.textPosition = statement.word.position;
        command.begin = statement.word.begin;
        command.end = statement.end;
        const std::size_t errors = log_.errorCount();
        read(statement, command);
        const bool faulty = statement.faulty || log_.errorCount() > errors;
        if (command.id == CommandId::fragment) fragmentFile_ = command.text;
        if (leavesOut(command.id, faulty) || faulty) return;
        commands_.push_back(std::move(command));
    }

    /// True inside a vertex list whose glBegin is faulty. Its vertices are skipped, since they would only
    /// repeat the error.
    bool leavesOut(CommandId id, bool faulty) {
        if (id == CommandId::glBegin) inFaultyList_ = faulty;
        const bool result = inFaultyList_ && belongsToList(id);
        if (id == CommandId::glEnd) inFaultyList_ = false;
        return result;
    }

    void read(const Statement& statement, Command& command) {
        switch (statement.row->form) {
            case ArgumentForm::numbers:
                return readNumbers(statement, command, log_);
            case ArgumentForm::file:
                return readFile(statement, command, log_);
            case ArgumentForm::cubeMap:
                return readCubeMap(statement, command, log_);
            case ArgumentForm::units:
                return readUnits(statement, command, log_);
            case ArgumentForm::texture:
                return readTexture(statement, command, log_);
            case ArgumentForm::topology:
                return readTopology(statement, command, log_);
            case ArgumentForm::switchWord:
                return readSwitch(statement, command, log_);
            case ArgumentForm::pointGroups:
                return readPointGroups(statement, command, log_);
            case ArgumentForm::message:
                command.text = statement.message;
                command.textPosition = statement.messagePosition;
                return;
            case ArgumentForm::program:
                break;
        }
        if (++programs_ <= kMostPrograms) return readProgram(statement, fragmentFile_, command, log_);
        log_.report("glib-E15", fmt::format("more than {} programs", kMostPrograms), command.position);
    }

    StatementReader reader_;
    MessageLog& log_;
    std::vector<Command> commands_;
    std::string fragmentFile_;  ///< the name in the last Fragment statement
    std::size_t programs_ = 0;
    bool inFaultyList_ = false;
};

}  // namespace

Script parse(std::string_view text, std::string path) {
    Script script;
    MessageLog log(path);
    script.path = std::move(path);
    try {
        if (text.size() > kLargestFile)
            log.report("glib-E15",
                       fmt::format("scene of {} bytes; the limit is {}",
                                   groupedText(static_cast<long long>(text.size())),
                                   groupedText(static_cast<long long>(kLargestFile))),
                       {});
        else
            script.commands = Parser(text, log).parse();
    } catch (const std::exception& problem) {
        script.commands.clear();
        log.report("glib-E15", fmt::format("the scene cannot be read: {}", problem.what()), {});
    }
    script.diagnostics = log.take();
    return script;
}

}  // namespace glibra::glib

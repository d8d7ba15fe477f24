#pragma once
// What the command lines of several subcommands have in common.

#include <glibra/driver.h>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace glibra::cli {

/// Makes the --help of a program or subcommand begin with an example.
void setExample(CLI::App& app, const char* example);

/// Adds a subcommand. `summary` says what it does, without a subject: "renders scenes to pictures". Its
/// --help begins with the example.
CLI::App* addCommand(CLI::App& app, const char* name, const char* summary, const char* example);

/// Prints the help that was asked for, or what is wrong with the command line. Returns the exit status.
int reportUsage(const CLI::App& app, const CLI::ParseError& wrong);

/// --driver
void addDriverOption(CLI::App& command, Driver& to);
/// --jobs; 0 means one worker per processor.
void addJobsOption(CLI::App& command, int& to);

}  // namespace glibra::cli

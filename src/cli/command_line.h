#pragma once
// The command lines of glibra and of the programs that it starts: options, their values and their --help.
// This is all that the commands know of CLI11, whose headers take seconds to compile; only command_line.cpp
// includes them.

#include <glibra/driver.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own name
class App;
class Option;
}  // namespace CLI

namespace glibra::cli {

/// Reads a value as the user typed it. Returns what is wrong with it, or an empty text.
using ReadValue = std::function<std::string(const std::string& text)>;

/// Why the text does not name a file or folder to write: "-" does not mean standard output there. Empty if it
/// does.
std::string whyNotWritten(const std::string& text);

/// An option, a flag or a positional argument of a command. Copies are the same option.
class Option {
  public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    /// What --help prints for the value: "FOLDER".
    Option& placeholder(const std::string& word);
    /// Allows numbers from `least` to `most` only; --help says so.
    Option& within(double least, double most);
    /// Allows numbers from `least` on.
    Option& atLeast(double least) { return within(least, std::numeric_limits<double>::infinity()); }
    /// Manual pages and completions offer these values.
    Option& offering(const std::vector<std::string>& words);
    /// --help prints the present value as the default.
    Option& withDefault();
    /// The value is the name of a file that exists.
    Option& existingFile();
    /// The value is the name of a file or folder to write (whyNotWritten).
    Option& written();
    /// --help does not list it, --help-all does: for what few users need.
    Option& rare();
    /// Neither lists it.
    Option& hidden();
    Option& required();
    Option& needs(const Option& other);
    Option& excludes(const Option& other);

    [[nodiscard]] bool isGiven() const;

  private:
    CLI::Option* option_;
};

/// A program or a subcommand. Names of options are as in "-o,--output"; positional arguments have names
/// without dashes. In "--eye,--view" the second long name is a former one, which works and is not listed. The
/// variables take their values while the command line is read, and must live until then.
class CommandLine {
  public:
    explicit CommandLine(CLI::App& app) : app_(&app) {}

    Option option(const std::string& name, std::string& to, const std::string& help);
    Option option(const std::string& name, std::filesystem::path& to, const std::string& help);
    Option option(const std::string& name, int& to, const std::string& help);
    Option option(const std::string& name, std::uint32_t& to, const std::string& help);
    Option option(const std::string& name, double& to, const std::string& help);
    Option option(const std::string& name, std::optional<double>& to, const std::string& help);
    Option option(const std::string& name, const ReadValue& read, const std::string& help);
    Option flag(const std::string& name, bool& to, const std::string& help);
    Option flag(const std::string& name, const std::function<void()>& action, const std::string& help);
    /// A flag that may have one of a few words after an equals sign: "--update" stands for the first word,
    /// "--update=missing" for another. `to` is empty without the flag.
    Option flag(const std::string& name, const std::vector<std::string>& words, std::string& to,
                const std::string& help);
    /// An option that may be repeated, with one value each time.
    Option repeated(const std::string& name, std::vector<std::string>& to, const std::string& help);
    Option repeated(const std::string& name, const ReadValue& read, const std::string& help);
    /// An option or positional argument that takes all words up to the next option.
    Option list(const std::string& name, std::vector<std::string>& to, const std::string& help);

    /// An option whose value is one of a few words. `words` is a range of pairs of a word and its value.
    template <class Value, class Words>
    Option choice(const std::string& name, Value& to, const Words& words, const std::string& help) {
        std::vector<std::string> names;
        std::vector<Value> values;
        for (const auto& [word, value] : words) {
            names.emplace_back(word);
            values.push_back(value);
        }
        return choice(name, std::move(names), [values, &to](std::size_t which) { to = values[which]; }, help);
    }

    /// --driver
    Option driver(Driver& to);
    /// --jobs; 0 means the usual number (gpu::usualWorkers).
    Option jobs(int& to);

    /// An option that was added before: "--only".
    [[nodiscard]] Option find(const std::string& name) const;

    /// Adds a subcommand. `summary` says what it does, without a subject: "renders scenes to pictures". Its
    /// --help begins with the examples, one per line.
    CommandLine subcommand(const char* name, const char* summary, const char* examples);
    /// Adds a subcommand that takes the rest of the command line, --help included, as it is.
    void subcommand(const char* name, const char* summary,
                    const std::function<void(const std::vector<std::string>&)>& run);
    /// What to do when the command line has been read and names this subcommand.
    void onRun(const std::function<void()>& run);
    [[nodiscard]] bool isGiven() const;

  private:
    Option choice(const std::string& name, const std::vector<std::string>& words,
                  const std::function<void(std::size_t)>& take, const std::string& help);

    CLI::App* app_;
};

/// An option as manual pages and completions show it. Names of what does not exist are empty.
struct OptionDescription {
    std::string longName;            ///< "--size"; of a positional argument its name, "scenes"
    std::string shortName;           ///< "-o"
    std::string placeholder;         ///< "FOLDER"; empty: takes no value
    std::string help;                ///< "a number of pixels"
    std::vector<std::string> words;  ///< the values that it can have, if these are few
    bool isPositional = false;
    bool isRare = false;  ///< only --help-all lists it
};

/// A program or one of its subcommands.
struct CommandDescription {
    std::string name;     ///< "render"
    std::string summary;  ///< "renders scenes to pictures"
    std::vector<std::string> examples;
    std::vector<OptionDescription> options;
    bool isProgram = false;  ///< a program of its own reads its options, which are not listed here
};

/// The command line of a program.
class Program {
  public:
    /// `name` is what --help prints as the program's name. The examples stand one per line.
    Program(const char* description, const char* examples, const char* name = "glibra");
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    [[nodiscard]] CommandLine line();
    /// --version prints the text.
    void version(const char* text);
    void requireSubcommand();
    /// The names of the subcommands, in their order.
    [[nodiscard]] std::vector<std::string> subcommands() const;
    /// The program itself, then its subcommands in their order, without what --help-all leaves out.
    [[nodiscard]] std::vector<CommandDescription> describe() const;
    /// Reads the arguments and runs the subcommand. Returns nothing, or the exit status of a command line
    /// that is wrong or asked for help only; what it asked for has been printed.
    std::optional<int> parse(int argc, char** argv);

  private:
    std::unique_ptr<CLI::App> app_;
};

}  // namespace glibra::cli

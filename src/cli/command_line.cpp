#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <type_traits>
#include <utility>

#include "base/suggest.h"
#include "base/utf8.h"
#include "cli/commands.h"

namespace glibra::cli {
namespace {

/// The options that --help leaves out and --help-all lists.
constexpr const char* kRare = "More options";

/// Prints the examples first, then the description, then the options: without those that are rare, without
/// former names, and without lists of what excludes what, which the message about the mistake says.
class ExamplesFirst : public CLI::Formatter {
  public:
    explicit ExamplesFirst(std::string examples) : examples_(std::move(examples)) {}

    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
        const bool all = mode == CLI::AppFormatMode::All;
        std::string text = make_description(app) + make_usage(app, std::move(name)) + make_positionals(app);
        std::size_t omitted = 0;
        for (const std::string& group : app->get_groups()) {
            const std::vector<const CLI::Option*> options = app->get_options(
                [&](const CLI::Option* each) { return each->get_group() == group && each->nonpositional(); });
            if (group.empty() || options.empty()) continue;
            if (group == kRare && !all)
                omitted = options.size();
            else
                text += make_group(group, false, options);
        }
        text += make_subcommands(app, all ? CLI::AppFormatMode::Normal : mode);
        if (omitted > 0) text += fmt::format("\n--help-all lists {} more options.\n", omitted);
        return text;
    }

    std::string make_description(const CLI::App* app) const override {
        std::string text = "Examples:\n";
        std::istringstream lines(examples_);
        for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
        return text + "\n" + CLI::Formatter::make_description(app);
    }

    std::string make_option_name(const CLI::Option* option, bool isPositional) const override {
        if (isPositional || option->get_lnames().empty())
            return CLI::Formatter::make_option_name(option, isPositional);
        std::string text;
        for (const std::string& each : option->get_snames()) text += "-" + each + ",";
        return text + "--" + option->get_lnames().front();
    }

    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text;
        if (option->get_type_size() == 0) return text;
        if (!option->get_type_name().empty()) text += " " + option->get_type_name();
        if (!option->get_default_str().empty()) text += "=" + option->get_default_str();
        if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
        return text;
    }

    [[nodiscard]] const std::string& examples() const { return examples_; }

  private:
    std::string examples_;
};

/// The name of the validator that keeps the words of a choice, for describe(): "words\nauto\negl".
constexpr std::string_view kWords = "words";

CLI::Validator keepingWords(const std::vector<std::string>& words) {
    const std::string name = fmt::format("{}\n{}", kWords, fmt::join(words, "\n"));
    return CLI::Validator([](std::string&) { return std::string(); }, "", name);
}

std::vector<std::string> splitLines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream from(text);
    for (std::string line; std::getline(from, line);) lines.push_back(line);
    return lines;
}

/// The words of keepingWords().
std::vector<std::string> wordsOf(CLI::Option& option) {
    try {
        for (int i = 0;; ++i) {
            std::vector<std::string> lines = splitLines(option.get_validator(i)->get_name());
            if (lines.empty() || lines.front() != kWords) continue;
            lines.erase(lines.begin());
            return lines;
        }
    } catch (const CLI::OptionNotFound&) {  // the option has no more validators
        return {};
    }
}

OptionDescription describedOption(CLI::Option& option) {
    OptionDescription to;
    to.isPositional = !option.nonpositional();
    to.isRare = option.get_group() == kRare;
    if (to.isPositional)
        to.longName = option.get_name();
    else if (!option.get_lnames().empty())
        to.longName = "--" + option.get_lnames().front();
    if (!option.get_snames().empty()) to.shortName = "-" + option.get_snames().front();
    if (option.get_type_size() != 0) to.placeholder = option.get_type_name();
    to.help = option.get_description();
    to.words = wordsOf(option);
    return to;
}

CommandDescription describedCommand(CLI::App& app) {
    CommandDescription to;
    to.name = app.get_name();
    to.summary = app.get_description();
    if (const auto* formatter = dynamic_cast<const ExamplesFirst*>(app.get_formatter().get()))
        to.examples = splitLines(formatter->examples());
    to.isProgram = app.get_prefix_command();
    for (CLI::Option* each : app.get_options({}))
        if (!each->get_group().empty()) to.options.push_back(describedOption(*each));
    return to;
}

/// The first long name, which messages show; former names are after it.
std::string shownName(const std::string& name) {
    const std::size_t at = name.find("--");
    const std::string shown = at == std::string::npos ? name : name.substr(at);
    return shown.substr(0, shown.find(','));
}

void readOne(const std::string& name, const ReadValue& read, const std::string& text) {
    if (const std::string wrong = read(text); !wrong.empty())
        throw CLI::ValidationError(shownName(name), wrong);
}

/// The option with the check that its value is not another option: `--stats -o picture.png`.
CLI::Option* withValue(CLI::App& app, CLI::Option* option) {
    return option->check([&app](const std::string& text) -> std::string {
        if (text.size() < 2 || text.front() != '-' || app.get_option_no_throw(text) == nullptr) return {};
        return fmt::format("expected a value, found the option {0} (./{0} is a file of that name)", text);
    });
}

CLI::Option* addReader(CLI::App& app, const std::string& name, const ReadValue& read,
                       const std::string& help) {
    return withValue(app,
                     app.add_option_function<std::string>(
                         name, [name, read](const std::string& text) { readOne(name, read, text); }, help));
}

/// Reads the whole text as a number.
template <class Number>
bool readNumber(const std::string& text, Number& to) {
    const char* end = text.data() + text.size();
    const auto [last, problem] = std::from_chars(text.data(), end, to);
    if (problem != std::errc() || last != end) return false;
    if constexpr (std::is_floating_point_v<Number>) return std::isfinite(to);
    return true;
}

template <class Number>
CLI::Option* addNumber(CLI::App& app, const std::string& name, Number& to, const std::string& help) {
    const ReadValue read = [&to](const std::string& text) -> std::string {
        if (readNumber(text, to)) return {};
        return fmt::format("expected a {}number, found '{}'", std::is_integral_v<Number> ? "whole " : "",
                           text);
    };
    CLI::Option* option = addReader(app, name, read, help)->type_name("N");
    option->default_function([&to] { return fmt::format("{:g}", static_cast<double>(to)); });
    return option;
}

/// What is wrong with the first word that the command does not understand, with the nearest option; empty if
/// it understands all. It is reported before what follows from it, such as a missing value.
std::string unknownWord(const CLI::App& command) {
    std::vector<std::string> words = command.remaining();
    std::erase(words, "--");  // CLI11 keeps it, although all after it is understood
    if (words.empty()) return {};
    const auto isOption = [](const std::string& each) { return each.size() > 1 && each.front() == '-'; };
    const auto found = std::find_if(words.begin(), words.end(), isOption);
    if (found == words.end())
        return fmt::format("'{}' is one word too many for {}", words.front(), command.get_name());
    const std::string word = found->substr(0, found->find('='));
    std::vector<std::string> names;
    for (const CLI::Option* each : command.get_options()) {
        if (each->get_group().empty()) continue;
        for (const std::string& name : each->get_lnames()) names.push_back("--" + name);
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return fmt::format("{} has no option '{}'{}", command.get_name(), word,
                       base::suggestion(word, candidates, 2));
}

/// CLI11's message in this program's words.
std::string explained(const CLI::ParseError& wrong) {
    std::string text = wrong.what();
    const std::string kind = wrong.get_name();
    // "--size: 1 required WxH missing"
    constexpr std::string_view kMissing = " missing";
    if (const std::size_t colon = text.find(": 1 required ");
        colon != std::string::npos && text.ends_with(kMissing)) {
        const std::size_t type = colon + std::string_view(": 1 required ").size();
        return fmt::format("{} needs a value: {}", text.substr(0, colon),
                           text.substr(type, text.size() - type - kMissing.size()));
    }
    const auto reworded = [&](std::string_view from, std::string_view to) {
        if (const std::size_t at = text.find(from); at != std::string::npos)
            text.replace(at, from.size(), to);
    };
    if (kind == "ExcludesError") reworded(" excludes ", " cannot be given together with ");
    if (kind == "RequiresError") reworded(" requires ", " has an effect only with ");
    if (kind == "RequiredError") reworded(" is required", " is missing");
    return text;
}

/// The first option that ends with "=", as "--update=$MODE" without MODE. CLI11 would see a flag without a
/// value.
std::string_view optionWithoutValue(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--") break;
        if (word.starts_with("--") && word.find('=') == word.size() - 1) return word;
    }
    return {};
}

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& words) {
    std::string text = words.front();
    for (std::size_t i = 1; i < words.size(); ++i) text += (i + 1 < words.size() ? ", " : " or ") + words[i];
    return text;
}

}  // namespace

Option& Option::placeholder(const std::string& word) {
    option_->type_name(word);
    return *this;
}

Option& Option::within(double least, double most) {
    const bool isOpen = std::isinf(most);
    const std::string allowed =
        isOpen ? fmt::format("{:g} or more", least) : fmt::format("{:.10g} to {:.10g}", least, most);
    const std::string expected = (isOpen ? "a number, " : "a number from ") + allowed;
    option_->description(fmt::format("{} ({})", option_->get_description(), allowed));
    option_->check([least, most, expected](const std::string& text) -> std::string {
        double value = 0;
        // What is not a number is reported where it is read.
        if (!readNumber(text, value) || (value >= least && value <= most)) return {};
        return fmt::format("expected {}, found '{}'", expected, text);
    });
    return *this;
}

Option& Option::offering(const std::vector<std::string>& words) {
    option_->check(keepingWords(words));
    return *this;
}

Option& Option::withDefault() {
    option_->capture_default_str();
    return *this;
}

Option& Option::existingFile() {
    option_->check(CLI::ExistingFile.description(""))->type_name("FILE");
    return *this;
}

std::string whyNotWritten(const std::string& text) {
    if (text != "-") return {};
    return "'-' does not mean standard output here; name a file or folder (./- for one with the name '-')";
}

Option& Option::written() {
    option_->check(whyNotWritten);
    return *this;
}

Option& Option::rare() {
    option_->group(kRare);
    return *this;
}

Option& Option::hidden() {
    option_->group("");
    return *this;
}

Option& Option::required() {
    option_->required();
    return *this;
}

Option& Option::needs(const Option& other) {
    option_->needs(other.option_);
    return *this;
}

Option& Option::excludes(const Option& other) {
    option_->excludes(other.option_);
    return *this;
}

bool Option::isGiven() const {
    return option_->count() > 0;
}

Option CommandLine::option(const std::string& name, std::string& to, const std::string& help) {
    return Option(*withValue(*app_, app_->add_option(name, to, help)));
}

Option CommandLine::option(const std::string& name, std::filesystem::path& to, const std::string& help) {
    return Option(*withValue(*app_, app_->add_option(name, to, help)));
}

Option CommandLine::option(const std::string& name, int& to, const std::string& help) {
    return Option(*addNumber(*app_, name, to, help));
}

Option CommandLine::option(const std::string& name, std::uint32_t& to, const std::string& help) {
    return Option(*addNumber(*app_, name, to, help));
}

Option CommandLine::option(const std::string& name, double& to, const std::string& help) {
    return Option(*addNumber(*app_, name, to, help));
}

Option CommandLine::option(const std::string& name, std::optional<double>& to, const std::string& help) {
    const ReadValue read = [&to](const std::string& text) -> std::string {
        if (readNumber(text, to.emplace())) return {};
        return fmt::format("expected a number, found '{}'", text);
    };
    return Option(*addReader(*app_, name, read, help)->type_name("N"));
}

Option CommandLine::option(const std::string& name, const ReadValue& read, const std::string& help) {
    return Option(*addReader(*app_, name, read, help));
}

Option CommandLine::flag(const std::string& name, bool& to, const std::string& help) {
    return Option(*app_->add_flag(name, to, help));
}

Option CommandLine::flag(const std::string& name, const std::function<void()>& action,
                         const std::string& help) {
    return Option(*app_->add_flag_callback(name, action, help));
}

Option CommandLine::flag(const std::string& name, const std::vector<std::string>& words, std::string& to,
                         const std::string& help) {
    CLI::Option* option = app_->add_flag(name + "{" + words.front() + "}", to, help);
    option->check([words](const std::string& text) -> std::string {
        if (std::find(words.begin(), words.end(), text) != words.end()) return {};
        return fmt::format("expected {}, found '{}'", alternatives(words), text);
    });
    return Option(*option);
}

Option CommandLine::repeated(const std::string& name, std::vector<std::string>& to, const std::string& help) {
    return Option(*withValue(*app_, app_->add_option(name, to, help)->allow_extra_args(false)));
}

Option CommandLine::repeated(const std::string& name, const ReadValue& read, const std::string& help) {
    const auto readAll = [name, read](const std::vector<std::string>& texts) {
        for (const std::string& each : texts) readOne(name, read, each);
    };
    CLI::Option* option = app_->add_option_function<std::vector<std::string>>(name, readAll, help);
    return Option(*withValue(*app_, option->allow_extra_args(false)));
}

Option CommandLine::list(const std::string& name, std::vector<std::string>& to, const std::string& help) {
    return Option(*withValue(*app_, app_->add_option(name, to, help)));
}

Option CommandLine::choice(const std::string& name, const std::vector<std::string>& words,
                           const std::function<void(std::size_t)>& take, const std::string& help) {
    const ReadValue read = [words, take](const std::string& text) -> std::string {
        const auto found = std::find(words.begin(), words.end(), text);
        if (found == words.end()) return fmt::format("expected {}, found '{}'", alternatives(words), text);
        take(static_cast<std::size_t>(found - words.begin()));
        return {};
    };
    return Option(*addReader(*app_, name, read, help)).offering(words).placeholder("WORD");
}

Option CommandLine::driver(Driver& to) {
    return choice(
               "--driver", to, kDriverWords,
               "the OpenGL driver: auto, egl, egl-device, osmesa, gles (what browsers have) or wgl (Windows)")
        .placeholder("DRIVER");
}

Option CommandLine::jobs(int& to) {
    return option("--jobs", to,
                  "number of worker processes; default one per processor, with a graphics card at most 4")
        .within(1, 256);
}

Option CommandLine::find(const std::string& name) const {
    return Option(*app_->get_option(name));
}

CommandLine CommandLine::subcommand(const char* name, const char* summary, const char* examples) {
    CLI::App* added = app_->add_subcommand(name, summary);
    added->formatter(std::make_shared<ExamplesFirst>(examples));
    return CommandLine(*added);
}

void CommandLine::subcommand(const char* name, const char* summary,
                             const std::function<void(const std::vector<std::string>&)>& run) {
    CLI::App* added = app_->add_subcommand(name, summary);
    added->prefix_command();
    added->set_help_flag();
    added->set_help_all_flag();
    added->callback([added, run] { run(added->remaining()); });
}

void CommandLine::onRun(const std::function<void()>& run) {
    app_->callback(run);
}

bool CommandLine::isGiven() const {
    return app_->parsed();
}

Program::Program(const char* description, const char* examples, const char* name)
    : app_(std::make_unique<CLI::App>(description, name)) {
    app_->allow_windows_style_options(false);  // "/tmp/a.glib" is a path everywhere
    app_->set_help_flag("-h,--help", "print this help, without rare options");
    app_->set_help_all_flag("--help-all", "print this help with all options");
    app_->formatter(std::make_shared<ExamplesFirst>(examples));
}

Program::~Program() = default;

CommandLine Program::line() {
    return CommandLine(*app_);
}

void Program::version(const char* text) {
    app_->set_version_flag("--version", text);
}

void Program::requireSubcommand() {
    app_->require_subcommand(1);
}

std::vector<std::string> Program::subcommands() const {
    std::vector<std::string> names;
    for (const CLI::App* each : app_->get_subcommands({})) names.push_back(each->get_name());
    return names;
}

std::vector<CommandDescription> Program::describe() const {
    std::vector<CommandDescription> all{describedCommand(*app_)};
    for (CLI::App* each : app_->get_subcommands({})) all.push_back(describedCommand(*each));
    return all;
}

std::optional<int> Program::parse(int argc, char** argv) {
    if (const std::string_view word = optionWithoutValue(argc, argv); !word.empty()) {
        printError(fmt::format("{} has no value", base::printableText(word)));
        return kWrongUsage;
    }
    try {
        app_->parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::Success& asked) {
        std::ostringstream help;
        std::ostringstream none;
        app_->exit(asked, help, none);
        // Arguments may be names of files.
        const std::string safe = base::printableText(help.str(), true);
        std::fwrite(safe.data(), 1, safe.size(), stdout);
        return kDone;
    } catch (const CLI::ParseError& wrong) {
        const CLI::App* command = app_.get();
        std::string name = command->get_name();
        while (!command->get_subcommands().empty()) {
            command = command->get_subcommands().back();
            name += " " + command->get_name();
        }
        const std::string unknown = unknownWord(*command);
        printError(unknown.empty() ? explained(wrong) : unknown);
        printLine(fmt::format("`{} --help` begins with examples", name));
        return kWrongUsage;
    }
}

}  // namespace glibra::cli

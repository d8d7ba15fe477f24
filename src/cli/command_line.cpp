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

#include "base/utf8.h"
#include "cli/commands.h"

namespace glibra::cli {
namespace {

/// Puts the example before the description.
class ExampleFormatter : public CLI::Formatter {
  public:
    explicit ExampleFormatter(std::string example) : example_(std::move(example)) {}
    std::string make_description(const CLI::App* app) const override {
        return "Example: " + example_ + "\n\n" + CLI::Formatter::make_description(app);
    }

  private:
    std::string example_;
};

/// The last of an option's names is the one that messages show.
std::string shownName(const std::string& name) {
    return name.substr(name.rfind(',') + 1);
}

void readOne(const std::string& name, const ReadValue& read, const std::string& text) {
    if (const std::string wrong = read(text); !wrong.empty())
        throw CLI::ValidationError(shownName(name), wrong);
}

CLI::Option* addReader(CLI::App& app, const std::string& name, const ReadValue& read,
                       const std::string& help) {
    return app.add_option_function<std::string>(
        name, [name, read](const std::string& text) { readOne(name, read, text); }, help);
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

Option& Option::withDefault() {
    option_->capture_default_str();
    return *this;
}

Option& Option::existingFile() {
    option_->check(CLI::ExistingFile.description(""))->type_name("FILE");
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
    return Option(*app_->add_option(name, to, help));
}

Option CommandLine::option(const std::string& name, std::filesystem::path& to, const std::string& help) {
    return Option(*app_->add_option(name, to, help));
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

Option CommandLine::repeated(const std::string& name, std::vector<std::string>& to, const std::string& help) {
    return Option(*app_->add_option(name, to, help)->allow_extra_args(false));
}

Option CommandLine::repeated(const std::string& name, const ReadValue& read, const std::string& help) {
    const auto readAll = [name, read](const std::vector<std::string>& texts) {
        for (const std::string& each : texts) readOne(name, read, each);
    };
    CLI::Option* option = app_->add_option_function<std::vector<std::string>>(name, readAll, help);
    return Option(*option->allow_extra_args(false));
}

Option CommandLine::list(const std::string& name, std::vector<std::string>& to, const std::string& help) {
    return Option(*app_->add_option(name, to, help));
}

Option CommandLine::choice(const std::string& name, std::vector<std::string> words,
                           const std::function<void(std::size_t)>& take, const std::string& help) {
    const ReadValue read = [words, take](const std::string& text) -> std::string {
        const auto found = std::find(words.begin(), words.end(), text);
        if (found == words.end()) return fmt::format("expected {}, found '{}'", alternatives(words), text);
        take(static_cast<std::size_t>(found - words.begin()));
        return {};
    };
    return option(name, read, help).placeholder("WORD");
}

Option CommandLine::driver(Driver& to) {
    return choice("--driver", to, kDriverWords, "the OpenGL driver: auto, egl, egl-device or osmesa")
        .placeholder("DRIVER");
}

Option CommandLine::jobs(int& to) {
    return option("--jobs", to, "number of worker processes; default one per processor").within(1, 256);
}

Option CommandLine::find(const std::string& name) const {
    return Option(*app_->get_option(name));
}

CommandLine CommandLine::subcommand(const char* name, const char* summary, const char* example) {
    CLI::App* added = app_->add_subcommand(name, summary);
    added->formatter(std::make_shared<ExampleFormatter>(example));
    return CommandLine(*added);
}

void CommandLine::subcommand(const char* name, const char* summary,
                             const std::function<void(const std::vector<std::string>&)>& run) {
    CLI::App* added = app_->add_subcommand(name, summary);
    added->prefix_command();
    added->set_help_flag();
    added->callback([added, run] { run(added->remaining()); });
}

void CommandLine::onRun(const std::function<void()>& run) {
    app_->callback(run);
}

bool CommandLine::isGiven() const {
    return app_->parsed();
}

Program::Program(const char* description, const char* example, const char* name)
    : app_(std::make_unique<CLI::App>(description, name)) {
    app_->formatter(std::make_shared<ExampleFormatter>(example));
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

std::optional<int> Program::parse(int argc, char** argv) {
    try {
        app_->parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& wrong) {
        std::ostringstream help;
        std::ostringstream error;
        const int status = app_->exit(wrong, help, error);
        const auto put = [](const std::string& text, std::FILE* file) {
            const std::string safe = base::printableText(text, true);  // arguments may be names of files
            std::fwrite(safe.data(), 1, safe.size(), file);
        };
        put(help.str(), stdout);
        put(error.str(), stderr);
        return status == 0 ? kDone : kWrongUsage;
    }
}

}  // namespace glibra::cli

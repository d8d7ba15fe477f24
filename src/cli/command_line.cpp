#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>
#include <sstream>
#include <string>
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

}  // namespace

void setExample(CLI::App& app, const char* example) {
    app.formatter(std::make_shared<ExampleFormatter>(example));
}

CLI::App* addCommand(CLI::App& app, const char* name, const char* summary, const char* example) {
    CLI::App* command = app.add_subcommand(name, summary);
    setExample(*command, example);
    return command;
}

int reportUsage(const CLI::App& app, const CLI::ParseError& wrong) {
    std::ostringstream help;
    std::ostringstream error;
    const int status = app.exit(wrong, help, error);
    const auto put = [](const std::string& text, std::FILE* file) {
        const std::string safe = base::printableText(text, true);  // arguments may be names of files
        std::fwrite(safe.data(), 1, safe.size(), file);
    };
    put(help.str(), stdout);
    put(error.str(), stderr);
    return status == 0 ? kDone : kWrongUsage;
}

void addDriverOption(CLI::App& command, Driver& to) {
    const std::map<std::string, Driver> words(kDriverWords.begin(), kDriverWords.end());
    command.add_option("--driver", to, "the OpenGL driver: auto, egl, egl-device or osmesa")
        ->transform(CLI::CheckedTransformer(words).description(""))
        ->type_name("DRIVER");
}

void addJobsOption(CLI::App& command, int& to) {
    command.add_option("--jobs", to, "number of worker processes (1 to 256); default one per processor")
        ->type_name("N")
        ->check(CLI::Range(1, 256).description(""));
}

}  // namespace glibra::cli

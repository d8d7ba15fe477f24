// glibra help, manual and completion: what they say of the options is what --help-all says, in real shells.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace glibra::test {
namespace {

/// The subcommands that `glibra --help` lists.
std::vector<std::string> subcommands(const Folder& folder) {
    const std::string help = glibra(folder.path(), "--help").out;
    std::istringstream lines(help.substr(help.find("Subcommands:")));
    std::vector<std::string> found;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string name;
        if (line.starts_with("  ") && line[2] != ' ' && words >> name) found.push_back(name);
    }
    return found;
}

/// The long options of a text: "--size".
std::set<std::string> longOptions(const std::string& text) {
    static const std::regex kOption("--[a-z][a-z-]*[a-z]");
    return {std::sregex_token_iterator(text.begin(), text.end(), kOption), std::sregex_token_iterator()};
}

/// The options that --help-all lists at the beginning of a line.
std::set<std::string> listedOptions(const Folder& folder, const std::string& command) {
    std::istringstream lines(glibra(folder.path(), command + " --help-all").out);
    std::set<std::string> found;
    static const std::regex kLine("^  (-[A-Za-z],)?(--[a-z-]+).*");
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, match, kLine)) found.insert(match[2]);
    return found;
}

/// What bash offers for these words, the last of which is being typed.
std::string bashOffers(const Folder& folder, const std::string& words) {
    folder.write(
        "complete.bash",
        fmt::format("source glibra.bash\nCOMP_WORDS=({})\nCOMP_CWORD=$(( ${{#COMP_WORDS[@]}} - 1 ))\n"
                    "_glibra\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"\n",
                    words));
    return shell(folder.path(), "bash complete.bash").out;
}

bool isOneOf(const std::string& name, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* each) { return name == each; });
}

/// The window and the benchmarks are programs of their own, which read their options themselves.
bool readsOptionsElsewhere(const std::string& command) {
    return isOneOf(command, {"view", "bench", "help"});
}

TEST(Help, OfASubcommandIsWhatItsOptionPrints) {
    const Folder folder;
    for (const std::string& each : subcommands(folder)) {
        if (readsOptionsElsewhere(each)) continue;
        const Finished asked = glibra(folder.path(), "help " + each);
        EXPECT_EQ(asked.status, 0) << each;
        EXPECT_EQ(asked.out, glibra(folder.path(), each + " --help").out) << each;
    }
    EXPECT_EQ(glibra(folder.path(), "help").out, glibra(folder.path(), "--help").out);
    const Finished wrong = glibra(folder.path(), "help rendr");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_PRED2(contains, wrong.err, "render");
}

TEST(Manual, HasAPageForEachSubcommandWithAllItsOptions) {
    const Folder folder;
    const std::vector<std::string> commands = subcommands(folder);
    ASSERT_GE(commands.size(), 10U);
    for (const std::string& each : commands) {
        const Finished page = glibra(folder.path(), "manual " + each);
        ASSERT_EQ(page.status, 0) << each << page.err;
        folder.write("page.1", page.out);
        const Finished lint = shell(folder.path(), "mandoc -T lint -W error page.1");
        EXPECT_EQ(lint.out + lint.err, "") << each;
        static const std::regex kDash(R"(\\-)");
        const std::string shown = std::regex_replace(page.out, kDash, "-");
        if (readsOptionsElsewhere(each)) continue;
        const std::set<std::string> has = longOptions(shown);
        for (const std::string& option : listedOptions(folder, each))
            EXPECT_TRUE(has.contains(option)) << each << " " << option;
    }
    const std::string whole =
        std::regex_replace(glibra(folder.path(), "manual").out, std::regex(R"(\\-)"), "-");
    for (const std::string& each : commands) EXPECT_PRED2(contains, whole, "\\fB" + each + "\\fR") << each;
    EXPECT_EQ(glibra(folder.path(), "manual rendr").status, 2);
}

TEST(Completion, OfBashOffersCommandsOptionsWordsAndFiles) {
    const Folder folder;
    folder.write("dots.glib", "Sphere\n");
    folder.write("glibra.bash", glibra(folder.path(), "completion bash").out);
    const std::vector<std::string> commands = subcommands(folder);
    const std::string offered = bashOffers(folder, "glibra ''");
    for (const std::string& each : commands) EXPECT_PRED2(contains, offered, each + "\n");
    EXPECT_PRED2(contains, offered, "dots.glib\n");
    for (const std::string& each : commands) {
        if (readsOptionsElsewhere(each)) continue;
        const std::set<std::string> has = longOptions(bashOffers(folder, fmt::format("glibra {} --", each)));
        for (const std::string& option : listedOptions(folder, each))
            EXPECT_TRUE(has.contains(option)) << each << " " << option;
    }
    EXPECT_EQ(bashOffers(folder, "glibra render dots.glib --driver ''"),
              "auto\negl\negl-device\nosmesa\nwgl\ngles\n");
    EXPECT_EQ(bashOffers(folder, "glibra render do"), "dots.glib\n");
    EXPECT_EQ(bashOffers(folder, "glibra help ren"), "render\n");
    EXPECT_EQ(bashOffers(folder, "glibra manual ren"), "render\n");
    EXPECT_EQ(bashOffers(folder, "glibra completion ''"), "bash\nzsh\nfish\npowershell\n");
    EXPECT_PRED2(contains, bashOffers(folder, "glibra render --labels ''"), "none\n");
    for (const char* each : {"--eye", "--projection"})
        EXPECT_EQ(bashOffers(folder, fmt::format("glibra render {} ''", each)).find("dots"),
                  std::string::npos);
    folder.write("b c.glib", "Sphere\n");
    EXPECT_EQ(bashOffers(folder, "glibra render b"), "b c.glib\n");
    EXPECT_EQ(bashOffers(folder, "glibra render -o b"), "b c.glib\n");
}

TEST(Completion, OfFishOffersOptionsWithTheirTexts) {
    const Folder folder;
    folder.write("glibra.fish", glibra(folder.path(), "completion fish").out);
    const auto offers = [&](const std::string& typed) {
        return shell(
                   folder.path(),
                   fmt::format("HOME=. fish --no-config -c 'source glibra.fish; complete -C \"{}\"'", typed))
            .out;
    };
    EXPECT_PRED2(contains, offers("glibra ren"), "render\trenders scenes");
    EXPECT_PRED2(contains, offers("glibra render --driv"), "--driver\t");
    EXPECT_PRED2(contains, offers("glibra render --driver os"), "osmesa");
    EXPECT_PRED2(contains, offers("glibra completion po"), "powershell");
}

TEST(Completion, OfZshIsAScriptOfZsh) {
    const Folder folder;
    folder.write("_glibra", glibra(folder.path(), "completion zsh").out);
    const Finished read =
        shell(folder.path(),
              "zsh -f -c 'autoload -Uz compinit; compinit -D; source ./_glibra; print ${_comps[glibra]}'");
    EXPECT_EQ(read.out, "_glibra\n") << read.err;
    EXPECT_EQ(read.err, "");
}

/// What of quotes and brackets is open at the end of a text of PowerShell, and how deep it was; "?" for what
/// closes nothing.
std::string openAtEnd(const std::string& text) {
    std::string open;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char each = text[i];
        if (each == '#' && open.empty()) {
            i = text.find('\n', i);
        } else if (!open.empty() && open.back() == '\'') {
            if (each == '\'') open.pop_back();  // a doubled one opens it again
        } else if (each == '\'' || each == '{' || each == '(' || each == '[') {
            open += each;
        } else if (each == '}' || each == ')' || each == ']') {
            if (open.empty() || open.back() != (each == '}' ? '{' : each == ')' ? '(' : '[')) return "?";
            open.pop_back();
        }
    }
    return open;
}

TEST(Completion, OfPowerShellNamesCommandsOptionsAndWords) {
    const Folder folder;
    const std::string text = glibra(folder.path(), "completion powershell").out;
    EXPECT_EQ(openAtEnd(text), "");
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](unsigned char each) { return each < 128; }))
        << "its encoding depends on the console";
    for (const std::string& each : subcommands(folder)) {
        EXPECT_PRED2(contains, text, "            '" + each + "|");
        if (readsOptionsElsewhere(each)) continue;
        const std::size_t at = text.find("            '" + each + "' { $offers = @(");
        ASSERT_NE(at, std::string::npos) << each;
        const std::set<std::string> has = longOptions(text.substr(at, text.find("            ) }", at) - at));
        for (const std::string& option : listedOptions(folder, each))
            EXPECT_TRUE(has.contains(option)) << each << " " << option;
    }
    EXPECT_PRED2(contains, text,
                 "'render --driver' { $offers = 'auto', 'egl', 'egl-device', 'osmesa', 'wgl', 'gles' }\n");
    EXPECT_PRED2(contains, text,
                 "'completion completion' { $offers = 'bash', 'zsh', 'fish', 'powershell' }\n");
    EXPECT_PRED2(contains, text, "'render --output' { return }\n") << "PowerShell offers files by itself";
}

TEST(Completion, OfAnotherShellIsRefused) {
    const Folder folder;
    const Finished wrong = glibra(folder.path(), "completion tcsh");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_PRED2(contains, wrong.err, "bash, zsh, fish or powershell");
}

}  // namespace
}  // namespace glibra::test

// Generated macro programs: the preprocessor against the C preprocessor and glslangValidator -E.

#include <gtest/gtest.h>

#include <cstdint>

#include "preprocessed.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

/// A program of macros and of text that calls them, made from a seed.
class Generator {
  public:
    Generator(std::uint32_t seed, bool pastes) : state_(seed * 2654435761U + 1), pastes_(pastes) {}

    std::string run() {
        std::string text = "#version 450\n";
        const int macros = 3 + below(5);
        for (int i = 0; i < macros; ++i) text += define(i);
        for (int line = 0; line < 6; ++line) {
            if (below(5) == 0) text += "#undef " + nameOf(below(macros)) + "\n";
            if (below(8) == 0) text += "#ifdef " + nameOf(below(macros)) + "\nyes\n#else\nno\n#endif\n";
            if (below(8) == 0) text += "#if " + condition(3) + "\nholds\n#endif\n";
            text += sequence(6, {}, 2, true) + ";\n";
        }
        return text;
    }

    std::string condition(int depth) {
        static constexpr const char* kBinary[] = {
            "+", "-", "*", "<<", ">>", "<", ">", "<=", ">=", "==", "!=", "&", "|", "^", "&&", "||"};
        switch (depth <= 0 ? 0 : below(6)) {
            case 0:
                return below(4) == 0 ? std::string("defined ") + nameOf(below(8)) : std::to_string(below(9));
            case 1:
                return std::string(1, "!-~+"[below(4)]) + " " + condition(depth - 1);
            case 2:
                return "(" + condition(depth - 1) + ")";
            case 3:
                return below(2) == 0 ? "(0 && 1 / 0)" : "(1 || 1 % 0)";
            default: {
                const std::string op = kBinary[below(16)];
                // Shifts by more than the width are nobody's business.
                const std::string right =
                    op == "<<" || op == ">>" ? std::to_string(below(3)) : condition(depth - 1);
                return "(" + condition(depth - 1) + " " + op + " " + right + ")";
            }
        }
    }

  private:
    int below(int n) {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        state_ ^= state_ << 5;
        return static_cast<int>(state_ % static_cast<std::uint32_t>(n));
    }

    static std::string nameOf(int macro) { return std::string("M") + static_cast<char>('A' + macro); }

    std::string blank(bool lines) {
        switch (below(lines ? 8 : 5)) {
            case 0:
                return "";
            case 1:
                return "/* c, ) */";
            case 5:
                return "\n";
            case 6:
                return " // (\n  ";
            case 7:
                return "\\\n";
            default:
                return " ";
        }
    }

    std::string define(int macro) {
        parameters_[macro] = below(4) - 1;
        std::string text = "#define " + nameOf(macro);
        std::vector<std::string> names;
        if (parameters_[macro] >= 0) {
            text += "(";
            for (int i = 0; i < parameters_[macro]; ++i) {
                names.push_back(std::string(1, static_cast<char>('p' + i)));
                text += (i ? "," : "") + names.back();
            }
            text += ")";
        }
        return text + " " + sequence(1 + below(5), names, 1, false) + "\n";
    }

    std::string atom(const std::vector<std::string>& names) {
        static constexpr const char* kAtoms[] = {"-", "+", "-1", ".5", "1.", "x",  "2",  "&", "|", "<",
                                                 ">", "=", "/",  "*",  "!",  "++", "<=", "y", ".", "1e3"};
        if (!names.empty() && below(2) == 0)
            return names[static_cast<std::size_t>(below(static_cast<int>(names.size())))];
        return kAtoms[below(20)];
    }

    std::string call(const std::vector<std::string>& names, int depth, bool lines) {
        const int macro = below(8);
        std::string text = nameOf(macro);
        const int count = parameters_[macro];
        if (count < 0 || below(8) == 0) return text;
        text += blank(lines) + "(";
        for (int i = 0; i < std::max(count, 1); ++i) {
            if (i) text += ",";
            if (count > 0 && below(6) != 0)
                text += blank(lines) + sequence(1 + below(3), names, depth - 1, lines);
        }
        return text + ")";
    }

    std::string sequence(int length, const std::vector<std::string>& names, int depth, bool lines) {
        std::string text;
        for (int i = 0; i < length; ++i) {
            const int kind = below(8);
            std::string piece;
            if (kind < 3 && depth > 0)
                piece = call(names, depth, lines);
            else if (kind == 3 && depth > 0)
                piece = "(" + sequence(2, names, depth - 1, lines) + (below(2) ? "," : "") + "x)";
            else if (kind == 4 && pastes_ && !names.empty())
                piece = "q##" + names[0] + "##_1";
            else
                piece = atom(names);
            // Blanks keep the atoms of the source itself apart.
            text += piece + " " + blank(lines);
        }
        return text;
    }

    std::uint32_t state_;
    bool pastes_;
    int parameters_[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
};

/// What the C preprocessor makes of it, which knows no #version.
Tokens expectedOf(std::string text) {
    text.erase(0, text.find('\n'));
    return cppTokens(text);
}

TEST(GeneratedMacros, ExpandAsInC) {
    int compared = 0;
    for (std::uint32_t seed = 1; seed <= (GLIBRA_SANITIZED ? 60U : 250U); ++seed) {
        const std::string text = Generator(seed, seed % 2 == 0).run();
        const Preprocessed own = preprocessed(text);
        if (!own.ids.empty()) continue;  // a call without end, or a paste that makes no token
        ++compared;
        EXPECT_EQ(expectedOf(text), own.tokens) << "seed " << seed << "\n" << text;
    }
    EXPECT_GT(compared, GLIBRA_SANITIZED ? 25 : 100);
}

TEST(GeneratedMacros, ConditionsCountAsInC) {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        std::string text = "#version 450\n#define MA\n#define MC 3\n";
        for (std::uint32_t k = 0; k < 60; ++k) {
            const std::string condition = Generator(seed * 100 + k, false).condition(5);
            text += "#if " + condition + "\nyes" + std::to_string(k) + "\n#else\nno\n#endif\n";
        }
        const Preprocessed own = preprocessed(text);
        EXPECT_EQ("", own.ids);
        EXPECT_EQ(expectedOf(text), own.tokens) << text;
        EXPECT_EQ(glslangTokens(text), own.tokens) << text;
    }
}

}  // namespace
}  // namespace glibra::glsl::test

#pragma once
// Generated programs of variables, groups, repetitions and conditions, as trees and as texts of scenes.

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace glibra::fuzz {

/// Choices from the bytes of an input; zeros after its end.
class Choices {
  public:
    Choices(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
    std::size_t below(std::size_t count) { return at_ < size_ ? data_[at_++] % count : 0; }
    [[nodiscard]] bool isEmpty() const { return at_ >= size_; }

  private:
    const std::uint8_t* data_;
    std::size_t size_, at_ = 0;
};

/// (a + b + 3) mod 64, so that no value grows without end.
struct Sum {
    std::vector<std::string> names;
    int constant = 0;
    [[nodiscard]] std::string text(int modulus = 64) const {
        std::string all = std::to_string(constant);
        for (const std::string& each : names) all += " + float(" + each + ")";
        return "mod(" + all + ", " + std::to_string(modulus) + ")";
    }
};

struct Statement {
    enum class Kind { let, array, show, set, expect, repeat, values, scope, when, group, draw, pass, once };
    Kind kind = Kind::show;
    std::string name;
    Sum sum;
    int count = 0;
    std::vector<std::pair<std::string, Sum>> arguments{};  ///< of a group: its defaults
    std::vector<bool> areVectors{};                        ///< the argument is a vec2 instead of a number
    std::vector<Statement> body{}, other{};
};
using Kind = Statement::Kind;

struct Program {
    std::vector<Statement> statements;
    bool usesTime = false;  ///< in the conditions of When
};

inline constexpr const char* kVariables[] = {"a", "b",
                                             "c"};    // which the scene declares, the last one perhaps late
inline constexpr const char* kLocals[] = {"d", "e"};  // which are counters and parameters only
inline constexpr const char* kTags[] = {"uA", "uB"};

/// Makes programs.
class Generator {
  public:
    explicit Generator(Choices choices) : choices_(choices) {}

    Program program() {
        Program made;
        made.usesTime = choices_.below(2) == 1;
        mayHaveOnce_ = !made.usesTime;  // Once cannot read the time, nor what changes with it
        const std::size_t known = choices_.below(8) == 7 ? 2 : 3;
        for (std::size_t i = 0; i < known; ++i) {
            Statement first{Kind::let, kVariables[i], {}};
            first.sum.constant = static_cast<int>(choices_.below(9));
            made.statements.push_back(first);
        }
        while (!choices_.isEmpty() && made.statements.size() < 12)
            made.statements.push_back(statement(0, true));
        return made;
    }

  private:
    std::string anyName() {
        const std::size_t which = choices_.below(6);
        return which < 3 ? kVariables[which] : which < 5 ? kLocals[which - 3] : "i";
    }
    Sum sum() {
        Sum made;
        made.constant = static_cast<int>(choices_.below(8));
        for (std::size_t i = choices_.below(3); i > 0; --i) {
            const std::size_t which = choices_.below(8);  // names that may be unknown are rarer
            made.names.push_back(which < 6 ? kVariables[which % 3] : anyName());
        }
        return made;
    }
    std::vector<Statement> body(int depth) {
        std::vector<Statement> all;
        for (std::size_t i = choices_.below(4); i > 0; --i) all.push_back(statement(depth + 1, false));
        return all;
    }

    Statement statement(int depth, bool isTop) {
        Statement made;
        made.sum = sum();
        const std::size_t most = depth > 4 ? 6 : 16;
        switch (choices_.below(most)) {
            case 0:
            case 1:
                made.kind = Kind::let;
                made.name = kVariables[choices_.below(3)];
                break;
            case 2:
                made.kind = isInPass_ || isInBlock_ ? Kind::let : Kind::set;
                made.name = made.kind == Kind::set ? kTags[choices_.below(2)] : kVariables[0];
                break;
            case 3:
                made.kind = isInBlock_ ? Kind::let : Kind::expect;
                made.name = kVariables[1];
                break;
            case 4:
                made.kind = Kind::array;
                made.name = "list";
                made.count = 1 + static_cast<int>(choices_.below(3));
                break;
            case 5:
                return show(made);
            case 6:
            case 7:
                made.kind = Kind::repeat;
                made.name = anyName();
                made.count = static_cast<int>(choices_.below(4));
                made.body = body(depth);
                break;
            case 8:
                made.kind = Kind::values;
                made.name = anyName();
                made.arguments = {{"", sum()}, {"", sum()}};
                made.body = body(depth);
                break;
            case 9:
                made.kind = Kind::scope;
                made.body = body(depth);
                break;
            case 10:
                made.kind = Kind::when;
                made.count = static_cast<int>(choices_.below(8));
                made.body = body(depth);
                made.other = body(depth);
                break;
            case 11:
            case 12:
            case 13:
                return drawOrGroup(depth, std::move(made));
            case 14:
                if (isInPass_ || isInBlock_ || isInGroup_) return show(made);
                made.kind = Kind::pass;
                isInPass_ = true;
                made.body = body(depth);
                isInPass_ = false;
                break;
            default:
                if (!isTop || !mayHaveOnce_) return show(made);
                made.kind = Kind::once;
                isInBlock_ = isInPass_ = true;
                made.body = body(depth);
                isInBlock_ = isInPass_ = false;
                break;
        }
        return made;
    }

    static Statement show(Statement made) {
        made.kind = Kind::show;
        return made;
    }

    /// Draws an earlier group, or declares one where it stands.
    Statement drawOrGroup(int depth, Statement made) {
        if (!isInGroup_ && !isInPass_ && (groups_.empty() || choices_.below(2) == 0)) {
            made.kind = Kind::group;
            made.name = "g" + std::to_string(number_++);
            for (std::size_t i = choices_.below(3); i > 0; --i) {
                const std::string name = anyName();
                if (made.arguments.empty() || made.arguments.front().first != name)
                    made.arguments.emplace_back(name, sum());
            }
            isInGroup_ = true;
            made.body = body(depth);
            isInGroup_ = false;
            // Only groups that stand at the top are drawn from anywhere.
            if (depth == 0) groups_.push_back(made);
            Statement all{Kind::scope, "", {}};
            Statement call = drawOf(made);
            if (depth == 0) return made;
            all.body = {std::move(made), std::move(call)};
            return all;
        }
        if (groups_.empty()) return show(made);
        return drawOf(groups_[choices_.below(groups_.size())]);
    }

    Statement drawOf(const Statement& group) {
        Statement made{Kind::draw, group.name, {}};
        for (const auto& [name, usual] : group.arguments)
            if (choices_.below(2) == 0) {
                made.arguments.emplace_back(name, sum());
                made.areVectors.push_back(choices_.below(4) == 0);
            }
        return made;
    }

    Choices choices_;
    std::vector<Statement> groups_;
    int number_ = 0;
    bool isInPass_ = false, isInBlock_ = false, isInGroup_ = false, mayHaveOnce_ = false;
};

/// The program as a scene.
class Writer {
  public:
    std::string write(const Program& program) {
        time_ = program.usesTime ? " + 16*time" : "";
        text_ =
            "Camera at[4] LookAt (i) 0 5  (i) 0 0  0 1 0  Ortho -1 1 -1 1 1 10\n"
            "Texture2D picture 8 8 rgba8\n";
        statements(program.statements);
        return text_;
    }

  private:
    void line(const std::string& text) { text_ += text + "\n"; }
    void block(const std::string& begin, const std::vector<Statement>& body, const std::string& end) {
        line(begin);
        statements(body);
        line(end);
    }
    void statements(const std::vector<Statement>& all) {
        for (const Statement& each : all) statement(each);
    }
    void statement(const Statement& s) {
        switch (s.kind) {
            case Kind::let:
                return line("Let " + s.name + " (" + s.sum.text() + ")");
            case Kind::array:
                line("Let " + s.name + "[" + std::to_string(s.count) + "] (i + " + s.sum.text() + ")");
                return line("QuadXY (" + s.name + "[" + std::to_string(s.count - 1) + "]) 1");
            case Kind::show:
                return line("QuadXY (" + s.sum.text() + ") 1");
            case Kind::set:
                return line("Set " + s.name + " (" + s.sum.text() + ")");
            case Kind::expect:
                return line("Expect (" + s.sum.text() + " == 99)");
            case Kind::repeat:
                return block("Repeat " + std::to_string(s.count) + " as " + s.name, s.body, "EndRepeat");
            case Kind::values:
                return block("Repeat [(" + s.arguments[0].second.text() + ") (" +
                                 s.arguments[1].second.text() + ")] as " + s.name,
                             s.body, "EndRepeat");
            case Kind::scope:
                return block("Group", s.body, "EndGroup");
            case Kind::when:
                line("When (" + s.sum.text() + time_ + " < " + std::to_string(s.count) + ")");
                statements(s.body);
                return block("Else", s.other, "EndWhen");
            case Kind::group: {
                std::string head = "Group " + s.name;
                for (const auto& [name, usual] : s.arguments) head += " " + name + " (" + usual.text() + ")";
                return block(head, s.body, "EndGroup");
            }
            case Kind::draw: {
                std::string head = "Draw " + s.name;
                for (std::size_t i = 0; i < s.arguments.size(); ++i) {
                    const std::string value = s.arguments[i].second.text();
                    head += " " + s.arguments[i].first +
                            (s.areVectors[i] ? " (vec2(" + value + ", 1))" : " (" + value + ")");
                }
                return line(head);
            }
            case Kind::pass:
                return block("Pass window from at[" + s.sum.text(4) + "] keep", s.body, "EndPass");
            case Kind::once:
                line("Once");
                block("Pass picture", s.body, "EndPass");
                return line("EndOnce");
        }
    }
    std::string text_, time_;
};

}  // namespace glibra::fuzz

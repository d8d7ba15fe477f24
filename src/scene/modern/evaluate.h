#pragma once
// Private to this room: the values of the arguments of modern statements.

#include <compare>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "expression/expression.h"
#include "glib/script.h"
#include "scene/modern/conditions.h"
#include "scene/modern/environment.h"

namespace glibra::scene {

struct Interpreter;

/// An expression of a script is known by the place where it is written, whatever copies there are of its
/// value.
struct WrittenAt {
    const glib::Script* script = nullptr;
    int line = 0, column = 0;
    glib::Value::Kind kind = glib::Value::Kind::expression;
    friend auto operator<=>(const WrittenAt&, const WrittenAt&) = default;
};
WrittenAt writtenAt(const Interpreter&, const glib::Value& value);

/// An expression that has been read.
struct ReadExpression {
    std::optional<expression::Expression> expression;  ///< nothing if it is wrong, which has been reported
    bool isProblemReported = false;                    ///< a problem of its evaluation
    bool readsShape = false;  ///< it reads a camera's projection, which depends on the target
};

/// The expressions of a script, each read once for each meaning of its names.
using ExpressionCache = std::map<WrittenAt, MadeOfNames<ReadExpression>>;

/// Evaluates an expression where it stands. Nothing with the problem reported, once for each expression.
std::optional<expression::Value> evaluate(Interpreter&, const glib::Value& value,
                                          const expression::Wanted& wanted = {});

/// Remembers that a Once block, or whoever collects it, reads the value of a name at that place. Reports
/// memory-E11 for a variable that changes with time and that Once reads.
void noteRead(Interpreter&, std::string_view name, Environment::Slot slot, const Place& place);

/// Remembers what the scene, or the block that is open, depends on.
void addDepends(Interpreter&, expression::Depends depends);

/// Collects what the evaluations during its life depend on. At its end the scene or block depends on it too.
class DependsOnly {
  public:
    explicit DependsOnly(Interpreter& in);
    DependsOnly(const DependsOnly&) = delete;
    DependsOnly& operator=(const DependsOnly&) = delete;
    ~DependsOnly() { all_ = all_ | before_; }
    [[nodiscard]] expression::Depends depends() const { return all_; }

  private:
    expression::Depends& all_;
    expression::Depends before_;
};

/// The names that a condition reads, with their values where it stands; null with the reason reported if it
/// is wrong. The scene depends on what the condition reads.
std::shared_ptr<const ConditionNames> namesOfCondition(Interpreter&, const glib::Value& value,
                                                       const expression::Wanted& wanted);

/// One number; an expression must be a number.
std::optional<double> numberOf(Interpreter&, const glib::Value& value);
/// A condition: `true`, a number other than 0, or an expression that is a boolean or a number.
std::optional<bool> truthOf(Interpreter&, const glib::Value& value);

/// The index of a word among `words`: a word as written, or an expression whose value is one of them.
std::optional<std::size_t> wordOf(Interpreter&, const glib::Value& value,
                                  std::span<const std::string_view> words);
/// A number from `least` to `most`, cut toward zero if it is an integer. Nothing with glib-E26 reported:
/// "Step: the rate 0 is not between 1e-06 and 1,000,000".
std::optional<double> numberIn(Interpreter&, const glib::Value& value, std::string_view what, double least,
                               double most);
std::optional<int> integerIn(Interpreter&, const glib::Value& value, std::string_view what, int least,
                             int most);

/// The numbers of several values in order. A vector or matrix gives as many as it has components. Nothing if
/// an expression has no value. The values must not be words or texts.
std::optional<std::vector<double>> numbersOf(Interpreter&, std::span<const glib::Value> values);

/// The same for exactly `count` numbers. Reports glib-E26 for fewer or more.
std::optional<std::vector<double>> numbersOf(Interpreter&, std::span<const glib::Value> values,
                                             std::size_t count, std::string_view what);

}  // namespace glibra::scene

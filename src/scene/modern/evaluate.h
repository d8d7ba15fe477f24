#pragma once
// Private to this room: the values of the arguments of modern statements.

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "expression/expression.h"
#include "glib/value.h"
#include "scene/modern/environment.h"

namespace glibra::scene {

struct Interpreter;

/// The expressions of a script, each read once for the lengths that arrays have (Environment::lengths).
struct ExpressionCache {
    struct Entry {
        std::optional<expression::Expression>
            expression;                  ///< nothing if it is wrong, which has been reported
        bool isProblemReported = false;  ///< a problem of its evaluation
        bool readsShape = false;         ///< it reads a camera's projection, which depends on the target
    };
    std::map<std::pair<const glib::Value*, std::size_t>, Entry> entries;
};

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

/// True if the text of an expression is right; otherwise the reason is reported. Its value is not asked for.
bool isReadable(Interpreter&, const glib::Value& value, const expression::Wanted& wanted);

/// The names of buffers that an expression reads, each once; empty if it is wrong.
std::vector<std::string> buffersRead(Interpreter&, const glib::Value& value,
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

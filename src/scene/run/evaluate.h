#pragma once
// Private to this room: the values of the arguments of modern statements.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/expression.h"
#include "expression/known_names.h"
#include "glib/parse/arguments.h"
#include "glib/script.h"
#include "scene/objects.h"
#include "scene/run/state.h"

namespace glibra::scene {

// ---- What a scene, or a Once or Step block, depends on.

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

WrittenAt writtenAt(const Interpreter&, const Value& value);

/// Evaluates an expression where it stands. Nothing with the problem reported, once for each expression.
std::optional<expression::Value> evaluate(Interpreter&, const Value& value,
                                          const expression::Wanted& wanted = {});

/// True if an expression reads what a faulty statement would have declared.
bool readsLostName(const Interpreter&, std::string_view text);
/// For an expression with an unknown name, which `notes` has: "; line 9 sets it, which is below", if a Let
/// below sets it. Otherwise empty.
std::string whereSet(const Interpreter&, const Value& value, std::span<const NotedNames::Note> notes);

/// Gives the names that an expression reads their values where it stands, and notes what they depend on.
/// False with the reason reported if the expression is wrong.
bool supplyNames(Interpreter&, const Value& value, const expression::Wanted& wanted);
/// The same for an expression that cannot be read yet, and these names, some of which it may not have.
bool supplyNames(Interpreter&, const Value& value, std::span<const std::string> paths);

/// One number; an expression must be a number.
std::optional<double> numberOf(Interpreter&, const Value& value);
/// A condition: `true`, a number other than 0, or an expression that is a boolean or a number.
std::optional<bool> truthOf(Interpreter&, const Value& value);

/// The index of a word among `words`: a word as written, or an expression whose value is one of them.
std::optional<std::size_t> wordOf(Interpreter&, const Value& value, std::span<const std::string_view> words);
/// A number from `least` to `most`. Nothing with glib-E05 reported: "Step: the rate 0 is not between 1e-06
/// and 1,000,000".
std::optional<double> numberIn(Interpreter&, const Value& value, std::string_view what, double least,
                               double most);

/// Numbers that count something: base::wholeNumber(). A fraction is cut, and glib-W27 reported, unless the
/// value follows time, window or mouse.
std::optional<std::vector<double>> wholesOf(Interpreter&, std::span<const Value> values);
std::optional<std::vector<double>> wholesOf(Interpreter&, std::span<const Value> values, std::size_t count,
                                            std::string_view what);
std::optional<double> wholeOf(Interpreter&, const Value& value);
/// The same from `least` to `most`, as numberIn().
std::optional<double> wholeIn(Interpreter&, const Value& value, std::string_view what, double least,
                              double most);
std::optional<int> integerIn(Interpreter&, const Value& value, std::string_view what, int least, int most);

/// The numbers of several values in order. A vector or matrix gives as many as it has components. Nothing if
/// an expression has no value. The values must not be words or texts.
std::optional<std::vector<double>> numbersOf(Interpreter&, std::span<const Value> values);

/// The same for numbers that are kept as 32-bit floats. Nothing, with glib-E31, if one is too large.
std::optional<std::vector<double>> floatsOf(Interpreter&, std::span<const Value> values);
/// False with glib-E31 reported if 32-bit floats do not hold the numbers of a value.
bool fitFloats(Interpreter&, const Value& value, std::span<const double> numbers);

/// The same with the place of each number.
std::optional<std::vector<glib::EvaluatedNumber>> evaluatedNumbers(Interpreter&,
                                                                   std::span<const Value> values);
/// Fills the numbers of a classic command by its row. False with the reason reported.
bool fillNumbers(Interpreter&, const glib::StatementRow& row, std::span<const glib::EvaluatedNumber> numbers,
                 Command& command);

/// What numbersOf() gives, if these are `count` numbers. Reports glib-E26 for fewer or more.
std::optional<std::vector<double>> numbersOf(Interpreter&, std::span<const Value> values, std::size_t count,
                                             std::string_view what);
std::optional<std::vector<double>> floatsOf(Interpreter&, std::span<const Value> values, std::size_t count,
                                            std::string_view what);

/// The value of a parameter or variable: an expression, the name of a variable, or one to four numbers.
/// Nothing with the reason reported.
std::optional<expression::Value> constantOf(Interpreter&, std::span<const Value> values);
/// Elements of a list or array variable.
inline constexpr int kMostVariableElements = 65'536;
/// The numbers of a list, where `[6 of (...)]` counts `i`. Nothing with the reason reported.
std::optional<std::vector<double>> listOf(Interpreter&, const Value& list);
/// What expressions know of a name that counts.
expression::Symbol counterSymbol();
/// The values of `element` for i from 0 to count - 1, one after the other. `owner` is the value that they
/// stand in. Nothing with the reason reported, which is glib-E15 if they are more than `most` numbers.
std::optional<std::vector<double>> elementsOf(Interpreter&, const Value& owner,
                                              std::span<const Value> element, int count, double most);
/// The same for an expression, of which only the first element is computed here. `areWhole`: they become
/// integers, and glib-W27 tells of the first fraction, unless it follows time.
std::optional<BufferValues> elementsLater(Interpreter&, const Value& element, int count, double most,
                                          bool areWhole);
/// glib-W27 for the first fraction that integers cut; nothing without one.
Diagnostics reportFirstCut(std::span<const double> numbers, const Place& place);

}  // namespace glibra::scene

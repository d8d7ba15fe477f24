#pragma once
// Expressions that read what was drawn: Expect (condition) and Print (expression) (language, 12.9).

#include <glibra/result.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expression/expression.h"
#include "scene/nodes.h"

namespace glibra::scene {

/// What a condition may be.
inline constexpr expression::Type kConditionTypes[] = {expression::Type::boolean(),
                                                       expression::Type::number()};

/// What a function of a condition gives.
struct Measured {
    expression::Type type;
    std::vector<double> components;  ///< as many as the type has; empty: there is no value
    std::string why{};               ///< there is no value
};

/// The names that a condition reads, with the values that they have where it stands. The elements of buffers
/// and what functions measure are known when the condition is answered.
class ConditionNames final : public expression::Names, public expression::Values {
  public:
    struct Name {
        std::string path;
        expression::Symbol symbol;
        std::vector<double> components;      ///< of all elements
        std::vector<bool> has{};             ///< by element
        std::string why{};                   ///< a value is missing
        std::optional<BufferView> buffer{};  ///< whose element or count it is
        std::size_t elementSize = 0;         ///< components of its elements; 0: they are structures
        std::optional<Measure> measure{};    ///< it is a call that measures something
        bool isOfScene = false;              ///< as a function of the scene sees it
    };
    void add(Name name);
    void add(std::shared_ptr<const expression::Function> function);
    [[nodiscard]] bool has(std::string_view path, bool isOfScene) const;
    /// The textures and buffers that are read, at any time.
    [[nodiscard]] std::vector<ObjectView> objects() const;
    /// What calls measure.
    [[nodiscard]] std::vector<Measure> measures() const;
    /// Fills in the elements and counts of buffers. `read` returns the numbers of a buffer.
    void readBuffers(const std::function<std::vector<double>(const BufferView& buffer)>& read);
    /// Fills in what calls measure.
    void measure(const std::function<Measured(const Measure& measure)>& value);

    [[nodiscard]] std::optional<expression::Symbol> find(std::string_view path) const override;
    [[nodiscard]] std::optional<expression::Symbol> findInScene(std::string_view path) const override;
    [[nodiscard]] std::shared_ptr<const expression::Function> findFunction(
        std::string_view name) const override;
    [[nodiscard]] std::vector<std::string> known(std::string_view path) const override;
    [[nodiscard]] const double* find(std::uint32_t slot, std::size_t element) const override;
    [[nodiscard]] std::string whyMissing(std::uint32_t slot, std::size_t element) const override;

  private:
    std::vector<Name> names_;  ///< by slot
    std::vector<std::shared_ptr<const expression::Function>> functions_;
};

/// The value of an expression, also as text, "true" or "[1 0 2]", and what was found: "5 == 7" if it compares
/// two values, otherwise that text.
struct Answer {
    expression::Value value;
    std::string text, found;
};

/// Evaluates the expression with these names. `file`: that it stands in. Reports why it has no value.
Result<Answer> answerTo(const glib::Value& expression, const ConditionNames& names, const std::string& file,
                        const expression::Wanted& wanted = {});

/// glib-W43: a Repeat has run all its rounds, and its condition, which was found to be that, does not hold.
Diagnostic notReached(const Check& condition, std::size_t rounds, const std::string& found);

}  // namespace glibra::scene

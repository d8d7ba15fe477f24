#pragma once
// The conditions of checks: Expect (condition) (language, 12.9).

#include <glibra/result.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expression/known_names.h"

namespace glibra::scene {

struct Check;

/// The names that a condition reads, with the values that they have where it stands. The elements of buffers
/// are known when the condition is answered.
class ConditionNames final : public expression::Names, public expression::Values {
  public:
    struct Name {
        std::string path;
        expression::Symbol symbol;
        std::vector<double> components;  ///< of all elements
        std::vector<bool> has{};         ///< by element
        std::string why{};               ///< a value is missing
        std::string buffer{};            ///< of an element or of the count: the name of the buffer
        std::size_t elementSize = 0;     ///< components of its elements; 0: they are structures
        bool isOfScene = false;          ///< as a function of the scene sees it
    };
    void add(Name name);
    void add(std::shared_ptr<const expression::Function> function);
    /// The names of the buffers that are read, each once.
    [[nodiscard]] std::vector<std::string> buffers() const;
    /// Fills in the elements and counts of buffers. `read` returns the numbers of a buffer.
    void readBuffers(const std::function<std::vector<double>(const std::string& buffer)>& read);

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

/// Whether a condition is true, and what it was found to be: "5 == 7" if it compares two values, otherwise
/// "true" or "false".
struct ConditionAnswer {
    bool holds = false;
    std::string found;
};

/// Evaluates the condition of a check. `read` returns the numbers of a buffer. Reports why the condition has
/// no value.
Result<ConditionAnswer> answerCondition(
    const Check& check, const std::function<std::vector<double>(const std::string& buffer)>& read);

/// glib-W43: a Repeat has run all its rounds, and its condition, which was found to be that, does not hold.
Diagnostic notReached(const Check& condition, std::size_t rounds, const std::string& found);

}  // namespace glibra::scene

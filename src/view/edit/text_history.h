#pragma once
// Undo and redo of what is typed into a text.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::view {

class TextHistory {
  public:
    /// The text as it is at first.
    explicit TextHistory(std::string text) : present_(std::move(text)) {}

    /// The text is this one now, by whatever has changed it. What follows on the change before, as the
    /// letters of a word do, belongs to the same step.
    void record(std::string_view text);
    /// The next change begins a step of its own.
    void endStep() { mayJoin_ = false; }

    [[nodiscard]] bool canUndo() const { return at_ > 0; }
    [[nodiscard]] bool canRedo() const { return at_ < steps_.size(); }
    /// A text, and where its cursor belongs, in bytes: behind what has changed.
    struct State {
        std::string text;
        std::size_t cursor = 0;
    };
    /// The text before the last step that is not undone, or after the first that is; the present one if there
    /// is none.
    State undo();
    State redo();

    static constexpr std::size_t kMostSteps = 2000;

  private:
    /// `removed` stood where `added` stands.
    struct Step {
        std::size_t begin = 0;
        std::string removed, added;
    };
    bool join(const Step& step);

    std::string present_;
    std::vector<Step> steps_;
    std::size_t at_ = 0;  ///< the steps before it are done, the others undone
    bool mayJoin_ = false;
};

}  // namespace glibra::view

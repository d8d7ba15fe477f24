#pragma once
// Undo and redo of edits of a text.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::view {

class TextHistory {
  public:
    /// Starts with the initial text.
    explicit TextHistory(std::string text) : present_(std::move(text)) {}

    /// Records the text after a change of any kind. A change that continues the last one, as the letters of a
    /// word do, joins its step.
    void record(std::string_view text);
    /// The next change begins a new step.
    void endStep() { mayJoin_ = false; }

    [[nodiscard]] bool canUndo() const { return at_ > 0; }
    [[nodiscard]] bool canRedo() const { return at_ < steps_.size(); }
    /// A text, and the byte offset of the cursor: after the change.
    struct State {
        std::string text;
        std::size_t cursor = 0;
    };
    /// Undoes or redoes one step and returns the text after that. Without such a step it returns the current
    /// text.
    State undo();
    State redo();

    static constexpr std::size_t kMostSteps = 2000;

  private:
    /// `removed` was replaced by `added`, at byte `begin`.
    struct Step {
        std::size_t begin = 0;
        std::string removed, added;
    };
    bool join(const Step& step);

    std::string present_;
    std::vector<Step> steps_;
    std::size_t at_ = 0;  ///< steps before it are done, the others are undone
    bool mayJoin_ = false;
};

}  // namespace glibra::view

#pragma once
// Undo and redo of values and views.

#include <vector>

#include "view/scene/session.h"

namespace glibra::view {

class History {
  public:
    /// Remembers the state as it is, if it differs from the last one remembered. Call it when a change is
    /// complete.
    void record(const Session& session);
    /// False if there is nothing to go back (or forward) to.
    bool undo(Session& session);
    bool redo(Session& session);
    [[nodiscard]] bool canUndo() const { return at_ > 0; }
    [[nodiscard]] bool canRedo() const { return at_ + 1 < states_.size(); }
    void clear();

    static constexpr std::size_t kMost = 500;

  private:
    struct Value {
        scene::ProgramIndex program{};
        std::string tag;
        std::vector<double> values;
        friend bool operator==(const Value&, const Value&) = default;
    };
    struct State {
        std::vector<Value> values;
        ViewState view;
        friend bool operator==(const State&, const State&) = default;
    };
    [[nodiscard]] bool isPresent(const Session& session) const;
    static State stateOf(const Session& session);
    void restore(Session& session) const;

    std::vector<State> states_;
    std::size_t at_ = 0;  ///< the present one
};

}  // namespace glibra::view

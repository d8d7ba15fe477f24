#pragma once
// Undo and redo of values and views.

#include <vector>

#include "view/session/session.h"

namespace glibra::view {

class History {
  public:
    /// Stores the current state if it differs from the last stored one. Call it when a change is complete. A
    /// new state discards the undone ones.
    void record(const Session& session);
    /// Records the current state, then goes back by one. A value that is animated counts as the one from
    /// before its animation, which undo ends. Returns false if there is nothing to undo.
    bool undo(Session& session);
    /// Returns false if there is nothing to redo.
    bool redo(Session& session);
    /// The last change was taken back by other means, and is to be forgotten: nothing happens unless the
    /// session is as before that change.
    void takeBack(const Session& session);
    void clear();

    static constexpr std::size_t kMost = 500;  ///< states; the oldest is dropped

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
    /// True if the stored current state is the session's.
    [[nodiscard]] bool isCurrent(const Session& session) const;
    static State stateOf(const Session& session);
    void restore(Session& session) const;

    std::vector<State> states_;
    std::size_t at_ = 0;  ///< the current one
};

}  // namespace glibra::view

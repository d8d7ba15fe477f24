#pragma once
// The values of a session over time: undo and redo, and what is kept between runs.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "view/session/session.h"

namespace glibra::view {

// Undo and redo of values and views.

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

// Keeps the values of a scene in a file, so that they are there when the scene is opened again: after the
// window was closed, after the program was ended, and after a crash.

// A session as JSON, for programs that watch or test the window.

/// One object: values, transforms, time, picture size, messages and counts.
nlohmann::ordered_json stateOf(const Session& session);

class ValueKeeper {
  public:
    /// `folder`, which must outlive the object, has a file for each scene; empty: nothing is kept.
    explicit ValueKeeper(const std::filesystem::path& folder) : folder_(folder) {}

    /// Gives a session that has just opened its scene the values of the last time, as far as the scene still
    /// says the same about them. Returns true if a value is another one now.
    bool restore(Session& session);
    /// Writes changed values, at most twice a second. `now`: any clock, in seconds. Returns the seconds until
    /// the next call is due; negative: there is nothing to write.
    double keep(const Session& session, double now);
    /// Writes them at once if they have changed.
    void keepNow(const Session& session);
    /// The values of the session's scene are not to come back.
    void forget(const Session& session);

  private:
    [[nodiscard]] bool isSeen(const Session& session) const;
    void see(const Session& session);

    const std::filesystem::path& folder_;
    std::filesystem::path scene_;
    std::vector<std::vector<double>> seen_;  ///< the values when keep() looked last
    double changedAt_ = -1;  ///< the first change that is not written; negative: there is none
};

}  // namespace glibra::view

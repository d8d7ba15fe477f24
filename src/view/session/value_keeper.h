#pragma once
// Keeps the values of a scene in a file, so that they are there when the scene is opened again: after the
// window was closed, after the program was ended, and after a crash.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "view/session/session.h"

namespace glibra::view {

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

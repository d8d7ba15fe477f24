#pragma once
// Which Expect statements of a scene still have to be answered, and at which times (language, 12.9).

#include <set>
#include <vector>

#include "scene/scene.h"

namespace glibra::render {

/// The checks that a scene has at the time of its picture. Each is answered once, at the time that it had
/// then: what its statement says at that time counts, and if it does not run there, what it said here.
class OpenChecks {
  public:
    /// `scene`: as it is at `time`, that of the picture.
    OpenChecks(const scene::Scene& scene, double time);

    /// That of the picture.
    [[nodiscard]] double time() const { return time_; }
    /// The times of pictures to look at, at least one: those of the checks, and those that statements name
    /// which have not run.
    [[nodiscard]] const std::set<double>& times() const { return times_; }
    /// The checks to answer at `moment`, which count as answered from now on. `there` are those of the scene
    /// at that moment; those that ask for it and were not there before are answered too.
    std::vector<scene::Check> take(double moment, const std::vector<scene::Check>& there);

    [[nodiscard]] const std::vector<scene::Check>& all() const { return all_; }
    [[nodiscard]] bool isAnswered() const { return open_.empty(); }
    /// Those that take() has not returned, and those of the kind `error`.
    [[nodiscard]] std::vector<scene::Check> unanswered() const;
    /// The statements that have never run.
    [[nodiscard]] const std::vector<scene::IdleCheck>& idle() const { return idle_; }

  private:
    [[nodiscard]] double timeOf(const scene::Check& check) const { return check.seconds.value_or(time_); }

    double time_;
    std::vector<scene::Check> all_, open_;
    std::vector<scene::IdleCheck> idle_;
    std::set<double> times_;
};

}  // namespace glibra::render

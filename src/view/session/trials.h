#pragma once
// The draws that have another state than the scene says, to try that. They are found again after an edit.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "render/live/live_scene.h"

namespace glibra::view {

class Trials {
  public:
    /// The text of a file of the scene, as it was read last.
    using TextOf = std::function<std::string(const std::filesystem::path&)>;

    [[nodiscard]] bool empty() const { return trials_.empty(); }
    /// By the draws of the scene as it is now. A draw whose line is missing has none, until the line is there
    /// again.
    [[nodiscard]] const render::TriedStates& states() const { return states_; }
    /// The draw gets another state; that of the scene ends the trial.
    void set(const scene::Draw& draw, const base::RasterState& state, const TextOf& textOf);
    /// The scene has been read again.
    void follow(const scene::Scene& scene, const TextOf& textOf);
    void clear() { *this = {}; }

  private:
    struct Trial {
        std::filesystem::path file;
        DrawId then, now;  ///< in texts_, and in the texts as they are; `now` has no line if it is gone
        render::TriedState state;
    };
    void keepTexts(const TextOf& textOf);
    void list();

    std::vector<Trial> trials_;
    render::TriedStates states_;                          ///< of those that are not gone
    std::map<std::filesystem::path, std::string> texts_;  ///< in which all trials stood
};

}  // namespace glibra::view

#pragma once
// `glibra review --serve`: the shots of a run that failed, one by one in a browser, to accept or to reject.
// Accepted pictures become goldens as --update makes them, without being drawn again: what becomes a golden
// is what was seen.

#include <glibra/result.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "suite/golden/hash.h"
#include "suite/results/results.h"
#include "suite/serve/loopback_server.h"
#include "suite/suite.h"

namespace glibra::suite {

struct ReviewOptions {
    std::filesystem::path results;
    std::filesystem::path goldens{};  ///< replaces the folders of the suites, as for `glibra test`
    bool allowOutside = false;
};

/// Shots that failed for one reason, as far as that can be told: the same scene, or the same shaders in other
/// scenes, and the same kind of difference.
struct ReviewGroup {
    std::string cause;               ///< "teapot.glib: differences"
    std::vector<std::size_t> shots;  ///< indices into Review::shots()
};

class Review {
  public:
    /// `suites` are those of the run, as they are now.
    Review(const RunResult& run, std::vector<Suite> suites, ReviewOptions options);

    /// The shots that need a look, in the order of the run.
    [[nodiscard]] const std::vector<ShotResult>& shots() const { return shots_; }
    [[nodiscard]] std::vector<ReviewGroup> groups() const;

    /// Registers the page and what it needs. The object must live as long as the server.
    void serve(LoopbackServer& server);

    /// A picture of a shot as PNG: "got", "expected" or "difference". Remembers that `got` was seen.
    WebReply picture(const WebRequest& request);
    /// {"shots": [3, 5], "force": false, "also": false}: makes their pictures goldens. Replies with what
    /// became of each; a shot whose picture no browser has fetched, or whose file has changed since, is
    /// refused.
    WebReply accept(const WebRequest& request);
    /// {"shots": [3]}: marks them as rejected.
    WebReply reject(const WebRequest& request);
    [[nodiscard]] WebReply data() const;

  private:
    struct Known {
        const Suite* suite = nullptr;
        const Shot* shot = nullptr;
    };
    [[nodiscard]] Known find(const ShotResult& result) const;
    [[nodiscard]] Result<std::vector<std::byte>> read(const std::filesystem::path& file) const;
    [[nodiscard]] std::string whyNot(std::size_t index) const;
    /// Returns why the picture could not be accepted, or nothing.
    std::string acceptOne(std::size_t index, bool force, bool also);

    std::vector<ShotResult> shots_;
    std::vector<Suite> suites_;
    ReviewOptions options_;
    std::map<std::size_t, Hash> seen_;  ///< of the files that were shown
    std::map<std::size_t, std::string> decided_;
};

}  // namespace glibra::suite

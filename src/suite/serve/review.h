#pragma once
// `glibra review --serve`: the shots of a run that failed, one by one in a browser, to accept or to reject.
// Accepted pictures become goldens as --update makes them, without being drawn again: what becomes a golden
// is what was seen.

#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/hash_list.h"
#include "suite/results/results.h"
#include "suite/serve/loopback_server.h"
#include "suite/suite.h"

namespace glibra::suite {

// How two pictures differ, in so few numbers that alike differences of other pictures can be found.

struct DifferenceSign {
    std::array<double, 3> color{};  ///< mean signed difference of the pixels that differ, in 255ths
    double size = 0;                ///< mean absolute difference of the pixels that differ, in 255ths
    double share = 0;               ///< of the pixels that differ
};

/// The sign of the difference of two pictures; nothing if they have different sizes or do not differ.
std::optional<DifferenceSign> differenceSign(const image::Image& expected, const image::Image& got);
/// True if somebody who has judged the one knows what to expect of the other: the colours change in the same
/// direction, and size and share of the change are alike within a factor of two.
bool areAlike(const DifferenceSign& a, const DifferenceSign& b);
/// "12 of 255 darker in 38 % of the pixels".
std::string toText(const DifferenceSign& sign);

struct ReviewOptions {
    std::filesystem::path results;
    std::filesystem::path goldens{};  ///< replaces the folders of the suites, as for `glibra test`
    bool allowOutside = false;
};

/// Shots whose pictures differ from their goldens in a like manner.
struct AlikeShots {
    std::string difference;          ///< "12 of 255 darker in 38 % of the pixels"; or empty
    std::vector<std::size_t> shots;  ///< indices into Review::shots()
};

/// Shots that failed for one reason, as far as that can be told: the same files have changed since their
/// goldens, or else they share files, and the same kind of difference.
struct ReviewGroup {
    std::string cause;               ///< "common.glsl: differences"
    std::vector<std::size_t> shots;  ///< indices into Review::shots()
    std::vector<AlikeShots> alike;   ///< the same shots, the largest part first
};

class Review {
  public:
    /// `suites` are those of the run, as they are now.
    Review(const RunResult& run, std::vector<Suite> suites, ReviewOptions options);

    /// The shots that need a look, in the order of the run.
    [[nodiscard]] const std::vector<ShotResult>& shots() const { return shots_; }
    /// They stay as they are while goldens are accepted.
    [[nodiscard]] const std::vector<ReviewGroup>& groups() const { return groups_; }

    /// Registers the page and what it needs. The object must live as long as the server.
    void serve(LoopbackServer& server);

    /// A picture of a shot as PNG: "got", "expected" or "difference".
    WebReply picture(const WebRequest& request);
    /// {"shots": [3, 5]}: the pictures `got` of these shots have been in view on the page. Those that no
    /// browser has fetched do not count.
    WebReply see(const WebRequest& request);
    /// {"shots": [3, 5], "force": false, "also": false}: makes their pictures goldens, with their lines in
    /// the list of hashes. Replies with what became of each; a shot whose picture has not been in view, or
    /// whose file has changed since, is refused.
    WebReply accept(const WebRequest& request);
    /// {"shots": [3]}: marks them as rejected. What this review has accepted is undone: the golden and its
    /// lines in the list of hashes are those of before. Replies with what became of each; a shot is refused
    /// that an earlier review has accepted, or whose golden has changed since.
    WebReply reject(const WebRequest& request);
    [[nodiscard]] WebReply data() const;

    /// Makes the picture of a shot its golden for somebody who has looked at it elsewhere, such as in the
    /// report of the run. Returns why that is not done, or nothing; never what accept() needs `force` for.
    std::string acceptUnseen(std::size_t index);
    /// True if --accept names the shot by one of the patterns: as for --only, or by SUITE/SHOT.
    [[nodiscard]] bool isNamed(std::size_t index, std::span<const std::string> patterns) const;

    /// "accepted", "rejected" or "": what was decided about the picture of a shot, in this review or in an
    /// earlier one of the same picture (RESULTS/review.json).
    [[nodiscard]] std::string decisionOf(std::size_t index) const;
    /// The warning result-W02 if RESULTS/review.json is there and cannot be read.
    [[nodiscard]] const Diagnostics& problems() const { return problems_; }

  private:
    struct Known {
        const Suite* suite = nullptr;
        const Shot* shot = nullptr;
    };
    [[nodiscard]] Known find(const ShotResult& result) const;
    [[nodiscard]] Result<GoldenStore> storeOf(const Suite& suite) const;
    [[nodiscard]] Result<std::vector<std::byte>> read(const std::filesystem::path& file) const;
    [[nodiscard]] std::string whyNot(std::size_t index) const;
    /// Returns why the picture could not be accepted, or nothing.
    std::string acceptOne(std::size_t index, bool force, bool also);
    /// Returns why the shot could not be rejected, or nothing.
    std::string rejectOne(std::size_t index);
    /// Returns why the golden could not be made what it was before it was accepted, or nothing.
    std::string undo(std::size_t index);
    /// Takes over what an earlier review of the same pictures has decided. Results may come from somebody
    /// else: a picture counts as accepted only if it is one of the goldens.
    void readDecisions();
    /// Remembers a decision, also on the disk. Returns false if it cannot be written there.
    bool decide(std::size_t index, std::string word);
    /// Hash of the picture of a shot, or of why it failed if it has none; empty if it cannot be read.
    [[nodiscard]] std::string contentOf(std::size_t index) const;
    /// True if the picture of a shot is equal to one of its goldens.
    [[nodiscard]] bool isGolden(std::size_t index) const;

    [[nodiscard]] std::vector<ReviewGroup> findGroups() const;
    /// How the picture of a shot differs from its golden; nothing if that is not known.
    [[nodiscard]] std::optional<DifferenceSign> signOf(std::size_t index) const;
    [[nodiscard]] std::vector<AlikeShots> alikeOf(const std::vector<std::size_t>& shots) const;

    std::vector<ShotResult> shots_;
    std::vector<ReviewGroup> groups_;
    std::vector<Suite> suites_;
    ReviewOptions options_;
    std::map<std::size_t, Hash> fetched_, seen_;  ///< of the files that browsers have, and that were in view
    struct Decision {
        std::string word, content;
    };
    std::map<std::size_t, Decision> decided_;
    Diagnostics problems_;
    /// What a golden was before this review replaced it.
    struct Before {
        std::string variant;
        std::optional<std::vector<std::byte>> golden;  ///< its file; nothing: there was none
        std::vector<AcceptedHash> lines;               ///< of the list of hashes
        Hash accepted;                                 ///< of the file that took its place
    };
    std::map<std::size_t, Before> before_;
};

/// What a review has decided, in the folder of the results.
inline constexpr const char* kReviewFile = "review.json";

}  // namespace glibra::suite

#include "budget/least_counts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/primitives.h"

namespace glibra::budget {
namespace {

constexpr int kMostCount = geometry::kMostSubdivisions;

class Search {
  public:
    explicit Search(const CountsRequest& request) : request_(request) {
        const auto counts = request.model->usedCounts();
        for (std::size_t i = 0; i < counts.size(); ++i)
            if (request.isFree[i])
                free_.push_back({counts[i].index, std::max(counts[i].least, request.least[i])});
    }

    [[nodiscard]] std::vector<double> find() {
        if (free_.empty()) return request_.numbers;
        if (const auto found = within(request_.allowed)) return *found;
        if (free_.size() == request_.model->countsUsed) return nearest();
        // A stated count is too small. The others are chosen as if it were free.
        CountsRequest all = request_;
        all.isFree.fill(true);
        const std::vector<double> wanted = Search(all).find();
        std::vector<double> numbers = request_.numbers;
        for (const Free& each : free_) numbers[each.index] = wanted[each.index];
        return numbers;
    }

  private:
    struct Free {
        std::size_t index;
        int least;
    };

    [[nodiscard]] double deviation(const std::vector<double>& numbers) const {
        return request_.model->deviation(numbers, request_.fidelity);
    }
    [[nodiscard]] std::uint64_t vertices(const std::vector<double>& numbers) const {
        return scene::countsOf({request_.model->command, numbers, {}, nullptr})
            .value_or(geometry::Counts{})
            .vertices;
    }
    /// Sets one count to the smallest that keeps the bound together with the others. Returns false if there
    /// is none.
    bool lower(std::vector<double>& numbers, const Free& count, double allowed) const {
        double& number = numbers[count.index];
        const auto keeps = [&](int n) {
            number = n;
            return deviation(numbers) <= allowed;
        };
        if (keeps(count.least)) return true;
        int tooFew = count.least, enough = kMostCount;
        // Most counts are small, so the search begins there.
        while (tooFew < kMostCount) {
            const int next = std::min(2 * tooFew, kMostCount);
            if (keeps(next)) {
                enough = next;
                break;
            }
            if (next == kMostCount) return false;
            tooFew = next;
        }
        while (enough - tooFew > 1) {
            const int middle = tooFew + (enough - tooFew) / 2;
            (keeps(middle) ? enough : tooFew) = middle;
        }
        number = enough;
        return true;
    }

    [[nodiscard]] std::optional<std::vector<double>> within(double allowed) const {
        std::vector<double> numbers = request_.numbers;
        if (free_.size() == 1) {
            if (!lower(numbers, free_[0], allowed) || vertices(numbers) > kMostBudgetVertices)
                return std::nullopt;
            return numbers;
        }
        // The first count is smallest if the second is as large as possible.
        numbers[free_[1].index] = kMostCount;
        if (!lower(numbers, free_[0], allowed)) return std::nullopt;
        std::optional<std::vector<double>> best;
        std::uint64_t fewest = kMostBudgetVertices + 1;
        for (int first = static_cast<int>(numbers[free_[0].index]); first <= kMostCount; ++first) {
            numbers[free_[0].index] = first;
            numbers[free_[1].index] = free_[1].least;
            if (vertices(numbers) >= fewest) break;
            if (!lower(numbers, free_[1], allowed)) continue;
            if (const std::uint64_t all = vertices(numbers); all < fewest) {
                fewest = all;
                best = numbers;
            }
        }
        return best;
    }

    /// Finds the smallest bound that can be kept, to a thousandth.
    [[nodiscard]] std::vector<double> nearest() const {
        double kept = deviation(request_.numbers), tooSmall = request_.allowed;
        std::optional<std::vector<double>> best = within(kept);
        if (!best) return request_.numbers;
        while (kept > 1.001 * tooSmall && kept > 0) {
            // Bounds differ by powers of ten, so the geometric middle is used.
            const double middle = tooSmall > 0 ? std::sqrt(kept * tooSmall) : kept / 1000;
            if (auto found = within(middle)) {
                kept = middle;
                best = std::move(found);
            } else {
                tooSmall = middle;
            }
        }
        return *best;
    }

    const CountsRequest& request_;
    std::vector<Free> free_;
};

}  // namespace

std::vector<double> leastCounts(const CountsRequest& request) {
    return Search(request).find();
}

}  // namespace glibra::budget

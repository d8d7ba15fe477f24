#include "bench/subjects/transforms.h"

#include <algorithm>
#include <string>
#include <utility>

#include "bench/subjects/subjects.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureTransforms(Bench& bench) {
    Diagnostics problems;
    std::vector<Figure> figures{placementFigure(bench, true, problems),
                                placementFigure(bench, false, problems), chainFigure(bench, problems),
                                normalMatrixFigure(bench, problems)};
    // Each figure asks for the driver; one message is enough.
    const auto isKnown = [&, seen = std::vector<std::string>()](const Diagnostic& each) mutable {
        if (std::ranges::find(seen, each.text) != seen.end()) return true;
        seen.push_back(each.text);
        return false;
    };
    std::erase_if(problems, isKnown);
    return {std::move(figures), std::move(problems)};
}

}  // namespace glibra::bench

#pragma once
// What a subject of `glibra bench` is. The table of all subjects is in bench/subjects/subjects.h.

#include <glibra/result.h>

#include <initializer_list>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

struct Subject {
    std::string_view name;   ///< name on the command line: "primitives"
    std::string_view title;  ///< "Primitives: slices and stacks against the analytic surface"
    /// The figures in the order of the report. Errors: no driver, or a missing file of the library.
    Result<std::vector<Figure>> (*measure)(Bench& bench);
};

/// The figures that functions make of the same arguments, or the errors of the first function that fails.
template <class... Arguments>
Result<std::vector<Figure>> measureEach(std::initializer_list<Result<Figure> (*)(Arguments...)> measures,
                                        std::type_identity_t<Arguments>... arguments) {
    std::vector<Figure> figures;
    for (const auto measure : measures) {
        Result<Figure> figure = measure(arguments...);
        if (!figure) return std::move(figure.diagnostics);
        figures.push_back(std::move(*figure));
    }
    return figures;
}

}  // namespace glibra::bench

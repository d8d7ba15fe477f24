#pragma once
// A figure as a log-log diagram in SVG, for a page with the styles of page/bench.css.

#include <string>
#include <string_view>

#include "bench/core/measurement.h"

namespace glibra::bench {

enum class Abscissa { setting, time };

/// Error over setting or over median time. Points without an error (or without a time) are left out; an error
/// of 0 lies on the lower edge. Points on the front are filled; a front is a broken line against the cost it
/// is a front of. The spread of a time is a bar. A theory is a dotted line without signs. Each point carries
/// its values as data-tip. Empty if there is nothing to draw.
std::string plot(const Figure& figure, Abscissa abscissa);

/// The sign of curve `index` as a small picture for a legend.
std::string legendSign(const Figure& figure, std::size_t index);

/// & < > " ' escaped, for content and attributes.
std::string escapeHtml(std::string_view text);

}  // namespace glibra::bench

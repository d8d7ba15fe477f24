#pragma once
// A figure as a log-log diagram in SVG, for a page that has the styles of page/bench.css.

#include <string>
#include <string_view>

#include "bench/core/measurement.h"

namespace glibra::bench {

enum class Abscissa { setting, time };

/// Plots the error over the setting or over the median time. Points without an error (or without a time) are
/// left out; an error of 0 is on the lower edge. Points on the front are filled, and a step line joins them
/// in the diagram of their cost. A bar shows the spread of a time. A theory is a dotted line without symbols.
/// Each point carries its values as data-tip. Empty if there are no points to plot.
std::string plot(const Figure& figure, Abscissa abscissa);

/// The symbol of curve `index` as a small picture for a legend.
std::string legendSign(const Figure& figure, std::size_t index);

}  // namespace glibra::bench

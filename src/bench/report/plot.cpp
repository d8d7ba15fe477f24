#include "bench/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.h"
#include "bench/core/fit.h"
#include "bench/core/front.h"
#include "bench/report/log_axis.h"

namespace glibra::bench {
namespace {

// In units of the SVG's coordinates.
constexpr double kPlotWidth = 560, kPlotHeight = 380;
constexpr double kLeft = 52, kRight = 14, kTop = 28, kBottom = 54;
constexpr double kSign = 4.2;  ///< half the size of a point's symbol
constexpr std::size_t kStyles = 9;

struct Placed {
    const Point* point = nullptr;
    const Curve* curve = nullptr;
    double x = 0, y = 0, lowX = 0, highX = 0;
};

bool isDrawn(const Point& point, Abscissa abscissa) {
    return std::isfinite(point.error) &&
           (abscissa == Abscissa::setting ? point.setting > 0 : point.time.has_value());
}

double abscissaOf(const Point& point, Abscissa abscissa) {
    return abscissa == Abscissa::setting ? point.setting : point.time->median;
}

/// Circle, square, triangle, diamond, then from the start again.
std::string sign(std::size_t index, double x, double y, std::string_view attributes) {
    const double s = kSign;
    switch (index % 4) {
        case 0:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"{}/>", x, y, s, attributes);
        case 1:
            return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"{}/>",
                               x - .9 * s, y - .9 * s, 1.8 * s, 1.8 * s, attributes);
        case 2:
            return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"{}/>", x, y - 1.2 * s,
                               x + 1.1 * s, y + .8 * s, x - 1.1 * s, y + .8 * s, attributes);
        default:
            return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"{}/>", x,
                               y - 1.3 * s, x + 1.3 * s, y, x, y + 1.3 * s, x - 1.3 * s, y, attributes);
    }
}

std::string tip(const Figure& figure, const Curve& curve, const Point& point) {
    std::string text =
        fmt::format("{}\n{}\n{}: {}{}{}", curve.name, point.label, figure.errorName, numberText(point.error),
                    figure.errorUnit.empty() ? "" : " ", figure.errorUnit);
    if (point.time)
        text += fmt::format("\ntime: {} ({} to {}, {} measurements)", secondsText(point.time->median, true),
                            secondsText(point.time->low, true), secondsText(point.time->high, true),
                            point.time->repeats);
    if (point.memory) text += "\nmemory: " + bytesText(*point.memory);
    if (point.isOnFront) text += "\non the Pareto front";
    return base::escapeXml(text);
}

std::string gridLines(const LogAxis& across, const LogAxis& up, bool hasZero) {
    const double right = kPlotWidth - kRight, floor = kPlotHeight - kBottom;
    std::string svg = "<g class=\"grid\">";
    std::string labels = "<g class=\"ticks\">";
    for (const Tick& tick : across.ticks()) {
        const double x = kLeft + tick.place * (right - kLeft);
        svg += fmt::format("<path d=\"M{0:.1f} {1}V{2}\"/>", x, kTop, floor);
        labels += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>", x, floor + 21,
                              tick.label);
    }
    for (const Tick& tick : up.ticks()) {
        const double y = floor - tick.place * (floor - kTop);
        svg += fmt::format("<path d=\"M{0} {1:.1f}H{2}\"/>", kLeft, y, right);
        labels += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", kLeft - 7, y + 4,
                              tick.label);
    }
    if (hasZero)
        labels += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">0</text>", kLeft - 7, floor + 4);
    return svg +
           fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></g>", kLeft, kTop, right - kLeft,
                       floor - kTop) +
           labels + "</g>";
}

/// The name of the vertical axis is above the axis, where long names have room.
std::string axisNames(const Figure& figure, Abscissa abscissa) {
    const std::string across = abscissa == Abscissa::setting ? figure.settingName : "time in seconds";
    const std::string up = figure.errorUnit.empty()
                               ? figure.errorName
                               : fmt::format("{} ({})", figure.errorName, figure.errorUnit);
    return fmt::format(
        "<g class=\"names\"><text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>"
        "<text x=\"{}\" y=\"{}\">{}</text></g>",
        kLeft + (kPlotWidth - kRight - kLeft) / 2, kPlotHeight - 12, base::escapeXml(across), kLeft,
        kTop - 10, base::escapeXml(up));
}

std::string pathThrough(const std::vector<Placed>& points, std::string_view style) {
    if (points.size() < 2) return {};
    std::string path;
    for (const Placed& each : points)
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", each.x, each.y);
    return fmt::format("<path class=\"{}\" d=\"{}\"/>", style, path);
}

/// A step line: between two points of the front, the cheaper one is the best at its cost.
std::string frontLine(std::vector<Placed> points) {
    std::erase_if(points, [](const Placed& each) { return !each.point->isOnFront; });
    if (points.size() < 2) return {};
    std::ranges::sort(points, {}, &Placed::x);
    std::string path = fmt::format("M{:.1f} {:.1f}", points[0].x, points[0].y);
    for (std::size_t i = 1; i < points.size(); ++i)
        path += fmt::format("H{:.1f}V{:.1f}", points[i].x, points[i].y);
    return fmt::format("<path class=\"front\" d=\"{}\"/>", path);
}

/// A theory has the colour of the curve it belongs to.
std::size_t styleOf(const Figure& figure, std::size_t index) {
    return figure.curves[index].theoryOf.value_or(index) % kStyles;
}

/// Where settings are difficulties, costs hardly differ between them, and a line would zigzag.
bool isJoined(const Figure& figure, Abscissa abscissa) {
    return abscissa == Abscissa::setting || figure.alternatives != Alternatives::setting;
}

std::string curveSvg(const Figure& figure, std::size_t index, const std::vector<Placed>& points,
                     Abscissa abscissa) {
    std::string svg = fmt::format("<g class=\"curve c{}\" data-curve=\"{}\">", styleOf(figure, index), index);
    if (figure.curves[index].theoryOf) return svg + pathThrough(points, "line theory") + "</g>";
    if (isJoined(figure, abscissa)) svg += pathThrough(points, "line");
    for (const Placed& each : points)
        if (each.highX > each.lowX)
            svg += fmt::format("<path class=\"spread\" d=\"M{0:.1f} {2:.1f}H{1:.1f}\"/>", each.lowX,
                               each.highX, each.y);
    for (const Placed& each : points)
        svg += sign(index, each.x, each.y,
                    fmt::format(" class=\"point{}\" tabindex=\"0\" data-tip=\"{}\"",
                                each.point->isOnFront ? " on" : "", tip(figure, *each.curve, *each.point)));
    return svg + "</g>";
}

}  // namespace

std::string plot(const Figure& figure, Abscissa abscissa) {
    std::vector<double> costs, errors;
    for (const Curve& curve : figure.curves)
        for (const Point& point : curve.points) {
            if (!isDrawn(point, abscissa)) continue;
            costs.push_back(abscissaOf(point, abscissa));
            errors.push_back(point.error);
        }
    if (costs.empty()) return {};
    const LogAxis across(costs, 8), up(errors, 9);
    const double right = kPlotWidth - kRight, floor = kPlotHeight - kBottom;
    const auto placeX = [&](double cost) { return kLeft + across.place(cost) * (right - kLeft); };

    const bool hasFront = isTimed(figure) == (abscissa == Abscissa::time);
    std::string curves, fronts;
    std::vector<Placed> all;
    for (std::size_t i = 0; i < figure.curves.size(); ++i) {
        std::vector<Placed> points;
        for (const Point& point : figure.curves[i].points) {
            if (!isDrawn(point, abscissa)) continue;
            Placed placed{&point, &figure.curves[i]};
            placed.x = placed.lowX = placed.highX = placeX(abscissaOf(point, abscissa));
            placed.y = floor - up.place(point.error) * (floor - kTop);
            if (abscissa == Abscissa::time) {
                placed.lowX = placeX(point.time->low);
                placed.highX = placeX(point.time->high);
            }
            points.push_back(placed);
        }
        curves += curveSvg(figure, i, points, abscissa);
        all.insert(all.end(), points.begin(), points.end());
        if (hasFront && figure.alternatives == Alternatives::curve) fronts += frontLine(std::move(points));
    }
    if (hasFront && figure.alternatives == Alternatives::figure) fronts = frontLine(std::move(all));
    return fmt::format("<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} against {}\">",
                       kPlotWidth, kPlotHeight, base::escapeXml(figure.errorName),
                       abscissa == Abscissa::time ? "time" : base::escapeXml(figure.settingName)) +
           gridLines(across, up, std::ranges::find(errors, 0.) != errors.end()) +
           axisNames(figure, abscissa) + fronts + curves + "</svg>";
}

std::string legendSign(const Figure& figure, std::size_t index) {
    const bool isTheory = figure.curves[index].theoryOf.has_value();
    return fmt::format(
        "<svg class=\"sign\" viewBox=\"0 0 26 12\" aria-hidden=\"true\"><g class=\"curve c{}\">"
        "<path class=\"line{}\" d=\"M1 6H25\"/>{}</g></svg>",
        styleOf(figure, index), isTheory ? " theory" : "",
        isTheory ? std::string() : sign(index, 13, 6, " class=\"point on\""));
}

}  // namespace glibra::bench

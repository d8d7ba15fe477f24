#include "bench/report/text_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/core/fit.h"

namespace glibra::bench {
namespace {

std::string describe(const Point& point, const std::string& unit) {
    std::string text = fmt::format("{}: {}", point.label, numberText(point.error));
    if (!unit.empty()) text += " " + unit;
    if (point.time) text += fmt::format(" in {}", secondsText(point.time->median));
    return text;
}

std::string curveLine(const Curve& curve, const Figure& figure, std::size_t width) {
    if (curve.points.empty()) return fmt::format("    {}\n", curve.name);
    const auto front = std::ranges::count_if(curve.points, &Point::isOnFront);
    std::string ends = describe(curve.points.front(), figure.errorUnit);
    if (curve.points.size() > 1) ends += "; " + describe(curve.points.back(), figure.errorUnit);
    return fmt::format("    {:<{}}  {} of {} on the front; {}\n", curve.name, width, front,
                       curve.points.size(), ends);
}

}  // namespace

std::string textReport(const SubjectRun& subject) {
    std::string text = fmt::format("{} ({})\n", subject.title, secondsText(subject.seconds));
    for (const Figure& figure : subject.figures) {
        text += fmt::format("  {}: {}; {} against {}\n", figure.name, figure.title, figure.errorName,
                            figure.settingName);
        std::size_t width = 0;
        for (const Curve& curve : figure.curves) width = std::max(width, curve.name.size());
        for (const Curve& curve : figure.curves) text += curveLine(curve, figure, width);
        for (const std::string& finding : figure.findings) text += fmt::format("    - {}\n", finding);
    }
    return text;
}

std::string machineLine(const Machine& machine) {
    return fmt::format("{}, {} cores, {}; {}", machine.processor, machine.cores, machine.system,
                       machine.driver.empty() ? "no OpenGL driver" : machine.renderer);
}

}  // namespace glibra::bench

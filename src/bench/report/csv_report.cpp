#include "bench/report/csv_report.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text.h"

namespace glibra::bench {
namespace {

using base::csvField;

std::string number(double value) {
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string timing(const std::optional<Timing>& time) {
    return time ? fmt::format("{},{},{},{}", time->median, time->low, time->high, time->repeats) : ",,,";
}

}  // namespace

std::string csvReport(const Report& report) {
    std::string csv =
        "subject,figure,curve,setting,label,error,error_unit,time_median_s,time_low_s,time_high_s,repeats,"
        "memory_bytes,front,gpu_time_s\n";
    for (const SubjectRun& subject : report.subjects)
        for (const Figure& figure : subject.figures)
            for (const Curve& curve : figure.curves)
                for (const Point& point : curve.points)
                    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csvField(subject.name),
                                       csvField(figure.name), csvField(curve.name), number(point.setting),
                                       csvField(point.label), number(point.error), csvField(figure.errorUnit),
                                       timing(point.time), point.memory ? number(*point.memory) : "",
                                       point.isOnFront ? 1 : 0, point.gpuTime ? number(*point.gpuTime) : "");
    return csv;
}

}  // namespace glibra::bench

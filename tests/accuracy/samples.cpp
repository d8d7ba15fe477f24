#include "samples.h"

#include <cmath>
#include <limits>
#include <set>

namespace glibra::bench::test {

Report sampleReport() {
    Report report;
    report.glibra = "9.8.7";
    report.date = "2026-03-01T12:00:00Z";
    report.quick = true;
    report.machine = {"Processor <A> & B", 4, 8e9, "Linux 1 x", "GCC 12", "EGL", "llvmpipe", "4.5"};
    Figure figure;
    figure.name = "position";
    figure.title = "Sphere, \"fine\" <and> coarse";
    figure.settingName = "slices";
    figure.errorName = "distance";
    figure.errorUnit = "radii";
    figure.reference = "closed form";
    figure.findings = {"error falls as slices^-2.00"};
    figure.alternatives = Alternatives::curve;
    Curve timed{"float, \"textbook\" <1>", {timedPoint(8, .1, 1e-3), timedPoint(16, .025, 4e-3)}};
    timed.points[0].memory = 4096;
    Curve plain{"double", {pointAt(8, 0), pointAt(16, std::numeric_limits<double>::quiet_NaN())}};
    plain.points.push_back(pointAt(32, std::numeric_limits<double>::infinity()));
    figure.curves = {timed, plain};
    SubjectRun subject{"primitives", "Primitives: meshes", 1.5, {figure}, {}};
    subject.diagnostics = {diagnose("gpu-E01", "no usable OpenGL driver")};
    report.subjects = {subject};
    return report;
}

void expectSound(const std::vector<Figure>& figures) {
    std::set<std::string> names;
    for (const Figure& figure : figures) {
        EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
        for (const std::string* text :
             {&figure.title, &figure.settingName, &figure.errorName, &figure.reference})
            EXPECT_FALSE(text->empty()) << figure.name;
        EXPECT_FALSE(figure.findings.empty()) << figure.name;
        std::set<std::string> curves;
        for (const Curve& curve : figure.curves) {
            EXPECT_TRUE(curves.insert(curve.name).second) << figure.name << ", " << curve.name;
            EXPECT_FALSE(curve.points.empty()) << figure.name << ", " << curve.name;
            std::set<std::string> labels;
            for (const Point& point : curve.points) {
                EXPECT_TRUE(labels.insert(point.label).second) << curve.name << ", " << point.label;
                EXPECT_GE(point.error, 0) << curve.name << ", " << point.label;
                EXPECT_TRUE(std::isfinite(point.error)) << curve.name << ", " << point.label;
            }
        }
    }
}

}  // namespace glibra::bench::test

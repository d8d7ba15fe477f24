#include "bench/core/computed.h"

namespace glibra::bench {
namespace {

Numbers numbersOf(const ShaderValues& values) {
    Numbers results;
    const int parts = values.shader().has("uHalf") ? 2 : 1;
    for (int part = 0; part < parts; ++part) {
        values.shader().set("uHalf", part);
        const std::vector<Four> found = values.values();
        results.resize(found.size(), glm::dvec4(0));
        for (std::size_t i = 0; i < found.size(); ++i) results[i] += glm::dvec4(found[i]);
    }
    return results;
}

Point pointOf(Bench& bench, const Computation& way, const ComputedCase& given, int inputsPerValue) {
    Point point{given.setting, given.label};
    if (way.onCpu) {
        Numbers results(given.inputs.size() / static_cast<std::size_t>(inputsPerValue), glm::dvec4(0));
        way.onCpu(given, results);
        point.error = given.error(results);
        point.time = bench.time([&] { way.onCpu(given, results); });
        point.memory = way.bytes;
        return point;
    }
    const ShaderValues values(bench, way.glsl, given.inputs, inputsPerValue);
    if (way.uniforms) way.uniforms(values.shader(), given);
    point.error = given.error(numbersOf(values));
    point.time = bench.timeDrawing([&] { values.compute(); });
    point.memory = values.bytes();
    return point;
}

}  // namespace

void addComputed(Figure& figure, Bench& bench, const std::vector<Computation>& ways,
                 const std::vector<ComputedCase>& cases, int inputsPerValue) {
    for (const Computation& way : ways)
        bench.attempt([&] {
            for (const ComputedCase& each : cases)
                figure.add(way.name, pointOf(bench, way, each, inputsPerValue)).isForScenes = way.isForScenes;
        });
}

}  // namespace glibra::bench

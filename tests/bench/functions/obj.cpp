// Reading a model of 70 MB, against tinyobjloader: from text to triangles, and to a mesh that can be drawn.

#include <benchmark/benchmark.h>
#include <tiny_obj_loader.h>

#include <cstdint>
#include <istream>
#include <sstream>
#include <streambuf>
#include <string>

#include "functions/grid_model.h"
#include "geometry/obj/obj_model.h"

namespace {

using namespace glibra;

const std::string& text() {
    static const std::string grid = bench::gridModel(640);
    return grid;
}

/// A stream over a text, without a copy.
class TextBuffer : public std::streambuf {
  public:
    explicit TextBuffer(const std::string& from) {
        char* begin = const_cast<char*>(from.data());  // NOLINT: the interface asks for it and only reads
        setg(begin, begin, begin + from.size());
    }
};

void objToPolygons(benchmark::State& state) {
    const std::string& from = text();
    for (auto _ : state) benchmark::DoNotOptimize(geometry::parseObj(from, "grid.obj"));
    state.SetBytesProcessed(static_cast<std::int64_t>(from.size()) * state.iterations());
}

void objToMesh(benchmark::State& state) {
    const std::string& from = text();
    for (auto _ : state) {
        const auto model = geometry::parseObj(from, "grid.obj");
        benchmark::DoNotOptimize(geometry::obj(*model, false));
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(from.size()) * state.iterations());
}

void tinyobjToPolygons(benchmark::State& state) {
    const std::string& from = text();
    for (auto _ : state) {
        TextBuffer buffer(from);
        std::istream stream(&buffer);
        tinyobj::attrib_t attributes;
        std::vector<tinyobj::shape_t> shapes;
        std::vector<tinyobj::material_t> materials;
        std::string warning, error;
        tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, false);
        benchmark::DoNotOptimize(shapes.data());
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(from.size()) * state.iterations());
}

BENCHMARK(objToPolygons)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(objToMesh)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(tinyobjToPolygons)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

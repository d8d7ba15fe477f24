// Turns one model file into data that can be drawn, in a process of its own, to measure its time and memory.
// Use: load_obj glibra|tinyobjloader FILE.obj   (load_obj grid FILE.obj writes a model of 70 MB)
//
// glibra: file, polygons, mesh with one vertex per distinct triple. tinyobjloader: its own reader with
// triangulation, then one vertex per distinct triple by std::unordered_map, as in its examples.

#include <tiny_obj_loader.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "functions/grid_model.h"
#include "geometry/obj/obj_model.h"
#include "image/file.h"

namespace {

using namespace glibra;

struct Counts {
    std::size_t vertices = 0, indices = 0;
};

Counts byGlibra(const std::string& path) {
    auto bytes = image::readFile(path, {path, {}}, geometry::kLargestModelFile);
    if (!bytes) return {};
    const auto model =
        geometry::parseObj({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path);
    if (!model) return {};
    bytes.value.reset();  // as the program does
    const geometry::Mesh mesh = geometry::obj(*model, false);
    return {mesh.vertexCount(), mesh.indices.size()};
}

struct Triple {
    int position, normal, texCoord;
    bool operator==(const Triple&) const = default;
};
struct HashOfTriple {
    std::size_t operator()(const Triple& each) const {
        std::size_t hash = 0;
        for (const int index : {each.position, each.normal, each.texCoord})
            hash = (hash ^ static_cast<std::size_t>(index)) * 0x9e3779b97f4a7c15U;
        return hash ^ hash >> 32;
    }
};

Counts byTinyobjloader(const std::string& path) {
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(path)) return {};
    const tinyobj::attrib_t& attributes = reader.GetAttrib();
    std::unordered_map<Triple, std::uint32_t, HashOfTriple> known;
    std::vector<std::array<float, 8>> vertices;
    std::vector<std::uint32_t> indices;
    for (const tinyobj::shape_t& shape : reader.GetShapes())
        for (const tinyobj::index_t& each : shape.mesh.indices) {
            const Triple triple{each.vertex_index, each.normal_index, each.texcoord_index};
            const auto [found, isNew] = known.emplace(triple, static_cast<std::uint32_t>(vertices.size()));
            if (isNew) {
                std::array<float, 8> vertex{};
                std::memcpy(vertex.data(),
                            &attributes.vertices[3 * static_cast<std::size_t>(triple.position)],
                            3 * sizeof(float));
                std::memcpy(&vertex[3], &attributes.normals[3 * static_cast<std::size_t>(triple.normal)],
                            3 * sizeof(float));
                std::memcpy(&vertex[6], &attributes.texcoords[2 * static_cast<std::size_t>(triple.texCoord)],
                            2 * sizeof(float));
                vertices.push_back(vertex);
            }
            indices.push_back(found->second);
        }
    return {vertices.size(), indices.size()};
}

}  // namespace

int main(int count, char** arguments) {
    const std::string_view what = count == 3 ? arguments[1] : "";
    if (what == "grid") {
        const std::string text = bench::gridModel(640);
        std::ofstream file(arguments[2], std::ios::binary);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        return file.flush() ? 0 : 1;
    }
    if (what != "glibra" && what != "tinyobjloader") {
        std::fprintf(stderr, "use: load_obj glibra|tinyobjloader|grid FILE.obj\n");
        return 2;
    }
    const Counts made = what == "glibra" ? byGlibra(arguments[2]) : byTinyobjloader(arguments[2]);
    std::printf("%zu vertices, %zu indices\n", made.vertices, made.indices);
    return made.vertices > 0 ? 0 : 1;
}

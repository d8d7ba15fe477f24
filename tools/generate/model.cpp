// Makes the animals in scenes/models/: `model FOLDER [NAME]...`. A body is a sum of blended sticks and
// ellipsoids; its surface is cut into quads by surface nets (S. Gibson 1998): one vertex per cell that
// the surface crosses and one quad per lattice edge that it crosses, so the mesh is closed. The vertices are
// then moved onto the surface.
#include <array>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "distance.h"

namespace generate {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Model {
    const char* name;
    const char* title;
    double (*body)(Vec3 p);
    Vec3 low, high;  // box of the lattice
    double cell;     // spacing of the lattice; main refuses spacings that give a mesh that touches itself
    double scale;    // units of the file per unit of the body
};

// ---- Bodies: x forward, y up, z to the left, symmetric about z = 0
// -----------------------------------------

// Sticks that join end to end at `joints`. There are no fillets between them, so that no joint bulges.
template <std::size_t N>
double limb(Vec3 p, const std::array<Vec3, N>& joints, const std::array<double, N>& radii) {
    double d = 1e9;
    for (std::size_t i = 0; i + 1 < N; ++i)
        d = std::min(d, stick(p, joints[i], joints[i + 1], radii[i], radii[i + 1]));
    return d;
}

// A long-necked dinosaur about 4.9 long.
double dinosaur(Vec3 p) {
    const Vec3 q = {p.x, p.y, std::abs(p.z)};
    double d = ellipsoid(p - Vec3{-0.12, 1.06, 0}, {1.02, 0.50, 0.46});
    const std::array<Vec3, 8> neck = {{{0.35, 1.16, 0},
                                       {0.70, 1.33, 0},
                                       {0.97, 1.55, 0},
                                       {1.17, 1.82, 0},
                                       {1.32, 2.10, 0},
                                       {1.43, 2.38, 0},
                                       {1.55, 2.60, 0},
                                       {1.68, 2.72, 0}}};
    d = blend(d, limb(p, neck, {0.34, 0.27, 0.22, 0.185, 0.16, 0.145, 0.135, 0.13}), 0.3);
    d = blend(d, ellipsoid(turnZ(p - Vec3{1.86, 2.70, 0}, 18), {0.25, 0.125, 0.135}), 0.10);
    d = blend(d, sphere(q - Vec3{1.78, 2.80, 0.085}, 0.052), 0.05);
    const std::array<Vec3, 8> tail = {{{-0.70, 1.08, 0},
                                       {-1.05, 1.00, 0},
                                       {-1.40, 0.86, 0},
                                       {-1.75, 0.70, 0},
                                       {-2.08, 0.56, 0},
                                       {-2.40, 0.47, 0},
                                       {-2.70, 0.46, 0},
                                       {-2.98, 0.53, 0}}};
    d = blend(d, limb(p, tail, {0.34, 0.285, 0.23, 0.18, 0.14, 0.11, 0.088, 0.075}), 0.3);
    const auto leg = [&](double x, double thick) {
        const std::array<Vec3, 3> joints = {{{x, 0.95, 0.27}, {x + 0.02, 0.45, 0.31}, {x, 0.10, 0.31}}};
        double l = limb(q, joints, {thick, thick * 0.74, thick * 0.76});
        l = blend(l, ellipsoid(q - Vec3{x + 0.05, 0.07, 0.31}, {0.20, 0.09, 0.16}), 0.08);
        d = blend(d, l, 0.2);
    };
    leg(0.50, 0.19);
    leg(-0.66, 0.22);
    return std::max(d, -p.y);  // the animal stands on y = 0
}

// A cow about 2.8 long.
double cow(Vec3 p) {
    const Vec3 q = {p.x, p.y, std::abs(p.z)};
    double d = box(p - Vec3{0, 1.15, 0}, {0.82, 0.40, 0.34}, 0.30);
    d = blend(d, ellipsoid(p - Vec3{-0.05, 0.98, 0}, {0.70, 0.38, 0.42}), 0.3);
    d = blend(d, ellipsoid(p - Vec3{-0.68, 1.25, 0}, {0.28, 0.28, 0.33}), 0.3);
    d = blend(d, stick(p, {0.70, 1.25, 0}, {1.08, 1.55, 0}, 0.30, 0.20), 0.25);
    d = blend(d, stick(p, {1.10, 1.60, 0}, {1.48, 1.36, 0}, 0.20, 0.125), 0.10);
    d = blend(d, ellipsoid(turnZ(p - Vec3{1.50, 1.345, 0}, 32), {0.13, 0.13, 0.15}), 0.08);
    d = blend(d, ellipsoid(turnX(turnZ(q - Vec3{1.00, 1.66, 0.27}, 20), 25), {0.085, 0.065, 0.17}), 0.06);
    const std::array<Vec3, 4> horn = {
        {{1.05, 1.70, 0.09}, {1.05, 1.82, 0.20}, {1.07, 1.92, 0.25}, {1.11, 2.03, 0.24}}};
    d = blend(d, limb(q, horn, {0.065, 0.058, 0.05, 0.04}), 0.05);
    const auto leg = [&](double x, double knee, double thick) {
        const std::array<Vec3, 3> joints = {{{x, 1.0, 0.24}, {x + knee, 0.52, 0.24}, {x, 0.12, 0.24}}};
        double l = limb(q, joints, {thick, thick * 0.55, thick * 0.48});
        l = blend(l, stick(q, {x, 0.07, 0.24}, {x + 0.06, 0.05, 0.24}, 0.095, 0.08), 0.06);
        d = blend(d, l, 0.2);
    };
    leg(0.58, 0.04, 0.17);
    leg(-0.66, -0.07, 0.20);
    d = blend(d, ellipsoid(p - Vec3{-0.38, 0.66, 0}, {0.23, 0.14, 0.18}), 0.12);
    d = blend(d, stick(q, {-0.33, 0.60, 0.08}, {-0.33, 0.50, 0.09}, 0.04, 0.035), 0.03);
    const std::array<Vec3, 4> tail = {
        {{-0.92, 1.42, 0}, {-1.08, 1.20, 0}, {-1.13, 0.95, 0}, {-1.14, 0.74, 0}}};
    d = blend(d, limb(p, tail, {0.07, 0.055, 0.048, 0.045}), 0.08);
    d = blend(d, stick(p, {-1.14, 0.74, 0}, {-1.15, 0.55, 0}, 0.075, 0.045), 0.05);
    return std::max(d, -p.y);
}

const Model kModels[] = {{"dinosaur",
                          "a long-necked dinosaur, 4.9 long",
                          dinosaur,
                          {-3.2, -0.1, -0.75},
                          {2.3, 3.0, 0.75},
                          0.072,
                          1},
                         {"cow", "a cow, 2.8 long", cow, {-1.35, -0.1, -0.65}, {1.8, 2.2, 0.65}, 0.066, 1}};

// ---- Surface nets
// ------------------------------------------------------------------------------------------

struct Mesh {
    std::vector<Vec3> points, normals, textures;
    std::vector<std::array<int, 4>> quads;  // point = normal index, from 0
    std::vector<std::array<int, 4>> quadTextures;
};

Vec3 gradient(const Model& m, Vec3 p) {
    const double h = 0.12 * m.cell;
    return {m.body(p + Vec3{h, 0, 0}) - m.body(p - Vec3{h, 0, 0}),
            m.body(p + Vec3{0, h, 0}) - m.body(p - Vec3{0, h, 0}),
            m.body(p + Vec3{0, 0, h}) - m.body(p - Vec3{0, 0, h})};
}

// Moves a point along the gradient to the surface of the body, by at most one cell.
Vec3 ontoSurface(const Model& m, Vec3 p) {
    const Vec3 start = p;
    for (int i = 0; i < 12; ++i) {
        const Vec3 n = unit(gradient(m, p));
        const Vec3 next = p - n * (0.8 * m.body(p));
        if (length(next - start) > 0.6 * m.cell) break;
        p = next;
    }
    return p;
}

class Net {
  public:
    explicit Net(const Model& model) : m(model) {
        nx = steps(m.low.x, m.high.x), ny = steps(m.low.y, m.high.y), nz = steps(m.low.z, m.high.z);
        values.reserve(static_cast<std::size_t>((nx + 1) * (ny + 1) * (nz + 1)));
        for (int k = 0; k <= nz; ++k)
            for (int j = 0; j <= ny; ++j)
                for (int i = 0; i <= nx; ++i) values.push_back(m.body(at(i, j, k)));
    }

    Mesh mesh() {
        Mesh out;
        for (int k = 1; k < nz; ++k)
            for (int j = 1; j < ny; ++j)
                for (int i = 1; i < nx; ++i) {
                    edge(out, {i, j, k}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
                    edge(out, {i, j, k}, {0, 1, 0}, {0, 0, -1}, {-1, 0, 0});
                    edge(out, {i, j, k}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0});
                }
        for (Vec3& p : out.points) p = ontoSurface(m, p);
        for (const Vec3 p : out.points) out.normals.push_back(unit(gradient(m, p)));
        return out;
    }

  private:
    using Index = std::array<int, 3>;

    int steps(double low, double high) const { return static_cast<int>(std::ceil((high - low) / m.cell)); }
    // Half a step off the plane z = 0, so that mirrored halves meet in quads and not in slivers.
    Vec3 at(int i, int j, int k) const {
        return m.low + Vec3{i * m.cell, j * m.cell, 0} + Vec3{0, 0, -m.low.z + (k - nz / 2 - 0.5) * m.cell};
    }
    double value(Index c) const {
        return values[static_cast<std::size_t>((c[2] * (ny + 1) + c[1]) * (nx + 1) + c[0])];
    }

    // The vertex of a cell: the mean of the crossings on its edges.
    int vertex(Mesh& out, Index cell) {
        const auto found = made.find(cell);
        if (found != made.end()) return found->second;
        Vec3 sum;
        int crossings = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 4; ++corner) {
                Index a = cell;
                a[static_cast<std::size_t>((axis + 1) % 3)] += corner & 1;
                a[static_cast<std::size_t>((axis + 2) % 3)] += corner >> 1;
                Index b = a;
                ++b[static_cast<std::size_t>(axis)];
                const double va = value(a), vb = value(b);
                if ((va < 0) == (vb < 0)) continue;
                sum = sum + mix(at(a[0], a[1], a[2]), at(b[0], b[1], b[2]), va / (va - vb));
                ++crossings;
            }
        const int index = static_cast<int>(out.points.size());
        out.points.push_back(sum * (1.0 / crossings));
        made.emplace(cell, index);
        return index;
    }

    // The quad of the four cells around the lattice edge from `c` along `step` = u x v, counter-clockwise
    // from outside.
    void edge(Mesh& out, Index c, Index step, Index u, Index v) {
        const Index end = {c[0] + step[0], c[1] + step[1], c[2] + step[2]};
        const bool inside = value(c) < 0;
        if (inside == (value(end) < 0)) return;
        const auto shifted = [&](bool byU, bool byV) {
            return Index{c[0] + byU * u[0] + byV * v[0], c[1] + byU * u[1] + byV * v[1],
                         c[2] + byU * u[2] + byV * v[2]};
        };
        std::array<int, 4> quad = {vertex(out, shifted(false, false)), vertex(out, shifted(true, false)),
                                   vertex(out, shifted(true, true)), vertex(out, shifted(false, true))};
        if (!inside) std::swap(quad[1], quad[3]);
        out.quads.push_back(quad);
    }

    Model m;
    int nx = 0, ny = 0, nz = 0;
    std::vector<double> values;
    std::map<Index, int> made;
};

// A cylinder around the long axis: s goes around it, t along it. In a quad across the seam s goes slightly
// beyond 1, which the repeat wrap mode continues.
void addTextures(const Model& m, Mesh& mesh) {
    std::map<std::pair<int, bool>, int> made;
    const auto around = [&](int i) {
        const Vec3 p = mesh.points[static_cast<std::size_t>(i)];
        return std::atan2(p.z, 1.0 - p.y) / (2 * kPi) + 0.5;
    };
    for (const auto& quad : mesh.quads) {
        double low = 1, high = 0;
        for (const int i : quad) low = std::min(low, around(i)), high = std::max(high, around(i));
        std::array<int, 4> textures{};
        for (std::size_t c = 0; c < 4; ++c) {
            const bool beyond = high - low > 0.5 && around(quad[c]) < 0.5;
            const auto [place, isNew] =
                made.try_emplace({quad[c], beyond}, static_cast<int>(mesh.textures.size()));
            if (isNew)
                mesh.textures.push_back(
                    {around(quad[c]) + beyond,
                     (mesh.points[static_cast<std::size_t>(quad[c])].x - m.low.x) / (m.high.x - m.low.x), 0});
            textures[c] = place->second;
        }
        mesh.quadTextures.push_back(textures);
    }
}

// True if each edge of each quad is traversed once in the other direction, by exactly one other quad.
bool isClosed(const Mesh& mesh) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& quad : mesh.quads)
        for (std::size_t c = 0; c < 4; ++c) ++uses[{quad[c], quad[(c + 1) % 4]}];
    for (const auto& [edge, count] : uses) {
        const auto twin = uses.find({edge.second, edge.first});
        if (count != 1 || twin == uses.end()) return false;
    }
    return true;
}

bool write(const Model& m, const Mesh& mesh, const std::string& path) {
    std::FILE* out = std::fopen(path.c_str(), "wb");
    if (out == nullptr) return false;
    std::fprintf(out, "# %s: %s, made by tools/generate/model.cpp\n", m.name, m.title);
    for (const Vec3 p : mesh.points)
        std::fprintf(out, "v %.4f %.4f %.4f\n", p.x * m.scale, p.y * m.scale, p.z * m.scale);
    for (const Vec3 t : mesh.textures) std::fprintf(out, "vt %.3f %.3f\n", t.x, t.y);
    for (const Vec3 n : mesh.normals) std::fprintf(out, "vn %.3f %.3f %.3f\n", n.x, n.y, n.z);
    for (std::size_t f = 0; f < mesh.quads.size(); ++f) {
        std::fputs("f", out);
        for (std::size_t c = 0; c < 4; ++c)
            std::fprintf(out, " %d/%d/%d", mesh.quads[f][c] + 1, mesh.quadTextures[f][c] + 1,
                         mesh.quads[f][c] + 1);
        std::fputc('\n', out);
    }
    return std::fclose(out) == 0;
}

}  // namespace
}  // namespace generate

int main(int argc, char** argv) {
    using namespace generate;
    if (argc < 2) {
        std::fputs("usage: model FOLDER [NAME]...\n", stderr);
        return 2;
    }
    for (const Model& m : kModels) {
        bool wanted = argc == 2;
        for (int i = 2; i < argc; ++i) wanted = wanted || std::strcmp(argv[i], m.name) == 0;
        if (!wanted) continue;
        Mesh mesh = Net(m).mesh();
        if (!isClosed(mesh)) {
            std::fprintf(stderr, "%s: the mesh touches itself; choose another lattice spacing\n", m.name);
            return 1;
        }
        addTextures(m, mesh);
        const std::string path = std::string(argv[1]) + "/" + m.name + ".obj";
        if (!write(m, mesh, path)) {
            std::fprintf(stderr, "cannot write %s\n", path.c_str());
            return 1;
        }
        std::printf("%s: %zu points, %zu quads\n", m.name, mesh.points.size(), mesh.quads.size());
    }
    return 0;
}

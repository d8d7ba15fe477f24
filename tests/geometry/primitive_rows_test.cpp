// What holds for the row of every primitive.

#include <algorithm>
#include <set>
#include <string>

#include "geometry/shapes/primitive.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

/// The default numbers with small counts, so that meshes are quickly made. Fixed counts keep their default.
std::vector<double> smallNumbers(const PrimitiveSpec& spec) {
    std::vector<double> numbers = completeNumbers(spec, {});
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (spec.arguments[i].kind == ArgumentKind::count && !spec.arguments[i].isFixed)
            numbers[i] = spec.arguments[i].least + 2 + static_cast<double>(i);
    return numbers;
}

TEST(PrimitiveRows, HaveNamesOfTheirOwnAndASummary) {
    std::set<std::string_view> names;
    for (const PrimitiveSpec* each : primitives()) {
        EXPECT_FALSE(each->names[0].empty());
        EXPECT_FALSE(each->summary.empty()) << each->names[0];
        for (const std::string_view name : each->names)
            if (!name.empty()) {
                EXPECT_TRUE(names.insert(name).second) << name;
            }
    }
}

TEST(PrimitiveRows, PutFixedArgumentsLastAndDefaultsInsideTheirLimits) {
    for (const PrimitiveSpec* each : primitives()) {
        bool isFixed = false;
        for (const ShapeArgument& argument : each->arguments) {
            EXPECT_FALSE(argument.name.empty()) << each->names[0];
            EXPECT_FALSE(isFixed && !argument.isFixed) << each->names[0] << ' ' << argument.name;
            isFixed = argument.isFixed;
            if (argument.kind == ArgumentKind::count || argument.kind == ArgumentKind::seed) {
                EXPECT_GE(argument.byDefault, argument.least) << each->names[0] << ' ' << argument.name;
                EXPECT_LE(argument.byDefault, argument.most) << each->names[0] << ' ' << argument.name;
            }
            if (argument.kind == ArgumentKind::size) {
                EXPECT_GT(argument.byDefault, 0) << each->names[0] << ' ' << argument.name;
            }
        }
    }
}

TEST(PrimitiveRows, MakeTheMeshThatTheyAnnounce) {
    for (const PrimitiveSpec* each : primitives()) {
        SCOPED_TRACE(each->names[0]);
        const std::vector<double> numbers = smallNumbers(*each);
        const Mesh mesh = each->make(numbers);
        EXPECT_EQ(mesh.topology, each->topology);
        EXPECT_EQ(countsOf(mesh), each->counts(numbers));
        EXPECT_EQ(mesh.attribute(kFaceIndex) != nullptr, each->hasFaceIndex);
        expectSound(mesh, each->space != Space::sky);  // its texture coordinates are directions
        if (mesh.topology == Topology::triangles) {
            // At the tip of the spout, four cells per patch are too few to follow the bend.
            const bool isTeapot = each->names[0] == "Teapot";
            EXPECT_EQ(wronglyWound(isTeapot ? each->make(completeNumbers(*each, {})) : mesh), 0U);
            EXPECT_EQ(openEdges(mesh) == 0, each->isClosed);
        }
    }
}

TEST(PrimitiveRows, TangentsAreTheDerivativeOfThePositionByT) {
    for (const PrimitiveSpec* each : primitives()) {
        // The texture coordinates of a sky are directions. Soccerball has the tangents of the sphere. The
        // coordinates of a teapot's patches are skewed; teapot_test.cpp compares its tangents with
        // differences.
        if (each->topology != Topology::triangles || each->space == Space::sky || each->hasFaceIndex ||
            each->names[0] == "Teapot")
            continue;
        std::vector<double> numbers = completeNumbers(*each, {});
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (each->arguments[i].kind == ArgumentKind::count && !each->arguments[i].isFixed)
                numbers[i] = 96;
        const FrameAgreement agreement = frameAgreement(each->make(numbers));
        EXPECT_GT(agreement.t, .97) << each->names[0];
        EXPECT_GT(agreement.s, .97) << each->names[0];
    }
}

TEST(PrimitiveRows, LieInTheirExtent) {
    for (const PrimitiveSpec* each : primitives()) {
        ASSERT_EQ(each->deviation == nullptr, each->extent == nullptr) << each->names[0];
        if (each->extent == nullptr) continue;
        std::vector<double> numbers = smallNumbers(*each);
        const Extent extent = each->extent(numbers);
        if (!std::isfinite(extent.radius)) continue;  // quads: any place
        const Mesh mesh = each->make(numbers);
        const glm::dvec3 centre = (extent.low + extent.high) / 2.0;
        for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
            const glm::dvec3 place = positionAt(mesh, i);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(place[axis], extent.low[axis] - 1e-6) << each->names[0];
                EXPECT_LE(place[axis], extent.high[axis] + 1e-6) << each->names[0];
            }
            EXPECT_LE(glm::distance(place, centre), extent.radius + 1e-6) << each->names[0];
        }
    }
}

TEST(PrimitiveRows, DeviationsDoNotRiseWithAnyCount) {
    for (const PrimitiveSpec* each : primitives()) {
        if (each->deviation == nullptr) continue;
        for (const Fidelity fidelity : {Fidelity::shape, Fidelity::pattern})
            for (std::size_t i = 0; i < each->arguments.size(); ++i) {
                if (each->arguments[i].kind != ArgumentKind::count) continue;
                std::vector<double> numbers = smallNumbers(*each);
                double last = 1e9;
                for (int n = std::max(2, static_cast<int>(each->arguments[i].least)); n < 200; ++n) {
                    numbers[i] = n;
                    const double now = each->deviation(numbers, fidelity);
                    // The head of an arrow has only whole slices of its own.
                    if (each->names[0] != "Xarrow") {
                        EXPECT_LE(now, last) << each->names[0] << ' ' << n;
                    }
                    last = now;
                }
            }
    }
}

TEST(PrimitiveRows, TwinsDrawTheOtherTopology) {
    for (const PrimitiveSpec* each : primitives()) {
        if (each->twin == nullptr) continue;
        EXPECT_TRUE(each->topology == Topology::triangles || each->topology == Topology::lines);
        EXPECT_NE(each->topology, each->twin->topology) << each->names[0];
        EXPECT_NE(each->twin->twin, nullptr) << each->names[0];
    }
}

TEST(PrimitiveRows, CompleteNumbersWithDefaultsAndLimits) {
    for (const PrimitiveSpec* each : primitives()) {
        const std::vector<double> wild(each->arguments.size(), -1e30);
        const std::vector<double> tame = completeNumbers(*each, wild);
        ASSERT_EQ(tame.size(), each->arguments.size());
        for (std::size_t i = 0; i < tame.size(); ++i) switch (each->arguments[i].kind) {
                case ArgumentKind::number:
                    EXPECT_EQ(tame[i], -1e30) << each->names[0];
                    break;
                case ArgumentKind::size:
                    EXPECT_EQ(tame[i], 1e30) << each->names[0];
                    break;
                case ArgumentKind::count:
                case ArgumentKind::seed:
                    EXPECT_EQ(tame[i], each->arguments[i].least) << each->names[0];
                    break;
            }
    }
}

TEST(PrimitiveRows, DrawNothingIfASizeIsZero) {
    for (const PrimitiveSpec* each : primitives()) {
        EXPECT_FALSE(drawsNothing(*each, {})) << each->names[0];
        for (std::size_t i = 0; i < each->arguments.size(); ++i) {
            std::vector<double> numbers = completeNumbers(*each, {});
            numbers[i] = 0;
            EXPECT_EQ(drawsNothing(*each, numbers), each->arguments[i].kind == ArgumentKind::size)
                << each->names[0] << ' ' << each->arguments[i].name;
        }
    }
}

}  // namespace
}  // namespace glibra::geometry

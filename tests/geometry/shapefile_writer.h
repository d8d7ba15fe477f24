#pragma once
// Writes shapefiles for the tests, following the format's description.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace glibra::geometry {

inline void putLittle(std::string& bytes, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}
inline void putBig(std::string& bytes, std::uint32_t value) {
    for (int i = 3; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}
inline void putReal(std::string& bytes, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    putLittle(bytes, static_cast<std::uint32_t>(bits));
    putLittle(bytes, static_cast<std::uint32_t>(bits >> 32));
}

inline void putBoxAndCounts(std::string& bytes, std::uint32_t type, const std::vector<std::uint32_t>* parts,
                            const std::vector<glm::dvec3>& points) {
    putLittle(bytes, type);
    for (int i = 0; i < 4; ++i) putReal(bytes, 0);
    if (parts) putLittle(bytes, static_cast<std::uint32_t>(parts->size()));
    putLittle(bytes, static_cast<std::uint32_t>(points.size()));
    if (parts)
        for (const std::uint32_t part : *parts) putLittle(bytes, part);
    for (const glm::dvec3& point : points) {
        putReal(bytes, point.x);
        putReal(bytes, point.y);
    }
    // z and measures, or measures alone: range and values.
    for (std::uint32_t block = 0; block < (type / 10 == 1 ? 2U : type / 10);
         block += type / 10 == 1 ? 1 : 2) {
        putReal(bytes, 0);
        putReal(bytes, 0);
        for (const glm::dvec3& point : points) putReal(bytes, block == 0 && type / 10 == 1 ? point.z : -99);
    }
}

inline std::string polyRecord(std::uint32_t type, const std::vector<std::uint32_t>& parts,
                              const std::vector<glm::dvec3>& points) {
    std::string bytes;
    putBoxAndCounts(bytes, type, &parts, points);
    return bytes;
}

inline std::string multipointRecord(std::uint32_t type, const std::vector<glm::dvec3>& points) {
    std::string bytes;
    putBoxAndCounts(bytes, type, nullptr, points);
    return bytes;
}

inline std::string pointRecord(std::uint32_t type, const glm::dvec3& point) {
    std::string bytes;
    putLittle(bytes, type);
    putReal(bytes, point.x);
    putReal(bytes, point.y);
    if (type == 11) putReal(bytes, point.z);
    if (type != 1) putReal(bytes, -99);
    return bytes;
}

inline std::string nullRecord() {
    std::string bytes;
    putLittle(bytes, 0);
    return bytes;
}

inline std::string multipatchRecord() {
    std::string bytes;
    putLittle(bytes, 31);
    return bytes + std::string(60, '\1');
}

/// Returns the whole file: its header, and each record with its header.
inline std::string shapefile(std::uint32_t type, const std::vector<std::string>& records) {
    std::string body;
    std::uint32_t number = 1;
    for (const std::string& record : records) {
        putBig(body, number++);
        putBig(body, static_cast<std::uint32_t>(record.size() / 2));
        body += record;
    }
    std::string bytes;
    putBig(bytes, 9994);
    bytes.append(20, '\0');
    putBig(bytes, static_cast<std::uint32_t>((100 + body.size()) / 2));
    putLittle(bytes, 1000);
    putLittle(bytes, type);
    bytes.append(64, '\0');
    return bytes + body;
}

}  // namespace glibra::geometry

#include "geometry/obj/obj_plain.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <new>
#include <string>
#include <utility>

#include "base/parallel.h"

namespace glibra::geometry {
namespace {

/// A piece of whole lines and its content.
struct Piece {
    std::string_view text;
    std::vector<Triple> positions, texCoords, normals;
    std::vector<Triple> colors;  ///< of the first positions; empty if there is none
    std::vector<ObjCorner> corners;
    std::vector<std::uint32_t> faceEnds;  ///< indices into `corners`
    /// `s` lines: the number of faces above, and the group below
    std::vector<std::pair<std::uint32_t, std::uint32_t>> groups;
    std::uint32_t positionsNeeded = 0, texCoordsNeeded = 0, normalsNeeded = 0;
    bool isPlain = false;
};

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

const char* skipBlanks(const char* at) {
    while (isBlank(*at)) ++at;
    return at;
}

/// Reads lines that end with LF. All functions return the place after what they have read, or null if the
/// line is not a plain one. No pointer passes the last LF of the text, and enough bytes follow that LF for
/// everything that reads ahead.
class PieceReader {
  public:
    explicit PieceReader(Piece& piece) : piece_(piece) {}

    void read() {
        const char* at = piece_.text.data();
        const char* const end = at + piece_.text.size();
        // About the content of a usual file, so that the vectors seldom grow.
        piece_.positions.reserve(piece_.text.size() / 128);
        piece_.corners.reserve(piece_.text.size() / 32);
        while (at != nullptr && at < end) at = readLine(skipBlanks(at));
        piece_.isPlain = at != nullptr;
    }

  private:
    const char* readLine(const char* at) {
        if (*at == 'v') {
            if (isBlank(at[1])) return readPosition(at + 1);
            if (at[1] == 't' && isBlank(at[2])) return endOfLine(readTriple(at + 2, 1, piece_.texCoords));
            if (at[1] == 'n' && isBlank(at[2])) return endOfLine(readTriple(at + 2, 3, piece_.normals));
            return nullptr;
        }
        if (*at == 's' && isBlank(at[1])) return readGroup(skipBlanks(at + 1));
        if (*at == 'f' && isBlank(at[1])) return readFace(at + 1);
        if (*at == '#') return endOfComment(at);
        if (*at == '\n' || *at == '\r' || isMeaningless(at)) return endOfLine(at);
        return nullptr;
    }

    static bool isMeaningless(const char* at) {
        const char* end = at;
        while (*end >= 'a' && *end <= 'z') ++end;
        if (!isBlank(*end) && *end != '\n' && *end != '\r') return false;
        const std::string_view word(at, static_cast<std::size_t>(end - at));
        return word == "o" || word == "g" || word == "usemtl" || word == "mtllib";
    }

    /// Skips the rest of the line; null stays null.
    static const char* endOfLine(const char* at) {
        if (at == nullptr) return nullptr;
        for (; *at != '\n'; ++at) {
            if (*at == '#') return endOfComment(at);
            if (*at == '\\' || (*at == '\r' && at[1] != '\n')) return nullptr;
        }
        return at + 1;
    }
    static const char* endOfComment(const char* at) {
        for (; *at != '\n'; ++at)
            if (*at == '\r' && at[1] != '\n') return nullptr;
        return at + 1;
    }

    static bool endsNumber(char c) { return isBlank(c) || c == '\n' || c == '\r'; }

    /// Reads a number with an exponent or many digits.
    static const char* readLongNumber(const char* at, float& value) {
        if (*at == '+') ++at;
        const char* end = at;
        while ((*end >= '0' && *end <= '9') || *end == '.' || *end == 'e' || *end == 'E' || *end == '-' ||
               *end == '+')
            ++end;
        const auto [rest, failure] = std::from_chars(at, end, value);
        return failure == std::errc{} && rest == end ? end : nullptr;
    }

    /// Reads a number and what ends it.
    static const char* readNumber(const char* at, float& value) {
        const char* rest = readDecimal(at, value);
        if (rest == nullptr) rest = readLongNumber(at, value);
        return rest != nullptr && endsNumber(*rest) ? rest : nullptr;
    }

    static const char* readTriple(const char* at, int least, std::vector<Triple>& triples) {
        Triple triple{0, 0, 0};
        int numbers = 0;
        for (at = skipBlanks(at); numbers < 3; at = skipBlanks(at), ++numbers) {
            if (*at == '\n' || *at == '\r' || *at == '#') break;
            at = readNumber(at, triple[static_cast<std::size_t>(numbers)]);
            if (at == nullptr) return nullptr;
        }
        if (numbers < least) return nullptr;
        triples.push_back(triple);
        return at;
    }

    const char* readPosition(const char* at) {
        at = readTriple(at, 3, piece_.positions);
        // Three more numbers, or more, are a colour.
        if (at == nullptr || *at == '\n' || *at == '\r') return endOfLine(at);
        Triple color{0, 0, 0};
        const char* rest = at;
        for (float& value : color) {
            const char* const token = skipBlanks(rest);
            rest = readNumber(token, value);
            // Numbers that are too small, or written in an odd way, are left to the other reader.
            const bool mayBeNumber =
                (*token >= '0' && *token <= '9') || *token == '.' || *token == '-' || *token == '+';
            if (rest == nullptr) return mayBeNumber ? nullptr : endOfLine(at);
        }
        piece_.colors.resize(piece_.positions.size() - 1, {1, 1, 1});
        piece_.colors.push_back(color);
        return endOfLine(rest);
    }

    const char* readGroup(const char* at) {
        std::uint32_t group = kFlat;
        if (at[0] == 'o' && at[1] == 'f' && at[2] == 'f') {
            at += 3;
        } else {
            const Digits digits = digitsAt(at);
            if (digits.count == 0 || digits.count == 8) return nullptr;
            group = static_cast<std::uint32_t>(digits.value);
            at += digits.count;
        }
        piece_.groups.emplace_back(static_cast<std::uint32_t>(piece_.faceEnds.size()), group);
        return endsNumber(*at) ? endOfLine(at) : nullptr;
    }

    /// Reads a positive index; `index` counts from 0.
    static const char* readIndex(const char* at, std::uint32_t& index) {
        const Digits digits = digitsAt(at);
        if (digits.count == 0 || digits.count == 8 || digits.value == 0) return nullptr;
        index = static_cast<std::uint32_t>(digits.value) - 1;
        return at + digits.count;
    }

    const char* readCorner(const char* at, ObjCorner& corner) {
        at = readIndex(at, corner.position);
        if (at == nullptr) return nullptr;
        piece_.positionsNeeded = std::max(piece_.positionsNeeded, corner.position + 1);
        if (*at == '/' && at[1] != '/') {
            at = readIndex(at + 1, corner.texCoord);
            if (at == nullptr) return nullptr;
            piece_.texCoordsNeeded = std::max(piece_.texCoordsNeeded, corner.texCoord + 1);
        } else if (*at == '/') {
            ++at;
        }
        if (*at == '/') {
            at = readIndex(at + 1, corner.normal);
            if (at == nullptr) return nullptr;
            piece_.normalsNeeded = std::max(piece_.normalsNeeded, corner.normal + 1);
        }
        return endsNumber(*at) ? at : nullptr;
    }

    const char* readFace(const char* at) {
        const std::size_t first = piece_.corners.size();
        for (at = skipBlanks(at); *at != '\n' && *at != '\r' && *at != '#'; at = skipBlanks(at)) {
            ObjCorner corner;
            at = readCorner(at, corner);
            if (at == nullptr) return nullptr;
            piece_.corners.push_back(corner);
        }
        if (piece_.corners.size() < first + 3) return nullptr;
        piece_.faceEnds.push_back(static_cast<std::uint32_t>(piece_.corners.size()));
        return endOfLine(at);
    }

    Piece& piece_;
};

/// Cuts the text into pieces of whole lines. `rest` becomes the end of the text, where too few bytes follow
/// for everything that reads ahead.
std::vector<Piece> cut(std::string_view text, std::size_t pieceBytes, std::string_view& rest) {
    std::vector<Piece> pieces;
    const std::size_t last =
        text.size() < kDecimalReach ? std::string_view::npos : text.rfind('\n', text.size() - kDecimalReach);
    const std::size_t end = last == std::string_view::npos ? 0 : last + 1;
    for (std::size_t at = 0; at < end;) {
        const std::size_t next =
            end - at <= pieceBytes ? end : std::min(end, text.find('\n', at + pieceBytes) + 1);
        pieces.push_back({});
        pieces.back().text = text.substr(at, next - at);
        at = next;
    }
    rest = text.substr(end);
    return pieces;
}

/// Joins the values of one kind from all pieces.
template <class Value>
std::vector<Value> joined(std::vector<Piece>& pieces, std::vector<Value> Piece::* member) {
    std::size_t count = 0;
    for (const Piece& piece : pieces) count += (piece.*member).size();
    std::vector<Value> all;
    all.reserve(count);
    for (Piece& piece : pieces) {
        all.insert(all.end(), (piece.*member).begin(), (piece.*member).end());
        std::vector<Value>().swap(piece.*member);
    }
    return all;
}

/// The smoothing group of each face; empty if there are no `s` lines.
std::vector<std::uint32_t> groupsOf(const std::vector<Piece>& pieces, std::size_t faces) {
    std::vector<std::uint32_t> groups;
    if (std::ranges::all_of(pieces, [](const Piece& each) { return each.groups.empty(); })) return groups;
    groups.reserve(faces);
    std::uint32_t group = kNoIndex;
    std::size_t before = 0;
    for (const Piece& piece : pieces) {
        for (const auto& [face, next] : piece.groups) {
            groups.resize(before + face, group);
            group = next;
        }
        before += piece.faceEnds.size();
    }
    groups.resize(faces, group);
    return groups;
}

/// The colour of each position; empty if there is none.
std::vector<Triple> colorsOf(const std::vector<Piece>& pieces) {
    std::vector<Triple> colors;
    std::size_t before = 0;
    for (const Piece& piece : pieces) {
        if (!piece.colors.empty()) {
            colors.resize(before, {1, 1, 1});
            colors.insert(colors.end(), piece.colors.begin(), piece.colors.end());
        }
        before += piece.positions.size();
    }
    if (!colors.empty()) colors.resize(before, {1, 1, 1});
    return colors;
}

bool withinLimits(const ObjModel& model) {
    constexpr std::size_t kMost = 3 * kMostTriangles;
    return model.faceCount() > 0 && model.positions.size() <= kMost && model.texCoords.size() <= kMost &&
           model.normals.size() <= kMost && model.triangleCount() <= kMostTriangles;
}

}  // namespace

std::optional<ObjModel> readPlainObj(std::string_view text, std::size_t pieceBytes) {
    std::string_view rest;
    std::vector<Piece> pieces = cut(text, pieceBytes, rest);
    std::string padded(rest);
    if (!padded.empty() && padded.back() != '\n') padded += '\n';
    const std::size_t restBytes = padded.size();
    padded.append(kDecimalReach, '\n');
    pieces.push_back({});
    pieces.back().text = std::string_view(padded).substr(0, restBytes);

    std::atomic<bool> isPlain{true};
    base::forEachIndex(pieces.size(), 0, [&](std::size_t i) {
        try {
            if (isPlain) PieceReader(pieces[i]).read();
        } catch (const std::bad_alloc&) {
            // The line-by-line reader needs less memory, and throws where the caller expects it.
        }
        if (!pieces[i].isPlain) isPlain = false;
    });
    if (!isPlain) return {};

    ObjModel model;
    std::uint32_t positions = 0, texCoords = 0, normals = 0;
    std::size_t faces = 0, corners = 0;
    for (const Piece& piece : pieces) {
        positions = std::max(positions, piece.positionsNeeded);
        texCoords = std::max(texCoords, piece.texCoordsNeeded);
        normals = std::max(normals, piece.normalsNeeded);
        faces += piece.faceEnds.size();
    }
    model.faceStarts.reserve(faces + 1);
    model.faceStarts.push_back(0);
    for (const Piece& piece : pieces) {
        for (const std::uint32_t end : piece.faceEnds)
            model.faceStarts.push_back(static_cast<std::uint32_t>(corners + end));
        corners += piece.corners.size();
    }
    model.groups = groupsOf(pieces, faces);
    model.colors = colorsOf(pieces);
    model.positions = joined(pieces, &Piece::positions);
    model.texCoords = joined(pieces, &Piece::texCoords);
    model.normals = joined(pieces, &Piece::normals);
    model.corners = joined(pieces, &Piece::corners);
    const bool allExist = positions <= model.positions.size() && texCoords <= model.texCoords.size() &&
                          normals <= model.normals.size();
    if (!allExist || !withinLimits(model)) return {};
    return model;
}

}  // namespace glibra::geometry

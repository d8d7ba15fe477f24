#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "geometry/obj/concave_faces.h"
#include "geometry/obj/obj_model.h"
#include "geometry/obj/obj_plain.h"

namespace glibra::geometry {
namespace {

// A cursor over a line-oriented text of numbers, fast enough for a hundred megabytes.

/// A statement ends with the line (LF, CR LF or CR) or at a `#` that begins a token. A backslash at the end
/// of a line joins the next line to it. Blanks are space, tab, vertical tab and form feed.
class TextScanner {
  public:
    explicit TextScanner(std::string_view text)
        : at_(text.data()), end_(text.data() + text.size()), lineStart_(at_) {}

    [[nodiscard]] bool atEnd() const { return at_ == end_; }
    [[nodiscard]] int line() const { return line_; }
    /// The column, in bytes from 1.
    [[nodiscard]] int column() const { return static_cast<int>(at_ - lineStart_) + 1; }
    /// The next byte; a line feed at the end of the text.
    [[nodiscard]] char current() const { return at_ == end_ ? '\n' : *at_; }
    void advance() { ++at_; }

    void skipBlanks() {
        for (;;) {
            while (at_ != end_ && isBlank(*at_)) ++at_;
            if (at_ == end_ || *at_ != '\\' || !skipJoin()) return;
        }
    }

    /// True if the statement has no further token. Call skipBlanks first.
    [[nodiscard]] bool statementEnds() const { return at_ == end_ || isLineEnd(*at_) || *at_ == '#'; }

    /// Reads everything up to a blank, a line end or a join.
    std::string_view token() {
        const char* const start = at_;
        while (at_ != end_ && !isBlank(*at_) && !isLineEnd(*at_) && !(*at_ == '\\' && joinLength(at_) > 0))
            ++at_;
        return {start, static_cast<std::size_t>(at_ - start)};
    }

    /// True if a token ends here.
    [[nodiscard]] bool tokenEnds() const {
        return at_ == end_ || isBlank(*at_) || isLineEnd(*at_) || (*at_ == '\\' && joinLength(at_) > 0);
    }

    /// Reads the longest prefix that is a number: [+-] digits [. digits] [exponent]. Returns false and reads
    /// nothing if there is none or if it is not finite as a float. A number too small for a float is 0.
    bool number(float& value);

    /// Reads [+-] digits, limited to +-9e18. Returns false and reads nothing if there are no digits.
    bool integer(long long& value);

    /// Goes to the start of the next line that is not joined to this one.
    void nextLine();

  private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
    static bool isDigit(char c) { return c >= '0' && c <= '9'; }

    /// The number of bytes of the backslash at `at` with the blanks and the line end after it; 0 if it does
    /// not join lines.
    [[nodiscard]] std::size_t joinLength(const char* at) const;
    bool skipJoin();

    const char* at_;
    const char* end_;
    const char* lineStart_;
    int line_ = 1;
};

bool TextScanner::number(float& value) {
    const char* digits = at_;
    if (digits != end_ && (*digits == '+' || *digits == '-')) ++digits;
    // from_chars also accepts "inf" and "nan", but no plus sign.
    const bool begins =
        digits != end_ && (isDigit(*digits) || (*digits == '.' && digits + 1 != end_ && isDigit(digits[1])));
    if (!begins) return false;
    const char* const start = *at_ == '+' ? digits : at_;
    float result = 0;
    const auto [rest, failure] = std::from_chars(start, end_, result);
    if (failure == std::errc::result_out_of_range) {
        // Too large or too small: as a double it is clear which; beyond a double's range the sign of the
        // exponent decides.
        double wide = 0;
        const bool isWide = std::from_chars(start, rest, wide).ec == std::errc{};
        const char* const exponent = std::find_if(start, rest, [](char c) { return c == 'e' || c == 'E'; });
        const bool isTiny = isWide ? std::abs(wide) < 1
                                   : (exponent != rest && exponent + 1 != rest && exponent[1] == '-') ||
                                         *digits == '0' || *digits == '.';
        if (!isTiny) return false;
        result = static_cast<float>(wide);
    } else if (failure != std::errc{}) {
        return false;
    }
    value = result;
    at_ = rest;
    return true;
}

bool TextScanner::integer(long long& value) {
    const char* at = at_;
    const bool negative = at != end_ && *at == '-';
    if (at != end_ && (*at == '+' || *at == '-')) ++at;
    if (at == end_ || !isDigit(*at)) return false;
    constexpr long long kLargest = 9'000'000'000'000'000'000;
    long long result = 0;
    for (; at != end_ && isDigit(*at); ++at)
        result = result > kLargest / 10 - 1 ? kLargest : result * 10 + (*at - '0');
    value = negative ? -result : result;
    at_ = at;
    return true;
}

void TextScanner::nextLine() {
    bool inComment = false;
    for (; at_ != end_; ++at_) {
        if (*at_ == '#') inComment = true;
        if (*at_ == '\\' && !inComment) {
            if (const std::size_t length = joinLength(at_); length > 0) {
                skipJoin();
                --at_;
                continue;
            }
        }
        if (isLineEnd(*at_)) {
            if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
            ++at_;
            ++line_;
            lineStart_ = at_;
            return;
        }
    }
}

std::size_t TextScanner::joinLength(const char* at) const {
    const char* next = at + 1;
    while (next != end_ && isBlank(*next)) ++next;
    if (next == end_) return static_cast<std::size_t>(next - at);
    if (!isLineEnd(*next)) return 0;
    if (*next == '\r' && next + 1 != end_ && next[1] == '\n') ++next;
    return static_cast<std::size_t>(next + 1 - at);
}

bool TextScanner::skipJoin() {
    const std::size_t length = joinLength(at_);
    if (length == 0) return false;
    const bool hasLineEnd = isLineEnd(at_[length - 1]);
    at_ += length;
    if (hasLineEnd) {
        ++line_;
        lineStart_ = at_;
    }
    return true;
}

constexpr Triple kWhite{1, 1, 1};

/// No model uses more elements of a kind than its triangles have corners.
constexpr std::uint64_t kMostElements = 3 * kMostTriangles;

constexpr std::array<std::string_view, 4> kMeaningless{"o", "g", "usemtl", "mtllib"};

/// A face, line or point with an index that may be defined further down. It is checked again at the end of
/// the file.
struct Forward {
    std::size_t number = 0;
    int line = 1, column = 1;
};

/// Sequences of corners: faces, or lines.
struct Sequences {
    std::vector<ObjCorner>& corners;
    std::vector<std::uint32_t>& starts;  ///< of each sequence; last, the number of corners
    std::size_t least;                   ///< corners of one
    std::string_view name;
    std::vector<Forward> forward{};
};

/// The elements that an index refers to.
struct ElementKind {
    std::string_view name;
    std::size_t count = 0;  ///< how many are defined so far
};

class ObjReader {
  public:
    ObjReader(std::string_view text, std::string path, ObjElements wanted)
        : scanner_(text), remarks_(std::move(path)), wanted_(wanted) {}

    Result<ObjModel> read();

  private:
    bool readStatement(std::string_view word, int line, int column);
    void reportRest(TextScanner start, bool isRead);
    bool readNumber(float& value);
    bool readTriple(std::vector<Triple>& triples, std::string_view word, int least, int line, int column);
    bool readPosition(int line, int column);
    void readColor();
    void readGroup(int line, int column);
    bool readSequence(Sequences& to, int line, int column);
    bool readCorner(ObjCorner& corner, bool& isForward, std::string& fault);
    bool readIndex(const ElementKind& kind, std::uint32_t& index, bool& isForward, std::string& fault);
    [[nodiscard]] std::string outOfRange(const ObjCorner& corner) const;
    std::vector<bool> dropForward(Sequences& sequences);
    Result<ObjModel> failed(std::string_view id, std::string text) &&;

    TextScanner scanner_;
    FileRemarks remarks_;
    ObjElements wanted_;
    ObjModel model_;
    Sequences faces_{model_.corners, model_.faceStarts, 3, "face"};
    Sequences lines_{model_.lineCorners, model_.lineStarts, 2, "line"};
    std::vector<std::uint32_t> pointStarts_;
    Sequences points_{model_.points, pointStarts_, 1, "point"};
    std::uint32_t group_ = kNoIndex;
    bool hasGroups_ = false;  ///< an `s` line
    bool hasLines_ = false;   ///< or points
    std::string_view tooMany_;
};

Result<ObjModel> ObjReader::read() {
    for (Sequences* each : {&faces_, &lines_, &points_}) each->starts.push_back(0);
    while (!scanner_.atEnd()) {
        scanner_.skipBlanks();
        if (!scanner_.statementEnds()) {
            const int line = scanner_.line(), column = scanner_.column();
            if (!readStatement(scanner_.token(), line, column))
                return std::move(*this).failed(
                    "file-E09", fmt::format("has too many {}; the limit is {} triangles", tooMany_,
                                            base::groupedText(kMostTriangles)));
        }
        scanner_.nextLine();
    }
    const std::vector<bool> dropped = dropForward(faces_);
    if (!model_.groups.empty()) {
        std::size_t face = 0;
        std::erase_if(model_.groups, [&](std::uint32_t) { return face < dropped.size() && dropped[face++]; });
    }
    dropForward(lines_);
    dropForward(points_);
    if (!model_.colors.empty()) model_.colors.resize(model_.positions.size(), kWhite);
    const bool isEmpty = model_.faceCount() == 0 && model_.lineCorners.empty() && model_.points.empty();
    if (isEmpty)
        return std::move(*this).failed("file-E07",
                                       wanted_ == ObjElements::edges ? "has no faces, lines or points"
                                       : hasLines_ ? "has no faces; WireObj draws its lines and points"
                                                   : "has no faces");
    return {std::move(model_), std::move(remarks_).finish()};
}

/// Returns false if a limit is exceeded.
bool ObjReader::readStatement(std::string_view word, int line, int column) {
    if (word == "v") return readPosition(line, column);
    if (word == "vt") return readTriple(model_.texCoords, word, 1, line, column);
    if (word == "vn") return readTriple(model_.normals, word, 3, line, column);
    if (word == "f") return readSequence(faces_, line, column);
    if (word == "s") {
        readGroup(line, column);
        return true;
    }
    if (word == "l" || word == "p") {
        hasLines_ = true;
        if (wanted_ == ObjElements::edges) return readSequence(word == "l" ? lines_ : points_, line, column);
    }
    if (std::ranges::find(kMeaningless, word) == kMeaningless.end()) remarks_.ignored(word, line, column);
    return true;
}

/// Passes over the rest of a token, and says that it was read as what is before the rest, or as 0.
void ObjReader::reportRest(TextScanner start, bool isRead) {
    const std::string_view rest = scanner_.token();
    const int line = start.line(), column = start.column();
    const std::string_view token = start.token();
    const std::string_view prefix = token.substr(0, token.size() - rest.size());
    remarks_.warn("file-W06", fmt::format("'{}' read as {}", shown(token), isRead ? shown(prefix) : "0"),
                  line, column);
}

/// Reads the next number of the statement, 0 if it is malformed. Returns false at the end of the statement.
bool ObjReader::readNumber(float& value) {
    scanner_.skipBlanks();
    if (scanner_.statementEnds()) return false;
    const TextScanner start = scanner_;
    value = 0;
    const bool isNumber = scanner_.number(value);
    if (!isNumber || !scanner_.tokenEnds()) reportRest(start, isNumber);
    return true;
}

bool ObjReader::readTriple(std::vector<Triple>& triples, std::string_view word, int least, int line,
                           int column) {
    if (triples.size() >= kMostElements) {
        tooMany_ = "'v', 'vt' or 'vn' lines";
        return false;
    }
    Triple triple{0, 0, 0};
    int numbers = 0;
    while (numbers < 3 && readNumber(triple[static_cast<std::size_t>(numbers)])) ++numbers;
    if (numbers < least)
        remarks_.warn("file-W06",
                      fmt::format("'{}' with {}, missing ones are 0", word, base::counted(numbers, "number")),
                      line, column);
    triples.push_back(triple);
    return true;
}

bool ObjReader::readPosition(int line, int column) {
    if (!readTriple(model_.positions, "v", 3, line, column)) return false;
    readColor();
    return true;
}

/// Three more numbers, or more, are a colour. Anything else after a position is ignored.
void ObjReader::readColor() {
    Triple color{};
    for (float& value : color) {
        scanner_.skipBlanks();
        if (scanner_.statementEnds() || !scanner_.number(value) || !scanner_.tokenEnds()) return;
    }
    model_.colors.resize(model_.positions.size() - 1, kWhite);
    model_.colors.push_back(color);
}

/// Reads a number, or "off" for 0 and "on" for 1.
void ObjReader::readGroup(int line, int column) {
    scanner_.skipBlanks();
    const TextScanner start = scanner_;
    long long number = 0;
    const bool isNumber = scanner_.integer(number) && scanner_.tokenEnds() && number >= 0;
    if (!isNumber) {
        scanner_ = start;
        const std::string_view word = scanner_.token();
        number = word == "on" ? 1 : 0;
        if (word != "on" && word != "off")
            remarks_.warn("file-W06", fmt::format("smoothing group '{}' read as 0", shown(word)), line,
                          column);
    }
    if (!hasGroups_) model_.groups.assign(model_.faceCount(), kNoIndex);
    group_ = static_cast<std::uint32_t>(std::min<long long>(number, kNoIndex - 1));
    hasGroups_ = true;
}

bool ObjReader::readSequence(Sequences& to, int line, int column) {
    const std::size_t first = to.corners.size();
    bool isForward = false;
    std::string fault;
    for (scanner_.skipBlanks(); fault.empty() && !scanner_.statementEnds(); scanner_.skipBlanks()) {
        ObjCorner corner;
        if (!readCorner(corner, isForward, fault)) break;
        to.corners.push_back(corner);
        const std::size_t perSequence = to.least - 1;  // corners that make no triangle, or no line
        const std::size_t sequences = to.starts.size() - 1;
        if (to.corners.size() - std::min(to.corners.size(), perSequence * sequences) >
            kMostTriangles + perSequence) {
            tooMany_ = to.least == 3 ? "faces" : to.least == 2 ? "lines" : "points";
            return false;
        }
    }
    const std::size_t count = to.corners.size() - first;
    if (fault.empty() && count < to.least) fault = "only " + base::counted(count, "corner");
    if (!fault.empty()) {
        to.corners.resize(first);
        remarks_.warn("file-W05", fmt::format("{} dropped: {}", to.name, fault), line, column);
        return true;
    }
    if (isForward) to.forward.push_back({to.starts.size() - 1, line, column});
    to.starts.push_back(static_cast<std::uint32_t>(to.corners.size()));
    if (&to == &faces_ && hasGroups_) model_.groups.push_back(group_);
    return true;
}

/// Reads v, v/t, v//n or v/t/n; t and n may be empty. Returns false and sets `fault` if the corner is
/// invalid.
bool ObjReader::readCorner(ObjCorner& corner, bool& isForward, std::string& fault) {
    const TextScanner start = scanner_;
    if (!readIndex({"vertex", model_.positions.size()}, corner.position, isForward, fault)) return false;
    if (scanner_.current() == '/') {
        scanner_.advance();
        if (scanner_.current() != '/' && !scanner_.tokenEnds() &&
            !readIndex({"texture coordinate", model_.texCoords.size()}, corner.texCoord, isForward, fault))
            return false;
    }
    if (scanner_.current() == '/') {
        scanner_.advance();
        if (!scanner_.tokenEnds() &&
            !readIndex({"normal", model_.normals.size()}, corner.normal, isForward, fault))
            return false;
    }
    if (!scanner_.tokenEnds()) reportRest(start, true);
    return true;
}

bool ObjReader::readIndex(const ElementKind& kind, std::uint32_t& index, bool& isForward,
                          std::string& fault) {
    long long written = 0;
    if (!scanner_.integer(written)) {
        fault = fmt::format("'{}' is not an index", shown(scanner_.token()));
        return false;
    }
    const auto count = static_cast<long long>(kind.count);
    const long long found = written > 0 ? written - 1 : count + written;
    if (written == 0 || found < 0 || found >= static_cast<long long>(kMostElements)) {
        fault = fmt::format("{} {} does not exist", kind.name, written);
        return false;
    }
    if (found >= count) isForward = true;
    index = static_cast<std::uint32_t>(found);
    return true;
}

/// Describes the index of the corner that does not exist; empty if all exist.
std::string ObjReader::outOfRange(const ObjCorner& corner) const {
    const auto missing = [](std::string_view name, std::uint32_t index, std::size_t count) {
        return index == kNoIndex || index < count
                   ? std::string()
                   : fmt::format("{} {} does not exist", name, std::uint64_t{index} + 1);
    };
    std::string fault = missing("vertex", corner.position, model_.positions.size());
    if (fault.empty()) fault = missing("texture coordinate", corner.texCoord, model_.texCoords.size());
    if (fault.empty()) fault = missing("normal", corner.normal, model_.normals.size());
    return fault;
}

/// Drops the sequences whose indices were not defined further down either, and returns which; none if all
/// stay.
std::vector<bool> ObjReader::dropForward(Sequences& sequences) {
    std::vector<bool> dropped;
    const std::size_t count = sequences.starts.size() - 1;
    for (const Forward& each : sequences.forward) {
        const auto begin = sequences.corners.begin() + sequences.starts[each.number];
        const auto end = sequences.corners.begin() + sequences.starts[each.number + 1];
        for (auto corner = begin; corner != end; ++corner)
            if (const std::string fault = outOfRange(*corner); !fault.empty()) {
                remarks_.warn("file-W05", fmt::format("{} dropped: {}", sequences.name, fault), each.line,
                              each.column);
                dropped.resize(count);
                dropped[each.number] = true;
                break;
            }
    }
    if (dropped.empty()) return dropped;
    std::vector<ObjCorner> corners;
    std::vector<std::uint32_t> starts{0};
    for (std::size_t i = 0; i < count; ++i) {
        if (dropped[i]) continue;
        corners.insert(corners.end(), sequences.corners.begin() + sequences.starts[i],
                       sequences.corners.begin() + sequences.starts[i + 1]);
        starts.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    sequences.corners = std::move(corners);
    sequences.starts = std::move(starts);
    return dropped;
}

Result<ObjModel> ObjReader::failed(std::string_view id, std::string text) && {
    Diagnostic fault = diagnose(std::string(id), fmt::format("'{}' {}", fileName(remarks_.path()), text),
                                remarks_.place(1, 1));
    Diagnostics all = std::move(remarks_).finish();
    all.push_back(std::move(fault));
    return all;
}

/// True if the file begins like one that a compiler or linker writes: COFF for usual machines, anonymous COFF
/// objects, ELF, Mach-O, or Intel's OMF. All of these contain zero bytes, and a text does not.
bool isCompilerOutput(std::string_view text) {
    using namespace std::string_view_literals;
    constexpr std::array<std::string_view, 12> kMagic{"\x4c\x01"sv,
                                                      "\x64\x86"sv,
                                                      "\xc4\x01"sv,
                                                      "\xc0\x01"sv,
                                                      "\x64\xaa"sv,
                                                      "\0\0\xff\xff"sv,
                                                      "\x7f"
                                                      "ELF"sv,
                                                      "\xfe\xed\xfa\xce"sv,
                                                      "\xfe\xed\xfa\xcf"sv,
                                                      "\xce\xfa\xed\xfe"sv,
                                                      "\xcf\xfa\xed\xfe"sv,
                                                      "\x80"sv};
    if (text.substr(0, 512).find('\0') == std::string_view::npos) return false;
    return std::ranges::any_of(kMagic, [&](std::string_view magic) { return text.starts_with(magic); });
}

}  // namespace

Result<ObjModel> parseObj(std::string_view text, std::string path, ObjElements wanted) {
    const auto failure = [&](std::string_view id, std::string_view what) {
        return diagnose(std::string(id), fmt::format("'{}' {}", fileName(path), what), {path, 1, 1});
    };
    if (text.size() > kLargestModelFile)
        return failure("file-E09", fmt::format("has {}, the limit is {}", base::readableBytes(text.size()),
                                               base::readableBytes(kLargestModelFile)));
    if (isCompilerOutput(text)) return failure("file-E08", "is a compiler's object file, not a model");
    if (base::isNoText(text)) return failure("file-E08", base::notThe("an OBJ model", text));
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    Result<ObjModel> model;
    if (auto plain = readPlainObj(text))
        model = *std::move(plain);
    else
        model = ObjReader(text, path, wanted).read();
    const std::string mismatch = model ? std::string() : base::notThe("an OBJ model", text);
    if (!mismatch.empty()) return failure("file-E08", mismatch);
    if (!model) return model;
    if (const std::size_t uncut = splitConcaveFaces(*model); uncut > 0)
        model.diagnostics.push_back(
            diagnose("file-W17",
                     fmt::format("{} of many corners drawn as {} from the first corner",
                                 base::countedInGroups(uncut, "concave face"), uncut == 1 ? "a fan" : "fans"),
                     {path, 1, 1}));
    return model;
}

}  // namespace glibra::geometry

#pragma once
// What a scene declares, as values: files, shapes, textures, samplers, buffers, programs.

#include <glibra/diagnostic.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/files.h"
#include "base/program_resources.h"
#include "base/raster_state.h"
#include "base/texel_format.h"
#include "geometry/list_mesh.h"
#include "geometry/mesh.h"
#include "glib/script.h"
#include "glsl/types/request.h"
#include "glsl/types/stage.h"

namespace glibra::scene {

// ---- Indices
// They know which list they belong to: an index of a texture cannot be used for a list of programs.

/// The place of one `Of` in a list, or none. `Of` is only a name: it may be incomplete.
template <class Of>
class Index {
  public:
    constexpr Index() = default;  ///< none
    constexpr explicit Index(std::size_t position) : next_(static_cast<std::uint32_t>(position) + 1) {}

    /// False for none.
    constexpr explicit operator bool() const { return next_ != 0; }
    /// Counts from 0. For none it is beyond the end of every list.
    [[nodiscard]] constexpr std::size_t position() const { return std::size_t{next_} - 1; }

    /// None comes before all others.
    friend constexpr auto operator<=>(Index, Index) = default;

  private:
    std::uint32_t next_ = 0;  // position + 1
};

/// All indices below a count, for range-based for.
template <class Of>
class IndexRange {
  public:
    class Iterator {
      public:
        explicit Iterator(std::size_t position) : position_(position) {}
        Index<Of> operator*() const { return Index<Of>(position_); }
        Iterator& operator++() {
            ++position_;
            return *this;
        }
        friend bool operator==(Iterator, Iterator) = default;

      private:
        std::size_t position_;
    };
    explicit IndexRange(std::size_t count) : count_(count) {}
    [[nodiscard]] Iterator begin() const { return Iterator(0); }
    [[nodiscard]] Iterator end() const { return Iterator(count_); }

  private:
    std::size_t count_;
};

/// A vector whose operator[] takes only an Index<Of>. `Of` differs from `T` where a list holds one value for
/// each element of another list.
template <class T, class Of = T>
class List : public std::vector<T> {
  public:
    using std::vector<T>::vector;

    /// Throws std::out_of_range for none and for an index beyond the end.
    typename std::vector<T>::reference operator[](Index<Of> index) { return this->at(index.position()); }
    typename std::vector<T>::const_reference operator[](Index<Of> index) const {
        return this->at(index.position());
    }

    /// Appends the element and returns its index.
    Index<Of> add(T element) {
        this->push_back(std::move(element));
        return Index<Of>(this->size() - 1);
    }
    [[nodiscard]] IndexRange<Of> indices() const { return IndexRange<Of>(this->size()); }
};

/// The element of a plain vector that the index belongs to. Throws like List.
template <class T>
const T& at(const std::vector<T>& vector, Index<T> index) {
    return vector.at(index.position());
}

// ---- Buffer values
// The numbers that a scene gives a buffer.

/// Numbers in order, which copies share. Those of an expression are computed when they are first read, so
/// that a buffer that nothing reads costs nothing. One thread at a time may read them.
class BufferValues {
  public:
    struct Made {
        std::vector<double> numbers;  ///< without an error as many as were promised
        Diagnostics problems;
    };

    BufferValues() = default;
    BufferValues(std::vector<double> numbers);
    /// `make` gives that many numbers. It is called at most once.
    BufferValues(std::size_t size, std::function<Made()> make);

    /// Computes nothing.
    [[nodiscard]] std::size_t size() const { return content_ ? content_->size : 0; }
    [[nodiscard]] bool empty() const { return size() == 0; }
    /// As many as size(); what could not be computed is 0.
    [[nodiscard]] const std::vector<double>& numbers() const;
    [[nodiscard]] bool hasFailed() const;
    /// What computing them has reported: all at the first call, and at later ones, also those of copies, the
    /// errors.
    [[nodiscard]] Diagnostics takeProblems() const;

    /// Numbers of which some could not be computed equal no others.
    friend bool operator==(const BufferValues& a, const BufferValues& b) {
        return a.content_ == b.content_ || (!a.hasFailed() && !b.hasFailed() && a.numbers() == b.numbers());
    }

  private:
    struct Content {
        std::size_t size = 0;
        std::function<Made()> make;  ///< empty: `made` is there
        Made made;
        bool hasFailed = false;
    };
    const Content& made() const;

    std::shared_ptr<Content> content_;
};

// ---- Objects

struct FileReference;
struct Shape;
struct Texture;
struct Sampler;
struct Buffer;
struct Slot;
struct Program;
struct UniformSet;
struct AttributeSet;

/// The content of all slots at one place of the scene, sorted by unit and target. Draws share these.
using SlotTable = std::vector<Slot>;

// Indices into the lists of Declarations.
using FileIndex = Index<FileReference>;
using ShapeIndex = Index<Shape>;
using TextureIndex = Index<Texture>;
using SamplerIndex = Index<Sampler>;
using BufferIndex = Index<Buffer>;
using SlotTableIndex = Index<SlotTable>;
using ProgramIndex = Index<Program>;
using UniformSetIndex = Index<UniformSet>;
using AttributeSetIndex = Index<AttributeSet>;

/// A file that a scene names, looked up but not read. `path` is empty if no file was found. `remarks`
/// (file-E01, file-W01 ...) are reported when the file is needed. Statements that name the same file share
/// one reference, with the place of the first statement.
struct FileReference {
    std::string name;  ///< as written
    std::filesystem::path path;
    Diagnostics remarks;
    Place place;
    /// The text of a shader that stands in the script, with as many empty lines before it as put it on its
    /// lines of the script, which is `path`.
    std::optional<std::string> text{};
    std::shared_ptr<const std::string> content{};  ///< of a file that is in memory (MemoryFiles)

    [[nodiscard]] base::FileSource source() const { return {path, content}; }
};

/// What a geometry command draws: the command with its numbers, or a list made by glBegin, Triangles or
/// LinesAdjacency. Equal shapes share one entry of Scene::shapes, and so one mesh.
struct Shape {
    glib::CommandId command{};
    /// The arguments with defaults filled in. One count that scenes cannot set may follow: cells per side of
    /// a Teapot's patches, subdivisions of a Soccerball's triangles, or sides of an Xarrow. Of `Vertices`:
    /// the number of vertices, 0 if a buffer gives it.
    std::vector<double> numbers;
    FileIndex file{};
    std::shared_ptr<const geometry::Mesh>
        list;  ///< the mesh itself, if the text of the scene contains the vertices
    std::optional<geometry::Topology> bare{};       ///< of `Vertices`: primitives without vertex data
    std::optional<geometry::ListTopology> strip{};  ///< of `Vertices`: the primitives share vertices
    friend bool operator==(const Shape&, const Shape&) = default;
};

using base::TexelFormat;
using base::TextureTarget;

/// Where a texture's texels come from.
struct PictureSource {
    std::vector<FileIndex> files;  ///< one; or six for a cube map, which may also be one panorama or cross
};
struct EmptySource {
    int width = 1, height = 1, depth = 1;  ///< `depth` of an array: its layers, six for each cube map
    TexelFormat format = TexelFormat::rgba8;
    friend bool operator==(const EmptySource&, const EmptySource&) = default;
};
/// Precision of noise texels: 8 bits, as in glman, or 16 bits.
enum class NoiseTexels { bytes, shorts };

/// Noise of a given size. If there is a file with raw bytes of exactly that size, the texels come from it;
/// otherwise the noise is built in. The remarks (file-N01, file-W09, file-W10) are reported when the texture
/// is needed.
struct NoiseSource {
    int dimensions = 3;
    int size = 64;
    bool isSizeGiven = false;                 ///< the scene sets it
    NoiseTexels texels = NoiseTexels::bytes;  ///< of built-in noise
    FileIndex file{};
    Diagnostics remarks;
};

struct Texture {
    TextureTarget target = TextureTarget::texture2D;
    std::variant<PictureSource, EmptySource, NoiseSource> source;
    Place place;
    int unit = 0;        ///< of the language; a texture with a name has none
    std::string name{};  ///< empty: it is on a unit
    // The rest is of textures with a name.
    base::SamplerState sampler{};
    int levels = 1;           ///< of an empty texture; 0: down to one texel
    int samples = 1;          ///< more: multisampled
    bool isFlipped = false;   ///< rows of a file from the bottom up
    bool isSrgb = false;      ///< texels of a file are sRGB
    bool hasMipmaps = false;  ///< made after each writer, and from files
    bool hasHistory = false;  ///< there are two copies, which are exchanged
};

/// A sampler with a name, for texture.name.
struct Sampler {
    std::string name;
    base::SamplerState state;
    Place place;
    bool statesWrap = false;  ///< otherwise what compares reads 1 outside of a texture
};

/// Memory that shaders read and write.
struct Buffer {
    std::string name;
    /// The element's type: a basic GLSL type, or a structure of a shader. Empty: that of the block called
    /// `name`.
    std::string type;
    std::optional<std::uint64_t> count{};  ///< elements; nothing: as many as the values fill
    BufferValues values;                   ///< components in order; what they do not fill is zero
    bool isComputed = false;               ///< an expression gives `values`, one element at a time
    FileIndex file{};                      ///< raw bytes, in place of `values`
    bool hasHistory = false;
    Place place;
    std::optional<glib::CommandId> meshOf{};  ///< the shape that Mesh has made it of
};

/// A texture or a part of it.
struct TextureView {
    TextureIndex texture{};
    std::optional<int> level{};  ///< one level
    std::optional<int> layer{};  ///< of an array or a 3D texture, or the face of a cube map
    bool isPrevious = false;     ///< the other copy of a texture with history
    SamplerIndex sampler{};      ///< none: the texture's own
    friend bool operator==(const TextureView&, const TextureView&) = default;
};

struct BufferView {
    BufferIndex buffer{};
    bool isPrevious = false;
    friend bool operator==(const BufferView&, const BufferView&) = default;
};

/// A count that a buffer holds: its 32-bit word of that number, counted from 0.
struct CountFrom {
    BufferView buffer{};
    std::uint64_t word = 0;
    explicit operator bool() const { return static_cast<bool>(buffer.buffer); }
    friend bool operator==(const CountFrom&, const CountFrom&) = default;
};

using ObjectView = std::variant<TextureView, BufferView>;

/// A sampler, image or block of a program that a tag binds to an object.
struct ObjectBinding {
    std::string tag;
    ObjectView object;
    glib::Position tagPosition{}, valuePosition{};
    bool mayBeUnknown = false;  ///< as in UniformSpec
    std::string resembles{};    ///< KeyedValues::resembles
    /// The value is a choice, or the counter of a Repeat over words, whose word names the object. Only a
    /// sampler, an image or a block takes the object; other uniforms take the value of the same tag.
    bool isChosen = false;
};

/// What draws set besides the values of their program's Program statement. Draws share these.
struct UniformSet {
    std::vector<glib::UniformSpec> values;
    std::vector<ObjectBinding> objects;
    std::vector<std::string> lost{};  ///< tags whose value has an error, which has been reported
};

/// A vertex input that an Attribute statement gives.
/// What a vertex input reads of the elements of a buffer.
struct ElementPart {
    std::string member{};                  ///< of a structure; empty: all of the element
    std::uint64_t offset = 0, stride = 0;  ///< bytes; stride 0: that of the elements
    [[nodiscard]] bool isBytes() const { return offset != 0 || stride != 0; }
    friend bool operator==(const ElementPart&, const ElementPart&) = default;
};

struct AttributeBinding {
    std::string name;
    /// A mesh attribute (geometry's name), one to four numbers, or a buffer.
    std::variant<std::string, std::vector<double>, BufferView> source;
    bool isPerInstance = false;  ///< of a buffer
    ElementPart part{};          ///< of a buffer
    Place place;
};
struct AttributeSet {
    std::vector<AttributeBinding> bindings;
};

/// How a draw samples its textures.
struct Sampling {
    bool clamp = false;  ///< clamp to edge, otherwise repeat (noise always repeats, cube maps always clamp)
    friend bool operator==(const Sampling&, const Sampling&) = default;
};

/// Units that hold the noise textures until a scene fills them; Noise2 and Noise3 without a tag read them.
inline constexpr int kNoise2Unit = 2;
inline constexpr int kNoise3Unit = 3;

/// One filled slot of the (unit, target) table. The first two elements of Scene::textures are the noise
/// textures: 2D on unit 2, 3D on unit 3.
struct Slot {
    int unit = 0;
    TextureTarget target = TextureTarget::texture2D;
    TextureIndex texture{};
};

/// The shader file of one stage that was current at a Program statement.
struct StageFile {
    glsl::Stage stage = glsl::Stage::vertex;
    FileIndex file{};
    bool isInherited = false;  ///< it has been stated for an earlier program
};

struct Program {
    std::string name;
    Place place;
    std::vector<StageFile> stages;  ///< a compute program has only that stage
    std::string geometryInput;      ///< a lower-case GLSL word, or empty
    std::string geometryOutput;
    int geometryVerticesOut = 0;
    /// In modern scenes: an earlier program follows the three statements, too. They then give way to the
    /// layouts of this program's shader in silence.
    bool sharesGeometryWords = false;
    std::vector<glib::UniformSpec> uniforms;
    std::vector<glsl::Constant> constants;  ///< values that its shaders are compiled with; each name once
    std::vector<Place> constantPlaces;      ///< of their names
    /// `isFill`: as a Fill sees the program, which leaves out what it inherits besides the fragment stage.
    [[nodiscard]] bool hasStage(glsl::Stage stage, bool isFill = false) const {
        for (const StageFile& each : stages)
            if (each.stage == stage && !(isFill && isLeftOutByFill(each))) return true;
        return false;
    }
    static bool isLeftOutByFill(const StageFile& stage) {
        return stage.isInherited && stage.stage != glsl::Stage::fragment;
    }
};

/// What a scene declares. Indices into these lists stay valid until the scene is read again.
struct Declarations {
    List<FileReference> files;
    List<Shape> shapes;
    List<Texture> textures;
    List<Sampler> samplers;
    List<Buffer> buffers;
    List<SlotTable> slotTables;
    List<UniformSet> uniformSets;
    List<AttributeSet> attributeSets;
    List<Program> programs;
};

}  // namespace glibra::scene

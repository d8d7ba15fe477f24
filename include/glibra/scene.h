#pragma once
// A scene that stays loaded: its values can be set and its picture drawn again, at the cost of drawing and
// reading pixels.

#include <glibra/diagnostic.h>
#include <glibra/export.h>
#include <glibra/render.h>
#include <glibra/result.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace glibra {

/// A value of a scene that can be set: a uniform variable of one of its programs, or a variable of the scene
/// (Let).
struct Value {
    std::string name;     ///< "uShininess", "lights[1].color"
    std::string program;  ///< the program that has the uniform; empty: a variable of the scene
    int programLine =
        0;             ///< of its Program statement, for names as "24:uShininess"; 0: a variable of the scene
    std::string type;  ///< GLSL's word: "float", "vec3", "int", "bool", "mat4"; of a variable likewise
    /// All components of the first array element, then of the next; matrices by columns. Arrays have the
    /// length that their declaration gives them.
    std::vector<double> value;
    std::vector<double> initial;      ///< as the scene has it
    bool hasRange = false;            ///< the scene states one, as <0 .5 1>
    double minimum = 0, maximum = 1;  ///< of the range. Values outside of it can be set
    std::vector<std::string> words;   ///< of a choice; the value counts them from 0
    Place place;                      ///< of the value in the scene
};

/// How one picture of a loaded scene is drawn. What is 0 is chosen by the scene.
struct DrawOptions {
    int width = 0, height = 0;  ///< pixels, 1 to 65536 and what the driver allows; 0: the scene's WindowSize
    double time = 0;            ///< seconds since loading, finite
    int samples = 0;            ///< per pixel, 1 to 64, limited to the driver's maximum; 0: one
    bool alpha = false;         ///< keeps the window's alpha; otherwise pictures are opaque
    bool floatPixels = false;   ///< 32-bit float pixels, not limited to 0..1
    bool axes = false;          ///< draws axes 1.5 units long at the origin of world space
    ViewState view{};           ///< transforms in addition to the scene's
};

/// Where Scene::drawInto() puts a picture, in the context that the renderer adopted.
struct Surface {
    std::uint32_t framebuffer = 0;  ///< the name of a framebuffer object; 0: the window's own
    std::uint32_t texture = 0;      ///< the name of a GL_TEXTURE_2D, whose level 0 then takes the picture
    int x = 0, y = 0;               ///< the lower left pixel of the picture
    int width = 0, height = 0;      ///< pixels; 0: those of the texture, else the scene's WindowSize
};

/// A texture of the scene as OpenGL has it. It belongs to the scene: others read it, and change neither its
/// content nor how it is sampled but by a sampler object of their own.
struct DeviceTexture {
    std::uint32_t name = 0;                ///< of glBindTexture
    std::uint32_t target = 0;              ///< GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, ...
    std::uint32_t format = 0;              ///< its internal format: GL_RGBA16F, ...
    int width = 1, height = 1, depth = 1;  ///< texels of level 0; layers count as depth
    int levels = 1;
};

/// The content of a buffer of the scene.
struct BufferContent {
    /// The numbers of one member of the head or of an element; matrices by columns. Each column has another
    /// name.
    struct Column {
        std::string name;        ///< "position"
        std::string type;        ///< of its numbers: "float", "int", "uint", "bool" (of 4 bytes), "double"
        std::size_t offset = 0;  ///< of the first number: bytes from the begin of the head or of the element
        std::size_t count = 1;   ///< numbers
        std::size_t stride =
            0;  ///< bytes from a number to the next; 0: they are unequal, as in a padded matrix
        /// Of each number: bytes from the begin of the head or of the element. The columns of a mat3 are 16
        /// bytes apart, and the numbers of a row_major matrix do not follow each other.
        std::vector<std::size_t> offsets;
    };
    std::vector<std::byte> bytes;  ///< all of it, as on the device
    std::vector<Column> head;      ///< members before the array
    std::vector<Column> columns;   ///< of an element of the array
    std::size_t headBytes = 0;     ///< where the array begins
    std::size_t stride = 0;        ///< bytes from element to element; 0: there is no array
    std::uint64_t elements = 0;    ///< of the array

    /// The numbers of a column of `columns`, in the element of that number; of a column of `head` with
    /// `isOfHead`. Empty for an element that there is not.
    [[nodiscard]] GLIBRA_API std::vector<double> numbers(const Column& column, std::uint64_t element = 0,
                                                         bool isOfHead = false) const;

    /// The element of that number as a T, which must have the layout of an element (std430).
    template <class T>
    [[nodiscard]] T element(std::uint64_t number) const {
        T to{};
        const std::size_t at = headBytes + static_cast<std::size_t>(number) * stride;
        if (at < bytes.size()) std::memcpy(&to, bytes.data() + at, std::min(sizeof to, bytes.size() - at));
        return to;
    }
};

/// Numbers in memory, for Scene::write(). What is left empty is not checked.
struct DataView {
    /// A member of a record; its numbers follow each other, those of a matrix by columns.
    struct Field {
        std::string name;        ///< as BufferContent::Column has it
        std::string type;        ///< as DataView::type
        std::size_t offset = 0;  ///< bytes from the begin of a record
        std::size_t count = 1;   ///< numbers
    };
    std::span<const std::byte> bytes;  ///< all of it, without gaps
    /// Of each number: "float32", "float64", "int8" to "int32", "uint8" to "uint32". Empty: records, which
    /// without `fields` lie as the elements on the device.
    std::string type{};
    std::vector<std::size_t> shape{};      ///< sizes of the array, that of neighbouring numbers last
    std::vector<Field> fields{};           ///< of a record
    std::size_t record = 1;                ///< bytes of a record
    std::optional<std::uint64_t> first{};  ///< the first element that is replaced; nothing: all are
    bool isOfHead = false;                 ///< replaces the members before the array of a buffer
};

/// The word of DataView::type for a C++ type; empty for what is no such number.
template <class T>
constexpr std::string_view numberWord() {
    constexpr bool isNumber = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
    if constexpr (!isNumber)
        return {};
    else if constexpr (std::is_floating_point_v<T>)
        return sizeof(T) == 4 ? "float32" : sizeof(T) == 8 ? "float64" : "long double";
    else if constexpr (std::is_signed_v<T>)
        return sizeof(T) == 1 ? "int8" : sizeof(T) == 2 ? "int16" : sizeof(T) == 4 ? "int32" : "int64";
    else
        return sizeof(T) == 1 ? "uint8" : sizeof(T) == 2 ? "uint16" : sizeof(T) == 4 ? "uint32" : "uint64";
}

/// A loaded scene. Use it on the thread of its Renderer, which it keeps alive; it may be destroyed on any
/// thread, and in a forked process. Calls of a scene that has been moved from return library-E05.
class GLIBRA_API Scene {
  public:
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;
    ~Scene();

    /// Draws the picture at a time. The first picture of a size makes what it is drawn into; all others cost
    /// drawing and reading. Errors: library-E01 for wrong options, gpu-E08 on a wrong thread and in a process
    /// that was forked after a renderer was opened, gpu-E06 or E07 after a reset of the device (the next call
    /// opens a new context and reads the scene again), and those of drawing.
    Result<Picture> draw(const DrawOptions& options = {});

    /// All values that can be set, in the order of the scene. None where problems() says why.
    [[nodiscard]] std::vector<Value> values() const;
    /// Why calls cannot be answered here and now: gpu-E08 on a wrong thread or in a forked process,
    /// library-E05, and what prevents reading the scene again after a reset of the device. Otherwise empty.
    [[nodiscard]] Diagnostics problems() const;
    /// Sets a value for the pictures that follow, in all programs that have it. "Glaze.uShininess" and, by
    /// the line of its Program statement, "24:uShininess" name that of one program. A text is a word of a
    /// choice, or numbers separated by commas or blanks. Errors: library-E02 if there is no such value, with
    /// the nearest name; library-E03 for numbers that do not fit its type: another count of them, fractions
    /// for an int, what is beyond the least or the largest number of an int, uint or float, and what is not
    /// finite.
    Result<void> set(std::string_view name, double value);
    Result<void> set(std::string_view name, int value);
    Result<void> set(std::string_view name, bool value);
    Result<void> set(std::string_view name, std::initializer_list<double> values);
    Result<void> set(std::string_view name, std::span<const double> values);
    Result<void> set(std::string_view name, std::string_view text);
    Result<void> set(std::string_view name, const char* text) { return set(name, std::string_view(text)); }

    /// Answers the Expect statements with the present values; those without a time of their own at `time`.
    /// Returns an error for each that does not hold. Draws with a copy of the scene of its own.
    [[nodiscard]] Diagnostics check(double time = 0);

    /// Draws a picture into a framebuffer or a texture of the caller's, without reading it back: its
    /// rectangle takes the picture's pixels, the bottom row first as OpenGL has them, in all colours that the
    /// framebuffer has for drawing. Depth and stencil stay, as does what lies outside of the rectangle. With
    /// `alpha` the alpha of the scene, otherwise 1. Colours are stored as they are, also in sRGB formats.
    /// Width and height of the options are 0 or the rectangle's. target() and buffer() then show this
    /// picture. Afterwards the state is that of the library (Renderer::open(Renderer::current())). Errors:
    /// library-E08 if the renderer has a context of its own, or for a framebuffer or texture that takes no
    /// picture, library-E01 for a rectangle that no picture has, and those of draw().
    Result<void> drawInto(const Surface& surface, const DrawOptions& options = {});
    /// A texture after the last picture, for draws of the caller's in the adopted context or one that shares
    /// its objects. With samples resolved and mipmaps made. It keeps its name until reload(), until the size
    /// of the picture changes, or a variable on which its size depends; its content until the next call.
    /// Errors: library-E04 if nothing has been drawn, library-E02 for a texture that there is not,
    /// library-E07 for one that the picture does not use, and library-E08 if the renderer has a context of
    /// its own.
    Result<DeviceTexture> deviceTexture(std::string_view name);

    /// "window": the last picture, in floats. Otherwise a texture or a part of one, as "shadow",
    /// "glow.level(2)", "sky.face(0)", "slices.layer(3)", after the last picture, top row first, in the
    /// components of its format and the type that loses nothing: integers of its bits, 8 or 16 bits for 0..1,
    /// otherwise floats. Errors: library-E04 if nothing has been drawn, library-E02
    /// for a texture or a part that there is not, draw-E10 for one that has no picture, such as all layers of
    /// an array at once.
    Result<Picture> target(std::string_view name);
    /// The content of a buffer after the last picture, also of one that the picture does not show: the scene
    /// is then drawn once more. Errors: library-E04 if nothing has been drawn, library-E02 if there is no
    /// such buffer, and those of drawing.
    Result<BufferContent> buffer(std::string_view name);

    /// Replaces level 0 of a texture, or elements of a buffer, for the pictures that follow. What was written
    /// takes the place of what the scene declares, in both copies of an object with history, until the scene
    /// is read again: Step blocks go on from it, what begins anew begins with it, and mipmaps are made if the
    /// scene asks for them. An empty texture whose size follows the picture's is empty again when that
    /// changes. check() does not see it: it draws with the data that the scene declares.
    ///
    /// A texture takes the numbers that target() gives for it: components of the format, bytes or 16 bits for
    /// 0..1, integers of its bits, otherwise floats, which may be NaN. Their shape is (height, width) with
    /// the components last, (width) in one dimension, with the layers or the six faces first. Rows are those
    /// of picture files: the top row first, t = 0 last. A volume (depth, height, width) has its texel (0, 0,
    /// 0) first, as raw texture files have.
    ///
    /// The elements of a buffer are records with the members of BufferContent::columns by name, whatever
    /// their order; numbers of one type, as many for each element as its members have together, without
    /// padding; or structures that lie as the elements on the device. All layouts are filled right.
    ///
    /// Errors: library-E02 for a name that the scene does not have, library-E03 for another type, shape or
    /// count, library-E07 for what the picture does not use, those of draw(), and draw-E05 without memory.
    /// Nothing is written then.
    Result<void> write(std::string_view name, const DataView& data);
    /// The same for a contiguous range: of numbers in the order of the shape, or of structures or bytes. With
    /// `first`, elements of a buffer from that one on.
    template <std::ranges::contiguous_range Range>
    Result<void> write(std::string_view name, const Range& data, std::optional<std::uint64_t> first = {}) {
        using Element = std::ranges::range_value_t<Range>;
        static_assert(std::is_trivially_copyable_v<Element>);
        const std::span<const Element> all(std::ranges::data(data), std::ranges::size(data));
        DataView view;
        view.bytes = std::as_bytes(all);
        view.type = numberWord<Element>();
        view.record = sizeof(Element);
        view.first = first;
        return write(name, view);
    }

    /// What was reported when the scene was read.
    [[nodiscard]] const Diagnostics& diagnostics() const;
    /// Every file that was read for it, the scene first.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;
    /// Counts of all pictures since loading, as "frames" and "draws".
    [[nodiscard]] std::map<std::string, std::uint64_t> stats() const;
    /// Reads the scene and its files again, those of a relative path in the folder that was the current one
    /// when it was loaded. Values that were set stay. After an error the scene is as it was.
    Result<void> reload();

  private:
    friend class Renderer;
    struct State;
    explicit Scene(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

template <std::invocable<const std::filesystem::path&> Reader>
Result<Scene> Renderer::loadText(std::string_view text, const std::string& name, Reader files,
                                 RenderOptions options) {
    options.reader = std::make_shared<const FileReader>(std::move(files));
    return loadText(text, name, std::map<std::string, std::string>(), options);
}

}  // namespace glibra

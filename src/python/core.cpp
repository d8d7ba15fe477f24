// The module glibra._core: the C++ library as Python sees it. What makes it pleasant is in
// glibra/__init__.py.

#include <glibra/glibra.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace {

using glibra::BufferContent;
using glibra::Comparison;
using glibra::Diagnostic;
using glibra::Diagnostics;
using glibra::DrawOptions;
using glibra::Picture;
using glibra::Result;
using glibra::Tolerance;
using glibra::Value;

/// Thrown where C++ returns a Result without a value; Python sees glibra.SceneError.
struct Failure {
    Diagnostics diagnostics;
};

template <class T>
T taken(Result<T> result) {
    if (!result) throw Failure{std::move(result.diagnostics)};
    return std::move(*result);
}
void taken(Result<void> result) {
    if (!result) throw Failure{std::move(result.diagnostics)};
}

/// The array owns the pixels: rows x columns x components, top row first.
py::array arrayOf(Picture picture) {
    auto* pixels = new std::vector<std::byte>(std::move(picture.data));
    const py::capsule owner(pixels, [](void* all) { delete static_cast<std::vector<std::byte>*>(all); });
    const char* kind = picture.isFloat ? "f" : picture.isSigned ? "i" : "u";
    const auto type = py::dtype::from_args(py::str(kind + std::to_string(picture.bits / 8)));
    const std::vector<py::ssize_t> shape{picture.height, picture.width, picture.components};
    return py::array(type, shape, pixels->data(), owner);
}

Picture pictureOf(const py::array& from) {
    const char kind = from.dtype().kind();
    if (from.ndim() != 2 && from.ndim() != 3)
        throw py::value_error("a picture is an array of rows, columns and components");
    if (kind != 'f' && !((kind == 'u' || kind == 'i') && from.itemsize() <= 4))
        throw py::value_error("the numbers of a picture are float32, or whole ones of 8, 16 or 32 bits");
    const std::string type = kind == 'f' ? "f4" : kind + std::to_string(from.itemsize());
    const py::array all = py::module_::import("numpy").attr("ascontiguousarray")(from, type);
    Picture picture;
    picture.height = static_cast<int>(all.shape(0));
    picture.width = static_cast<int>(all.shape(1));
    picture.components = all.ndim() == 3 ? static_cast<int>(all.shape(2)) : 1;
    picture.isFloat = kind == 'f';
    picture.isSigned = kind == 'i';
    picture.bits = static_cast<int>(8 * all.itemsize());
    const auto* bytes = static_cast<const std::byte*>(all.data());
    picture.data.assign(bytes, bytes + all.nbytes());
    return picture;
}

py::dtype typeOf(const BufferContent::Column& column) {
    const char* name = column.type == "double"  ? "f8"
                       : column.type == "int"   ? "i4"
                       : column.type == "float" ? "f4"
                                                : "u4";
    return py::dtype::from_args(py::str(name));
}

/// A structured array with a record for each element, or one record with the members before the array. The
/// numbers of a field follow each other, however they lie on the device.
py::array arrayOf(const BufferContent& content, bool isOfHead) {
    const std::vector<BufferContent::Column>& columns = isOfHead ? content.head : content.columns;
    py::list fields;
    for (const BufferContent::Column& each : columns) {
        const py::object type = typeOf(each);
        if (each.count == 1)
            fields.append(py::make_tuple(each.name, type));
        else
            fields.append(py::make_tuple(each.name, type, py::make_tuple(each.count)));
    }
    const auto count = isOfHead ? std::uint64_t{1} : content.elements;
    py::array to(py::dtype::from_args(fields), std::vector<py::ssize_t>{static_cast<py::ssize_t>(count)});
    const auto bytes = static_cast<std::size_t>(to.nbytes());
    auto* at = static_cast<std::byte*>(to.mutable_data());
    const std::byte* const end = at + bytes;
    const auto copy = [&](std::size_t from, std::size_t size) {
        if (from + size <= content.bytes.size() && at + size <= end)
            std::memcpy(at, content.bytes.data() + from, size);
        at += size;
    };
    for (std::uint64_t element = 0; element < count; ++element) {
        const std::size_t from =
            isOfHead ? 0 : content.headBytes + static_cast<std::size_t>(element) * content.stride;
        for (const BufferContent::Column& each : columns) {
            const std::size_t size = each.type == "double" ? sizeof(double) : sizeof(float);
            if (each.stride == size)
                copy(from + each.offset, size * each.count);
            else
                for (const std::size_t offset : each.offsets) copy(from + offset, size);
        }
    }
    return to;
}

/// A C-contiguous array, which must outlive the result.
glibra::DataView dataOf(const py::array& array) {
    glibra::DataView data;
    data.bytes = {static_cast<const std::byte*>(array.data()), static_cast<std::size_t>(array.nbytes())};
    data.shape.assign(array.shape(), array.shape() + array.ndim());
    data.record = static_cast<std::size_t>(array.itemsize());
    const py::dtype type = array.dtype();
    const py::object names = type.attr("names");
    if (names.is_none()) {
        data.type = type.attr("name").cast<std::string>();
        return data;
    }
    for (const py::handle name : names) {
        const py::tuple field = type.attr("fields")[name];
        std::size_t count = 1;
        for (const py::handle side : field[0].attr("shape")) count *= side.cast<std::size_t>();
        data.fields.push_back({name.cast<std::string>(),
                               field[0].attr("base").attr("name").cast<std::string>(),
                               field[1].cast<std::size_t>(), count});
    }
    return data;
}

py::list listOf(const Diagnostics& diagnostics) {
    py::list all;
    for (const Diagnostic& each : diagnostics) all.append(each);
    return all;
}

/// library-E01 for a whole number that no option has.
int intOf(const char* name, const py::object& value) {
    const py::object whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!whole) throw py::error_already_set();
    int isBeyond = 0;
    const long long number = PyLong_AsLongLongAndOverflow(whole.ptr(), &isBeyond);
    if (isBeyond != 0 || number != static_cast<int>(number))
        throw Failure{
            {glibra::diagnose("library-E01", std::string(name) + ": " + std::string(py::str(whole)) +
                                                 " is no number of pixels, samples or objects")}};
    return static_cast<int>(number);
}

/// The name of an object of OpenGL; one that no object has for numbers that are none.
std::uint32_t nameOf(const py::object& value) {
    const int number = intOf("name", value);
    return number < 0 ? ~0U : static_cast<std::uint32_t>(number);
}

DrawOptions optionsOf(const py::object& width, const py::object& height, double time,
                      const py::object& samples, bool alpha, bool floats, const std::vector<double>& eye,
                      bool axes) {
    DrawOptions options;
    if (eye.size() == options.view.eye.size()) std::copy(eye.begin(), eye.end(), options.view.eye.begin());
    options.width = intOf("width", width);
    options.height = intOf("height", height);
    options.time = time;
    options.samples = intOf("samples", samples);
    options.alpha = alpha;
    options.floatPixels = floats;
    options.axes = axes;
    return options;
}

glibra::RenderOptions loadOptionsOf(const py::dict& from) {
    glibra::RenderOptions to;
    to.within = from["within"].cast<std::filesystem::path>();
    to.libraryRoots = from["library"].cast<std::vector<std::filesystem::path>>();
    to.strict = from["strict"].cast<bool>();
    return to;
}

/// Those of a picture that is drawn once.
glibra::RenderOptions renderOptionsOf(const py::dict& from) {
    glibra::RenderOptions to = loadOptionsOf(from);
    const DrawOptions drawn =
        optionsOf(from["width"], from["height"], from["time"].cast<double>(), from["samples"],
                  from["alpha"].cast<bool>(), from["floats"].cast<bool>(),
                  from["eye"].cast<std::vector<double>>(), from["axes"].cast<bool>());
    to.width = drawn.width;
    to.height = drawn.height;
    to.time = drawn.time;
    to.samples = drawn.samples;
    to.alpha = drawn.alpha;
    to.floatPixels = drawn.floatPixels;
    to.axes = drawn.axes;
    to.viewState = drawn.view;
    to.set = from["set"].cast<std::vector<std::string>>();
    to.maxError = from["max_error"].cast<double>();
    to.overrideCounts = from["override_counts"].cast<bool>();
    return to;
}

/// The array and the remarks of a picture.
py::tuple drawnOf(Result<Picture> picture) {
    const Diagnostics remarks = picture ? picture.diagnostics : Diagnostics();
    return py::make_tuple(arrayOf(taken(std::move(picture))), listOf(remarks));
}

}  // namespace

PYBIND11_MODULE(_core, module) {
    module.attr("__version__") = GLIBRA_VERSION_STRING;

    py::class_<Diagnostic>(module, "Diagnostic",
                           "A message: str() of it is the line that the command line prints.")
        .def_readonly("id", &Diagnostic::id, "its id in the catalogue, as 'glib-W04'")
        .def_readonly("text", &Diagnostic::text)
        .def_property_readonly(
            "severity", [](const Diagnostic& each) { return glibra::name(each.severity); },
            "'error', 'warning' or 'note'")
        .def_property_readonly("file", [](const Diagnostic& each) { return each.place.file; })
        .def_property_readonly("line", [](const Diagnostic& each) { return each.place.line; })
        .def_property_readonly("column", [](const Diagnostic& each) { return each.place.column; })
        .def_readonly("subject", &Diagnostic::subject, "the name that the text is about, or ''")
        .def_readonly("suggestion", &Diagnostic::suggestion,
                      "the name that the text proposes in its place, or ''")
        .def("__str__", [](const Diagnostic& each) { return toString(each); })
        .def("__repr__", [](const Diagnostic& each) { return "<" + toString(each) + ">"; })
        .def("__eq__",
             [](const Diagnostic& one, const py::object& other) {
                 return py::isinstance<Diagnostic>(other) &&
                        toString(one) == toString(other.cast<Diagnostic>());
             })
        .def("__hash__", [](const Diagnostic& each) { return py::hash(py::str(toString(each))); })
        .def(py::pickle(
            [](const Diagnostic& each) {
                return py::make_tuple(static_cast<int>(each.severity), each.id, each.text, each.place.file,
                                      each.place.line, each.place.column, each.subject, each.suggestion);
            },
            [](const py::tuple& from) {
                return Diagnostic{static_cast<glibra::Severity>(from[0].cast<int>()),
                                  from[1].cast<std::string>(),
                                  from[2].cast<std::string>(),
                                  {from[3].cast<std::string>(), from[4].cast<int>(), from[5].cast<int>()},
                                  from[6].cast<std::string>(),
                                  from[7].cast<std::string>()};
            }));

    // The translator may run until the interpreter ends, and nothing may be released after that.
    static py::handle error;
    module.def("use_error", [](const py::object& type) { error = py::object(type).release(); });
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Failure& failure) {
            const py::object value = error(toString(failure.diagnostics), listOf(failure.diagnostics));
            PyErr_SetObject(error.ptr(), value.ptr());
        }
    });

    py::class_<Value>(module, "Value", "A value of a scene that can be set.")
        .def_readonly("name", &Value::name)
        .def_readonly("program", &Value::program,
                      "the program that has the uniform; '': a variable of the scene")
        .def_readonly("program_line", &Value::programLine, "the line of its Program statement; 0: a variable")
        .def_readonly("type", &Value::type, "GLSL's word: 'float', 'vec3'; of an array, that of an element")
        .def_readonly("value", &Value::value, "its numbers, of one for a scalar")
        .def_readonly("initial", &Value::initial, "the numbers in the scene")
        .def_readonly("words", &Value::words, "of a choice; the value counts them from 0")
        .def_property_readonly("file", [](const Value& each) { return each.place.file; })
        .def_property_readonly("line", [](const Value& each) { return each.place.line; })
        .def_property_readonly("column", [](const Value& each) { return each.place.column; })
        .def_property_readonly(
            "range",
            [](const Value& each) -> py::object {
                if (!each.hasRange) return py::none();
                return py::make_tuple(each.minimum, each.maximum);
            },
            "the least and the largest number of its slider, or None")
        .def("__repr__",
             [](const Value& each) {
                 std::string text = "<" + each.type + " " + each.name;
                 for (const double one : each.value) text += " " + std::string(py::str(py::float_(one)));
                 return text + ">";
             })
        .def(py::pickle(
            [](const Value& each) {
                return py::make_tuple(each.name, each.program, each.programLine, each.type, each.value,
                                      each.initial, each.hasRange, each.minimum, each.maximum, each.words,
                                      each.place.file, each.place.line, each.place.column);
            },
            [](const py::tuple& from) {
                Value to;
                to.name = from[0].cast<std::string>();
                to.program = from[1].cast<std::string>();
                to.programLine = from[2].cast<int>();
                to.type = from[3].cast<std::string>();
                to.value = from[4].cast<std::vector<double>>();
                to.initial = from[5].cast<std::vector<double>>();
                to.hasRange = from[6].cast<bool>();
                to.minimum = from[7].cast<double>();
                to.maximum = from[8].cast<double>();
                to.words = from[9].cast<std::vector<std::string>>();
                to.place = {from[10].cast<std::string>(), from[11].cast<int>(), from[12].cast<int>()};
                return to;
            }));

    py::class_<Comparison>(module, "Comparison", "How two pictures differ; true if they are the same.")
        .def_readonly("same", &Comparison::same)
        .def_readonly("reason", &Comparison::reason, "the figure that decided, and its limit")
        .def_readonly("differing_pixels", &Comparison::differingPixels)
        .def_readonly("largest", &Comparison::largest, "of a component, in 255ths of the range")
        .def_readonly("x", &Comparison::x, "where, from the left")
        .def_readonly("y", &Comparison::y, "where, from the top")
        .def_readonly("root_mean_square", &Comparison::rootMeanSquare, "in 255ths of the range")
        .def_readonly("flip", &Comparison::flip)
        .def_readonly("structure", &Comparison::structure)
        .def_property_readonly("diagnostics", [](const Comparison& each) { return listOf(each.diagnostics); })
        .def("__bool__", [](const Comparison& each) { return each.same; })
        .def("__repr__",
             [](const Comparison& each) {
                 return std::string("<") + (each.same ? "same: " : "different: ") + each.reason + ">";
             })
        .def(py::pickle(
            [](const Comparison& each) {
                return py::make_tuple(each.same, each.reason, each.differingPixels, each.largest, each.x,
                                      each.y, each.rootMeanSquare, each.flip, each.structure,
                                      listOf(each.diagnostics));
            },
            [](const py::tuple& from) {
                Comparison to;
                to.same = from[0].cast<bool>();
                to.reason = from[1].cast<std::string>();
                to.differingPixels = from[2].cast<std::uint64_t>();
                to.largest = from[3].cast<double>();
                to.x = from[4].cast<int>();
                to.y = from[5].cast<int>();
                to.rootMeanSquare = from[6].cast<double>();
                to.flip = from[7].cast<std::optional<double>>();
                to.structure = from[8].cast<std::optional<double>>();
                to.diagnostics = from[9].cast<Diagnostics>();
                return to;
            }));

    py::class_<glibra::Renderer>(module, "Renderer")
        .def(py::init([](const std::string& driver) {
                 const auto which = glibra::driverOfWord(driver);
                 if (!which)
                     throw py::value_error("driver: expected auto, egl, egl-device, osmesa, gles or wgl");
                 return taken(glibra::Renderer::open(*which));
             }),
             py::arg("driver") = "auto")
        .def_static("current", [] { return taken(glibra::Renderer::open(glibra::Renderer::current())); })
        .def("load",
             [](glibra::Renderer& renderer, const std::filesystem::path& path, const py::dict& options) {
                 return taken(renderer.load(path, loadOptionsOf(options)));
             })
        .def("render",
             [](glibra::Renderer& renderer, const std::filesystem::path& path, const py::dict& options) {
                 const glibra::RenderOptions read = renderOptionsOf(options);
                 Result<Picture> picture;
                 {
                     const py::gil_scoped_release others;
                     picture = renderer.render(path, read);
                 }
                 return drawnOf(std::move(picture));
             })
        .def("load_text", [](glibra::Renderer& renderer, const std::string& text, const std::string& name,
                             const std::map<std::string, std::string>& files, const py::dict& options) {
            return taken(renderer.loadText(text, name, files, loadOptionsOf(options)));
        });

    py::class_<glibra::Scene>(module, "Scene")
        .def("draw",
             [](glibra::Scene& scene, const py::object& width, const py::object& height, double time,
                const py::object& samples, bool alpha, bool floats, const std::vector<double>& eye,
                bool axes) {
                 const DrawOptions options =
                     optionsOf(width, height, time, samples, alpha, floats, eye, axes);
                 Result<Picture> picture;
                 {
                     const py::gil_scoped_release others;
                     picture = scene.draw(options);
                 }
                 return drawnOf(std::move(picture));
             })
        .def("draw_into",
             [](glibra::Scene& scene, const std::vector<py::object>& surface, double time,
                const py::object& samples, bool alpha, const std::vector<double>& eye, bool axes) {
                 const py::int_ none(0);
                 const DrawOptions options = optionsOf(none, none, time, samples, alpha, false, eye, axes);
                 const glibra::Surface to{nameOf(surface.at(0)),         nameOf(surface.at(1)),
                                          intOf("x", surface.at(2)),     intOf("y", surface.at(3)),
                                          intOf("width", surface.at(4)), intOf("height", surface.at(5))};
                 Result<void> drawn;
                 {
                     const py::gil_scoped_release others;
                     drawn = scene.drawInto(to, options);
                 }
                 const Diagnostics remarks = drawn.diagnostics;
                 taken(std::move(drawn));
                 return listOf(remarks);
             })
        .def("device_texture",
             [](glibra::Scene& scene, const std::string& name) {
                 const glibra::DeviceTexture texture = taken(scene.deviceTexture(name));
                 py::dict to;
                 to["name"] = texture.name;
                 to["target"] = texture.target;
                 to["format"] = texture.format;
                 to["size"] = py::make_tuple(texture.width, texture.height, texture.depth);
                 to["levels"] = texture.levels;
                 return to;
             })
        .def("values",
             [](const glibra::Scene& scene) {
                 std::vector<Value> values = scene.values();
                 if (values.empty())
                     if (Diagnostics problems = scene.problems(); !problems.empty()) throw Failure{problems};
                 return values;
             })
        .def("set", [](glibra::Scene& scene, const std::string& name,
                       const std::string& text) { taken(scene.set(name, text)); })
        .def("set_numbers",
             [](glibra::Scene& scene, const std::string& name, const std::vector<double>& numbers) {
                 taken(scene.set(name, std::span<const double>(numbers)));
             })
        .def("check",
             [](glibra::Scene& scene, double time) {
                 if (Diagnostics problems = scene.problems(); !problems.empty()) throw Failure{problems};
                 return listOf(scene.check(time));
             })
        .def("target",
             [](glibra::Scene& scene, const std::string& name) { return arrayOf(taken(scene.target(name))); })
        .def("buffer",
             [](glibra::Scene& scene, const std::string& name, bool isOfHead) {
                 const BufferContent content = taken(scene.buffer(name));
                 return arrayOf(content, isOfHead || content.stride == 0);
             })
        .def("write",
             [](glibra::Scene& scene, const std::string& name, const py::array& array,
                std::optional<std::uint64_t> first, bool isOfHead) {
                 glibra::DataView data = dataOf(array);
                 data.first = first;
                 data.isOfHead = isOfHead;
                 Result<void> written;
                 {
                     const py::gil_scoped_release others;
                     written = scene.write(name, data);
                 }
                 taken(std::move(written));
             })
        .def("diagnostics", [](const glibra::Scene& scene) { return listOf(scene.diagnostics()); })
        .def("files", &glibra::Scene::files)
        .def("stats", &glibra::Scene::stats)
        .def("reload", [](glibra::Scene& scene) { taken(scene.reload()); });

    module.def("save", [](const py::array& picture, const std::filesystem::path& file) {
        taken(pictureOf(picture).save(file));
    });
    module.def("compare", [](const py::object& got, const py::object& expected, double largest,
                             double fraction, double cluster, double line, double bias,
                             std::optional<double> flip, std::optional<double> structure, double relative,
                             double absolute, bool exact) {
        const auto whole = [](double number, const char* name) {
            if (number == std::floor(number) && std::abs(number) <= std::numeric_limits<int>::max())
                return static_cast<int>(number);
            throw Failure{{glibra::diagnose("library-E01", std::string(name) + ": " + std::to_string(number) +
                                                               " is not a whole number up to 2147483647")}};
        };
        Tolerance tolerance;
        tolerance.largest = largest;
        tolerance.fraction = fraction;
        tolerance.cluster = whole(cluster, "cluster");
        tolerance.line = whole(line, "line");
        tolerance.bias = bias;
        tolerance.flip = flip;
        tolerance.structure = structure;
        tolerance.relative = relative;
        tolerance.absolute = absolute;
        tolerance.exact = exact;
        const bool isFile = !py::isinstance<py::array>(got),
                   isOtherFile = !py::isinstance<py::array>(expected);
        Comparison found;
        if (isFile && isOtherFile)
            found =
                compare(got.cast<std::filesystem::path>(), expected.cast<std::filesystem::path>(), tolerance);
        else if (isOtherFile)
            found =
                compare(pictureOf(got.cast<py::array>()), expected.cast<std::filesystem::path>(), tolerance);
        else if (isFile)
            found =
                compare(pictureOf(expected.cast<py::array>()), got.cast<std::filesystem::path>(), tolerance);
        else
            found =
                compare(pictureOf(got.cast<py::array>()), pictureOf(expected.cast<py::array>()), tolerance);
        if (hasError(found.diagnostics)) throw Failure{found.diagnostics};
        return found;
    });
}

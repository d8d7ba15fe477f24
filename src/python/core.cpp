// The module glibra._core: the C++ library as Python sees it. What makes it pleasant is in
// glibra/__init__.py.

#include <glibra/glibra.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

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
    const py::dtype type = picture.isFloat      ? py::dtype::of<float>()
                           : picture.bits == 16 ? py::dtype::of<std::uint16_t>()
                                                : py::dtype::of<std::uint8_t>();
    const std::vector<py::ssize_t> shape{picture.height, picture.width, picture.components};
    return py::array(type, shape, pixels->data(), owner);
}

Picture pictureOf(const py::array& from) {
    const bool isFloat = from.dtype().kind() == 'f';
    const bool isWide = from.dtype().kind() == 'u' && from.itemsize() == 2;
    if (from.ndim() != 2 && from.ndim() != 3)
        throw py::value_error("a picture is an array of rows, columns and components");
    if (!isFloat && !(from.dtype().kind() == 'u' && from.itemsize() <= 2))
        throw py::value_error("the numbers of a picture are uint8, uint16 or float32");
    const py::array all =
        isFloat  ? py::array(py::array_t < float, py::array::c_style | py::array::forcecast > (from))
        : isWide ? py::array(py::array_t < std::uint16_t, py::array::c_style | py::array::forcecast > (from))
                 : py::array(py::array_t < std::uint8_t, py::array::c_style | py::array::forcecast > (from));
    Picture picture;
    picture.height = static_cast<int>(all.shape(0));
    picture.width = static_cast<int>(all.shape(1));
    picture.components = all.ndim() == 3 ? static_cast<int>(all.shape(2)) : 1;
    picture.isFloat = isFloat;
    picture.bits = static_cast<int>(8 * all.itemsize());
    const auto* bytes = static_cast<const std::byte*>(all.data());
    picture.data.assign(bytes, bytes + all.nbytes());
    return picture;
}

py::dtype typeOf(const BufferContent::Column& column) {
    const char* name = column.type == "double" ? "f8"
                       : column.type == "int"  ? "i4"
                       : column.type == "uint" ? "u4"
                                               : "f4";
    if (column.type == "bool") name = "u4";
    return py::dtype::from_args(py::str(name));
}

/// A structured array with a record for each element; of a buffer without an array, one record of its
/// members.
py::array arrayOf(const BufferContent& content) {
    const bool hasArray = content.stride > 0;
    const std::vector<BufferContent::Column>& columns = hasArray ? content.columns : content.head;
    py::list names, formats, offsets;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const BufferContent::Column& each = columns[i];
        names.append(each.name.empty() ? "f" + std::to_string(i) : each.name);
        if (each.count == 1)
            formats.append(typeOf(each));
        else
            formats.append(py::make_tuple(typeOf(each), py::make_tuple(each.count)));
        offsets.append(each.offset);
    }
    const std::size_t size = hasArray ? content.stride : content.bytes.size();
    const std::size_t count = hasArray ? static_cast<std::size_t>(content.elements) : 1;
    py::dict description;
    description["names"] = names;
    description["formats"] = formats;
    description["offsets"] = offsets;
    description["itemsize"] = size;
    const py::dtype type = py::dtype::from_args(description);
    py::array to(type, std::vector<py::ssize_t>{static_cast<py::ssize_t>(count)});
    const std::size_t from = hasArray ? content.headBytes : 0;
    const std::size_t bytes =
        std::min(count * size, content.bytes.size() - std::min(from, content.bytes.size()));
    std::memcpy(to.mutable_data(), content.bytes.data() + from, bytes);
    return to;
}

py::list listOf(const Diagnostics& diagnostics) {
    py::list all;
    for (const Diagnostic& each : diagnostics) all.append(each);
    return all;
}

DrawOptions optionsOf(int width, int height, double time, int samples, bool alpha, bool floats) {
    DrawOptions options;
    options.width = width;
    options.height = height;
    options.time = time;
    options.samples = samples;
    options.alpha = alpha;
    options.floatPixels = floats;
    return options;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
    module.attr("__version__") = GLIBRA_VERSION_STRING;

    py::class_<Diagnostic>(module, "Diagnostic")
        .def_readonly("id", &Diagnostic::id)
        .def_readonly("text", &Diagnostic::text)
        .def_property_readonly("severity", [](const Diagnostic& each) { return glibra::name(each.severity); })
        .def_property_readonly("file", [](const Diagnostic& each) { return each.place.file; })
        .def_property_readonly("line", [](const Diagnostic& each) { return each.place.line; })
        .def_property_readonly("column", [](const Diagnostic& each) { return each.place.column; })
        .def("__str__", [](const Diagnostic& each) { return toString(each); })
        .def("__repr__", [](const Diagnostic& each) { return "<" + toString(each) + ">"; });

    // The translator may run until the interpreter ends, and nothing may be released after that.
    static const py::handle error = PyErr_NewExceptionWithDoc(
        "glibra.SceneError", "What prevented a picture; `diagnostics` are the single messages.",
        PyExc_RuntimeError, nullptr);
    module.attr("SceneError") = error;
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Failure& failure) {
            const py::object value = error(toString(failure.diagnostics));
            value.attr("diagnostics") = listOf(failure.diagnostics);
            PyErr_SetObject(error.ptr(), value.ptr());
        }
    });

    py::class_<Value>(module, "Value")
        .def_readonly("name", &Value::name)
        .def_readonly("program", &Value::program)
        .def_readonly("type", &Value::type)
        .def_readonly("value", &Value::value)
        .def_readonly("initial", &Value::initial)
        .def_readonly("words", &Value::words)
        .def_property_readonly("range",
                               [](const Value& each) -> py::object {
                                   if (!each.hasRange) return py::none();
                                   return py::make_tuple(each.minimum, each.maximum);
                               })
        .def("__repr__", [](const Value& each) {
            std::string text = "<" + each.type + " " + each.name;
            for (const double one : each.value) text += " " + std::string(py::str(py::float_(one)));
            return text + ">";
        });

    py::class_<Comparison>(module, "Comparison")
        .def_readonly("same", &Comparison::same)
        .def_readonly("reason", &Comparison::reason)
        .def_readonly("differing_pixels", &Comparison::differingPixels)
        .def_readonly("largest", &Comparison::largest)
        .def_readonly("root_mean_square", &Comparison::rootMeanSquare)
        .def_readonly("flip", &Comparison::flip)
        .def_readonly("structure", &Comparison::structure)
        .def("__bool__", [](const Comparison& each) { return each.same; })
        .def("__repr__", [](const Comparison& each) {
            return std::string("<") + (each.same ? "same: " : "different: ") + each.reason + ">";
        });

    py::class_<glibra::Renderer>(module, "Renderer")
        .def(py::init([](const std::string& driver) {
                 const auto which = glibra::driverOfWord(driver);
                 if (!which) throw py::value_error("driver: expected auto, egl, egl-device or osmesa");
                 return taken(glibra::Renderer::open(*which));
             }),
             py::arg("driver") = "auto")
        .def("load", [](glibra::Renderer& renderer,
                        const std::filesystem::path& path) { return taken(renderer.load(path)); })
        .def("load_text", [](glibra::Renderer& renderer, const std::string& text, const std::string& name,
                             const std::map<std::string, std::string>& files) {
            return taken(renderer.loadText(text, name, files));
        });

    py::class_<glibra::Scene>(module, "Scene")
        .def("draw",
             [](glibra::Scene& scene, int width, int height, double time, int samples, bool alpha,
                bool floats) {
                 Result<Picture> picture;
                 {
                     const py::gil_scoped_release others;
                     picture = scene.draw(optionsOf(width, height, time, samples, alpha, floats));
                 }
                 return arrayOf(taken(std::move(picture)));
             })
        .def("values", &glibra::Scene::values)
        .def("set", [](glibra::Scene& scene, const std::string& name,
                       const std::string& text) { taken(scene.set(name, text)); })
        .def("set_numbers",
             [](glibra::Scene& scene, const std::string& name, const std::vector<double>& numbers) {
                 taken(scene.set(name, std::span<const double>(numbers)));
             })
        .def("check", [](glibra::Scene& scene, double time) { return listOf(scene.check(time)); })
        .def("target",
             [](glibra::Scene& scene, const std::string& name) { return arrayOf(taken(scene.target(name))); })
        .def("buffer",
             [](glibra::Scene& scene, const std::string& name) { return arrayOf(taken(scene.buffer(name))); })
        .def("diagnostics", [](const glibra::Scene& scene) { return listOf(scene.diagnostics()); })
        .def("files", &glibra::Scene::files)
        .def("stats", &glibra::Scene::stats)
        .def("reload", [](glibra::Scene& scene) { taken(scene.reload()); });

    module.def("save", [](const py::array& picture, const std::filesystem::path& file) {
        taken(pictureOf(picture).save(file));
    });
    module.def("compare", [](const py::object& got, const py::object& expected, double largest,
                             double fraction, int cluster, int line, double bias, std::optional<double> flip,
                             std::optional<double> structure, double relative, double absolute, bool exact) {
        Tolerance tolerance;
        tolerance.largest = largest;
        tolerance.fraction = fraction;
        tolerance.cluster = cluster;
        tolerance.line = line;
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
        if (!found.diagnostics.empty()) throw Failure{found.diagnostics};
        return found;
    });
}

"""A program with the types of the package, for `mypy --strict`; it is never run."""
import numpy

import glibra

scene = glibra.Scene("a.glib", library=["shaders"], current=True)
scene.uShininess = numpy.float32(20)
scene["lights[0].color"] = [1, 0, 0]
picture = scene.draw(numpy.int64(320), 240, time=numpy.float64(2), samples=4, dtype="float32", eye=numpy.identity(4))
glibra.save(picture, "a.png")
compared = glibra.compare(picture, "a.png", largest=numpy.float32(2), flip=.1)
print(compared.same, compared.flip, [each.range for each in scene.values], scene.files[0].name)
scene.write("volume", numpy.zeros((16, 32, 32), "float32"))
scene.write("points", numpy.zeros((5, 3)), first=numpy.uint64(2))
scene.draw_into(3, x=numpy.int32(1), y=2, width=3, height=4)
print(scene.device_texture("shadow")["name"], scene.buffer("points", head=True)["count"], scene.target().shape)
process = scene.view(time=1, wait=False)
if process is not None:
    print(process.wait())
other = glibra.Scene(text="Sphere", name="b.glib", files={"b.vert": b"", "b.png": picture})
try:
    other.check(numpy.float32(1))
except glibra.SceneError as error:
    print(error.id, error.line, [each.suggestion for each in error.diagnostics])
print(glibra.render("a.glib", 64, 48, set={"uA": 1, "uB": (1, 2), "uC": numpy.float32(1)}).dtype, other.film(2.0))

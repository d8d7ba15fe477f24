// Begins: the data of the page, and the module, which all its scenes share.

/** @typedef {import("./types.js").Scene} Scene */
import { App } from "./app.js";
import { make, unpacked, Unpacker } from "./dom.js";
import { Film } from "./film.js";
import { Runtime } from "./runtime.js";

/** @param {string} id */
const contentOf = (id) => document.getElementById(id)?.textContent ?? "";

/** @type {any} what the scripts of a site have set */
const site = globalThis;

/** @type {Promise<WebAssembly.Module> | undefined} */
let compiled;

/** @param {HTMLCanvasElement} canvas */
async function startOn(canvas) {
    compiled ??= unpacked(site.glibraRuntime ?? contentOf("glibra-runtime")).then((bytes) => WebAssembly.compile(bytes));
    return new Runtime(await compiled, canvas);
}

const place = document.querySelector(".live");
const data = /** @type {Scene} */ (place ? site.glibraScene ?? JSON.parse(contentOf("glibra-scene")) : {}), { film } = data;
if (place instanceof HTMLElement && (film || typeof WebAssembly === "object") && Unpacker)
    new App(place, data, film ? async (canvas) => new Film(film, canvas) : startOn);
else place?.append(make("p", { class: "remark", text: "This is a picture, because this browser has no WebAssembly." }));

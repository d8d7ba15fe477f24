/** @param {WebAssembly.Module} module @param {HTMLCanvasElement} canvas @returns {Promise<import("./types.js").Module>} */
export async function startModule(module, canvas) { throw new Error(`not there yet: ${module} ${canvas}`); }

// The functions of OpenGL ES 3.0 that the module of a live page imports, by WebGL 2. GL's names of objects are numbers, which
// tables here map to WebGL's objects; addresses are places in the module's memory.

/** @typedef {{memory: WebAssembly.Memory, allocate: (bytes: number) => number}} Module */
/** @typedef {(...values: any[]) => any} Call */

// What OpenGL ES has and WebGL has not.
const NUMBER = {
    EXTENSIONS: 0x1F03, MAJOR_VERSION: 0x821B, MINOR_VERSION: 0x821C, NUM_EXTENSIONS: 0x821D, CONTEXT_FLAGS: 0x821E,
    NUM_COMPRESSED_TEXTURE_FORMATS: 0x86A2, NUM_PROGRAM_BINARY_FORMATS: 0x87FE, NUM_SHADER_BINARY_FORMATS: 0x8DF9,
    SHADER_COMPILER: 0x8DFA, INFO_LOG_LENGTH: 0x8B84, SHADER_SOURCE_LENGTH: 0x8B88, ACTIVE_UNIFORM_MAX_LENGTH: 0x8B87,
    ACTIVE_ATTRIBUTE_MAX_LENGTH: 0x8B8A, ACTIVE_UNIFORM_BLOCK_MAX_NAME_LENGTH: 0x8A35, UNIFORM_BLOCK_NAME_LENGTH: 0x8A41,
    TRANSFORM_FEEDBACK_VARYING_MAX_LENGTH: 0x8C76, UNIFORM_NAME_LENGTH: 0x8A39, NUM_SAMPLE_COUNTS: 0x9380, PRIMITIVE_RESTART_FIXED_INDEX: 0x8D69,
};

// WebGL's extensions that are enabled where they are there, and other names that OpenGL ES has for them.
const EXTENSIONS = {
    EXT_color_buffer_float: [], EXT_color_buffer_half_float: [], EXT_float_blend: [], OES_texture_float_linear: [],
    EXT_texture_filter_anisotropic: [], EXT_texture_norm16: [], EXT_depth_clamp: [], EXT_clip_control: [],
    EXT_polygon_offset_clamp: [], EXT_texture_mirror_clamp_to_edge: [], OES_sample_variables: [],
    OES_shader_multisample_interpolation: [], KHR_parallel_shader_compile: [],
    OES_draw_buffers_indexed: ["EXT_draw_buffers_indexed"],
};

// What may fail although the call is right.
const FAILING = ["glBufferData", "glTexStorage2D", "glTexStorage3D", "glTexSubImage2D", "glTexSubImage3D", "glGenerateMipmap",
                 "glRenderbufferStorageMultisample", "glCheckFramebufferStatus", "glCompileShader", "glLinkProgram",
                 "glReadPixels", "glGetBufferSubData"];

// A letter for each argument that is no number: the name of an object, or a location (l) in the program in use.
const KINDS = {
    b: "Buffer", t: "Texture", f: "Framebuffer", r: "Renderbuffer", s: "Sampler", p: "Program", h: "Shader", q: "Query",
    v: "VertexArray", x: "TransformFeedback", y: "Sync",
};
const TAKES = {
    AttachShader: "ph", BeginQuery: ".q", BindBuffer: ".b", BindBufferBase: "..b", BindBufferRange: "..b..",
    BindFramebuffer: ".f", BindRenderbuffer: ".r", BindSampler: ".s", BindTexture: ".t", BindTransformFeedback: ".x",
    BindVertexArray: "v", CompileShader: "h", DeleteProgram: "p", DeleteShader: "h", DeleteSync: "y", DetachShader: "ph",
    FramebufferRenderbuffer: "...r", FramebufferTexture2D: "...t.", FramebufferTextureLayer: "..t..", LinkProgram: "p",
    SamplerParameterf: "s..", SamplerParameteri: "s..", Uniform1f: "l.", Uniform1i: "l.", UniformBlockBinding: "p..",
    UseProgram: "p", ValidateProgram: "p",
};

/** Objects by their numbers; 0 is none. */
class Names {
    constructor() {
        /** @type {any[]} */
        this.objects = [null];
        /** @type {Map<any, number>} */
        this.numbers = new Map();
    }
    /** @param {any} object */
    add(object) {
        if (!object) return 0;
        this.numbers.set(object, this.objects.length);
        return this.objects.push(object) - 1;
    }
    /** @param {number} number */
    remove(number) {
        const object = this.objects[number];
        this.numbers.delete(object);
        this.objects[number] = null;
        return object;
    }
}

/**
 * The imports of the module "gl".
 * @param {WebGL2RenderingContext} context
 * @param {Module} module what is there once the module runs
 * @returns {Record<string, Call>}
 */
export function glImports(context, module) {
    const gl = /** @type {any} */ (context);
    /** @type {Record<string, any>} */
    const extensions = {};
    /** @type {string[]} */
    const extensionNames = [];
    for (const [name, others] of Object.entries(EXTENSIONS)) {
        extensions[name] = gl.getExtension(name);
        if (extensions[name]) extensionNames.push(...[name, ...others].map((each) => `GL_${each}`));
    }

    // What WebGL does not know is an error without its warning in the console.
    const known = new Set([gl, ...Object.values(extensions)].flatMap((each) => {
        const numbers = [];
        for (const name in each)
            if (name === name.toUpperCase()) numbers.push(each[name]);
        return numbers;
    }));
    let isUnknown = false;

    // ---- The memory of the module

    /** @type {{buffer?: ArrayBuffer, [type: string]: any}} */
    let views = {};
    const memory = () => {
        const {buffer} = module.memory;
        if (views.buffer !== buffer)
            views = {
                buffer, u8: new Uint8Array(buffer), i8: new Int8Array(buffer), u16: new Uint16Array(buffer),
                i16: new Int16Array(buffer), u32: new Uint32Array(buffer), i32: new Int32Array(buffer),
                f32: new Float32Array(buffer), data: new DataView(buffer),
            };
        return views;
    };
    const setNumber = (/** @type {number} */ at, /** @type {number} */ value) => { if (at) memory().u32[at >> 2] = value; };
    const numbersAt = (/** @type {number} */ at, /** @type {number} */ count) =>
        Array.from(memory().u32.subarray(at >> 2, (at >> 2) + count));
    const textAt = (/** @type {number} */ at, length = -1) =>
        new TextDecoder().decode(memory().u8.subarray(at, length < 0 ? memory().u8.indexOf(0, at) : at + length));
    /** Writes a text, cut to `size` bytes with its zero. */
    const setText = (/** @type {string} */ text, /** @type {number} */ size, /** @type {number} */ lengthAt,
                     /** @type {number} */ at) => {
        if (size <= 0) return;
        const bytes = new TextEncoder().encode(text).subarray(0, size - 1);
        memory().u8.set(bytes, at);
        memory().u8[at + bytes.length] = 0;
        setNumber(lengthAt, bytes.length);
    };
    const lengthOf = (/** @type {string | null} */ text) => text ? new TextEncoder().encode(text).length + 1 : 0;
    /** @type {Map<string, number>} */
    const kept = new Map();
    /** The address of a text that stays. */
    const keep = (/** @type {string} */ text) => {
        const before = kept.get(text);
        if (before !== undefined) return before;
        const size = lengthOf(text) || 1, at = module.allocate(size);
        setText(text, size, 0, at);
        kept.set(text, at);
        return at;
    };

    // ---- Objects

    /** @type {Record<string, Names>} */
    const names = {};
    for (const letter of Object.keys(KINDS)) names[letter] = new Names();
    // Those of all programs are different numbers.
    /** @type {any[]} */
    const locations = [];
    /** @type {WeakMap<any, Map<string, number>>} */
    const locationsOf = new WeakMap();
    const locationOf = (/** @type {number} */ number) => number < 0 ? null : locations[number];
    let packs = false, unpacks = false;  // pixels go to buffers, and come from them
    // Only a buffer that is bound first for indices may hold some. Until one is bound to another target than that of uploads,
    // its content waits here.
    /** @type {Map<number, {content: number | Uint8Array, usage: number} | null>} */
    const waiting = new Map();
    let mayFail = true, asked = 0;  // glGetError
    /** The one that is bound for uploads, and the one that is bound for reading, if they wait. */
    let uploaded = 0, read = 0;
    /** The content that has waited, or nothing. */
    const waitingContent = (/** @type {number} */ target) => {
        const number = target === gl.COPY_WRITE_BUFFER ? uploaded : target === gl.COPY_READ_BUFFER ? read : 0;
        const of = number ? waiting.get(number) : null;
        if (of && typeof of.content === "number") of.content = new Uint8Array(of.content);
        return of ? /** @type {Uint8Array} */ (of.content) : null;
    };

    /** @type {Record<string, Call>} */
    const calls = {};
    for (const [letter, kind] of Object.entries(KINDS)) {
        const plural = kind === "Query" ? "Queries" : `${kind}s`;
        if ("phy".includes(letter)) continue;
        calls[`glGen${plural}`] = (count, at) => {
            for (let i = 0; i < count; ++i) {
                const number = names[letter].add(gl[`create${kind}`]());
                setNumber(at + 4 * i, number);
                if (letter === "b") waiting.set(number, null);
            }
        };
        calls[`glDelete${plural}`] = (count, at) => {
            for (const each of numbersAt(at, count)) {
                gl[`delete${kind}`](names[letter].remove(each));
                if (letter !== "b") continue;
                waiting.delete(each);
                if (uploaded === each) uploaded = 0;
                if (read === each) read = 0;
            }
        };
    }
    for (const [name, letters] of Object.entries(TAKES)) {
        const call = gl[name[0].toLowerCase() + name.slice(1)].bind(gl);
        const tables = [...letters].map((letter) => letter === "." ? null : letter === "l" ? locations : names[letter].objects);
        calls[`gl${name}`] = (...values) => {
            for (let i = 0; i < tables.length; ++i) {
                const table = tables[i];
                if (table) values[i] = table[values[i]] ?? null;
            }
            call(...values);
        };
    }
    /** Binds a buffer by a call, and gives it the content that has waited. */
    const bind = (/** @type {number} */ target, /** @type {number} */ number, /** @type {() => void} */ call) => {
        const content = waiting.get(number);
        waiting.delete(number);
        call();
        if (content) gl.bufferData(target, content.content, content.usage);
        if (number && (uploaded === number || read === number)) settle();
    };
    /** What is bound for uploads is so in WebGL, too. */
    const settle = () => {
        for (const [target, number] of [[gl.COPY_WRITE_BUFFER, uploaded], [gl.COPY_READ_BUFFER, read]]) {
            if (target === gl.COPY_WRITE_BUFFER) uploaded = 0; else read = 0;
            if (number) bind(target, number, () => glBindBuffer(target, number));
        }
    };
    const {glBindBuffer, glBindBufferBase, glBindBufferRange, glDeleteProgram, glDeleteShader, glDeleteSync, glLinkProgram} = calls;
    Object.assign(calls, /** @type {Record<string, Call>} */ ({
        glCreateProgram: () => names.p.add(gl.createProgram()),
        glCreateShader: (kind) => names.h.add(gl.createShader(kind)),
        glDeleteProgram: (number) => { glDeleteProgram(number); names.p.remove(number); },
        glDeleteShader: (number) => { glDeleteShader(number); names.h.remove(number); },
        glDeleteSync: (number) => { glDeleteSync(number); names.y.remove(number); },
        glBindBuffer: (target, number) => {
            if (target === gl.PIXEL_PACK_BUFFER) packs = number !== 0;
            if (target === gl.PIXEL_UNPACK_BUFFER) unpacks = number !== 0;
            if (target === gl.COPY_WRITE_BUFFER && (uploaded = waiting.has(number) ? number : 0)) return;
            if (target === gl.COPY_READ_BUFFER && (read = waiting.get(number) ? number : 0)) return;
            bind(target, number, () => glBindBuffer(target, number));
        },
        glBindBufferBase: (target, index, number) => bind(target, number, () => glBindBufferBase(target, index, number)),
        glBindBufferRange: (target, index, number, ...range) =>
            bind(target, number, () => glBindBufferRange(target, index, number, ...range)),
        glLinkProgram: (number) => {
            locationsOf.delete(names.p.objects[number]);
            glLinkProgram(number);
        },
        glFenceSync: (condition, flags) => names.y.add(gl.fenceSync(condition, flags)),
        // WebGL tells of an end only after the script has returned, and its finish() does not wait. What reads waits for all.
        glFinish: () => {
            const bound = [gl.READ_FRAMEBUFFER_BINDING, gl.PIXEL_PACK_BUFFER_BINDING].map((each) => gl.getParameter(each));
            gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
            gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
            gl.bindBuffer(gl.PIXEL_PACK_BUFFER, bound[1]);
            gl.bindFramebuffer(gl.READ_FRAMEBUFFER, bound[0]);
        },
        glClientWaitSync: () => { calls.glFinish(); return gl.CONDITION_SATISFIED; },
    }));

    // ---- Numbers that GL gives

    /** What getParameter() and the like give, as numbers. @returns {number[]} */
    const asNumbers = (/** @type {any} */ value) => {
        if (value === null || value === undefined) return [0];
        if (typeof value === "number") return [value];
        if (typeof value === "boolean") return [value ? 1 : 0];
        if (typeof value[Symbol.iterator] === "function" && typeof value !== "string") return Array.from(value, Number);
        for (const each of Object.values(names)) {
            const number = each.numbers.get(value);
            if (number !== undefined) return [number];
        }
        return [0];
    };
    const parameter = (/** @type {number} */ name) => {
        switch (name) {
            case NUMBER.MAJOR_VERSION: return [3];
            case NUMBER.NUM_EXTENSIONS: return [extensionNames.length];
            case NUMBER.SHADER_COMPILER: return [1];
            case NUMBER.MINOR_VERSION: case NUMBER.CONTEXT_FLAGS: case NUMBER.NUM_COMPRESSED_TEXTURE_FORMATS:
            case NUMBER.NUM_PROGRAM_BINARY_FORMATS: case NUMBER.NUM_SHADER_BINARY_FORMATS: return [0];
        }
        if (known.has(name)) return asNumbers(gl.getParameter(name));
        isUnknown = true;
        return [0];
    };
    const setNumbers = (/** @type {number[]} */ all, /** @type {number} */ at, view = "u32") => {
        memory()[view].set(all, at >> 2);
    };
    const longest = (/** @type {number} */ count, /** @type {(index: number) => {name: string} | null} */ get) => {
        let most = 0;
        for (let i = 0; i < count; ++i) most = Math.max(most, lengthOf(get(i)?.name ?? null));
        return most;
    };
    const programParameter = (/** @type {any} */ of, /** @type {number} */ name) => {
        const count = (/** @type {number} */ what) => gl.getProgramParameter(of, what);
        switch (name) {
            case NUMBER.INFO_LOG_LENGTH: return [lengthOf(gl.getProgramInfoLog(of))];
            case NUMBER.ACTIVE_UNIFORM_MAX_LENGTH:
                return [longest(count(gl.ACTIVE_UNIFORMS), (i) => gl.getActiveUniform(of, i))];
            case NUMBER.ACTIVE_ATTRIBUTE_MAX_LENGTH:
                return [longest(count(gl.ACTIVE_ATTRIBUTES), (i) => gl.getActiveAttrib(of, i))];
            case NUMBER.ACTIVE_UNIFORM_BLOCK_MAX_NAME_LENGTH:
                return [longest(count(gl.ACTIVE_UNIFORM_BLOCKS), (i) => ({name: gl.getActiveUniformBlockName(of, i)}))];
            case NUMBER.TRANSFORM_FEEDBACK_VARYING_MAX_LENGTH:
                return [longest(count(gl.TRANSFORM_FEEDBACK_VARYINGS), (i) => gl.getTransformFeedbackVarying(of, i))];
            default: return asNumbers(gl.getProgramParameter(of, name));
        }
    };
    const active = (/** @type {string} */ get) => (/** @type {number[]} */ ...[of, index, size, lengthAt, countAt, typeAt, at]) => {
        const found = gl[get](names.p.objects[of], index);
        if (!found) return;
        setNumber(countAt, found.size);
        setNumber(typeAt, found.type);
        setText(found.name, size, lengthAt, at);
    };
    const log = (/** @type {string} */ get, /** @type {string} */ letter) =>
        (/** @type {number[]} */ ...[of, size, lengthAt, at]) =>
            setText(gl[get](names[letter].objects[of]) ?? "", size, lengthAt, at);
    const uniformInto = (/** @type {string} */ view) => (/** @type {number[]} */ ...[of, location, at]) =>
        setNumbers(asNumbers(gl.getUniform(names.p.objects[of], locationOf(location))), at, view);

    Object.assign(calls, /** @type {Record<string, Call>} */ ({
        // To answer, the browser waits for all work: asked after what allocates or builds, otherwise once a second.
        glGetError: () => {
            const unknown = isUnknown, now = performance.now();
            isUnknown = false;
            if (unknown) return gl.INVALID_ENUM;
            if (!mayFail && now - asked < 1000) return gl.NO_ERROR;
            asked = now;
            const error = gl.getError();
            mayFail = error !== gl.NO_ERROR;
            return error;
        },
        glGetIntegerv: (name, at) => setNumbers(parameter(name), at, "i32"),
        glGetFloatv: (name, at) => setNumbers(parameter(name), at, "f32"),
        glGetBooleanv: (name, at) => memory().u8.set(parameter(name).map((each) => each ? 1 : 0), at),
        glGetInteger64v: (name, at) => parameter(name).forEach(
            (each, i) => memory().data.setBigInt64(at + 8 * i, BigInt(Math.round(each)), true)),
        glGetString: (name) => {
            const text = name === NUMBER.EXTENSIONS ? extensionNames.join(" ") : String(gl.getParameter(name) ?? "");
            // WebGL's own numbers of versions follow those of OpenGL ES in text that others parse.
            return keep(name === gl.VERSION ? `OpenGL ES 3.0 (${text})`
                        : name === gl.SHADING_LANGUAGE_VERSION ? `OpenGL ES GLSL ES 3.00 (${text})` : text);
        },
        glGetStringi: (name, index) =>
            name === NUMBER.EXTENSIONS && index < extensionNames.length ? keep(extensionNames[index]) : 0,
        glGetProgramiv: (of, name, at) => setNumbers(programParameter(names.p.objects[of], name), at, "i32"),
        glGetShaderiv: (of, name, at) => {
            const shader = names.h.objects[of];
            setNumbers(name === NUMBER.INFO_LOG_LENGTH ? [lengthOf(gl.getShaderInfoLog(shader))]
                       : name === NUMBER.SHADER_SOURCE_LENGTH ? [lengthOf(gl.getShaderSource(shader))]
                       : asNumbers(gl.getShaderParameter(shader, name)), at, "i32");
        },
        glGetProgramInfoLog: log("getProgramInfoLog", "p"),
        glGetShaderInfoLog: log("getShaderInfoLog", "h"),
        glGetActiveAttrib: active("getActiveAttrib"),
        glGetActiveUniform: active("getActiveUniform"),
        glGetTransformFeedbackVarying: active("getTransformFeedbackVarying"),
        glGetActiveUniformBlockName: (of, index, size, lengthAt, at) =>
            setText(gl.getActiveUniformBlockName(names.p.objects[of], index) ?? "", size, lengthAt, at),
        glGetActiveUniformBlockiv: (of, index, name, at) => {
            const object = names.p.objects[of];
            setNumbers(name === NUMBER.UNIFORM_BLOCK_NAME_LENGTH ? [lengthOf(gl.getActiveUniformBlockName(object, index))]
                       : asNumbers(gl.getActiveUniformBlockParameter(object, index, name)), at, "i32");
        },
        glGetActiveUniformsiv: (of, count, indicesAt, name, at) => {
            const object = names.p.objects[of], indices = numbersAt(indicesAt, count);
            setNumbers(name === NUMBER.UNIFORM_NAME_LENGTH
                           ? indices.map((each) => lengthOf(gl.getActiveUniform(object, each)?.name ?? null))
                           : asNumbers(gl.getActiveUniforms(object, indices, name)), at, "i32");
        },
        glGetUniformLocation: (of, at) => {
            const object = names.p.objects[of], name = textAt(at);
            let all = locationsOf.get(object);
            if (!all) locationsOf.set(object, all = new Map());
            let number = all.get(name);
            if (number !== undefined) return number;
            const location = gl.getUniformLocation(object, name);
            number = location ? locations.push(location) - 1 : -1;
            // The elements of an array follow one another.
            const array = name.replace(/\[0\]$/, "");
            for (let i = 1, next; location && (next = gl.getUniformLocation(object, `${array}[${i}]`)); ++i) locations.push(next);
            all.set(name, number);
            return number;
        },
        glGetAttribLocation: (of, at) => gl.getAttribLocation(names.p.objects[of], textAt(at)),
        glGetFragDataLocation: (of, at) => gl.getFragDataLocation(names.p.objects[of], textAt(at)),
        glGetUniformBlockIndex: (of, at) => gl.getUniformBlockIndex(names.p.objects[of], textAt(at)) ?? gl.INVALID_INDEX,
        glGetUniformfv: uniformInto("f32"),
        glGetUniformiv: uniformInto("i32"),
        glGetUniformuiv: uniformInto("u32"),
        glGetQueryObjectuiv: (of, name, at) => setNumbers(asNumbers(gl.getQueryParameter(names.q.objects[of], name)), at),
        glGetRenderbufferParameteriv: (target, name, at) =>
            setNumbers(asNumbers(gl.getRenderbufferParameter(target, name)), at, "i32"),
        glGetFramebufferAttachmentParameteriv: (target, point, name, at) =>
            setNumbers(asNumbers(gl.getFramebufferAttachmentParameter(target, point, name)), at, "i32"),
        glGetInternalformativ: (target, format, name, size, at) => {
            const samples = asNumbers(gl.getInternalformatParameter(target, format, gl.SAMPLES) ?? []);
            setNumbers(name === NUMBER.NUM_SAMPLE_COUNTS ? [samples.length] : samples.slice(0, size), at, "i32");
        },
    }));

    // ---- Contents

    /** @type {Record<number, [string, number]>} */
    const texelViews = {
        [gl.BYTE]: ["i8", 0], [gl.UNSIGNED_BYTE]: ["u8", 0], [gl.SHORT]: ["i16", 1], [gl.INT]: ["i32", 2],
        [gl.UNSIGNED_INT]: ["u32", 2], [gl.FLOAT]: ["f32", 2], [gl.UNSIGNED_INT_24_8]: ["u32", 2],
        [gl.UNSIGNED_INT_2_10_10_10_REV]: ["u32", 2], [gl.UNSIGNED_INT_10F_11F_11F_REV]: ["u32", 2],
        [gl.UNSIGNED_INT_5_9_9_9_REV]: ["u32", 2],
    };
    /** The arguments by which WebGL finds texels: the last one of GL is their type. @returns {any[]} */
    const texelsAt = (/** @type {number} */ type, /** @type {number} */ at, /** @type {boolean} */ inBuffer) => {
        if (inBuffer) return [at];
        if (!at) return [null];
        const [view, shift] = texelViews[type] ?? ["u16", 1];
        return [memory()[view], at >> shift];
    };
    const upload = (/** @type {string} */ name) => (/** @type {any[]} */ ...values) => {
        const at = values.pop();
        gl[name](...values, ...texelsAt(values[values.length - 1], at, unpacks));
    };
    const clear = (/** @type {string} */ name, /** @type {string} */ view) =>
        (/** @type {number[]} */ ...[buffer, index, at]) => gl[name](buffer, index, memory()[view], at >> 2);

    Object.assign(calls, /** @type {Record<string, Call>} */ ({
        glBindAttribLocation: (of, index, at) => gl.bindAttribLocation(names.p.objects[of], index, textAt(at)),
        glShaderSource: (of, count, textsAt, lengthsAt) => {
            const texts = numbersAt(textsAt, count);
            const lengths = lengthsAt ? numbersAt(lengthsAt, count).map((each) => each | 0) : [];
            gl.shaderSource(names.h.objects[of], texts.map((at, i) => textAt(at, lengths[i] ?? -1)).join(""));
        },
        glTransformFeedbackVaryings: (of, count, textsAt, mode) => gl.transformFeedbackVaryings(
            names.p.objects[of], numbersAt(textsAt, count).map((at) => textAt(at)), mode),
        // Indices always restart.
        glEnable: (what) => { if (what !== NUMBER.PRIMITIVE_RESTART_FIXED_INDEX) gl.enable(what); },
        glDisable: (what) => { if (what !== NUMBER.PRIMITIVE_RESTART_FIXED_INDEX) gl.disable(what); },
        glDrawBuffers: (count, at) => gl.drawBuffers(numbersAt(at, count)),
        glBufferData: (target, size, at, usage) => {
            if (uploaded && target === gl.COPY_WRITE_BUFFER)
                waiting.set(uploaded, {content: at ? memory().u8.slice(at, at + size) : size, usage});
            else if (at)
                gl.bufferData(target, memory().u8, usage, at, size);
            else
                gl.bufferData(target, size, usage);
        },
        glBufferSubData: (target, offset, size, at) => {
            const content = waitingContent(target);
            if (content) content.set(memory().u8.subarray(at, at + size), offset);
            else if (size > 0) gl.bufferSubData(target, offset, memory().u8, at, size);
        },
        glGetBufferSubData: (target, offset, size, at) => {
            const content = waitingContent(target);
            if (content) memory().u8.set(content.subarray(offset, offset + size), at);
            else if (size > 0) gl.getBufferSubData(target, offset, memory().u8, at, size);
        },
        glCopyBufferSubData: (source, target, at, to, size) => {
            const from = waitingContent(source), into = waitingContent(target);
            if (!from && !into) return gl.copyBufferSubData(source, target, at, to, size);
            const bytes = from?.subarray(at, at + size) ?? new Uint8Array(size);  // WebGL copies no other data to indices
            if (!from) gl.getBufferSubData(source, at, bytes);
            if (into) into.set(bytes, to); else gl.bufferSubData(target, to, bytes);
        },
        glTexImage2D: upload("texImage2D"),
        glTexImage3D: upload("texImage3D"),
        glTexSubImage2D: upload("texSubImage2D"),
        glTexSubImage3D: upload("texSubImage3D"),
        glReadPixels: (x, y, width, height, format, type, at) =>
            gl.readPixels(x, y, width, height, format, type, ...texelsAt(type, at, packs)),
        glClearBufferfv: clear("clearBufferfv", "f32"),
        glClearBufferiv: clear("clearBufferiv", "i32"),
        glClearBufferuiv: clear("clearBufferuiv", "u32"),
    }));
    for (const [type, view] of [["f", "f32"], ["i", "i32"], ["ui", "u32"]])
        for (let size = 1; size <= 4; ++size) {
            const set = gl[`uniform${size}${type}v`].bind(gl);
            calls[`glUniform${size}${type}v`] = (location, count, at) =>
                set(locationOf(location), memory()[view], at >> 2, count * size);
        }
    for (const columns of [2, 3, 4])
        for (const rows of [2, 3, 4]) {
            const name = columns === rows ? `${columns}` : `${columns}x${rows}`;
            const set = gl[`uniformMatrix${name}fv`].bind(gl);
            calls[`glUniformMatrix${name}fv`] = (location, count, transposes, at) =>
                set(locationOf(location), transposes, memory().f32, at >> 2, count * columns * rows);
        }

    const indexed = extensions.OES_draw_buffers_indexed;
    if (indexed)
        for (const name of ["enablei", "disablei", "colorMaski", "blendEquationi", "blendEquationSeparatei", "blendFunci",
                            "blendFuncSeparatei"])
            calls[`gl${name[0].toUpperCase()}${name.slice(1)}`] = indexed[`${name}OES`].bind(indexed);
    if (extensions.EXT_clip_control) calls.glClipControl = (...values) => extensions.EXT_clip_control.clipControlEXT(...values);

    /** What is not above takes numbers alone, or WebGL lacks it. @returns {Call | undefined} */
    const find = (/** @type {string} */ name) => {
        const own = name[2]?.toLowerCase() + name.slice(3).replace(/(Depth|Range)f$/, "$1");
        if (!calls[name] && typeof gl[own] === "function") calls[name] = gl[own].bind(gl);
        return calls[name];
    };
    for (const name of FAILING) {
        const call = find(name);
        if (call) calls[name] = (...values) => {
            mayFail = true;
            return call(...values);
        };
    }

    // ---- The module's imports

    return new Proxy({}, {
        get: (_, name) => name === "has" ? (/** @type {number} */ at) => find(textAt(at)) ? 1 : 0
                          : find(String(name)) ?? (() => { throw new Error(`WebGL 2 has no ${String(name)}`); }),
    });
}

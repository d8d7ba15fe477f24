// The few functions of WASI that the module of a live page imports: a clock, random numbers and messages. There are no files.

/** @typedef {(...values: any[]) => any} Call */

const SUCCESS = 0, BAD_FILE = 8;

/**
 * @param {{memory: WebAssembly.Memory}} module what is there once the module runs
 * @param {(text: string) => void} print gets what the module writes, in lines
 * @returns {Record<string, Call>}
 */
export function wasiImports(module, print) {
    const data = () => new DataView(module.memory.buffer);
    let line = "";
    return {
        environ_get: () => SUCCESS,
        environ_sizes_get: (countAt, bytesAt) => {
            data().setUint32(countAt, 0, true);
            data().setUint32(bytesAt, 0, true);
            return SUCCESS;
        },
        clock_time_get: (clock, _precision, at) => {
            const milliseconds = clock === 0 ? Date.now() : performance.now();
            data().setBigUint64(at, BigInt(Math.round(milliseconds * 1e6)), true);
            return SUCCESS;
        },
        random_get: (at, bytes) => {
            crypto.getRandomValues(new Uint8Array(module.memory.buffer, at, bytes));
            return SUCCESS;
        },
        fd_write: (_file, partsAt, count, writtenAt) => {
            let written = 0;
            for (let i = 0; i < count; ++i) {
                const at = data().getUint32(partsAt + 8 * i, true), bytes = data().getUint32(partsAt + 8 * i + 4, true);
                line += new TextDecoder().decode(new Uint8Array(module.memory.buffer, at, bytes));
                written += bytes;
            }
            data().setUint32(writtenAt, written, true);
            const lines = line.split("\n");
            line = lines.pop() ?? "";
            lines.forEach(print);
            return SUCCESS;
        },
        ...Object.fromEntries(["fd_close", "fd_seek", "fd_read", "fd_fdstat_get"].map((each) => [each, () => BAD_FILE])),
        proc_exit: (status) => { throw new Error(`the module ended with status ${status}`); },
    };
}

// Elements, and what a page has packed.

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, string | number | boolean | ((event: any) => void)>} [attributes] functions listen to events;
 *     `text` is the content; true stands for an attribute without a value, and false for none
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (typeof value === "function") element.addEventListener(name, value);
        else if (name === "text") element.textContent = String(value);
        else if (value !== false) element.setAttribute(name, value === true ? "" : String(value));
    }
    element.append(...children);
    return element;
}

// 16 x 16, as paths.
const kIcons = {
    play: "M4 2.5v11l9-5.5z",
    pause: "M4 2.5h3v11H4zm5 0h3v11H9z",
    back: "M10.5 3v10L3.5 8zM12 3h1.5v10H12z",
    forward: "M5.5 3v10l7-5zM2.5 3H4v10H2.5z",
    restart: "M8 2.5V.5L4.5 3.5 8 6.5v-2a4 4 0 1 1-4 4H2a6 6 0 1 0 6-6z",
    step: "M2 3l6 5-6 5zM9 3h2v10H9zm3.5 0H14v10h-1.5z",
    home: "M8 1.5l6.5 6h-2V14H9.5v-4h-3v4h-3V7.5h-2z",
    values: "M1 3h7V1.500h3V3h4v2h-4v1.500H8V5H1zm0 8h2V9.500h3V11h9v2H6v1.500H3V13H1z",
    screen: "M2 2h5v2H4v3H2zm12 0v5h-2V4H9V2zM2 9h2v3h3v2H2zm12 0v5H9v-2h3V9z",
    save: "M7 1h2v6h3L8 11.5 4 7h3zM2 12.5h12V15H2z",
    link: "M6.5 9.5a2.5 2.5 0 0 0 3.5 0l3-3A2.5 2.5 0 0 0 9.5 3L8 4.5l1 1 1.5-1.5a1 1 0 0 1 1.5 1.5l-3 3a1 1 0 0 1-1.5 0zM9.5 6.5a2.5 2.5 0 0 0-3.5 0l-3 3A2.5 2.5 0 0 0 6.5 13L8 11.5l-1-1L5.5 12A1 1 0 0 1 4 10.5l3-3a1 1 0 0 1 1.5 0z",
    code: "M5.5 3.5L1 8l4.5 4.5 1.200-1.200L3.400 8l3.300-3.300zm5 0L9.300 4.700 12.600 8l-3.300 3.300 1.200 1.200L15 8z",
};
/** @typedef {keyof typeof kIcons} Icon */

/**
 * A button with a picture, whose name is read and shown under the mouse.
 * @param {Icon} name
 * @param {string} label
 * @param {() => void} act
 */
export function iconButton(name, label, act) {
    const button = make("button", { type: "button", class: "icon", click: act });
    rename(button, name, label);
    return button;
}

/**
 * @param {HTMLButtonElement} button
 * @param {Icon} name
 * @param {string} label
 */
export function rename(button, name, label) {
    if (button.title === label) return;
    button.title = label;
    button.setAttribute("aria-label", label);
    button.innerHTML = `<svg viewBox="0 0 16 16" aria-hidden="true"><path d="${kIcons[name]}"/></svg>`;
}

/**
 * @param {string} label
 * @param {string[][]} choices values and their words
 * @param {(value: string) => void} set
 */
export function menu(label, choices, set) {
    return make("select", { title: label, "aria-label": label, change: ({ target }) => set(target.value) },
        ...choices.map(([value, text]) => make("option", { value, text })));
}

/** @type {any} */
export const Unpacker = /** @type {any} */ (globalThis).DecompressionStream;

/**
 * The bytes of base64, which are packed by gzip.
 * @param {string} text
 * @returns {Promise<Uint8Array>}
 */
export async function unpacked(text) {
    const digits = atob(text.trim());
    const bytes = new Uint8Array(digits.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = digits.charCodeAt(i);
    const stream = new Blob([bytes]).stream().pipeThrough(new Unpacker("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

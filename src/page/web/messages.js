// The messages of a scene, below its picture; one that has a line leads there.

/** @typedef {import("./types.js").Message} Message */
import { make } from "./dom.js";

/** @param {Message} message as glibra prints it */
export const textOfMessage = (message) => (message.file ? `${message.file}:${message.line}:${message.column}: ` : "") +
    `${message.severity}: ${message.text}${message.id ? ` [${message.id}]` : ""}`;

/**
 * Each once, errors first.
 * @param {Message[]} messages
 */
export function sorted(messages) {
    const ranks = ["error", "warning", "note"];
    const distinct = new Map(messages.map((each) => [textOfMessage(each), each]));
    return [...distinct.values()].sort((a, b) => ranks.indexOf(a.severity) - ranks.indexOf(b.severity));
}

/**
 * @param {HTMLElement} list
 * @param {Message[]} messages
 * @param {(message: Message) => void} goTo
 */
export function showMessages(list, messages, goTo) {
    list.hidden = messages.length === 0;
    list.replaceChildren(...messages.slice(0, 50).map((each) => {
        const text = textOfMessage(each);
        return make("li", { class: each.severity }, each.file ? make("button", { type: "button", text, click: () => goTo(each) }) : text);
    }));
}

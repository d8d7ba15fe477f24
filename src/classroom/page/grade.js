"use strict";
// The page of a class that glibra serves: points and comments are typed into it, and every change is kept at once.

const saved = document.createElement("span");
saved.className = "saved";
saved.setAttribute("role", "status");
document.querySelector("header h1").after(saved);

const progress = document.createElement("span");
progress.className = "progress";
saved.before(progress);

const undoButton = document.createElement("button");
undoButton.type = "button";
undoButton.className = "undo";
undoButton.textContent = "undo";
undoButton.title = "takes the last change of points or comments back (u)";
undoButton.hidden = true;
saved.after(undoButton);

function say(words, failed = false) {
    saved.textContent = words;
    saved.classList.toggle("failed", failed);
}

async function post(name, change) {
    say("saving ...");
    try {
        const reply = await fetch(name, {
            method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(change)});
        const answer = await reply.json();
        if (!reply.ok) throw new Error(answer.error || reply.statusText);
        say("saved");
        return answer;
    } catch (problem) {
        say(`not saved: ${problem.message}`, true);
        return null;
    }
}

// Sends a change of marks, and shows what all submissions that it changed have now. True if it was saved.
async function send(change, name = "marks") {
    const answer = await post(name, change);
    if (!answer) return false;
    for (const each of answer.entries) show(cardOf(each.entry), each);
    undoButton.hidden = !answer.canUndo;
    return answer;
}

const cardOf = entry => document.getElementById(`s${String(entry + 1).padStart(4, "0")}`);
const nameOf = entry => cardOf(entry).dataset.name;

// The points that a text says: null if it is empty, and what is wrong with it otherwise. A comma is a decimal point,
// whatever the language of the browser.
function pointsOf(text, most) {
    const plain = text.trim().replace(",", ".");
    if (plain === "") return {points: null};
    if (!/^(\d+\.?\d*|\.\d+)$/.test(plain)) return {problem: `'${text}' is no number of points`};
    if (Number(plain) > most) return {problem: `'${text}' is more than the ${most} points of this check`};
    return {points: Number(plain)};
}

function show(card, answer) {
    const comment = card.querySelector(".commentField");
    if (document.activeElement !== comment) comment.value = answer.comment;
    for (const cell of card.querySelectorAll(".points[data-check]")) {
        const mark = answer.marks.find(each => each.check === cell.dataset.check);
        if (!mark) continue;
        const field = cell.querySelector("input");
        if (document.activeElement !== field && field.getAttribute("aria-invalid") !== "true")
            field.value = mark.open ? "" : mark.points;
        cell.parentElement.classList.toggle("own", mark.own);
        cell.parentElement.classList.toggle("open", mark.open);
    }
    const total = card.querySelector(".marks tfoot td");
    const rounded = answer.points === undefined ? "" : String(Math.round(answer.points * 100) / 100);
    if (total) total.textContent = rounded;
    const link = document.querySelector(`.overview a[href="#${card.id}"]`);
    const row = link && link.closest("tr");
    if (row && row.querySelector(".points")) row.querySelector(".points").textContent = rounded;
    if (row && row.querySelector(".open")) row.querySelector(".open").textContent = card.querySelectorAll("tr.open").length || "";
    count();
}

function count() {
    const words = document.querySelector(".unmarked");
    if (!words) return;
    const all = Number(words.dataset.all);
    const open = [...document.querySelectorAll(".card")].filter(each => each.querySelector("tr.open")).length;
    words.textContent = `${all - open} of ${all} submissions are marked. j and k go from one to the next, n to the next with a ` +
        "field to mark; in a field, with Alt. Alt+1 to Alt+9 add a kept comment; u undoes the last change.";
    progress.textContent = all > 0 ? `${all - open} of ${all} marked` : "";
}

// A choice of the paragraphs that other comments of this class have; one that is chosen is added to the comment.
function addBank(card, comment) {
    const bank = document.createElement("select");
    bank.className = "bank";
    bank.setAttribute("aria-label", "add what another comment says");
    const fill = () => {
        const own = comment.value.split("\n");
        const all = [...document.querySelectorAll(".commentField")].flatMap(each => each.value.split("\n"));
        const others = [...new Set(all.map(each => each.trim()).filter(each => each && !own.includes(each)))].sort();
        bank.replaceChildren(new Option("add an earlier comment", ""), ...others.map(each => new Option(each, each)));
        bank.hidden = others.length === 0;
    };
    bank.addEventListener("focus", fill);
    card.addEventListener("pointerenter", fill);
    card.addEventListener("focusin", event => event.target === bank || fill());
    bank.addEventListener("change", () => {
        if (!bank.value) return;
        comment.value += (comment.value ? "\n" : "") + bank.value;
        comment.dispatchEvent(new Event("change"));
        fill();
    });
    bank.hidden = true;
    comment.after(bank);
}

for (const card of document.querySelectorAll(".card")) {
    const entry = Number(card.id.slice(1)) - 1;
    for (const cell of card.querySelectorAll(".points[data-check]")) {
        const field = document.createElement("input");
        field.type = "text";
        field.inputMode = "decimal";
        field.autocomplete = "off";
        field.value = cell.textContent;
        field.setAttribute("aria-label", `points for ${cell.dataset.check}; empty: those of the check`);
        cell.textContent = "";
        cell.append(field);
        field.addEventListener("change", async () => {
            const {points, problem} = pointsOf(field.value, Number(cell.dataset.most));
            field.setAttribute("aria-invalid", String(problem !== undefined));
            if (problem) return say(`not saved: ${problem}`, true);
            send({entry, check: cell.dataset.check, points});
        });
    }
    const old = card.querySelector(".comment");
    const comment = document.createElement("textarea");
    comment.rows = 2;
    comment.className = "commentField";
    comment.placeholder = "a comment for this submission";
    comment.setAttribute("aria-label", comment.placeholder);
    comment.value = old ? old.textContent : "";
    if (old) old.remove();
    card.querySelector(".grading").append(comment);
    comment.addEventListener("change", () => send({entry, comment: comment.value}));
    comment.addEventListener("focus", () => showKept(comment));
    addBank(card, comment);
}
count();

// Comments that are kept for this class: one panel, which stands at the comment that was last in use.
const kept = document.createElement("div");
kept.className = "kept";
let keptComments = [], keptField = null;

function fillKept() {
    const list = document.createElement("ol");
    keptComments.forEach((text, index) => {
        const line = document.createElement("li");
        const add = document.createElement("button"), remove = document.createElement("button");
        add.type = remove.type = "button";
        add.className = "add";
        add.textContent = text;
        if (index < 9) add.title = `Alt+${index + 1}`;
        add.addEventListener("click", () => insertKept(index));
        remove.textContent = "\u00d7";
        remove.setAttribute("aria-label", `no longer keep: ${text}`);
        remove.addEventListener("click", () => changeKept({remove: text}));
        line.append(add, remove);
        list.append(line);
    });
    const keep = document.createElement("button");
    keep.type = "button";
    keep.className = "keep";
    keep.textContent = "keep this comment for others";
    keep.addEventListener("click", () => {
        const text = keptField.value.trim();
        if (text) changeKept({add: text});
    });
    kept.replaceChildren(...(keptComments.length ? [list] : []), keep);
}

async function changeKept(change) {
    const answer = await post("comments", change);
    if (!answer) return;
    keptComments = answer.comments;
    fillKept();
}

function insertKept(index) {
    if (!keptField || index >= keptComments.length) return;
    keptField.value += (keptField.value ? "\n" : "") + keptComments[index];
    keptField.dispatchEvent(new Event("change"));
}

function showKept(field) {
    keptField = field;
    field.nextElementSibling.after(kept);  // after the choice of what others say
}

// One judgement for all submissions with the same pictures.
function addAlike(entry, others) {
    if (others.length === 0) return;
    const line = document.createElement("p");
    line.className = "alike near";
    line.append(`The same pictures: ${others.map(nameOf).join(", ")}. `);
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = others.length === 1 ? "give it these points and this comment" : `give all ${others.length} these points and this comment`;
    button.addEventListener("click", async () => {
        if (await send({entry, alike: true})) say(`saved for ${others.map(nameOf).join(", ")}`);
    });
    line.append(button);
    cardOf(entry).querySelector(".grading").append(line);
}

async function undo() {
    const answer = await send({}, "undo");
    if (answer) say(`undone for ${answer.entries.map(each => nameOf(each.entry)).join(", ")}`);
}
undoButton.addEventListener("click", undo);

document.addEventListener("keydown", event => {
    if (event.metaKey || event.ctrlKey) return;
    const digit = /^Digit([1-9])$/.exec(event.code);
    const field = event.target.closest("input, textarea, select");
    if (event.altKey && digit && keptField) insertKept(Number(digit[1]) - 1);
    else if (!event.altKey && !field && event.key === "u" && !undoButton.hidden) undo();
    else return;
    event.preventDefault();
});

fetch("facts").then(reply => reply.json()).then(facts => {
    facts.alike.forEach((others, entry) => addAlike(entry, others));
    keptComments = facts.comments;
    fillKept();
    undoButton.hidden = !facts.canUndo;
    document.body.dataset.ready = "true";
});

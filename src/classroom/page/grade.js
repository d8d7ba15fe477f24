"use strict";
// The page of a class that glibra serves: points and comments are typed into it, and every change is kept at once.

const saved = document.createElement("span");
saved.className = "saved";
saved.setAttribute("role", "status");
document.querySelector("header h1").after(saved);

function say(words, failed = false) {
    saved.textContent = words;
    saved.classList.toggle("failed", failed);
}

async function send(change) {
    say("saving ...");
    try {
        const reply = await fetch("marks", {
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
    if (!answer) return;
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
        "field to mark; in a field, with Alt.";
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
            show(card, await send({entry, check: cell.dataset.check, points}));
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
    comment.addEventListener("change", async () => show(card, await send({entry, comment: comment.value})));
    addBank(card, comment);
}
count();
